// Step 12.13: directions to rectangles and other parallelograms.
#include "chapters/12_distribution/rectangle_light.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/light_checks.hpp"
#include "tests/12_distribution/parallelogram_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::LongVec;
using test::near;
using test::Random;
using test::square_point;

namespace {

/// The top of the cube from -1 to 1, which shines down.
const QuadLight top{{-1, 1, -1}, {0, 0, 2}, {2, 0, 0}};

void check_mean(const QuadLight& light, const Vec3& from, std::uint64_t seed) {
    INFO(test::show(light) << " from " << from << ": the mean direction, by Lambert's formula");
    const LongVec a = LongVec(light.corner) - LongVec(from), ab(light.ab), ac(light.ac);
    std::vector<Vec3> directions;
    for (const auto& one : test::directions_to(light, from, seed)) directions.push_back(one.direction);
    const LongVec flow = test::exact_flow({a, a + ac, a + ab + ac, a + ab});
    test::check_mean_direction(directions, Vec3(flow / test::exact_angle(light, from)));
}

}  // namespace

TEST_CASE("the top of a cube from its middle", "[12.13]") {
    INFO(test::show(top) << " from the origin is a sixth of 4 pi");
    CHECK(near(solid_angle(top, Vec3(0)), 2 * pi / 3, gamma(256)));
    INFO("from above it is dark: the same, but negative");
    CHECK(near(solid_angle(top, {0, 2, 0}), -2 * pi / 3, gamma(256)));
    // A quarter of it, and from a corner of the bottom an eighth of the half space's third.
    CHECK(near(solid_angle(QuadLight{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, Vec3(0)), pi / 6, gamma(256)));
}

TEST_CASE("the six sides of a box are all around a viewer inside", "[12.13]") {
    Random random(12146);
    for (int i = 0; i < cases(300); ++i) {
        const Vec3 from = 0.95 * random.in_cube();
        Real sum = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (const Real side : {-1.0, 1.0}) {
                QuadLight face{Vec3(-1), Vec3(0), Vec3(0)};
                face.corner[axis] = side;
                face.ab[(axis + 1) % 3] = 2;
                face.ac[(axis + 2) % 3] = 2;
                sum += std::abs(solid_angle(face, from));
            }
        INFO("the cube from -1 to 1 around " << from);
        CHECK(near(sum, 4 * pi, 1e-11));
    }
}

TEST_CASE("a small rectangle far away is as large as it looks", "[12.13]") {
    // 3h by 3h, perpendicular to (1, 2, 2), 3 away: h², up to a part of some h.
    const Real h = 0x1p-26;
    const QuadLight light{{1, 2, 2}, h * Vec3(2, -2, 1), h * Vec3(2, 1, -2)};
    INFO(test::show(light) << " from the origin");
    CHECK(near(solid_angle(light, Vec3(0)) / (h * h), 1, 10 * h));
    const auto found = toward(light, Vec3(0), {0.5, 0.5});
    REQUIRE(found.has_value());
    CHECK(near(found->direction, Vec3(1, 2, 2) / 3.0, 10 * h));
    CHECK(near(found->pdf * h * h, 1, 10 * h));
}

TEST_CASE("from its dark side and from its plane a rectangle sends nothing", "[12.13]") {
    for (const Vec3& from : {Vec3(0, 2, 0), Vec3(3, 1, 0), Vec3(-1, 1, -1), Vec3(4, 1.5, 2)}) {
        INFO(test::show(top) << " from " << from);
        CHECK_FALSE(toward(top, from, Vec2(0.5)).has_value());
    }
}

TEST_CASE("directions to the top of a cube", "[12.13]") {
    for (const Vec2& numbers : {Vec2(0, 0), Vec2(0.25, 0.5), Vec2(0.75, 0.125), Vec2(0.999, 0.999)}) {
        const auto found = toward(top, Vec3(0), numbers);
        INFO(test::show(top) << " from the origin, random numbers " << numbers);
        REQUIRE(test::or_say(found.has_value(), "nothing"));
        INFO(test::show(*found));
        CHECK(near(length(found->direction), 1, gamma(16)));
        INFO("the pdf is 3/(2 pi) for all");
        CHECK(near(found->pdf, 1.5 / pi, gamma(256)));
        const Vec3 point = found->distance * found->direction;
        INFO("it leads to the point " << point << ", which should be in the square");
        CHECK(near(point.y, 1, gamma(128)));
        CHECK(std::abs(point.x) <= 1 + gamma(128));
        CHECK(std::abs(point.z) <= 1 + gamma(128));
    }
}

TEST_CASE("the mean direction to the top of a cube", "[12.13]") {
    // Each side of the square is seen under the angle acos(1/3), and its plane leans by 45 degrees: Lambert's
    // vector is √2·acos(1/3) upwards, and the solid angle 2 pi/3.
    std::vector<Vec3> directions;
    for (const auto& one : test::directions_to(top, Vec3(0), 12147)) directions.push_back(one.direction);
    test::check_mean_direction(directions, {0, std::sqrt(2.0) * std::acos(1 / 3.0) * 1.5 / pi, 0});
}

TEST_CASE("directions to rectangles are evenly dense", "[12.13]") {
    test::check_density(top, Vec3(0), 12148);
    test::check_density(top, {0.9, 0.8, 0.7}, 12149);
    test::check_density({{1, 2, -1}, {0, 0, 6}, {3, 0, 0}}, Vec3(0), 12150);
    test::check_density({{-5, 0.5, 1}, {0, 0, 1}, {9, 0, 0}}, Vec3(0), 12151);
    // Turned, and far away.
    test::check_density({{4, 4, 3}, {2, -2, 1}, {1, 2, 2}}, {7, 4, 0}, 12152);
    test::check_density({{4, 4, 3}, {2, -2, 1}, {1, 2, 2}}, {50, -60, -70}, 12153);
}

TEST_CASE("directions to parallelograms are evenly dense", "[12.13]") {
    test::check_density({{-1, 1, -1}, {0, 0, 2}, {2, 0, 1.5}}, {0.3, 0.2, 0.4}, 12154);
    test::check_density({{-1, 1, -1}, {-1, 0, 2}, {2, 0.5, 1}}, {0.3, 0.2, -0.4}, 12155);
}

TEST_CASE("the mean direction to parallelograms", "[12.13]") {
    check_mean(top, {0.9, 0.8, 0.7}, 12156);
    check_mean({{4, 4, 3}, {2, -2, 1}, {1, 2, 2}}, {7, 4, 0}, 12157);
    check_mean({{-1, 1, -1}, {0, 0, 2}, {2, 0, 1.5}}, {0.3, 0.2, 0.4}, 12158);
}

TEST_CASE("solid angles and directions of any parallelograms", "[12.13]") {
    Random random(12159);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 ab = random.in_cube(), beside = random.in_cube();
        const bool is_rectangle = i % 2 == 0;
        const Vec3 ac = is_rectangle ? cross(ab, beside) : beside;
        const QuadLight light{random.in_cube(), ab, ac};
        test::check_view(light, 2.0 * random.in_cube(), square_point(random));
    }
}
