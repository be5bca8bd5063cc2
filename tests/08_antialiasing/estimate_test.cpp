// Steps 08.9 to 08.11: how wrong a mean is, and where more samples help most.
#include "chapters/08_antialiasing/estimate.hpp"

#include "common/math/error.hpp"
#include "tests/08_antialiasing/statistics.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <numeric>

using namespace rt;
using rt::test::cases;
using rt::test::show;

namespace {

constexpr Real u = unit_roundoff;

/// Two independent numbers with the standard normal distribution (Box & Muller 1958).
Vec2 normal_pair(test::Random& random) {
    const Real r = std::sqrt(-2 * std::log(1 - random.uniform(0, 1))), phi = random.uniform(0, 2 * pi);
    return {r * std::cos(phi), r * std::sin(phi)};
}

void check_counts(const std::vector<Real>& deviations, long long total, const std::vector<int>& expected) {
    INFO(total << " samples for pixels of deviations " << show(deviations) << ": how many each gets");
    const std::vector<int> counts = sample_counts(deviations, total);
    CHECK(test::or_say(counts == expected, show(counts) + ", expected " + show(expected)));
}

void check_shares(const std::vector<Real>& deviations, long long total, const std::vector<Real>& expected) {
    const std::vector<Real> shares = sample_shares(deviations, total);
    INFO("the shares of " << total << " samples for pixels of deviations " << show(deviations));
    bool right = shares.size() == expected.size();
    for (std::size_t i = 0; right && i < shares.size(); ++i)
        right = std::abs(shares[i] - expected[i]) <= 8 * u * expected[i];
    CHECK(test::or_say(right, show(shares) + ", expected " + show(expected)));
}

void check_whole(const std::vector<Real>& shares, long long total, const std::vector<int>& expected) {
    INFO("the shares " << show(shares) << " of " << total << " samples in whole numbers");
    const std::vector<int> counts = whole_counts(shares, total);
    CHECK(test::or_say(counts == expected, show(counts) + ", expected " + show(expected)));
}

long long sum_of(const std::vector<int>& counts) {
    return std::accumulate(counts.begin(), counts.end(), 0LL);
}

/// The shares max(1, c · deviation) with c such that they sum to `total`: found by bisection.
std::vector<Real> shares(const std::vector<Real>& deviations, long long total) {
    Real low = 0, high = static_cast<Real>(total) / *std::max_element(deviations.begin(), deviations.end());
    const auto sum_at = [&](Real c) {
        Real sum = 0;
        for (const Real deviation : deviations) sum += std::max(Real(1), c * deviation);
        return sum;
    };
    for (int i = 0; i < 200; ++i) {
        const Real middle = (low + high) / 2;
        (sum_at(middle) < static_cast<Real>(total) ? low : high) = middle;
    }
    std::vector<Real> found;
    for (const Real deviation : deviations) found.push_back(std::max(Real(1), low * deviation));
    return found;
}

/// A picture of disks, one in each of its square blocks: black but for them.
struct Picture {
    int side = 0;   ///< pixels
    int block = 0;  ///< pixels
    std::vector<test::Disk> disks;

    Picture(int blocks, int block_side, Real radius, std::uint64_t seed)
        : side(blocks * block_side), block(block_side) {
        Random random = random_for(seed, 0, 0);
        for (int y = 0; y < blocks; ++y) {
            for (int x = 0; x < blocks; ++x)
                disks.push_back({(Vec2(x, y) + Vec2(0.5)) * Real(block) + random_point(random), radius});
        }
    }
    std::size_t size() const { return static_cast<std::size_t>(side * side); }
    Vec2 corner(std::size_t i) const {
        return {Real(i % static_cast<std::size_t>(side)), Real(i / static_cast<std::size_t>(side))};
    }
    const test::Disk& disk(std::size_t i) const {
        const int x = static_cast<int>(i) % side / block, y = static_cast<int>(i) / side / block;
        return disks[static_cast<std::size_t>(y * (side / block) + x)];
    }
    Real coverage(std::size_t i) const { return test::mean(disk(i), corner(i), corner(i) + Vec2(1)); }

