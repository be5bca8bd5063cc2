// Steps 03.1, 03.2 and 03.10: the plane of a polygon, inside or outside, and the hit.
#include "chapters/03_triangles/polygon.hpp"
#include "common/math/error.hpp"
#include "tests/03_triangles/show.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>

using namespace rt;
using test::cases;
using test::Random;
using test::show;

namespace {

const std::vector<Vec3> unit_square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

/// A pentagram's outline: ten corners, every second one a notch. Radius 1 outside, 0.3 inside, in the xy
/// plane.
std::vector<Vec3> star() {
    std::vector<Vec3> corners;
    for (int i = 0; i < 10; ++i) {
        const Real angle = pi / 2 + i * pi / 5, radius = i % 2 == 0 ? 1 : 0.3;
        corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    return corners;
}

/// The (x, y) of a polygon in the xy plane put into the plane that lacks `axis`, at distance `height`.
std::vector<Vec3> stand(const std::vector<Vec3>& flat, int axis, Real height) {
    std::vector<Vec3> result;
    for (const Vec3& p : flat) {
        Vec3 q(height);
        q[(axis + 1) % 3] = p.x;
        q[(axis + 2) % 3] = p.y;
        result.push_back(q);
    }
    return result;
}

void check_inside(const std::vector<Vec2>& polygon, const Vec2& point, bool expected) {
    INFO("polygon " << polygon << ", point " << point);
    CHECK(test::or_say(point_in_polygon(polygon, point) == expected,
                       expected ? "outside, expected inside" : "inside, expected outside"));
}

void check_normal(const std::vector<Vec3>& corners, const Vec3& expected) {
    INFO("corners " << corners << "\nthe normal of their plane, whose length is twice the area");
    CHECK(test::near_direction(supporting_plane(corners).normal, expected, 0));
}

void check_hit(const Polygon& polygon, const Ray& ray, const Interval& range, Real t) {
    INFO(polygon << "\n" << ray << " in " << range << "; the t of the hit");
    const std::optional<Hit> hit = intersect(polygon, ray, range);
    REQUIRE(hit);
    CHECK(hit->t == t);
}

void check_miss(const Polygon& polygon, const Ray& ray, const Interval& range) {
    INFO(polygon << "\n" << ray << " in " << range);
    CHECK_FALSE(intersect(polygon, ray, range));
}

}  // namespace

TEST_CASE("the plane of a square in the xy plane looks along +z, twice its area long", "[03.1]") {
    const Plane plane = supporting_plane(unit_square);
    {
        INFO("the point of the plane, the first corner");
        CHECK(plane.point == Vec3(0));
    }
    check_normal(unit_square, {0, 0, 2});
}

TEST_CASE("a polygon whose corners turn clockwise looks the other way", "[03.1]") {
    const std::vector<Vec3> reversed(unit_square.rbegin(), unit_square.rend());
    check_normal(reversed, {0, 0, -2});
}

TEST_CASE("the plane goes through the first corner", "[03.1]") {
    const std::vector<Vec3> corners = {{3, 4, 5}, {3, 8, 5}, {3, 4, 9}};
    const Plane plane = supporting_plane(corners);
    {
        INFO("corners " << corners << ": the point of their plane");
        CHECK(plane.point == Vec3(3, 4, 5));
    }
    check_normal(corners, {16, 0, 0});
}

TEST_CASE("a notch or a straight angle at the first corners does not mislead the normal", "[03.1]") {
    // An L of area 3, listed from its notch; then a square whose first three corners are on one line.
    const std::vector<Vec3> from_notch = {{1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}};
    check_normal(from_notch, {0, 0, 6});
    const std::vector<Vec3> straight = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    check_normal(straight, {0, 0, 8});
}

TEST_CASE("a polygon without area has the normal zero", "[03.1]") {
    const std::vector<Vec3> line = {{1, 2, 3}, {2, 4, 6}, {3, 6, 9}, {2, 4, 6}};
    check_normal(line, Vec3(0));
    const std::vector<Vec3> point = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    check_normal(point, Vec3(0));
}

TEST_CASE("a polygon far from the origin has the same normal as one that is near", "[03.1]") {
    // Coordinates are multiples of 2^-10 and the way is 2^40: both polygons are exact, and so are their
    // differences. What remains are the roundings of a few products and sums near 1.
    Random random(31);
    for (int i = 0; i < cases(1000); ++i) {
        std::vector<Vec3> near, far;
        for (int k = 0; k < 3; ++k) near.push_back(glm::round(random.in_cube() * 0x1p10) * 0x1p-10);
        // The fourth corner of the parallelogram keeps it planar.
        near.push_back(near[0] + near[2] - near[1]);
        for (const Vec3& p : near) far.push_back(p + Vec3(0x1p40, -0x1p40, 0x1p40));
        const Vec3 difference = supporting_plane(near).normal - supporting_plane(far).normal;
        INFO("the polygon " << near
                            << "\nand the same farther away by 2^40, which no number needs rounding for: the "
                               "difference of their normals");
        REQUIRE(test::near(difference, Vec3(0), 64 * unit_roundoff));
    }
}

TEST_CASE("the normal is perpendicular to every edge of a planar polygon", "[03.1]") {
    Random random(32);
    for (int i = 0; i < cases(1000); ++i) {
        const Vec3 center = random.in_cube(), u = random.direction(), v = random.direction();
        std::vector<Vec3> corners;
        for (int k = 0; k < 7; ++k) {
            const Real angle = 2 * pi * k / 7, radius = random.uniform(0.2, 1);
            corners.push_back(center + radius * (std::cos(angle) * u + std::sin(angle) * v));
        }
        const Vec3 normal = supporting_plane(corners).normal;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec3 edge = corners[(k + 1) % corners.size()] - corners[k];
            // Corners are off their plane by a few u, edges are at most 2 long, the normal at most 2π.
            INFO("normal " << normal << ", edge " << edge
                           << ": their product, 0 where they are perpendicular");
            REQUIRE(test::near(glm::dot(normal, edge), 0, 200 * unit_roundoff));
        }
    }
}

