// Spheres around points: Ritter's, the one through four points, the smallest, and where a ray is inside.
#include "chapters/13_hierarchies/sphere_around.hpp"
#include "tests/catch.hpp"
#include "tests/show.hpp"
#include "tests/stability/volumes.hpp"
#include "tests/support.hpp"

using namespace rt;
using rt::test::cases;
using rt::test::near;
using rt::test::or_say;
using rt::test::Random;
using rt::test::show;

namespace {

void check_sphere(const BoundingSphere& actual, const Vec3& center, Real radius, Real bound = 1e-12) {
    {
        INFO("the centre");
        CHECK(near(actual.center, center, bound));
    }
    INFO("the radius");
    CHECK(near(actual.radius, radius, bound));
}

/// The first of the points that is outside, in words; empty if none is.
std::string left_out(const BoundingSphere& sphere, const std::vector<Vec3>& points, Real slack) {
    for (const Vec3& point : points) {
        const Real distance = length(point - sphere.center);
        if (!(distance <= sphere.radius + slack))
            return show(point) + " is outside of the " + show(sphere) + ": its distance from the centre is " +
                   show(distance);
    }
    return {};
}

void check_contains(const BoundingSphere& sphere, const std::vector<Vec3>& points, Real slack = 1e-12) {
    const std::string outside = left_out(sphere, points, slack);
    CHECK(or_say(outside.empty(), outside));
}

/// A right angle at the first point, and one point above the middle of the side across.
const std::vector<Vec3> tent{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {2, 1.5, 3}};

void check_part(const BoundingSphere& sphere, const Ray& ray, Interval range, const Interval& expected) {
    INFO("the part of the " << ray << " in " << range << " that is inside the " << sphere);
    const std::optional<Interval> part = clip(sphere, ray, range);
    REQUIRE(or_say(part.has_value(), "it misses the sphere"));
    {
        INFO("where it begins");
        CHECK(near(part->min, expected.min, 1e-12));
    }
    INFO("where it ends");
    CHECK(near(part->max, expected.max, 1e-12));
}

void check_missed(const BoundingSphere& sphere, const Ray& ray, Interval range = {}) {
    INFO("the part of the " << ray << " in " << range << " that is inside the " << sphere
                            << ", expected nothing");
    const std::optional<Interval> part = clip(sphere, ray, range);
    CHECK(or_say(!part.has_value(), "it is " + show(part.value_or(Interval{}))));
}

}  // namespace

TEST_CASE("by hand: Ritter's sphere around four points", "[13.13]") {
    // The farthest from (0, 0, 0) is (4, 0, 0), from there (0, 3, 0): radius 2.5 around (2, 1.5, 0). The last
    // point is 3 from there: radius 2.75, and the centre moves by 0.25.
    INFO("Ritter's sphere around the points (0, 0, 0), (4, 0, 0), (0, 3, 0) and (2, 1.5, 3)");
    check_sphere(sphere_by_ritter(tent), {2, 1.5, 0.25}, 2.75);
}

TEST_CASE("Ritter's sphere of few points", "[13.13]") {
    {
        INFO("Ritter's sphere of no points: expected one with a radius less than 0");
        CHECK(sphere_by_ritter({}).radius < 0);
    }
    const std::vector<Vec3> one{{1, 2, 3}}, two{{1, 2, 3}, {5, 2, 3}}, same{{1, 2, 3}, {1, 2, 3}};
    {
        INFO("Ritter's sphere of the point (1, 2, 3)");
        check_sphere(sphere_by_ritter(one), {1, 2, 3}, 0);
    }
    {
        INFO("Ritter's sphere of the points (1, 2, 3) and (5, 2, 3)");
        check_sphere(sphere_by_ritter(two), {3, 2, 3}, 2);
    }
    INFO("Ritter's sphere of (1, 2, 3) twice");
    check_sphere(sphere_by_ritter(same), {1, 2, 3}, 0);
}

