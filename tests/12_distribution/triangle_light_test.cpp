// Step 12.12: directions to triangles.
#include "chapters/12_distribution/triangle_light.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/light_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::directions_to;
using test::LongVec;
using test::near;
using test::Random;
using test::square_point;

namespace {

/// Seen from the origin it is an eighth of all directions; its corners run counterclockwise from there.
const TriangleLight octant{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
const TriangleLight turned_octant{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

void check_density(const TriangleLight& light, const Vec3& from, std::uint64_t seed) {
    INFO(test::show(light) << " from " << from << ", in 16 smaller triangles");
    const test::LongTriangle t = test::long_triangle(light, from);
    std::vector<int> counts(32, 0);
    for (const LightDirection& one : directions_to(light, from, seed)) {
        const Vec2 at = test::place_in(test::beyond_corner(one, t.a), t.ab, t.ac);
        ++counts[test::part_of_triangle(at.x, at.y)];
    }
    test::check_counts(counts, test::parts_of_triangle(t), cases(20000));
}

void check_mean(const TriangleLight& light, const Vec3& from, std::uint64_t seed) {
    INFO(test::show(light) << " from " << from << ": the mean direction, by Lambert's formula");
    const test::LongTriangle t = test::long_triangle(light, from);
    std::vector<Vec3> directions;
    for (const LightDirection& one : directions_to(light, from, seed)) directions.push_back(one.direction);
    const LongVec flow = test::exact_flow({t.a, t.b, t.c});
    test::check_mean_direction(directions, Vec3(flow / test::exact_angle(t)));
}

}  // namespace

TEST_CASE("an eighth of all directions", "[12.12]") {
    INFO("the triangle of (1, 0, 0), (0, 0, 1) and (0, 1, 0), from the origin: y/x is 1/1");
    CHECK(near(solid_angle(octant, Vec3(0)), pi / 2, gamma(64)));
    INFO("from its dark side it is negative");
    CHECK(near(solid_angle(turned_octant, Vec3(0)), -pi / 2, gamma(64)));
}

TEST_CASE("the faces of a regular tetrahedron from its middle", "[12.12]") {
    // Four of them make 4 pi. The denominator is 0.
    const Vec3 p(1, 1, 1), q(1, -1, -1), r(-1, 1, -1), s(-1, -1, 1);
    for (const TriangleLight& face : {TriangleLight{p, r, q}, {p, s, r}, {p, q, s}, {q, r, s}}) {
        INFO(test::show(face) << " from the origin");
        CHECK(near(std::abs(solid_angle(face, Vec3(0))), pi, gamma(128)));
    }
    INFO("one face, and the same with its dark side inside: the sign should change");
    CHECK(near(solid_angle(TriangleLight{p, r, q}, Vec3(0)), -solid_angle(TriangleLight{p, q, r}, Vec3(0)),
               gamma(256)));
}

TEST_CASE("the four faces of a tetrahedron are all around a viewer inside", "[12.12]") {
    Random random(12122);
    int greater_than_pi = 0;
    for (int i = 0; i < cases(1000); ++i) {
        const Vec3 p = random.in_cube(), q = random.in_cube(), r = random.in_cube(), s = random.in_cube();
        const Real volume = std::abs(dot(s - p, cross(q - p, r - p)));
        Vec4 weight;
        for (int k = 0; k < 4; ++k) weight[k] = random.uniform(0.05, 1);
        weight /= weight.x + weight.y + weight.z + weight.w;
        const Vec3 from = weight.x * p + weight.y * q + weight.z * r + weight.w * s;
        if (volume < 0.05) continue;
        Real sum = 0;
        for (const TriangleLight& face : {TriangleLight{p, r, q}, {p, s, r}, {p, q, s}, {q, r, s}}) {
            // Which way it is turned is no matter here.
            const Real one = std::abs(solid_angle(face, from));
            greater_than_pi += one > pi;
            sum += one;
        }
        INFO("from " << from << " inside the tetrahedron of " << p << ", " << q << ", " << r << ", " << s);
        // The pyramids' heights are at least a part 0.05/4 of the tetrahedron's, and that is at least a
        // 70th of the sides, which are at most √12.
        CHECK(near(sum, 4 * pi, 1e-10));
    }
    CHECK(greater_than_pi >= 1);
}

TEST_CASE("a small triangle far away is as large as it looks", "[12.12]") {
    // Perpendicular to (1, 2, 2), 3 away, with two sides of 3h at a right angle: 9h²/2 / 9, up to a part of
    // some h. With three corners instead of two sides, it would be lost in rounding.
    const Real h = 0x1p-26;
    const Vec3 a(1, 2, 2);
    const TriangleLight light{a, a + h * Vec3(2, 1, -2), a + h * Vec3(2, -2, 1)};
    INFO(test::show(light) << " from the origin");
    CHECK(near(solid_angle(light, Vec3(0)) / (h * h / 2), 1, 10 * h));
    const auto found = toward(light, Vec3(0), {0.5, 0.5});
    REQUIRE(found.has_value());
    CHECK(near(found->direction, Vec3(1, 2, 2) / 3.0, 10 * h));
    CHECK(near(found->distance, 3, 30 * h));
    CHECK(near(found->pdf * (h * h / 2), 1, 10 * h));
}

TEST_CASE("from its dark side and from its plane a triangle sends nothing", "[12.12]") {
    {
        INFO(test::show(turned_octant) << " from the origin, on its dark side");
        CHECK(test::or_say(!toward(turned_octant, Vec3(0), Vec2(0.5)), "a direction, expected nothing"));
    }
    const TriangleLight flat{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}};
    for (const Vec3& from : {Vec3(0), Vec3(4, 4, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}) {
        INFO(test::show(flat) << " from " << from << " in its plane");
        CHECK(near(solid_angle(flat, from), 0, 0));
        CHECK_FALSE(toward(flat, from, Vec2(0.5)).has_value());
    }
}

TEST_CASE("directions to an eighth of all directions", "[12.12]") {
    for (const Vec2& numbers : {Vec2(0, 0), Vec2(0.25, 0.5), Vec2(0.75, 0.125), Vec2(0.999, 0.999)}) {
        const auto found = toward(octant, Vec3(0), numbers);
        INFO(test::show(octant) << " from the origin, random numbers " << numbers);
        REQUIRE(test::or_say(found.has_value(), "nothing"));
        INFO(test::show(*found));
        const Vec3 w = found->direction;
        CHECK(near(length(w), 1, gamma(16)));
        INFO("the pdf is 2/pi for all");
        CHECK(near(found->pdf, 2 / pi, gamma(64)));
        INFO("all coordinates are positive, and the triangle's plane is x + y + z = 1");
        for (int k = 0; k < 3; ++k) CHECK(w[k] >= -gamma(64));
        CHECK(near(found->distance * (w.x + w.y + w.z), 1, gamma(256)));
    }
}

TEST_CASE("the mean direction to an eighth of all directions", "[12.12]") {
    // Lambert's vector is pi/4 (1, 1, 1), and the solid angle pi/2.
    std::vector<Vec3> directions;
    for (const LightDirection& one : directions_to(octant, Vec3(0), 12123))
        directions.push_back(one.direction);
    test::check_mean_direction(directions, Vec3(0.5));
}

TEST_CASE("directions to triangles are evenly dense", "[12.12]") {
    check_density(octant, Vec3(0), 12124);
    // From near a corner the triangle's parts look very different.
    check_density(octant, {0.8, 0.1, 0}, 12125);
    check_density({octant.b, octant.c, octant.a}, {0.8, 0.1, 0}, 12126);
    check_density({octant.c, octant.a, octant.b}, {0.8, 0.1, 0}, 12127);
    check_density({{-1, -1, 0}, {0, 2, 0}, {2, -1, 0}}, {0.1, 0.2, -0.1}, 12128);
}

TEST_CASE("the mean direction to triangles", "[12.12]") {
    check_mean(octant, {0.8, 0.1, 0}, 12129);
    check_mean({{-1, -1, 0}, {0, 2, 0}, {2, -1, 0}}, {0.1, 0.2, -0.1}, 12130);
    check_mean({{-1, -1, 0}, {0, 2, 0}, {2, -1, 0}}, {5, 4, -2}, 12131);
}

TEST_CASE("solid angles and directions of any triangles", "[12.12]") {
    Random random(12132);
    for (int i = 0; i < cases(2000); ++i) {
        const TriangleLight light{random.in_cube(), random.in_cube(), random.in_cube()};
        const Vec3 from = 2.0 * random.in_cube();
        const Vec2 numbers = square_point(random);
        const test::LongTriangle t = test::long_triangle(light, from);
        const Real expected = static_cast<Real>(test::exact_angle(t));
        const Real bound = gamma(64) * test::angle_condition(t, false);
        INFO(test::show(light) << " from " << from << ", random numbers " << numbers);
        CHECK(near(solid_angle(light, from), expected, bound));
        if (std::abs(expected) <= 4 * bound) continue;
        const auto found = toward(light, from, numbers);
        INFO("the solid angle is " << expected);
        REQUIRE(found.has_value() == (expected > 0));
        if (!found) continue;
        CHECK(near(found->pdf * expected, 1, 2 * bound / expected));
        CHECK(near(length(found->direction), 1, gamma(16)));
        CHECK(test::outside(*found, t) <= gamma(64) * 6);
    }
}