namespace {

void check_axis(const Vec3& normal, int axis) {
    INFO("the axis, 0, 1 or 2, of the greatest component of the normal " << normal);
    CHECK(dominant_axis(normal) == axis);
}

void check_projection(int axis, const Vec2& expected) {
    INFO("the point (1, 2, 3) along axis " << axis);
    CHECK(project({1, 2, 3}, axis) == expected);
}

}  // namespace

TEST_CASE("the dominant axis is that of the greatest component, whatever its sign", "[03.2]") {
    check_axis({1, -5, 3}, 1);
    check_axis({-7, 5, 3}, 0);
    check_axis({0, 0.5, -1}, 2);
}

TEST_CASE("of equal components the first is the dominant axis", "[03.2]") {
    check_axis({2, 2, -2}, 0);
    check_axis({0, -3, 3}, 1);
    check_axis({-4, 1, 4}, 0);
}

TEST_CASE("projecting keeps the other two coordinates in cyclic order", "[03.2]") {
    check_projection(0, {2, 3});
    check_projection(1, {3, 1});
    check_projection(2, {1, 2});
}

TEST_CASE("a point is inside a square or outside of it", "[03.2]") {
    const std::vector<Vec2> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    check_inside(square, {1, 1}, true);
    check_inside(square, {0.001, 1.999}, true);
    check_inside(square, {-1, 1}, false);
    check_inside(square, {3, 1}, false);
    check_inside(square, {1, 3}, false);
    check_inside(square, {1, -1}, false);
}

TEST_CASE("a notch is outside", "[03.2]") {
    const std::vector<Vec2> l_shape = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    check_inside(l_shape, {0.5, 1.5}, true);
    check_inside(l_shape, {1.5, 0.5}, true);
    check_inside(l_shape, {1.5, 1.5}, false);
}

TEST_CASE("a half-line through a corner counts the corner once", "[03.2]") {
    const std::vector<Vec2> diamond = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    check_inside(diamond, {0, 0}, true);
    check_inside(diamond, {-0.5, 0}, true);
    check_inside(diamond, {-2, 0}, false);
    check_inside(diamond, {2, 0}, false);
    // Here the half-line only touches the corners (2, 1) and (4, 1).
    const std::vector<Vec2> teeth = {{0, 0}, {5, 0}, {5, 2}, {4, 1}, {3, 2}, {2, 1}, {1, 2}};
    check_inside(teeth, {1, 1}, true);
    check_inside(teeth, {-1, 1}, false);
}