    /// Sum over independent samples of a pixel; `pass` tells independent calls apart.
    Real sum(std::size_t i, int count, std::uint64_t pass) const {
        Random random = random_for(88, i, pass);
        Real found = 0;
        for (int k = 0; k < count; ++k) found += test::value(disk(i), corner(i) + random_point(random));
        return found;
    }

    /// Standard deviation of one sample in each pixel, as four samples of pass 0 see it.
    std::vector<Real> pilot() const {
        std::vector<Real> deviations;
        for (std::size_t i = 0; i < size(); ++i) {
            Random random = random_for(88, i, 0);
            std::vector<Vec3> colors;
            for (int k = 0; k < 4; ++k)
                colors.push_back(Vec3(test::value(disk(i), corner(i) + random_point(random))));
            deviations.push_back(2 * estimate(colors).standard_error.x);
        }
        return deviations;
    }
};

/// Student's t, over the pixels with an edge, of how much nearer to the nearer one of black and white they
/// are than their coverage. Errors of a mean without bias do not know in which direction that is.
Real t_of_contrast(const Picture& picture, const std::vector<Real>& colors) {
    std::vector<Real> contrast;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const Real coverage = picture.coverage(i);
        if (coverage <= 1e-9 || coverage >= 1 - 1e-9) continue;
        contrast.push_back(coverage < 0.5 ? coverage - colors[i] : colors[i] - coverage);
    }
    return test::t_statistic(contrast, 0);
}

Real mean_square_error(const Picture& picture, const std::vector<Real>& colors) {
    Real sum = 0;
    for (std::size_t i = 0; i < colors.size(); ++i)
        sum += (colors[i] - picture.coverage(i)) * (colors[i] - picture.coverage(i));
    return sum / static_cast<Real>(colors.size());
}

/// The deviations that a pilot found, raised where it may have missed something: no pixel's is less than that
/// of the eight around it, nor than the average.
std::vector<Real> cautious(const Picture& picture, const std::vector<Real>& found) {
    const Real average =
        std::accumulate(found.begin(), found.end(), Real(0)) / static_cast<Real>(found.size());
    std::vector<Real> deviations;
    for (int y = 0; y < picture.side; ++y) {
        for (int x = 0; x < picture.side; ++x) {
            Real most = average;
            for (int j = std::max(y - 1, 0); j <= std::min(y + 1, picture.side - 1); ++j) {
                for (int i = std::max(x - 1, 0); i <= std::min(x + 1, picture.side - 1); ++i)
                    most = std::max(most, found[static_cast<std::size_t>(j * picture.side + i)]);
            }
            deviations.push_back(most);
        }
    }
    return deviations;
}

/// Of up to 60 pixels, some of them 0 and one of them 1.
std::vector<Real> deviations_of_pixels(test::Random& random) {
    std::vector<Real> deviations;
    const std::size_t pixels = 1 + random.index(60);
    const Real spread = random.uniform(0, 6);
    for (std::size_t k = 0; k < pixels; ++k)
        deviations.push_back(random.index(5) == 0 ? 0 : random.magnitude(-spread, spread));
    deviations[random.index(pixels)] = 1;
    return deviations;
}

}  // namespace

// 08.9 ---------------------------------------------------------------------------------------------------

TEST_CASE("mean and standard error of 1, 2, 3, 4", "[08.9]") {
    const std::vector<Vec3> values = {{1, 7, -1}, {2, 7, -2}, {3, 7, -3}, {4, 7, -4}};
    const Estimate e = estimate(values);
    // s² = (2.25 + 0.25 + 0.25 + 2.25)/3 = 5/3, and a quarter of it is the mean's.
    const Real expected = std::sqrt(Real(5) / 12);
    INFO("the values (1, 7, -1), (2, 7, -2), (3, 7, -3) and (4, 7, -4)");
    {
        INFO("their mean");
        CHECK(e.mean == Vec3(2.5, 7, -2.5));
    }
    INFO("the standard error of the mean: in x it is s/√4 with s² = 5/3, in y 0, in z as in x");
    CHECK(test::near(e.standard_error.x, expected, 4 * u));
    CHECK(e.standard_error.y == 0);
    CHECK(e.standard_error.z == e.standard_error.x);
}

