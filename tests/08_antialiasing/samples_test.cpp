// Steps 08.1, 08.2, 08.3 and 08.5: the mean over a pixel, strata, regular and jittered samples, the rules of
// POV-Ray.
#include "chapters/08_antialiasing/samples.hpp"

#include "common/math/error.hpp"
#include "tests/08_antialiasing/statistics.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <string>

using namespace rt;
using rt::test::cases;
using rt::test::show;

namespace {

constexpr Real u = unit_roundoff;

bool inside(const Stratum& part, const Vec2& p) {
    return p.x >= part.low.x && p.x < part.high.x && p.y >= part.low.y && p.y < part.high.y;
}

/// All the strata of a pixel, in order.
void check_strata(const std::vector<Stratum>& expected, Real bound = 0) {
    const std::vector<Stratum> parts = strata(static_cast<int>(expected.size()));
    {
        INFO("how many strata there are");
        REQUIRE(parts.size() == expected.size());
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        INFO("of " << parts.size() << " strata number " << i << ", counted from 0, is a " << show(parts[i])
                   << "; expected a " << show(expected[i]));
        CHECK(test::near(parts[i].low, expected[i].low, bound));
        CHECK(test::near(parts[i].high, expected[i].high, bound));
    }
}

/// A world that is looked at straight: the ray through the point (x, y) of the picture starts at (x, y, 0).
World plain_world(int width, int height) {
    World world;
    world.view.projection = Projection::Orthographic;
    world.view.half_height = Real(height) / 2;
    world.view.width = width;
    world.view.height = height;
    world.view.frame = {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    world.view.eye = {Real(width) / 2, Real(height) / 2, 0};
    return world;
}

Vec3 color_is_origin(const World&, const Ray& ray, Stream&) { return ray.origin; }
Vec3 color_is_one(const World&, const Ray&, Stream&) { return Vec3(1); }

/// The sum of the weights, which should be 1.
Real weights(const std::vector<PixelSample>& samples) {
    Real sum = 0;
    for (const PixelSample& sample : samples) sum += sample.weight;
    return sum;
}

/// The bits before `stirred` stirred them.
std::uint64_t unstirred(std::uint64_t bits) {
    bits ^= (bits >> 31) ^ (bits >> 62);
    bits *= 0x319642b2d24d8ec3u;  // inverse of 0x94d049bb133111eb modulo 2^64, and so on
    bits ^= (bits >> 27) ^ (bits >> 54);
    bits *= 0x96de1b173f119089u;
    return bits ^ (bits >> 30) ^ (bits >> 60);
}

/// A sequence whose number in dimension `which`, counted from 1, is the greatest that there is: 1 − 2^-53.
Random with_greatest(std::uint64_t which) {
    return {unstirred(~std::uint64_t(0)) - 0x9e3779b97f4a7c15u - which, 0};
}

}  // namespace

// 08.1 ---------------------------------------------------------------------------------------------------

TEST_CASE("a pixel of two samples is their weighted mean", "[08.1]") {
    const World world = plain_world(8, 6);
    const PixelSample two[2] = {{{0.25, 0.5}, 0.75}, {{0.75, 0.25}, 0.25}};
    // 3/4 of (5.25, 2.5) and 1/4 of (5.75, 2.25).
    const Vec3 color = sample_pixel(world, 5, 2, two, color_is_origin, {});
    {
        INFO(
            "pixel (5, 2), samples at (0.25, 0.5), weight 0.75, and (0.75, 0.25), weight 0.25, of a picture "
            "whose colour is its place");
        CHECK(test::near(color, {5.375, 2.4375, 0}, 0));
    }
    INFO("pixel (0, 0) of a white picture, one sample of weight 0.75: colour times weight");
    CHECK(sample_pixel(world, 0, 0, std::span(two).first(1), color_is_one, {}) == Vec3(0.75));
}

TEST_CASE("each sample has random numbers of its own, whatever the others asked for", "[08.1]") {
    const World world = plain_world(8, 6);
    const RayColor color_is_stream = [](const World&, const Ray&, Stream& stream) {
        const Vec3 color(static_cast<Real>(stream.seed), 10 * stream.x + stream.y,
                         10 * stream.sample + stream.dimension);
        next_point(stream);
        return color;
    };
    const Stream stream{.seed = 7, .x = 5, .y = 2, .sample = 4};
    const PixelSample three[3] = {{Vec2(0.5), 0.5}, {Vec2(0.25), 0.25}, {Vec2(0.75), 0.25}};
    const Vec3 color = sample_pixel(world, 5, 2, three, color_is_stream, stream);
    INFO(
        "three samples of weights 0.5, 0.25 and 0.25, whose streams should have the numbers 4, 5 and 6, and "
        "start at dimension 0\nthe seed; 10 x + y of the pixel; 10 times the weighted number of the sample");
    CHECK(test::near(color, {7, 52, 10 * (0.5 * 4 + 0.25 * 5 + 0.25 * 6)}, 0));
}

// 08.2 ---------------------------------------------------------------------------------------------------

TEST_CASE("one stratum is the whole pixel, four are its quarters", "[08.2]") {
    check_strata({{{0, 0}, {1, 1}}});
    check_strata({{{0, 0}, {0.5, 0.5}}, {{0.5, 0}, {1, 0.5}}, {{0, 0.5}, {0.5, 1}}, {{0.5, 0.5}, {1, 1}}});
}

TEST_CASE("of five strata two are in the upper row, which is two fifths high", "[08.2]") {
    check_strata({{{0, 0}, {0.5, 2. / 5}},
                  {{0.5, 0}, {1, 2. / 5}},
                  {{0, 2. / 5}, {1. / 3, 1}},
                  {{1. / 3, 2. / 5}, {2. / 3, 1}},
                  {{2. / 3, 2. / 5}, {1, 1}}},
                 2 * u);
}

TEST_CASE("any number of strata have equal areas, and cover the pixel once", "[08.2]") {
    for (int count = 1; count <= 400; ++count) {
        INFO(count << " strata");
        const std::vector<Stratum> parts = strata(count);
        REQUIRE(
            test::or_say(parts.size() == static_cast<std::size_t>(count), "there are " + show(parts.size())));
        // Each begins exactly where the one before ends: at its right, or at the left below it. So they leave
        // no gaps and do not overlap, if the first begins top left and the last ends bottom right.
        Vec2 begin(0);
        Real bottom = parts[0].high.y;
        for (const Stratum& part : parts) {
            if (begin.x == 1) {
                begin = Vec2(0, bottom);
                bottom = part.high.y;
            }
            // Its sides are 1/columns and columns/count; each end of a side is off by u/2 at most.
            const Vec2 side = part.high - part.low;
            const bool follows = part.low == begin && part.high.y == bottom && side.x > 0 && side.y > 0;
            const bool equal = std::abs(side.x * side.y * count - 1) <= u * (1 / side.x + 1 / side.y + 4);
            if (!follows || !equal) {
                INFO("stratum from " << show(part.low) << " to " << show(part.high)
                                     << ", the one before ends at x = " << begin.x);
                REQUIRE(test::or_say(follows, "it does not begin where the one before ends"));
                REQUIRE(test::or_say(equal, "its area is not 1/" + show(count)));
            }
            begin = Vec2(part.high.x, part.low.y);
        }
        INFO("where the last one ends, in the lower right corner");
        REQUIRE(parts.back().high == Vec2(1));
    }
}

TEST_CASE("n × n strata are squares with edges at multiples of 1/n", "[08.2]") {
    for (int n = 1; n <= 40; ++n) {
        const std::vector<Stratum> parts = strata(n * n);
        REQUIRE(parts.size() == static_cast<std::size_t>(n * n));
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const Stratum& part = parts[static_cast<std::size_t>(j * n + i)];
                // One more rounding than the last is forgiven.
                const auto low = test::near(part.low, Vec2(i, j) / Real(n), 2 * u);
                const auto high = test::near(part.high, Vec2(i + 1, j + 1) / Real(n), 2 * u);
                if (low && high) continue;
                INFO("of " << n << " × " << n << " strata that in column " << i << ", row " << j
                           << ": its upper left corner, and its lower right one");
                REQUIRE(low);
                REQUIRE(high);
            }
        }
    }
}

