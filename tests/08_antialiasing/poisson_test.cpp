// Step 08.4: samples that keep their distance.
#include "chapters/08_antialiasing/samples.hpp"

#include "common/math/error.hpp"
#include "tests/08_antialiasing/statistics.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <complex>
#include <numbers>

using namespace rt;
using rt::test::cases;

namespace {

constexpr Real u = unit_roundoff;

/// Least distance of two samples if the pattern is repeated in the eight pixels around: by comparing all.
Real least_distance(const std::vector<PixelSample>& samples) {
    Real least = infinity;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (const Real x : {-1., 0., 1.}) {
                for (const Real y : {-1., 0., 1.})
                    least = std::min(least, length(samples[i].at + Vec2(x, y) - samples[j].at));
            }
        }
    }
    return least;
}

/// Distance on the torus: along each axis the shorter way round.
Real way_round(const Vec2& a, const Vec2& b) {
    const auto along = [](Real from, Real to) {
        const Real way = std::abs(to - from);
        return std::min(way, 1 - way);
    };
    return std::hypot(along(a.x, b.x), along(a.y, b.y));
}

/// Distance in the densest packing, a honeycomb; of `count` points, one each pixel's area.
Real densest(int count) { return std::sqrt(2 / (std::numbers::sqrt3 * count)); }

/// Mean of |Σ exp(2πi k·p)|²/n over patterns and over the whole vectors k ≠ 0 with near ≤ |k| < far. It is 1
/// for independent samples.
template <class Pattern>
Real power(int patterns, Real near, Real far, Pattern pattern) {
    Real sum = 0, terms = 0;
    const int reach = static_cast<int>(far);
    for (int i = 0; i < patterns; ++i) {
        const std::vector<PixelSample> samples = pattern(random_for(31, static_cast<std::uint64_t>(i), 0));
        // k and −k have the same power, so half of them are enough.
        for (int ky = 0; ky <= reach; ++ky) {
            for (int kx = ky == 0 ? 1 : -reach; kx <= reach; ++kx) {
                const Real k = std::hypot(kx, ky);
                if (k < near || k >= far) continue;
                std::complex<Real> wave = 0;
                for (const PixelSample& sample : samples)
                    wave += std::polar(Real(1), 2 * pi * (kx * sample.at.x + ky * sample.at.y));
                sum += std::norm(wave) / static_cast<Real>(samples.size());
                ++terms;
            }
        }
    }
    return sum / terms;
}

}  // namespace

TEST_CASE("distances are measured across the pixel's edges too", "[08.4]") {
    const auto check = [](const Vec2& a, const Vec2& b, Real expected) {
        INFO("the distance of " << a << " and " << b << " where the pixel is repeated on all sides");
        CHECK(test::near(torus_distance(a, b), expected, 0));
    };
    check({0.25, 0.5}, {0.5, 0.5}, 0.25);
    check({0.125, 0.5}, {0.875, 0.5}, 0.25);
    check({0.5, 0}, {0.5, 0.75}, 0.25);
    check({0, 0}, {0.5, 0.5}, std::sqrt(Real(0.5)));
    // The step itself: two samples, whose distance is what is promised.
    INFO("how many samples there are of 2");
    CHECK(poisson_disk_samples(2, random_for(0, 0, 0)).samples.size() == 2);
}

TEST_CASE("a single Poisson disk sample lies anywhere, infinitely far from others", "[08.4]") {
    const PoissonDisk a = poisson_disk_samples(1, random_for(1, 0, 0)),
                      b = poisson_disk_samples(1, random_for(2, 0, 0));
    INFO("two patterns of one sample: how many, its weight, the distance, and that they differ");
    REQUIRE(a.samples.size() == 1);
    REQUIRE(b.samples.size() == 1);
    CHECK(a.samples[0].weight == 1);
    CHECK(a.distance == infinity);
    CHECK(a.samples[0].at != b.samples[0].at);
}

TEST_CASE("no two samples are nearer than the distance that is returned", "[08.4]") {
    const auto check = [](int count, std::uint64_t which) {
        INFO(count << " samples of random_for(7, " << count << ", " << which << ")");
        const PoissonDisk disk =
            poisson_disk_samples(count, random_for(7, static_cast<std::uint64_t>(count), which));
        REQUIRE(disk.samples.size() == static_cast<std::size_t>(count));
        for (const PixelSample& sample : disk.samples) {
            const bool inside = sample.at.x >= 0 && sample.at.x < 1 && sample.at.y >= 0 && sample.at.y < 1;
            const bool equal = std::abs(sample.weight * count - 1) <= 2 * u;
            INFO("a sample at " << sample.at << " that weighs " << sample.weight);
            REQUIRE(test::or_say(inside, "it lies outside of the pixel"));
            REQUIRE(test::or_say(equal, "it does not weigh as much as the others"));
        }
        // Distances below 1 are known to a few u, whichever way they are computed.
        {
            INFO(
                "the least distance of two samples, across the pixel's edges too; the distance that was "
                "returned");
            REQUIRE(least_distance(disk.samples) >= disk.distance - 4 * u);
        }
        // Where discs are dropped at random no more fit at 0.777 of the densest packing's distance: they
        // cover 0.547 of the plane then, against 0.907. So nearly all patterns are full at 0.7 already; of
        // some thousand patterns the worst shrank twice, to 0.63.
        INFO("distance " << disk.distance << ", in the densest packing " << densest(count));
        CHECK(disk.distance >= 0.55 * densest(count));
        CHECK(disk.distance <= 0.7 * densest(count) * (1 + 4 * u));
        // It is one of the distances that were tried.
        Real tried = 0.7 * densest(count);
        while (tried > disk.distance * 1.001) tried *= 0.95;
        CHECK(std::abs(disk.distance / tried - 1) <= 1e-13);
    };
    SECTION("patterns of 2 to 70 samples, and one of 400") {
        for (int count = 2; count <= 70; ++count) check(count, 0);
        check(400, 0);
    }
    SECTION("patterns whose distance has to shrink, some of them twice") {
        check(7, 4);
        check(16, 147);
        check(5, 39);
        check(12, 202);
    }
}