TEST_CASE("a half-line along an edge does not count the edge", "[03.2]") {
    const std::vector<Vec2> stairs = {{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2}, {0, 2}};
    check_inside(stairs, {1, 1}, true);
    check_inside(stairs, {-1, 1}, false);
    check_inside(stairs, {-1, 0}, false);
    check_inside(stairs, {-1, 2}, false);
}

TEST_CASE("what a self-crossing polygon goes around twice is outside", "[03.2]") {
    std::vector<Vec2> pentagram;
    for (int i = 0; i < 5; ++i) {
        const Real angle = pi / 2 + 2 * i * 2 * pi / 5;
        pentagram.push_back({std::cos(angle), std::sin(angle)});
    }
    check_inside(pentagram, {0, 0}, false);
    check_inside(pentagram, {0, 0.7}, true);
}

TEST_CASE("a point belongs to exactly one of two polygons that share an edge", "[03.2]") {
    // Corners and points on a small lattice, so that many points lie exactly on edges and at corners.
    Random random(33);
    for (int i = 0; i < cases(2000); ++i) {
        std::vector<Vec2> quad = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
        const auto whole = [&](int low, int high) {
            return static_cast<Real>(
                low + static_cast<int>(random.index(static_cast<std::size_t>(high - low + 1))));
        };
        quad[0] = {whole(-5, -1), whole(-5, -1)};
        quad[1] = {whole(1, 5), whole(-5, -1)};
        quad[2] = {whole(1, 5), whole(1, 5)};
        quad[3] = {whole(-5, -1), whole(1, 5)};
        const std::vector<Vec2> one = {quad[0], quad[1], quad[2]}, other = {quad[2], quad[3], quad[0]};
        const Vec2 point(whole(-5, 5), whole(-5, 5));
        INFO("diagonal " << show(quad[0]) << " to " << show(quad[2]));
        INFO("other corners " << show(quad[1]) << ", " << show(quad[3]));
        INFO("point " << show(point));
        const bool in_one = point_in_polygon(one, point), in_other = point_in_polygon(other, point);
        // Where the quadrilateral has a notch, the two triangles overlap, and the point may be in both.
        REQUIRE(test::or_say((in_one != in_other) == point_in_polygon(quad, point),
                             std::string("the point is ") + (in_one ? "inside" : "outside") +
                                 " of one triangle, " + (in_other ? "inside" : "outside") +
                                 " of the other, which does not fit the whole"));
    }
}

TEST_CASE("points on the common edge have one owner even where rounding decides", "[03.2]") {
    Random random(34);
    for (int i = 0; i < cases(10000); ++i) {
        const Vec2 p(random.uniform(-1, 0), random.uniform(-1, 0)),
            q(random.uniform(0, 1), random.uniform(0, 1));
        const std::vector<Vec2> below = {p, {2, -2}, q}, above = {q, {-2, 2}, p};
        const Vec2 point = p + random.uniform(0.1, 0.9) * (q - p);
        INFO("edge " << show(p) << " to " << show(q) << ", point " << show(point)
                     << ": how many of the two polygons beside the edge it is in");
        REQUIRE(point_in_polygon(below, point) + point_in_polygon(above, point) == 1);
    }
}

TEST_CASE("a ray hits a square where it is", "[03.10]") {
    const Polygon square{unit_square};
    check_hit(square, {{0.25, 0.5, 3}, {0, 0, -1}}, {}, 3);
    check_miss(square, {{1.25, 0.5, 3}, {0, 0, -1}}, {});
}

TEST_CASE("a polygon is hit from both sides, and t counts lengths of the direction", "[03.10]") {
    check_hit({unit_square}, {{0.25, 0.5, -3}, {0, 0, 4}}, {}, 0.75);
}

TEST_CASE("a polygon behind the ray or out of its range is missed", "[03.10]") {
    const Polygon square{unit_square};
    const Ray ray{{0.25, 0.5, 3}, {0, 0, -1}};
    check_miss(square, {{0.25, 0.5, 3}, {0, 0, 1}}, {});
    check_miss(square, ray, {3, 10});
    check_hit(square, ray, {2, 3}, 3);
    check_miss(square, ray, {0, 2.5});
}