TEST_CASE("one regular sample is in the middle of the pixel", "[08.2]") {
    const std::vector<PixelSample> one = regular_samples(1);
    INFO("how many regular samples there are of 1, where it is, and what it weighs");
    REQUIRE(one.size() == 1);
    CHECK(one[0].at == Vec2(0.5));
    CHECK(one[0].weight == 1);
}

TEST_CASE("regular samples are in the middles of the strata and weigh the same", "[08.2]") {
    for (int count = 1; count <= 100; ++count) {
        INFO(count << " samples");
        const std::vector<PixelSample> samples = regular_samples(count);
        const std::vector<Stratum> parts = strata(count);
        REQUIRE(samples.size() == parts.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            INFO("number " << i << " in the " << show(parts[i]) << ": its place, and its weight times "
                           << count);
            REQUIRE(test::near(samples[i].at, (parts[i].low + parts[i].high) / 2., 2 * u));
            REQUIRE(test::near(samples[i].weight * count, 1, 2 * u));
        }
    }
}

TEST_CASE("regular samples of a slope make the colour of its middle", "[08.2]") {
    const World world = plain_world(16, 9);
    for (int count = 1; count <= 100; ++count) {
        const Vec3 color = sample_pixel(world, 11, 3, regular_samples(count), color_is_origin, {});
        INFO(count << " regular samples of pixel (11, 3), where the colour is the place: its middle");
        // A sum of `count` terms near 12/count, each rounding of which is at most 12u.
        CHECK(test::near(color, {11.5, 3.5, 0}, 24 * u * (count + 4)));
    }
}