TEST_CASE("fewer than two values say nothing about their error", "[08.9]") {
    INFO("mean and standard error of no values, then of one");
    CHECK(estimate({}).mean == Vec3(0));
    CHECK(estimate({}).standard_error == Vec3(infinity));
    const Vec3 one(0.25, 0.5, 1);
    CHECK(estimate({&one, 1}).mean == one);
    CHECK(estimate({&one, 1}).standard_error == Vec3(infinity));
}

TEST_CASE("equal values have that value as their mean, and no error", "[08.9]") {
    const std::vector<Vec3> values(1000, Vec3(0.1, 1e8, 1e-8));
    const Estimate e = estimate(values);
    for (int i = 0; i < 3; ++i) {
        INFO("1000 times the value " << values[0][i] << ": the mean by the value, and the standard error");
        CHECK(test::near(e.mean[i] / values[0][i], 1, 2 * u));
        CHECK(test::near(e.standard_error[i], 0, u * values[0][i]));
    }
}

TEST_CASE("a small spread far from 0 does not cancel", "[08.9]") {
    // The values are 1e8 + d with |d| below 1e-6; subtracting 1e8 is exact, so the same values can be looked
    // at from near by.
    test::Random random(871);
    for (const std::size_t n : {2u, 10u, 1000u, 5000u}) {
        std::vector<Vec3> far, from_near;
        for (std::size_t i = 0; i < n; ++i) {
            far.push_back(Vec3(1e8) + 1e-6 * random.in_cube());
            from_near.push_back(far.back() - Vec3(1e8));
        }
        Vec3 mean(0), squares(0);
        for (const Vec3& d : from_near) mean += d / static_cast<Real>(n);
        for (const Vec3& d : from_near) squares += (d - mean) * (d - mean);
        const Estimate e = estimate(far);
        for (int i = 0; i < 3; ++i) {
            const Real error = std::sqrt(squares[i] / static_cast<Real>(n - 1) / static_cast<Real>(n));
            INFO(n << " values near 1e8 that differ by less than 1e-6: the mean less 1e8, and the standard "
                      "error");
            // The mean cannot be told better than doubles near 1e8 lie. The square's relative error is
            // n·u + n³u³κ², where κ = 1e14 is the mean by the spread (Chan, Golub & LeVeque 1983).
            const Real nu = static_cast<Real>(n) * u;
            CHECK(test::near(e.mean[i] - 1e8, mean[i], 2 * u * 1e8));
            CHECK(test::near(e.standard_error[i], error, (4 * nu + nu * nu * nu * 1e28) * error));
        }
    }
}