TEST_CASE("the first diameter is from the point that is farthest from the first", "[13.13]") {
    // From (0, 0, 0) the farthest is (6, 0, 0), and from there (−1, 5, 0): (0, 0, 0) is inside.
    const std::vector<Vec3> points{{0, 0, 0}, {6, 0, 0}, {-1, 5, 0}};
    INFO("Ritter's sphere of the points (0, 0, 0), (6, 0, 0) and (-1, 5, 0)");
    check_sphere(sphere_by_ritter(points), {2.5, 2.5, 0}, std::sqrt(Real(74)) / 2);
}

TEST_CASE("Ritter's sphere grows for each point that is outside, in their order", "[13.13]") {
    // Radius 5 around 0; (0, 7, 0) makes it 6 around (0, 1, 0); (0, −5, 0) is on that, (0, 0, 8) is √65 away.
    const std::vector<Vec3> points{{-5, 0, 0}, {5, 0, 0}, {0, 7, 0}, {0, -5, 0}, {0, 0, 8}};
    const Real distance = std::sqrt(Real(65)), by = (distance - 6) / 2;
    INFO("Ritter's sphere of (-5, 0, 0), (5, 0, 0), (0, 7, 0), (0, -5, 0) and (0, 0, 8)");
    check_sphere(sphere_by_ritter(points), Vec3(0, 1, 0) + by / distance * Vec3(0, -1, 8), 6 + by);
}

TEST_CASE("Ritter's sphere contains all points", "[13.13]") {
    Random random(1313);
    for (int k = 0; k < cases(1000); ++k) {
        const std::vector<Vec3> points = stability::cloud_families()[0].make(random);
        INFO("Ritter's sphere of " << points.size() << " points in a cube of edge 2");
        check_contains(sphere_by_ritter(points), points);
    }
}

TEST_CASE("by hand: the sphere through four points", "[13.14]") {
    // The first three have theirs at (2, 1.5, 0) with radius 2.5; at a height z the last is 3 − z away:
    // 2.5² + z² = (3 − z)², and z = 11/24.
    const Real z = 11.0 / 24;
    INFO("the sphere through (0, 0, 0), (4, 0, 0), (0, 3, 0) and (2, 1.5, 3)");
    check_sphere(sphere_through(tent), {2, 1.5, z}, 3 - z);
}

TEST_CASE("the smallest sphere through fewer points", "[13.14]") {
    {
        INFO("the sphere through no points: expected one with a radius less than 0");
        CHECK(sphere_through({}).radius < 0);
    }
    const std::span<const Vec3> all(tent);
    {
        INFO("the sphere through the point (4, 0, 0) alone");
        check_sphere(sphere_through(all.subspan(1, 1)), {4, 0, 0}, 0);
    }
    {
        INFO("the smallest sphere through (4, 0, 0) and (0, 3, 0)");
        check_sphere(sphere_through(all.subspan(1, 2)), {2, 1.5, 0}, 2.5);
    }
    {
        INFO("the smallest sphere through (0, 0, 0), (4, 0, 0) and (0, 3, 0)");
        check_sphere(sphere_through(all.first(3)), {2, 1.5, 0}, 2.5);
    }
    // Equal sides in the plane x + y + z = 1, far from right angles.
    const std::vector<Vec3> corner{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    INFO("the smallest sphere through (1, 0, 0), (0, 1, 0) and (0, 0, 1)");
    check_sphere(sphere_through(corner), Vec3(1.0 / 3), std::sqrt(2.0 / 3));
}

TEST_CASE("a point in the line or plane of those before it adds nothing", "[13.14]") {
    const std::vector<Vec3> twice{{1, 0, 0}, {3, 0, 0}, {3, 0, 0}}, line{{1, 0, 0}, {3, 0, 0}, {2, 0, 0}},
        square{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}};
    {
        INFO("the sphere through (1, 0, 0), (3, 0, 0) and (3, 0, 0) again");
        check_sphere(sphere_through(twice), {2, 0, 0}, 1);
    }
    {
        INFO("the sphere through (1, 0, 0), (3, 0, 0) and (2, 0, 0), which is between them");
        check_sphere(sphere_through(line), {2, 0, 0}, 1);
    }
    INFO("the sphere through the corners of a square of edge 2 in the plane z = 0");
    check_sphere(sphere_through(square), {1, 1, 0}, std::sqrt(Real(2)));
}