TEST_CASE("with regular samples the error of smooth colours falls as 1/n", "[08.2]") {
    const Real slope =
        test::error_slope(cases(500), test::any_smooth, [](int n, Random) { return regular_samples(n); });
    INFO("the exponent with which the error falls, the midpoint rule's is −1");
    // All errors have nearly the same ratios, whatever the place: chance plays no part worth mentioning.
    CHECK(test::near(slope, -1, 0.05));
}

// 08.3 ---------------------------------------------------------------------------------------------------

TEST_CASE("each stratum has one jittered sample, and all weigh the same", "[08.3]") {
    for (int count = 1; count <= 400; ++count) {
        INFO(count << " samples");
        const std::vector<PixelSample> samples = jittered_samples(count, random_for(1, 2, 3));
        const std::vector<Stratum> parts = strata(count);
        REQUIRE(samples.size() == parts.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const bool there = inside(parts[i], samples[i].at);
            const bool equal = std::abs(samples[i].weight * count - 1) <= 2 * u;
            if (there && equal) continue;
            INFO("sample " << i << " at " << show(samples[i].at) << " weighs " << samples[i].weight
                           << ", stratum from " << show(parts[i].low) << " to " << show(parts[i].high));
            REQUIRE(test::or_say(there, "it lies outside of its stratum"));
            REQUIRE(test::or_say(equal, "it does not weigh 1/" + show(count)));
        }
    }
}

TEST_CASE("jittered samples fall everywhere in their strata", "[08.3]") {
    const std::vector<Stratum> parts = strata(4);
    std::vector<Vec2> least(4, Vec2(infinity)), greatest(4, Vec2(-infinity));
    for (std::uint64_t k = 0; k < 500; ++k) {
        const std::vector<PixelSample> samples = jittered_samples(4, random_for(5, k, 0));
        REQUIRE(samples.size() == 4);
        for (std::size_t i = 0; i < 4; ++i) {
            least[i] = glm::min(least[i], samples[i].at);
            greatest[i] = glm::max(greatest[i], samples[i].at);
        }
    }
    // Of 500 uniform numbers the least is above 0.05 with a probability of 0.95^500, which is 1e-11.
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 side = parts[i].high - parts[i].low;
        INFO(show(parts[i]) << ": its samples lie from " << least[i] << " to " << greatest[i]);
        CHECK(test::near(least[i], parts[i].low + 0.025 * side, 0.025 * side.x));
        CHECK(test::near(greatest[i], parts[i].high - 0.025 * side, 0.025 * side.x));
    }
}

TEST_CASE("even the greatest random number leaves a sample in its stratum", "[08.3]") {
    for (const int count : {1, 2, 3, 4, 9, 10, 16, 25}) {
        const std::vector<Stratum> parts = strata(count);
        for (std::uint64_t which = 1; which <= 2 * static_cast<std::uint64_t>(count); ++which) {
            const std::vector<PixelSample> samples = jittered_samples(count, with_greatest(which));
            REQUIRE(samples.size() == parts.size());
            const std::size_t i = (which - 1) / 2;
            INFO(count << " samples, number " << i << ": its " << (which % 2 == 1 ? "x" : "y")
                       << " comes from 1 − 2^-53");
            INFO("it is at " << samples[i].at << ", its " << show(parts[i]));
            CHECK(test::or_say(inside(parts[i], samples[i].at), "it lies outside of its stratum"));
        }
    }
}

