// Step 08.12: Halton's points.
#include "chapters/08_antialiasing/samples.hpp"

#include "common/math/error.hpp"
#include "tests/08_antialiasing/statistics.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <vector>

using namespace rt;
using rt::test::cases;

namespace {

constexpr Real u = unit_roundoff;

void check_inverse(int index, int base, Real expected) {
    INFO("the digits of " << index << " in base " << base << ", mirrored at the point");
    CHECK(test::near(radical_inverse(index, base), expected, 4 * u));
}

/// How many of the points lie in each of `columns` × `rows` equal parts of the square, moved back by `by`.
std::vector<int> points_in(const std::vector<PixelSample>& samples, const Vec2& by, int columns, int rows) {
    std::vector<int> counts(static_cast<std::size_t>(columns * rows));
    for (const auto& sample : samples) {
        // A little to the right and down, because points lie on the edges of the parts.
        const Vec2 at = glm::fract(sample.at - by + Vec2(1e-9));
        const int column = static_cast<int>(at.x * columns), row = static_cast<int>(at.y * rows);
        ++counts[static_cast<std::size_t>(row * columns + column)];
    }
    return counts;
}

}  // namespace

TEST_CASE("6 is 110 in base 2 and 20 in base 3: mirrored, 3/8 and 2/9", "[08.12]") {
    check_inverse(6, 2, 3. / 8);
    check_inverse(6, 3, 2. / 9);
}

TEST_CASE("each number falls into a gap that those before it have left", "[08.12]") {
    const Real halves[] = {0, 1. / 2, 1. / 4, 3. / 4, 1. / 8, 5. / 8, 3. / 8, 7. / 8};
    for (int i = 0; i < 8; ++i) check_inverse(i, 2, halves[i]);
    const Real thirds[] = {0, 1. / 3, 2. / 3, 1. / 9, 4. / 9, 7. / 9, 2. / 9, 5. / 9, 8. / 9};
    for (int i = 0; i < 9; ++i) check_inverse(i, 3, thirds[i]);
    check_inverse(1234, 10, 0.4321);
    check_inverse(4, 5, 4. / 5);
    check_inverse((1 << 30) - 1, 2, 1 - std::ldexp(1., -30));
}

TEST_CASE("four of Halton's points are at their places, moved by one random point on the torus", "[08.12]") {
    const Vec2 points[] = {{0, 0}, {1. / 2, 1. / 3}, {1. / 4, 2. / 3}, {3. / 4, 1. / 9}};
    for (std::uint64_t which = 0; which < 20; ++which) {
        Random random = random_for(1, which, 0);
        const std::vector<PixelSample> samples = halton_samples(4, random);
        REQUIRE(samples.size() == 4);
        const Vec2 shift = random_point(random);
        for (std::size_t i = 0; i < 4; ++i) {
            INFO("point " << i << ", counted from 0, is at " << points[i] << "; moved by " << shift
                          << " on the torus it is at " << samples[i].at);
            CHECK(test::near(torus_distance(samples[i].at, glm::fract(points[i] + shift)), 0, 8 * u));
            INFO("what it weighs");
            CHECK(test::near(samples[i].weight, 0.25, 0));
        }
    }
}

TEST_CASE("of 6, 36 or 216 of Halton's points each of as many equal parts has one", "[08.12]") {
    int columns = 1, rows = 1;
    for (int power = 1; power <= 3; ++power) {
        columns *= 2, rows *= 3;
        Random random = random_for(2, 7, 0);
        const std::vector<PixelSample> samples = halton_samples(columns * rows, random);
        const std::vector<int> counts = points_in(samples, random_point(random), columns, rows);
        INFO(columns * rows << " points in " << columns << " columns and " << rows
                            << " rows: how many each part has");
        CHECK(test::or_say(counts == std::vector<int>(counts.size(), 1), test::show(counts)));
    }
}

TEST_CASE("Halton's points lie in the pixel, and weigh the same", "[08.12]") {
    for (int count = 1; count <= 200; ++count) {
        const std::vector<PixelSample> samples = halton_samples(count, random_for(3, 4, 5));
        INFO(count << " points");
        REQUIRE(samples.size() == static_cast<std::size_t>(count));
        for (const auto& sample : samples) {
            const bool inside = sample.at.x >= 0 && sample.at.x < 1 && sample.at.y >= 0 && sample.at.y < 1;
            INFO("a sample at " << sample.at << " that weighs " << sample.weight);
            REQUIRE(test::or_say(inside, "it lies outside of the pixel"));
            REQUIRE(test::near(sample.weight * count, 1, 2 * u));
        }
    }
}

TEST_CASE("the mean of Halton's points is the coverage", "[08.12]") {
    const int patterns = cases(2000);
    const auto t = [&](const auto& shape) {
        return std::abs(test::t_of(shape, patterns,
                                   [](std::uint64_t i) { return halton_samples(9, random_for(9, i, 0)); }));
    };
    INFO(
        "by how many of its standard errors the mean is off (Student's t), for a half-plane, a disk, a zone "
        "plate");
    CHECK(t(test::HalfPlane{{0.8, 0.6}, 0.55}) < test::t_limit);
    CHECK(t(test::Disk{{0.2, 0.9}, 0.6}) < test::t_limit);
    CHECK(t(test::ZonePlate{{-0.3, 0.1}, 12}) < test::t_limit);
}