TEST_CASE("the true mean is within two standard errors as often as Student says", "[08.9]") {
    // For five values of a normal distribution |t| < 2 has the probability x(3 − x²)/2 with x = 2/√8 (four
    // degrees of freedom): 0.8839. For more and more values it approaches 0.9545.
    const int trials = cases(100'000);
    const Real expected = 0.8838834764831845;
    test::Random random(872);
    int within = 0;
    for (int i = 0; i < trials; ++i) {
        Vec3 values[5];
        for (Vec3& value : values) value = Vec3(normal_pair(random), 0);
        const Estimate e = estimate(values);
        within += std::abs(e.mean.x) < 2 * e.standard_error.x;
        within += std::abs(e.mean.y) < 2 * e.standard_error.y;
    }
    const Real part = static_cast<Real>(within) / (2 * trials);
    INFO("of " << 2 * trials
               << " means of five normally distributed values, the part within two standard errors");
    // Five standard deviations of the number found. With n for n − 1 it would be 0.852, and 0.32 away or
    // more.
    CHECK(test::near(part, expected, 5 * std::sqrt(expected * (1 - expected) / (2 * trials))));
}

// 08.10 --------------------------------------------------------------------------------------------------

TEST_CASE("of 9 samples deviations of 0, 1 and 3 get the shares 1, 2 and 6", "[08.10]") {
    check_shares({0, 1, 3}, 9, {1, 2, 6});
}

TEST_CASE("samples are shared out in proportion to the deviations", "[08.10]") {
    check_shares({1, 3}, 8, {2, 6});
    check_shares({0.25, 0.5, 0.25}, 16, {4, 8, 4});
    check_shares({5}, 17, {17});
    check_shares({1, 2, 1}, 7, {1.75, 3.5, 1.75});
}

TEST_CASE("no share is less than 1, and the others give up what that takes", "[08.10]") {
    check_shares({1, 2, 100}, 10, {1, 1, 8});
    // 9.9 · 5/48.9 is more than 1, but once the first has got its one there are 4 left, and 9.9 · 4/39.9 is
    // less.
    check_shares({9, 9.9, 30}, 5, {1, 1, 3});
    check_shares({0, 0, 7, 0}, 5, {1, 1, 2, 1});
}

TEST_CASE("without deviations all shares are the same, and infinite ones share what there is", "[08.10]") {
    check_shares({0, 0, 0}, 8, {8. / 3, 8. / 3, 8. / 3});
    check_shares({infinity, 1, infinity, 0}, 12, {5, 1, 5, 1});
    check_shares({1e300, 1e-300, 1e300}, 9, {4, 1, 4});
    check_shares({5e-324, 0, 1.5e-323}, 9, {2, 1, 6});
    check_shares({1.7e308, 1.7e308}, 10, {5, 5});
}

TEST_CASE("shares are the greater of 1 and the deviation times a number, the same for all", "[08.10]") {
    test::Random random(881);
    for (int i = 0; i < cases(300); ++i) {
        const std::vector<Real> deviations = deviations_of_pixels(random);
        const std::size_t pixels = deviations.size();
        const auto total = static_cast<long long>(pixels + 1 + random.index(3000));
        const std::vector<Real> found = sample_shares(deviations, total),
                                expected = shares(deviations, total);
        REQUIRE(found.size() == pixels);
        for (std::size_t k = 0; k < pixels; ++k) {
            INFO("pixel " << k << " of " << pixels << ", which share " << total
                          << " samples; its deviation is " << deviations[k]);
            REQUIRE(test::near(found[k], expected[k], 1e-9 * expected[k]));
        }
    }
}

// 08.11 --------------------------------------------------------------------------------------------------

TEST_CASE("shares of 3.5, 2.125 and 1.375 of 7 samples become 4, 2 and 1", "[08.11]") {
    check_whole({3.5, 2.125, 1.375}, 7, {4, 2, 1});
}

TEST_CASE("of shares that are not whole the greatest fractions are rounded up", "[08.11]") {
    check_whole({1.75, 3.5, 1.75}, 7, {2, 3, 2});
    check_whole({2, 1, 6}, 9, {2, 1, 6});
    check_whole({1, 1.625, 7.375}, 10, {1, 2, 7});
    check_whole({0.875, 10.5, 20.625}, 32, {1, 10, 21});
    check_whole({}, 10, {});
}

TEST_CASE("of equal fractions the first are rounded up", "[08.11]") {
    check_whole({1.5, 1.5, 1.5, 1.5}, 6, {2, 2, 1, 1});
    check_whole({2.25, 2.75, 2.25, 2.75}, 10, {2, 3, 2, 3});
    check_whole({2.75, 1.25, 2.75, 1.25}, 8, {3, 1, 3, 1});
    check_whole(std::vector<Real>(40, 1.25), 50, [] {
        std::vector<int> counts(40, 1);
        std::fill_n(counts.begin(), 10, 2);
        return counts;
    }());
}

TEST_CASE("the counts of pixels come from their deviations", "[08.11]") {
    check_counts({0, 1, 3}, 9, {1, 2, 6});
    // 3.5, 2.1 and 1.4.
    check_counts({5, 3, 2}, 7, {4, 2, 1});
    check_counts({0, 0, 0}, 8, {3, 3, 2});
    check_counts({1, 5, 2}, 3, {1, 1, 1});
    check_counts({1, 5, 2}, 2, {1, 1, 1});
    check_counts({1, 5, 2}, 0, {1, 1, 1});
    check_counts({}, 10, {});
}

TEST_CASE("all the samples are spent, and no pixel gets one more or less than its share", "[08.11]") {
    test::Random random(881);
    for (int i = 0; i < cases(300); ++i) {
        const std::vector<Real> deviations = deviations_of_pixels(random);
        const std::size_t pixels = deviations.size();
        const auto total = static_cast<long long>(pixels + random.index(3000));
        const std::vector<int> counts = sample_counts(deviations, total);
        INFO(pixels << " pixels, " << total << " samples: " << show(counts));
        {
            INFO("how many counts there are, and their sum");
            REQUIRE(counts.size() == pixels);
            REQUIRE(sum_of(counts) == total);
        }
        const std::vector<Real> share = shares(deviations, total);
        for (std::size_t k = 0; k < pixels; ++k) {
            const bool right = counts[k] >= 1 && std::abs(counts[k] - share[k]) < 1 + 1e-9;
            INFO("pixel " << k << ": deviation " << deviations[k] << ", share " << share[k] << ", got "
                          << counts[k]);
            REQUIRE(test::or_say(right,
                                 counts[k] < 1 ? "it got none" : "it got one more or less than its share"));
        }
    }
}

TEST_CASE("adaptive sampling has no bias in a million samples, if its pilot is thrown away", "[08.11]") {
    const Picture picture(28, 8, 2.3, 882);
    const int mean = 16;
    const auto total = static_cast<long long>(picture.size()) * mean;
    const std::vector<int> counts = sample_counts(picture.pilot(), total);
    REQUIRE(counts.size() == picture.size());
    REQUIRE(sum_of(counts) == total);
    std::vector<Real> uniform, adaptive, reused;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        // 4 + 16 samples a pixel on the average, each of the three times: a million.
        uniform.push_back(picture.sum(i, 4 + mean, 1) / (4 + mean));
        const Real fresh = picture.sum(i, counts[i], 2);
        adaptive.push_back(fresh / counts[i]);
        reused.push_back((picture.sum(i, 4, 0) + fresh) / (4 + counts[i]));
    }
    const Real t_uniform = t_of_contrast(picture, uniform), t_adaptive = t_of_contrast(picture, adaptive),
               t_reused = t_of_contrast(picture, reused);
    INFO("by how many of its standard errors the contrast of edges is off (Student's t): uniform "
         << t_uniform << ", adaptive " << t_adaptive << ", adaptive with the pilot's samples " << t_reused);
    CHECK(std::abs(t_uniform) < test::t_limit);
    CHECK(std::abs(t_adaptive) < test::t_limit);
    // Where four samples happened to see no edge there is only one more, and the four that decided so make
    // the pixel blacker or whiter than it is.
    CHECK(std::abs(t_reused) > 2 * test::t_limit);
}

TEST_CASE("adaptive sampling makes smaller errors with as many samples, where few pixels have edges",
          "[08.11]") {
    const int mean = 12, pictures = 6;
    Real before = 0, after = 0;
    for (std::uint64_t seed = 0; seed < pictures; ++seed) {
        const Picture picture(1, 96, 30, seed);
        const std::vector<int> counts =
            sample_counts(cautious(picture, picture.pilot()), static_cast<long long>(picture.size()) * mean);
        REQUIRE(counts.size() == picture.size());
        std::vector<Real> uniform, adaptive;
        for (std::size_t i = 0; i < picture.size(); ++i) {
            uniform.push_back(picture.sum(i, 4 + mean, 1) / (4 + mean));
            adaptive.push_back(picture.sum(i, counts[i], 2) / counts[i]);
        }
        before += mean_square_error(picture, uniform) / pictures;
        after += mean_square_error(picture, adaptive) / pictures;
    }
    before = std::sqrt(before);
    after = std::sqrt(after);
    INFO("RMS error of 16 samples a pixel: uniform " << before << ", adaptive " << after);
    // About half as great; single pixels, at which the pilot and their few samples missed what is in a
    // corner, make it uncertain by a tenth.
    CHECK(after < 0.75 * before);
}