TEST_CASE("the distance shrinks only when 32·count darts in a row were refused", "[08.4]") {
    // The throwing of darts again, each compared with all samples: what distance is left when it is through?
    const auto distance_of = [](int count, Random random) {
        std::vector<Vec2> samples;
        Real distance = 0.7 * densest(count);
        for (int rejected = 0; static_cast<int>(samples.size()) < count;) {
            const Vec2 thrown = random_point(random);
            const bool near = std::any_of(samples.begin(), samples.end(), [&](const Vec2& sample) {
                return way_round(sample, thrown) < distance;
            });
            if (!near) samples.push_back(thrown);
            rejected = near ? rejected + 1 : 0;
            if (rejected == 32 * count) {
                distance *= 0.95;
                rejected = 0;
            }
        }
        return distance;
    };
    const auto check = [&](int count, std::uint64_t which) {
        const Random random = random_for(8, static_cast<std::uint64_t>(count), which);
        INFO(count << " samples of random_for(8, " << count << ", " << which
                   << "); a dart that sticks begins the count of those refused anew, and so does a shorter "
                      "distance\nthe distance that is returned");
        const Real expected = distance_of(count, random);
        REQUIRE(test::near(poisson_disk_samples(count, random).distance, expected, 1e-12 * expected));
    };
    // About one pattern in a hundred is so hard to fill that the difference shows.
    for (const int count : {6, 12, 16, 40})
        for (std::uint64_t which = 0; which < 200; ++which) check(count, which);
    // Found by trying: the dart after 95 refused ones sticks, the 96th is refused, too; after a shorter
    // distance as many are refused again, or one less.
    check(3, 121);
    check(3, 4592);
    check(5, 401);
    check(5, 12110);
}

TEST_CASE("equal random sequences make equal Poisson disk patterns", "[08.4]") {
    const PoissonDisk a = poisson_disk_samples(16, random_for(1, 2, 3)),
                      b = poisson_disk_samples(16, random_for(1, 2, 3));
    INFO("16 samples of random_for(1, 2, 3), twice");
    REQUIRE(a.samples.size() == b.samples.size());
    for (std::size_t i = 0; i < a.samples.size(); ++i) CHECK(a.samples[i].at == b.samples[i].at);
    CHECK(a.distance == b.distance);
}

TEST_CASE("the mean of Poisson disk samples is the coverage", "[08.4]") {
    const int patterns = cases(2000);
    const auto t = [&](const auto& shape) {
        return std::abs(test::t_of(shape, patterns, [](std::uint64_t i) {
            return poisson_disk_samples(9, random_for(9, i, 0)).samples;
        }));
    };
    INFO(
        "by how many of its standard errors the mean is off (Student's t), for a half-plane, a disk, a zone "
        "plate");
    CHECK(t(test::HalfPlane{{0.8, 0.6}, 0.55}) < test::t_limit);
    CHECK(t(test::Disk{{0.2, 0.9}, 0.6}) < test::t_limit);
    CHECK(t(test::ZonePlate{{-0.3, 0.1}, 12}) < test::t_limit);
}

TEST_CASE("the spectrum of Poisson disk samples is blue: little power in low frequencies", "[08.4]") {
    const int count = 100, patterns = cases(200);
    // 10 waves a pixel are one for each row of samples. Below half of that there is little power, and where
    // the distance between samples is one wave there is more than random samples have.
    const auto low = [&](auto pattern) { return power(patterns, 1, 5, pattern); };
    const Real random = low([](Random from) { return random_samples(100, from); });
    const Real blue = low([](Random from) { return poisson_disk_samples(100, from).samples; });
    const Real peak = power(std::max(1, patterns / 4), 10, 12,
                            [](Random from) { return poisson_disk_samples(100, from).samples; });
    INFO(count << " samples, " << patterns << " patterns: power of random samples " << random
               << ", of Poisson disk samples " << blue << ", at their distance " << peak);
    // The power of each wave of random samples has an exponential distribution: of 34 · 20 of them in the
    // quick run the mean is known to 0.04.
    CHECK(std::abs(random - 1) < 0.25);
    CHECK(blue < 0.3);
    CHECK(peak > 1.2);
}