TEST_CASE("a polygon without area is missed", "[03.10]") {
    check_miss({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}, {{1, 0, 3}, {0, 0, -1}}, {});
}

TEST_CASE("a ray at the edge or corner that squares share hits exactly one of them", "[03.10]") {
    const auto square = [](Real x, Real y) {
        return Polygon{{{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}}};
    };
    const std::vector<Polygon> tiles = {square(0, 0), square(1, 0), square(0, 1), square(1, 1)};
    const auto hits = [&](const Vec3& origin, const Vec3& target) {
        int count = 0;
        for (const Polygon& tile : tiles)
            count += intersect(tile, Ray{origin, target - origin}, Interval{}).has_value();
        return count;
    };
    for (const Vec3& target :
         {Vec3(1, 0.5, 0), Vec3(1, 1.25, 0), Vec3(0.5, 1, 0), Vec3(1.75, 1, 0), Vec3(1, 1, 0)}) {
        INFO("four unit squares side by side; at " << target
                                                   << ", where they meet: how many of them are hit");
        CHECK(hits(target + Vec3(0, 0, 3), target) == 1);
        CHECK(hits({0.1, 0.7, 0.3}, target) == 1);
        CHECK(hits({-5, 2, -0.5}, target) == 1);
    }
}

TEST_CASE("rays along the slanting ridge of a roof hit exactly one of its sides", "[03.10]") {
    // Numbers with long binary fractions, so that everything is rounded.
    const Vec3 p(0.1, 0.9, 0.3), q(0.7, 1.1, -2.4);
    const Polygon left{{p, q, {-1.3, 0.2, -2.3}, {-1.1, 0.1, 0.7}}};
    const Polygon right{{q, p, {1.6, 0.3, 0.2}, {1.9, 0.1, -2.9}}};
    for (const Vec3& origin : {Vec3(0.3, 5.1, -1.7), Vec3(0.9, 3.3, 0.4)}) {
        for (int i = 1; i < 400; ++i) {
            const Ray ray{origin, p + Real(i) / 400 * (q - p) - origin};
            INFO("at " << i << "/400 of the ridge, " << ray << ": how many of the two sides are hit");
            CHECK(intersect(left, ray, Interval{}).has_value() +
                      intersect(right, ray, Interval{}).has_value() ==
                  1);
        }
    }
}

TEST_CASE("a star standing across each axis is hit in its points and missed in its notches", "[03.10]") {
    for (int axis = 0; axis < 3; ++axis) {
        const Polygon polygon{stand(star(), axis, 2)};
        for (int i = 0; i < 10; ++i) {
            // At radius 0.6 the points of the star are inside and the notches are not.
            const Real angle = pi / 2 + i * pi / 5;
            Vec3 target(2);
            target[(axis + 1) % 3] = 0.6 * std::cos(angle);
            target[(axis + 2) % 3] = 0.6 * std::sin(angle);
            const Vec3 origin(-0.1, 0.3, -0.2);
            INFO("a star across axis " << axis << ", a ray at " << target << ", which is in a "
                                       << (i % 2 == 0 ? "point" : "notch"));
            const auto hit = intersect(polygon, Ray{origin, target - origin}, Interval{});
            if (i % 2 == 0) REQUIRE(hit);
            if (i % 2 == 1) REQUIRE_FALSE(hit);
            INFO("the t of the hit");
            if (hit) CHECK(test::near(hit->t, 1, 1e-14));
        }
    }
}

TEST_CASE("of several polygons the nearest is hit, and of equal ones the first", "[03.10]") {
    std::vector<Polygon> polygons;
    for (const Real height : {1.0, 4.0, 2.0, 4.0}) polygons.push_back({stand(unit_square, 2, height)});
    const Ray ray{{0.25, 0.5, 9}, {0, 0, -1}};
    INFO("unit squares in z = 1, 4, 2 and 4, in this order; " << ray);
    CHECK(test::same_hit(closest_hit(polygons, ray, Interval{}), Hit{.t = 5, .primitive = 1}));
    INFO("whether any_hit finds one; and where the range ends at 4");
    CHECK(any_hit(polygons, ray, Interval{}) == true);
    CHECK(any_hit(polygons, ray, {0, 4}) == false);
}