TEST_CASE("equal random sequences make equal patterns, others make others", "[08.3]") {
    const std::vector<PixelSample> a = jittered_samples(16, random_for(1, 2, 3)),
                                   b = jittered_samples(16, random_for(1, 2, 3)),
                                   c = jittered_samples(16, random_for(1, 2, 4));
    INFO("16 jittered samples from random_for(1, 2, 3), again, and from random_for(1, 2, 4)");
    REQUIRE(a.size() == 16);
    REQUIRE(b.size() == 16);
    REQUIRE(c.size() == 16);
    for (std::size_t i = 0; i < 16; ++i) {
        INFO("sample " << i << ", twice from the same numbers, then from others");
        CHECK(a[i].at == b[i].at);
        CHECK(a[i].at != c[i].at);
    }
}

TEST_CASE("jittered samples are uniform in their strata, and independent of their neighbours", "[08.3]") {
    const int count = 7;
    const std::vector<Stratum> parts = strata(count);
    std::vector<int> places(64), neighbours(64);
    for (int i = 0; i < cases(20'000); ++i) {
        const std::vector<PixelSample> samples =
            jittered_samples(count, random_for(4, static_cast<std::uint64_t>(i), 0));
        REQUIRE(samples.size() == parts.size());
        Vec2 before(0);
        for (std::size_t k = 0; k < parts.size(); ++k) {
            const Vec2 place = (samples[k].at - parts[k].low) / (parts[k].high - parts[k].low);
            const auto cell = [](Real x) {
                return std::min(static_cast<std::size_t>(8 * x), std::size_t(7));
            };
            ++places[cell(place.y) * 8 + cell(place.x)];
            if (k > 0) ++neighbours[cell(before.x) * 8 + cell(place.x)];
            before = place;
        }
    }
    // How uneven the counts are, by Pearson's χ²: about 63 where each is as likely as the others.
    const Real limit = test::chi_square_limit(64);
    {
        INFO(
            "where in their strata samples lie, counted in 8 x 8 parts: how uneven these 64 counts are (χ², "
            "about 63 where all parts are alike)");
        CHECK(test::chi_square(places) < limit);
    }
    INFO(
        "the place of a sample against that of the sample before, counted in 8 x 8 parts: how uneven these "
        "64 counts are (χ², about 63 where samples do not depend on each other)");
    CHECK(test::chi_square(neighbours) < limit);
}

TEST_CASE("the mean of random and of jittered samples is the coverage", "[08.3]") {
    const int patterns = cases(4000);
    const auto check = [&](const auto& shape) {
        INFO("coverage " << test::truth(shape));
        for (const int n : {5, 16}) {
            const Real independent = test::t_of(
                shape, patterns, [n](std::uint64_t i) { return random_samples(n, random_for(5, i, 0)); });
            const Real jittered = test::t_of(
                shape, patterns, [n](std::uint64_t i) { return jittered_samples(n, random_for(6, i, 0)); });
            INFO(n << " samples, random and jittered: by how many of its standard errors their mean is off "
                      "(Student's t)");
            CHECK(std::abs(independent) < test::t_limit);
            CHECK(std::abs(jittered) < test::t_limit);
        }
    };
    SECTION("of a half-plane") { check(test::HalfPlane{{0.8, 0.6}, 0.55}); }
    SECTION("of a disk") { check(test::Disk{{0.2, 0.9}, 0.6}); }
    SECTION("of a zone plate") { check(test::ZonePlate{{-0.3, 0.1}, 12}); }
    SECTION("and this test finds samples that stay in the upper left quarters of their strata") {
        const auto biased = [](std::uint64_t i) {
            std::vector<PixelSample> samples = jittered_samples(16, random_for(6, i, 0));
            const std::vector<Stratum> parts = strata(16);
            for (std::size_t k = 0; k < 16; ++k) samples[k].at = (samples[k].at + parts[k].low) / 2.;
            return samples;
        };
        CHECK(std::abs(test::t_of(test::HalfPlane{{0.8, 0.6}, 0.55}, patterns, biased)) > test::t_limit);
    }
}

TEST_CASE("the error falls as n^-½ for random samples, and faster for jittered ones", "[08.3]") {
    const int trials = cases(8000);
    // Each mean square error is known to about 2/√trials of itself, its root to half of that, and the slope
    // over a factor 256 in n to a quarter of that: 0.01 for 800 trials, and 0.003 for 8000.
    SECTION("random samples on an edge") {
        const Real slope = test::error_slope(trials / 2, test::any_edge, random_samples);
        INFO("the exponent with which the error falls, expected −0.5");
        CHECK(test::near(slope, -0.5, 0.05));
    }
    SECTION("jittered samples on an edge: only strata that it passes through are wrong") {
        const Real slope = test::error_slope(trials / 2, test::any_edge, jittered_samples);
        INFO("the exponent with which the error falls, expected −0.75");
        CHECK(test::near(slope, -0.75, 0.05));
    }
    SECTION("jittered samples of smooth colours: each stratum is nearly flat") {
        const Real slope = test::error_slope(trials / 8, test::any_smooth, jittered_samples);
        INFO("the exponent with which the error falls, expected −1");
        CHECK(test::near(slope, -1, 0.05));
    }
}

// 08.5 ---------------------------------------------------------------------------------------------------

TEST_CASE("four trapezoid samples are the corners of the pixel", "[08.5]") {
    for (const int count : {1, 2, 3, 4, 5, 8}) {
        INFO("asked for " << count << " samples");
        const std::vector<PixelSample> samples = trapezoid_samples(count);
        {
            INFO("how many samples there are");
            REQUIRE(samples.size() == 4);
        }
        const Vec2 corner[4] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
        for (std::size_t i = 0; i < 4; ++i) {
            INFO("number " << i << ", counted from 0: " << show(samples[i]));
            CHECK(test::near(samples[i].at, corner[i], 0));
            INFO("what it weighs");
            CHECK(test::near(samples[i].weight, 0.25, 0));
        }
    }
}

TEST_CASE("of nine trapezoid samples corners count 1/16, edges 2/16, the middle 4/16", "[08.5]") {
    const std::vector<PixelSample> samples = trapezoid_samples(9);
    REQUIRE(samples.size() == 9);
    const Real sixteenths[9] = {1, 2, 1, 2, 4, 2, 1, 2, 1};
    for (std::size_t i = 0; i < 9; ++i) {
        INFO("number " << i << ", counted from 0: " << show(samples[i]));
        CHECK(samples[i].at == Vec2(Real(i % 3) / 2, Real(i / 3) / 2));
        CHECK(samples[i].weight == sixteenths[i] / 16);
    }
}

TEST_CASE("trapezoid weights sum to 1, and make the mean of a slope and of a saddle exactly", "[08.5]") {
    for (int count = 1; count <= 300; ++count) {
        INFO("asked for " << count << " samples");
        const std::vector<PixelSample> samples = trapezoid_samples(count);
        int m = 1;
        while ((m + 2) * (m + 2) <= count) ++m;
        REQUIRE(samples.size() == static_cast<std::size_t>((m + 1) * (m + 1)));
        INFO("the first sample, and the last");
        CHECK(samples.front().at == Vec2(0));
        CHECK(test::near(samples.back().at, Vec2(1), 2 * u));
        Real slope = 0, saddle = 0;
        for (const auto& sample : samples) {
            slope += sample.weight * sample.at.x;
            saddle += sample.weight * sample.at.x * sample.at.y;
        }
        // Each of the terms has a few roundings, and so has each sum on the way.
        const Real bound = u * (static_cast<Real>(samples.size()) + 8);
        INFO("the sum of the weights; the weighted mean of x, and of x y");
        CHECK(test::near(weights(samples), 1, bound));
        CHECK(test::near(slope, 0.5, bound));
        CHECK(test::near(saddle, 0.25, bound));
    }
}

TEST_CASE("centred samples are regular ones and one more in the middle, of equal weight", "[08.5]") {
    for (int count = 1; count <= 300; ++count) {
        INFO("asked for " << count << " samples");
        const std::vector<PixelSample> samples = centered_samples(count);
        int n = 1;
        while ((n + 1) * (n + 1) + 1 <= count) ++n;
        const auto squares = static_cast<std::size_t>(n * n);
        REQUIRE(samples.size() == squares + 1);
        for (std::size_t i = 0; i < squares; ++i) {
            const Vec2 cell(Real(i % static_cast<std::size_t>(n)), Real(i / static_cast<std::size_t>(n)));
            const auto regular = test::near(samples[i].at, (cell + Vec2(0.5)) / Real(n), 4 * u);
            if (regular) continue;
            INFO("where sample " << i << " is, counted from 0");
            REQUIRE(regular);
        }
        {
            INFO("where the last one is, in the middle");
            CHECK(samples.back().at == Vec2(0.5));
        }
        for (const auto& sample : samples) {
            const auto equal = test::near(sample.weight * static_cast<Real>(squares + 1), 1, 2 * u);
            if (equal) continue;
            INFO("the weight of the " << show(sample) << ", times " << squares + 1 << ": all weigh the same");
            REQUIRE(equal);
        }
    }
}