TEST_CASE("all points are on the sphere through them", "[13.14]") {
    Random random(1314);
    for (int k = 0; k < cases(2000); ++k) {
        std::vector<Vec3> points;
        const std::size_t count = 2 + random.index(3);
        while (points.size() < count) points.push_back(10.0 + random.in_cube());
        const BoundingSphere sphere = sphere_through(points);
        INFO("the sphere through " << points);
        for (const Vec3& point : points) {
            INFO("the distance of " << point << " from the centre, expected the radius");
            CHECK(near(length(point - sphere.center), sphere.radius,
                       1e-10 * (1 + sphere.radius * sphere.radius)));
        }
    }
}

TEST_CASE("by hand: the smallest sphere of four points", "[13.15]") {
    const Real z = 11.0 / 24;
    const SmallestSphere smallest = smallest_sphere(tent);
    INFO("the smallest sphere around (0, 0, 0), (4, 0, 0), (0, 3, 0) and (2, 1.5, 3)");
    check_sphere(smallest.sphere, {2, 1.5, z}, 3 - z);
    INFO("how many points hold it: 3, or 4 with (0, 0, 0), which is on it, too");
    CHECK(smallest.support.size() >= 3);
    CHECK(smallest.support.size() <= 4);
}

TEST_CASE("a sphere that two points hold", "[13.15]") {
    // An obtuse angle: the sphere through all three would have radius 25.5.
    const std::vector<Vec3> points{{1, 0, 0}, {-5, 0, 0}, {5, 0, 0}, {0, 1, 0}, {0, 4, 0}, {0, 0, -3}};
    const SmallestSphere smallest = smallest_sphere(points);
    INFO("the smallest sphere around six points, of which (-5, 0, 0) and (5, 0, 0) are farthest apart");
    check_sphere(smallest.sphere, {0, 0, 0}, 5);
    INFO("which points hold it");
    REQUIRE(smallest.support.size() == 2);
    CHECK(near(smallest.support[0] + smallest.support[1], Vec3(0), 0));
}

TEST_CASE("a sphere that four points hold", "[13.15]") {
    // Four corners of a cube of edge 2, and points inside; before them a few that are needed for a while.
    const std::vector<Vec3> points{{0.5, 0, 0}, {-1, 0.5, 0.1}, {0.9, -0.9, 0.9}, {1, 1, 1},
                                   {1, -1, -1}, {0, 0, 0.3},    {-1, 1, -1},      {-1, -1, 1}};
    const SmallestSphere smallest = smallest_sphere(points);
    INFO("the smallest sphere around four corners of the cube from -1 to 1, and four points between them");
    check_sphere(smallest.sphere, Vec3(0), std::sqrt(Real(3)));
    INFO("how many points hold it");
    CHECK(smallest.support.size() == 4);
}

TEST_CASE("the smallest sphere of no, one and equal points", "[13.15]") {
    {
        INFO("the smallest sphere of no points: expected one with a radius less than 0, that nothing holds");
        CHECK(smallest_sphere({}).sphere.radius < 0);
        CHECK(smallest_sphere({}).support.size() == 0);
    }
    const std::vector<Vec3> same(7, Vec3(1, 2, 3));
    INFO("the smallest sphere of (1, 2, 3) seven times");
    check_sphere(smallest_sphere(same).sphere, {1, 2, 3}, 0);
}

TEST_CASE("no sphere around the points is smaller, and its support shows why", "[13.15]") {
    Random random(1315);
    for (int k = 0; k < cases(1000); ++k) {
        const std::vector<Vec3> points = stability::cloud_families()[0].make(random);
        const SmallestSphere smallest = smallest_sphere(points);
        INFO(points.size() << " points in a cube of edge 2");
        check_contains(smallest.sphere, points);
        {
            INFO("how many points hold the sphere: at most 4");
            REQUIRE(smallest.support.size() >= 1);
            REQUIRE(smallest.support.size() <= 4);
        }
        for (const Vec3& point : smallest.support) {
            INFO("how far the point " << point << " of the support is from the centre, expected the radius");
            CHECK(near(length(point - smallest.sphere.center), smallest.sphere.radius, 1e-11));
        }
        INFO("how far the centre is from the nearest place between the points of the support "
             << smallest.support);
        CHECK(near(stability::distance_from_hull(smallest.sphere.center, smallest.support), 0, 1e-9));
    }
}

TEST_CASE("by hand: a ray through a sphere", "[13.16]") {
    // The line x = 3 passes the centre at a distance of 3: within 5 it is 4 before and behind.
    const BoundingSphere sphere{{0, 0, 10}, 5};
    check_part(sphere, {{3, 0, 0}, {0, 0, 2}}, {}, {3, 7});
    check_part(sphere, {{3, 0, 20}, {0, 0, -1}}, {}, {6, 14});
    check_part(sphere, {{0, 0, 0}, {0, 0, 1}}, {}, {5, 15});
}

TEST_CASE("the part of a ray in a sphere is cut to the range", "[13.16]") {
    const BoundingSphere sphere{{0, 0, 10}, 5};
    const Ray ray{{3, 0, 0}, {0, 0, 2}};
    check_part(sphere, ray, {4, infinity}, {4, 7});
    check_part(sphere, ray, {0, 5}, {3, 5});
    check_part(sphere, ray, {4, 5}, {4, 5});
    check_part(sphere, {{3, 0, 10}, {0, 0, 2}}, {}, {0, 2});
    check_part(sphere, {{3, 0, 10}, {0, 0, 2}}, {-infinity, infinity}, {-2, 2});
    check_missed(sphere, ray, {0, 2.9});
    check_missed(sphere, ray, {7.1, infinity});
    check_missed(sphere, {{3, 0, 20}, {0, 0, 2}});
}

TEST_CASE("rays beside a sphere, and an empty sphere, are missed", "[13.16]") {
    check_missed({{0, 0, 10}, 5}, {{5.001, 0, 0}, {0, 0, 1}});
    check_missed({{0, 0, 10}, 5}, {{4, 4, 0}, {0, 0, 1}});
    check_missed({}, {{0, 0, 5}, {0, 0, -1}});
    check_missed({{0, 0, 0}, -1}, {{0.5, 0, 5}, {0, 0, -1}});
}

TEST_CASE("a sphere of radius 0 is met where the ray goes through it", "[13.16]") {
    check_part({{0, 0, 10}, 0}, {{0, 0, 0}, {0, 0, 4}}, {}, {2.5, 2.5});
}

TEST_CASE("a ray that touches the sphere is not lost by rounding", "[13.16]") {
    // (3, 4, 0) is on the sphere, and whatever is across it goes along the sphere there.
    const BoundingSphere sphere{{0, 0, 0}, 5};
    for (int m = 1; m <= 12; ++m)
        for (int n = -12; n <= 12; ++n)
            for (const Real times : {49, 103, 197}) {
                const Vec3 across(4 * m, -3 * m, n);
                const Ray ray{Vec3(3, 4, 0) - across, times * across};
                INFO("the " << ray
                            << " touches the sphere of radius 5 around the origin at (3, 4, 0), where t = 1/"
                            << times);
                const std::optional<Interval> part = clip(sphere, ray, {});
                CHECK(or_say(part.has_value(), "it is missed: rounding must be allowed for"));
            }
}
