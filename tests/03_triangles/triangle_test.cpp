// Steps 03.3 to 03.9 and 03.11: normal and weights, the watertight test, the surface, the nearest of many,
// and winding numbers.
#include "chapters/03_triangles/triangle.hpp"
#include "common/math/error.hpp"
#include "tests/03_triangles/show.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <vector>

using namespace rt;
using test::cases;
using test::Random;
using test::show;

namespace {

// A right-angled triangle in the xy plane; its corners are easy to weigh by head.
const Triangle right_angled{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

Triangle random_triangle(Random& random) { return {random.in_cube(), random.in_cube(), random.in_cube()}; }

Triangle moved(const Triangle& t, const Vec3& by) { return {t.a + by, t.b + by, t.c + by}; }
Triangle scaled(const Triangle& t, Real by) { return {t.a * by, t.b * by, t.c * by}; }

Vec3 weighted(const Triangle& t, const Vec3& w) { return w.x * t.a + w.y * t.b + w.z * t.c; }

/// How much rounding a triangle amplifies: the squared greatest extent over twice the area.
Real condition(const Triangle& t) {
    const Vec3 ab = t.b - t.a, ac = t.c - t.a;
    const Real extent = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(t.c - t.b, t.c - t.b)});
    return extent / glm::length(glm::cross(ab, ac));
}

/// Three positive weights, none below `least`.
Vec3 random_weights(Random& random, Real least) {
    const Real u = random.uniform(0, 1), v = random.uniform(0, 1);
    const Vec3 w = u + v < 1 ? Vec3(u, v, 1 - u - v) : Vec3(1 - u, 1 - v, u + v - 1);
    return Vec3(least) + (1 - 3 * least) * w;
}

std::optional<Hit> shoot(const Triangle& triangle, const Vec3& origin, const Vec3& direction,
                         Interval range = {}) {
    return intersect(triangle, Ray{origin, direction}, range);
}

void check_hit(const Triangle& triangle, const Ray& ray, const Interval& range = {}) {
    INFO(triangle << "\n" << ray << " in " << range);
    CHECK(intersect(triangle, ray, range));
}

void check_miss(const Triangle& triangle, const Ray& ray, const Interval& range = {}) {
    INFO(triangle << "\n" << ray << " in " << range);
    CHECK_FALSE(intersect(triangle, ray, range));
}

/// A hit at this t, with these weights of b and c.
void check_hit_at(const Triangle& triangle, const Ray& ray, Real t, const Vec2& uv, Real bound = 0) {
    INFO(triangle << "\n" << ray);
    const std::optional<Hit> hit = intersect(triangle, ray, Interval{});
    REQUIRE(hit);
    {
        INFO("the t of the hit");
        CHECK(test::near(hit->t, t, 0));
    }
    INFO("uv, the weights of b and c");
    CHECK(test::near(hit->uv, uv, bound));
}

void check_normal(const Triangle& triangle, const Vec3& normal) {
    INFO("the unit normal of the " << triangle);
    CHECK(test::near_direction(unit_normal(triangle), normal, 0));
}

}  // namespace

// ---------------------------------------------------------------------------------------------- 03.3

TEST_CASE("the normal of a counterclockwise triangle in the xy plane is +z", "[03.3]") {
    check_normal(right_angled, {0, 0, 1});
    check_normal({{0, 0, 0}, {0, 4, 0}, {4, 0, 0}}, {0, 0, -1});
    check_normal({{5, 1, 1}, {5, 3, 1}, {5, 1, 9}}, {1, 0, 0});
}

TEST_CASE("the normal has length 1 and is perpendicular to the edges", "[03.3]") {
    Random random(35);
    for (int i = 0; i < cases(2000); ++i) {
        const Triangle t = random_triangle(random);
        const Vec3 n = unit_normal(t);
        INFO(t << ", normal " << n
               << ": its length; its products with two edges, 0 where they are perpendicular");
        REQUIRE(test::near(glm::length(n), 1, 4 * unit_roundoff));
        // The edges are at most 2√3 long; a cross product of unit vectors is off by a few u, and dividing
        // by its length amplifies that.
        REQUIRE(test::near(glm::dot(n, t.b - t.a), 0, 32 * unit_roundoff * condition(t)));
        REQUIRE(test::near(glm::dot(n, t.c - t.a), 0, 32 * unit_roundoff * condition(t)));
    }
}

TEST_CASE("tiny and huge triangles have the normal of ordinary ones", "[03.3]") {
    for (const Real size : {1e-160, 1e-20, 1e20, 1e150}) {
        INFO("size " << size);
        check_normal(scaled(right_angled, size), {0, 0, 1});
    }
}

TEST_CASE("a triangle without area has the normal zero", "[03.3]") {
    check_normal({{1, 2, 3}, {1, 2, 3}, {5, 6, 7}}, Vec3(0));
    check_normal({{1, 2, 3}, {5, 6, 7}, {1, 2, 3}}, Vec3(0));
    check_normal({{1, 2, 3}, {5, 6, 7}, {5, 6, 7}}, Vec3(0));
    check_normal({{0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}, {0.4, 0.8, 1.2}}, Vec3(0));
    check_normal({{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}, Vec3(0));
}

TEST_CASE("a needle has its normal whichever corner comes first", "[03.3]") {
    // In the plane z = 0, one edge 2^-50 long, turned so that no coordinate is 0.
    const Vec3 tip(0.1, 0.2, 0.3), blunt = tip + Vec3(1, 2, 2);
    const Triangle needle{tip, blunt, blunt + 0x1p-50 * Vec3(2, -1, 0)};
    const auto& [a, b, c] = needle;
    // The corners are rounded; what matters is that the orders agree.
    const Vec3 normal = unit_normal(needle);
    for (const Triangle& turned : {Triangle{b, c, a}, Triangle{c, a, b}}) {
        INFO(turned << ": the normal, expected that with another corner first");
        CHECK(test::near_direction(unit_normal(turned), normal, 256 * unit_roundoff));
    }
    for (const Triangle& reversed : {Triangle{a, c, b}, Triangle{c, b, a}, Triangle{b, a, c}}) {
        INFO(reversed << ": the normal, expected the opposite of that in the other order");
        CHECK(test::near_direction(unit_normal(reversed), -normal, 256 * unit_roundoff));
    }
}

TEST_CASE("a triangle that is nearly a line, but not quite, has a normal", "[03.3]") {
    // The corners are 1 and 2 steps from the origin, the last one off the line by its last bit.
    const Real off = std::nextafter(2.0, 3.0);
    check_normal({{0, 0, 0}, {1, 1, 0}, {2, off, 0}}, {0, 0, 1});
    check_normal({{0, 0, 0}, {1, 1, 0}, {off, 2, 0}}, {0, 0, -1});
}

TEST_CASE("the weights at a corner, in the middle of an edge and at the centre", "[03.3]") {
    const auto check = [](const Vec3& point, const Vec3& expected) {
        const auto weights = barycentric(right_angled, point);
        INFO(right_angled << ", point " << point << ": the weights of a, b and c");
        REQUIRE(weights);
        CHECK(test::near(*weights, expected, 8 * unit_roundoff));
    };
    check({0, 0, 0}, {1, 0, 0});
    check({4, 0, 0}, {0, 1, 0});
    check({0, 4, 0}, {0, 0, 1});
    check({2, 0, 0}, {0.5, 0.5, 0});
    check({2, 2, 0}, {0, 0.5, 0.5});
    check({4.0 / 3, 4.0 / 3, 0}, Vec3(1.0 / 3));
    check({1, 2, 0}, {0.25, 0.25, 0.5});
}

TEST_CASE("outside, the weight of the corner beyond the opposite edge is negative", "[03.3]") {
    const auto check = [](const Vec3& point, const Vec3& expected) {
        const auto weights = barycentric(right_angled, point);
        INFO(right_angled << ", point " << point << " outside of it: the weights of a, b and c");
        REQUIRE(weights);
        CHECK(test::near(*weights, expected, 8 * unit_roundoff));
    };
    check({3, 3, 0}, {-0.5, 0.75, 0.75});  // beyond bc
    check({-1, 1, 0}, {1, -0.25, 0.25});   // beyond ca
    check({1, -1, 0}, {1, 0.25, -0.25});   // beyond ab
}

TEST_CASE("the weights that made a point are found again, at any size", "[03.3]") {
    Random random(36);
    for (int i = 0; i < cases(2000); ++i) {
        const Triangle t = scaled(random_triangle(random), random.magnitude(-20, 20));
        const Vec3 w(random.uniform(-2, 2), random.uniform(-2, 2), 0);
        const Vec3 made(w.x, w.y, 1 - w.x - w.y);
        const auto found = barycentric(t, weighted(t, made));
        INFO(t << ", the point that the weights " << made << " make; the weights that are found");
        REQUIRE(found);
        // Rounding moves the point by some u of its coordinates, which are up to 9 times a corner's. Measured
        // in the triangle that is the ratio of the coordinates to the least height, which the condition
        // bounds when the extent is known.
        const Real extent = glm::length(t.b - t.a) + glm::length(t.c - t.a);
        const Real reach = glm::length(t.a) + glm::length(t.b) + glm::length(t.c) + extent;
        // Weights from dot products have the square of the condition.
        const Real allowed = 64 * unit_roundoff * condition(t) * condition(t) * reach / extent;
        REQUIRE(test::near(*found, made, allowed));
        // Weights that each come from their own area make 1 as well as they are known themselves.
        INFO("their sum");
        REQUIRE(test::near(found->x + found->y + found->z, 1, allowed));
    }
}

TEST_CASE("a triangle without area has no weights", "[03.3]") {
    INFO("the weights in a triangle whose corners lie on a line, or are one point");
    CHECK_FALSE(barycentric({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {1, 1, 1}));
    CHECK_FALSE(barycentric({{3, 3, 3}, {3, 3, 3}, {3, 3, 3}}, {3, 3, 3}));
}

// ---------------------------------------------------------------------------------------------- 03.4

namespace {

// The example that the lesson works out by hand: a ray, a triangle, and where the ray sees its corners.
const Ray by_hand{{1, 1, 1}, {2, 1, 4}};
const Triangle by_hand_triangle{{4, 2, 9}, {8, 3, 13}, {3, 3, 5}};
const Triangle by_hand_seen{{-1, -1, 8}, {1, -1, 12}, {0, 1, 4}};

}  // namespace

TEST_CASE("by hand: the ray from (1, 1, 1) along (2, 1, 4) sees the lesson's corners", "[03.4]") {
    const ShearedRay sheared = shear(by_hand);
    {
        INFO("the " << by_hand << ": its slope along x and along y");
        CHECK(test::near(sheared.slope, {0.5, 0.25}, 0));
    }
    const auto check = [&](const Vec3& corner, const Vec3& expected) {
        INFO("where the corner " << corner << " is seen along the " << by_hand);
        CHECK(test::near(seen(sheared, corner), expected, 0));
    };
    check(by_hand_triangle.a, by_hand_seen.a);
    check(by_hand_triangle.b, by_hand_seen.b);
    check(by_hand_triangle.c, by_hand_seen.c);
}

TEST_CASE("z is the axis along which a ray goes fastest, and x and y follow it round", "[03.4]") {
    const auto check = [](const Vec3& direction, int z, const Vec2& slope) {
        const ShearedRay ray = shear({{1, 2, 3}, direction});
        INFO("a ray along " << direction << ": the axes that are called x, y and z, counted from 0");
        CHECK(Vec3(ray.x, ray.y, ray.z) == Vec3((z + 1) % 3, (z + 2) % 3, z));
        INFO("its slope, how fast it drifts aside along x and along y");
        CHECK(test::near(ray.slope, slope, 0));
    };
    check({1, 2, 4}, 2, {0.25, 0.5});
    check({4, 1, 2}, 0, {0.25, 0.5});
    check({1, -4, 2}, 1, {-0.5, -0.25});
    check({0, 0, -8}, 2, {0, 0});
}

TEST_CASE("what a slanting ray sees has moved aside by its slope times the depth", "[03.4]") {
    // From the ray's origin the point is (1, 4, 5). At the depth of 4 along y, which is called z here, the
    // ray has drifted by 2 along z and by −1 along x.
    const Ray slanting{{1, 1, 1}, {-1, 4, 2}};
    INFO("where the point (2, 5, 6) is seen along the " << slanting);
    CHECK(test::near(seen(shear(slanting), {2, 5, 6}), {3, 2, 4}, 0));
}

TEST_CASE("seen along the ray, its own points have x = y = 0", "[03.4]") {
    for (const Vec3& direction : {Vec3(0, 0, -2), Vec3(0.5, 4, -1), Vec3(-8, 2, 4), Vec3(0, -1, 0)}) {
        const Ray ray{{3, -1, 2}, direction};
        const Vec3 p = seen(shear(ray), point_at(ray, 4));
        INFO("direction " << direction << ": where the ray's point at t = 4 is seen is " << p);
        {
            INFO("its x and y, both 0 because it lies on the ray");
            CHECK(p.x == 0);
            CHECK(p.y == 0);
        }
        INFO("its depth, without the sign: 4 times the direction's greatest coordinate");
        const Vec3 size = glm::abs(direction);
        CHECK(std::abs(p.z) == 4 * max_component(size));
    }
}

TEST_CASE("seen along a ray in the direction of z, points keep their places", "[03.4]") {
    const auto check = [](const Ray& ray, const Vec3& point, const Vec3& expected) {
        INFO("where the point " << point << " is seen along the " << ray);
        CHECK(test::near(seen(shear(ray), point), expected, 0));
    };
    const Ray down{{1, 2, 5}, {0, 0, -1}};
    check(down, {4, 6, 5}, {3, 4, 0});
    check(down, {1, 2, 2}, {0, 0, -3});
    // Along x the other two coordinates follow in cyclic order: y, then z.
    check({{0, 0, 0}, {4, 1, 2}}, {4, 3, 5}, {2, 3, 4});
}

// ---------------------------------------------------------------------------------------------- 03.5

TEST_CASE("an edge function is positive for a counterclockwise turn", "[03.5]") {
    const auto check = [](const Vec2& p, const Vec2& q, Real expected) {
        INFO("the edge function of p = " << p << " and q = " << q << ": p.x q.y - p.y q.x");
        CHECK(test::near(edge_function(p, q), expected, 0));
    };
    check({1, 0}, {0, 1}, 1);
    check({0, 1}, {1, 0}, -1);
    check({3, 1}, {1, 2}, 5);
    check({3, 1}, {6, 2}, 0);
}

TEST_CASE("an edge function has the right sign where both products round to the same number", "[03.5]") {
    // (1 + e)(1 − e) − 1·1 = −e², far below the last digit of 1.
    const Real e = 0x1p-30;
    INFO("the edge function of (1 + e, 1) and (1, 1 - e), and that of the two exchanged, where e = " << e);
    CHECK(edge_function({1 + e, 1}, {1, 1 - e}) == -e * e);
    CHECK(edge_function({1, 1 - e}, {1 + e, 1}) == e * e);
}

TEST_CASE("exchanging the ends of an edge changes the sign and nothing else", "[03.5]") {
    Random random(37);
    for (int i = 0; i < cases(20000); ++i) {
        const Vec2 p(random.uniform(-1, 1), random.uniform(-1, 1));
        // Half of the cases are nearly parallel: that is where rounding matters.
        Vec2 q(random.uniform(-1, 1), random.uniform(-1, 1));
        if (i % 2 == 0) q = p * random.uniform(-2, 2);
        INFO("p = " << p << ", q = " << q
                    << ": the edge function of p and q, expected minus that of q and p");
        REQUIRE(edge_function(p, q) == -edge_function(q, p));
    }
}

// ---------------------------------------------------------------------------------------------- 03.6

TEST_CASE("by hand: seen at (-1, -1), (1, -1) and (0, 1), the corners weigh 1/4, 1/4 and 1/2", "[03.6]") {
    const auto& [a, b, c] = by_hand_seen;
    const ShearedRay ray{.ray = by_hand, .slope = {0.5, 0.25}};
    INFO("the " << by_hand << " sees the corners at a = " << a << ", b = " << b << " and c = " << c);
    const std::optional<Hit> hit = hit_of_seen(ray, a, b, c, {});
    REQUIRE(hit);
    {
        INFO("t: the depth of the point, 7, over the direction's z, which is 4");
        CHECK(test::near(hit->t, 1.75, 0));
    }
    INFO("uv, the weights of b and c");
    CHECK(test::near(hit->uv, {0.25, 0.5}, 0));
}

TEST_CASE("where a ray hits, by the corners that it sees", "[03.6]") {
    // The edge functions are −1 for a, −1 for b and −2 for c: weights of a quarter, a quarter and a half.
    const Vec3 a(-1, -1, 6), b(1, -1, 10), c(0, 1, 4);
    const ShearedRay ray{.ray = {{7, 8, 9}, {0, 0, 2}}};
    INFO("along a ray with the direction (0, 0, 2), the corners are seen at a = "
         << a << ", b = " << b << " and c = " << c << ", and weigh 1/4, 1/4 and 1/2");
    const auto check = [&](const std::optional<Hit>& hit, const Vec2& uv) {
        REQUIRE(hit);
        {
            INFO("t: the depth of the point, 6, over the direction's z");
            CHECK(test::near(hit->t, 3, 0));
        }
        INFO("uv, the weights of b and c");
        CHECK(test::near(hit->uv, uv, 0));
    };
    check(hit_of_seen(ray, a, b, c, {}), {0.25, 0.5});
    INFO("the same triangle from the other side: b and c have changed places");
    check(hit_of_seen(ray, a, c, b, {}), {0.5, 0.25});
}

TEST_CASE("the depth counts along the axis that is called z", "[03.6]") {
    // Along x: coordinate number 0 of the direction is its z.
    const ShearedRay ray{.ray = {{0, 0, 0}, {4, 1, 2}}, .x = 1, .y = 2, .z = 0, .slope = {0.25, 0.5}};
    const std::optional<Hit> hit = hit_of_seen(ray, {-1, -1, 8}, {3, -1, 8}, {-1, 3, 8}, {});
    INFO(
        "along a ray with the direction (4, 1, 2) all corners are seen 8 deep: t, and the weights of b and "
        "c");
    REQUIRE(hit);
    CHECK(test::near(hit->t, 2, 0));
    CHECK(test::near(hit->uv, {0.25, 0.25}, 0));
}

TEST_CASE("where the ray passes through an edge or a corner, the corners beside it weigh nothing", "[03.6]") {
    const ShearedRay ray{.ray = {{0, 0, 0}, {0, 0, 1}}};
    const auto check = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec2& uv) {
        INFO("the corners are seen at a = " << a << ", b = " << b << " and c = " << c
                                            << ": the weights of b and c");
        const std::optional<Hit> hit = hit_of_seen(ray, a, b, c, {});
        REQUIRE(hit);
        CHECK(test::near(hit->uv, uv, 0));
    };
    check({-1, 0, 5}, {1, 0, 5}, {0, 4, 5}, {0.5, 0});
    check({4, 1, 5}, {0, 0, 5}, {1, 4, 5}, {1, 0});
    check({4, 1, 5}, {1, 4, 5}, {0, 0, 5}, {0, 1});
}

TEST_CASE("a hit out of the range is none", "[03.6]") {
    const ShearedRay ray{.ray = {{0, 0, 0}, {0, 0, 1}}};
    const auto check = [&](Real depth, const Interval& range, bool expected) {
        const std::optional<Hit> hit =
            hit_of_seen(ray, {-1, -1, depth}, {1, -1, depth}, {0, 1, depth}, range);
        INFO("a triangle across the ray at t = " << depth << ", range " << range);
        CHECK(test::or_say(hit.has_value() == expected,
                           expected ? "missed, expected a hit" : "hit, expected a miss"));
    };
    check(5, {0, 5}, true);
    check(5, {5, 9}, false);
    check(5, {0, 4.5}, false);
    check(-5, {0, infinity}, false);
}

// ---------------------------------------------------------------------------------------------- 03.7

TEST_CASE("by hand: the ray from (1, 1, 1) along (2, 1, 4) hits the lesson's triangle at t = 7/4", "[03.7]") {
    check_hit_at(by_hand_triangle, by_hand, 1.75, {0.25, 0.5});
}

TEST_CASE("a ray down onto the triangle hits it at its height, weights by head", "[03.7]") {
    check_hit_at(right_angled, {{1, 2, 5}, {0, 0, -1}}, 5, {0.25, 0.5});
}

TEST_CASE("t counts lengths of the direction", "[03.7]") {
    check_hit_at(right_angled, {{1, 2, 5}, {0, 0, -4}}, 1.25, {0.25, 0.5});
}

TEST_CASE("both sides of a triangle are hit", "[03.7]") {
    check_hit_at(right_angled, {{1, 2, -5}, {0, 0, 1}}, 5, {0.25, 0.5});
}

TEST_CASE("rays past each of the edges miss", "[03.7]") {
    check_miss(right_angled, {{2.5, 2.5, 5}, {0, 0, -1}});
    check_miss(right_angled, {{-0.5, 1, 5}, {0, 0, -1}});
    check_miss(right_angled, {{1, -0.5, 5}, {0, 0, -1}});
}

TEST_CASE("edges and corners belong to the triangle", "[03.7]") {
    for (const Vec3& w :
         {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.5, 0.5, 0), Vec3(0, 0.25, 0.75)}) {
        const Vec3 target = weighted(right_angled, w);
        check_hit_at(right_angled, {target + Vec3(0, 0, 5), {0, 0, -1}}, 5, {w.y, w.z});
    }
}

TEST_CASE("a triangle behind the ray is missed", "[03.7]") {
    check_miss(right_angled, {{1, 1, 5}, {0, 0, 1}});
    check_miss(right_angled, {{1, 1, -5}, {0, 0, -1}});
}

TEST_CASE("the range leaves out its beginning and includes its end", "[03.7]") {
    check_miss(right_angled, {{1, 1, 5}, {0, 0, -1}}, {5, 10});
    check_hit(right_angled, {{1, 1, 5}, {0, 0, -1}}, {4, 5});
    check_miss(right_angled, {{1, 1, 5}, {0, 0, -1}}, {0, 4});
    check_hit(right_angled, {{1, 1, -5}, {0, 0, -1}}, {-10, 0});
}

TEST_CASE("a triangle seen edge-on is missed", "[03.7]") {
    check_miss(right_angled, {{-3, 1, 0}, {1, 0, 0}});
    check_miss(right_angled, {{1, -3, 0}, {0, 1, 0}});
    check_miss(right_angled, {{-1, -1, 0}, {1, 1, 0}});
}

TEST_CASE("rays exactly at an edge or corner hit, in every order of the corners", "[03.7]") {
    // None of these numbers is rounded: a slanted triangle, and rays at whole multiples of an edge's tenth.
    const Vec3 a(3, -7, 11), step(2, 5, -3), b = a + 10.0 * step, c(-20, 13, 4);
    for (int i = 0; i <= 10; ++i) {
        for (const Vec3& origin : {Vec3(50, 1, -60), Vec3(-17, -90, 33), Vec3(1, 2, 300)}) {
            const Vec3 direction = a + Real(i) * step - origin;
            INFO("exactly at " << i << " tenths of the edge from " << a << " to " << b);
            check_hit({a, b, c}, {origin, direction});
            check_hit({b, c, a}, {origin, direction});
            check_hit({c, a, b}, {origin, direction});
            check_hit({c, b, a}, {origin, direction});
        }
    }
}

TEST_CASE("a ray that passes a corner by the last bit of a coordinate misses", "[03.7]") {
    // The corner (1, 1, 0) is seen from above, and from 1 aside; beyond it is nothing.
    const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    const Real above = std::nextafter(1.0, 2.0), below = std::nextafter(1.0, 0.0);
    check_hit(triangle, {{1, 1, 5}, {0, 0, -1}});
    check_miss(triangle, {{1, above, 5}, {0, 0, -1}});
    check_miss(triangle, {{above, 1, 5}, {0, 0, -1}});
    check_miss(triangle, {{below, 1, 5}, {0, 0, -1}});
    check_hit(triangle, {{1, below, 5}, {0, 0, -1}});
}

TEST_CASE("a triangle without area is missed, wherever the ray points", "[03.7]") {
    const Vec3 p(0.25, 0.5, 0.75), q(1, 2, 3);
    const std::vector<Triangle> flat = {
        {p, p, p}, {p, p, q}, {p, q, p}, {q, p, p}, {p, q, p + 2.0 * (q - p)}};
    Random random(38);
    const auto check = [&](const Triangle& triangle) {
        const Vec3 origin = 4.0 * random.in_cube();
        const Vec3 target = triangle.a + random.uniform(0, 1) * (triangle.c - triangle.a);
        INFO("triangle " << show(triangle) << ", ray " << show(Ray{origin, target - origin}));
        REQUIRE_FALSE(shoot(triangle, origin, target - origin));
    };
    for (const Triangle& triangle : flat)
        for (int i = 0; i < cases(500); ++i) check(triangle);
    // Exactly on one line through the origin, although the differences between the corners are rounded.
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 corner = random.in_cube();
        check({corner, 2.0 * corner, 4.0 * corner});
    }
}

TEST_CASE("rays along each axis, both ways, hit a triangle across the axis", "[03.7]") {
    const Triangle across{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}};
    for (int axis = 0; axis < 3; ++axis) {
        for (const Real way : {-1.0, 1.0}) {
            Vec3 direction(0);
            direction[axis] = way;
            const Vec3 origin = Vec3(1) - 7.0 * direction;
            check_hit_at(across, {origin, direction}, 7, Vec2(1.0 / 3), 8 * unit_roundoff);
        }
    }
}

TEST_CASE("a ray hits where it is aimed, and misses where it is aimed outside", "[03.7]") {
    Random random(39);
    for (int i = 0; i < cases(10000); ++i) {
        const Triangle t = random_triangle(random);
        const Vec3 origin = 3.0 * random.direction();
        const Vec3 w = random_weights(random, 0.01);
        const Vec3 direction = weighted(t, w) - origin;
        const Real slope = std::abs(glm::dot(unit_normal(t), direction));
        // Aspect and slant amplify the rounding of the aim; the tolerance below grows with both.
        const Real kappa = condition(t) * 20 / slope;
        if (64 * unit_roundoff * kappa > 1e-3) continue;
        INFO(t << "\n" << test::show(Ray{origin, direction}));
        const auto hit = shoot(t, origin, direction);
        {
            INFO("aimed at the point of the weights " << w << ": t of the hit, and uv");
            REQUIRE(hit);
            REQUIRE(test::near(hit->t, 1, 64 * unit_roundoff * kappa));
            REQUIRE(test::near(hit->uv, Vec2(w.y, w.z), 64 * unit_roundoff * kappa));
        }

        Vec3 outside = w;
        const int corner = static_cast<int>(random.index(3));
        outside[corner] = -0.01;
        outside /= outside.x + outside.y + outside.z;
        INFO("aimed outside instead, at the point of the weights " << outside);
        REQUIRE_FALSE(shoot(t, origin, weighted(t, outside) - origin));
    }
}

TEST_CASE("the order of the corners changes neither hit nor miss", "[03.7]") {
    Random random(40);
    for (int i = 0; i < cases(5000); ++i) {
        const Triangle t = random_triangle(random);
        const Vec3 origin = 3.0 * random.direction();
        // On the edge between a and b, or at a corner: rounding decides, but always in the same way.
        const Real at = i % 3 == 0 ? 0 : random.uniform(0, 1);
        const Vec3 direction = t.a + at * (t.b - t.a) - origin;
        INFO(t << "\n"
               << test::show(Ray{origin, direction})
               << ": whether it is hit, with the corners in another order");
        const bool hit = shoot(t, origin, direction).has_value();
        REQUIRE(shoot({t.b, t.c, t.a}, origin, direction).has_value() == hit);
        REQUIRE(shoot({t.c, t.b, t.a}, origin, direction).has_value() == hit);
    }
}

TEST_CASE("directions and triangles of any size", "[03.7]") {
    for (const Real size : {1e-20, 1e-10, 1e10, 1e20}) {
        for (const Real length : {1e-20, 1e-10, 1e10, 1e20}) {
            INFO("triangle scaled by " << size << ", direction of length " << length);
            const auto hit = shoot(scaled(right_angled, size), Vec3(1, 2, 5) * size, {0, 0, -length});
            INFO("a hit, its t, and its u");
            REQUIRE(hit);
            CHECK(hit->t == Approx(5 * size / length).epsilon(1e-15));
            CHECK(hit->uv.x == Approx(0.25).epsilon(1e-15));
            CHECK_FALSE(shoot(scaled(right_angled, size), Vec3(3, 3, 5) * size, {0, 0, -length}));
        }
    }
}

TEST_CASE("no ray escapes through the edges and corners of a closed octahedron", "[03.7]") {
    Random random(41);
    // Near the origin, and where the meshes of a city model might stand.
    for (const Vec3& center : {Vec3(0.1, 0.2, 0.3), Vec3(148376, 1234, -223423)}) {
        std::vector<Vec3> corners;
        for (int i = 0; i < 3; ++i)
            for (const Real way : {-1.0, 1.0}) {
                Vec3 p(0);
                p[i] = way;
                corners.push_back(center + p + 0.3 * random.in_cube());
            }
        std::vector<Triangle> faces;
        for (std::size_t x = 0; x < 2; ++x)
            for (std::size_t y = 2; y < 4; ++y)
                for (std::size_t z = 4; z < 6; ++z) faces.push_back({corners[x], corners[y], corners[z]});
        for (int i = 0; i < cases(10000); ++i) {
            const Triangle& face = faces[random.index(8)];
            const Vec3 target = face.a + (i % 4 == 0 ? 0 : random.uniform(0, 1)) * (face.b - face.a);
            const Ray ray{center + 0.1 * random.in_cube(), target - center};
            Ray aimed = ray;
            aimed.direction = target - ray.origin;
            int hits = 0;
            for (const Triangle& f : faces) hits += intersect(f, aimed, Interval{}).has_value();
            INFO(aimed << "\naimed from inside at an edge of the " << face << ": how many faces it hits");
            REQUIRE(hits >= 1);
        }
    }
}

TEST_CASE("no ray passes between the slices of a fan", "[03.7]") {
    Random random(42);
    const int slices = 1000;
    std::vector<Vec3> rim;
    for (int i = 0; i < slices; ++i)
        rim.push_back(
            {std::cos(2 * pi * i / slices), std::sin(2 * pi * i / slices), 0.1 * random.uniform(-1, 1)});
    const Vec3 hub(0.01, 0.02, 0.03);
    for (int i = 0; i < cases(2000); ++i) {
        const auto k = random.index(slices);
        const Vec3 origin = Vec3(0, 0, 2) + 0.5 * random.in_cube();
        const Vec3 target = hub + (i % 4 == 0 ? 0 : random.uniform(0, 0.9)) * (rim[k] - hub);
        const Ray ray{origin, target - origin};
        bool hit = false;
        for (std::size_t s = 0; s < slices && !hit; ++s)
            hit = intersect(Triangle{hub, rim[s], rim[(s + 1) % slices]}, ray, Interval{}).has_value();
        INFO(ray << "\naimed at the edge between two slices, from the hub to " << rim[k]);
        REQUIRE(test::or_say(hit, "none of the slices is hit"));
    }
}

// ---------------------------------------------------------------------------------------------- 03.8

TEST_CASE("the surface at a hit: point by weights, flat normal, weights as uv", "[03.8]") {
    const Surface surface =
        surface_at(right_angled, Ray{{1, 2, 5}, {0, 0, -1}}, Hit{.t = 5, .uv = {0.25, 0.5}});
    INFO(right_angled << ", weights 0.25 of a, 0.25 of b and 0.5 of c");
    {
        INFO("the point");
        CHECK(test::near(surface.point, {1, 2, 0}, 0));
    }
    {
        INFO("the normal, and the shading normal");
        CHECK(test::near_direction(surface.normal, {0, 0, 1}, 0));
        CHECK(test::near_direction(surface.shading_normal, {0, 0, 1}, 0));
    }
    INFO("uv, the weights of b and c");
    CHECK(test::near(surface.uv, {0.25, 0.5}, 0));
}

TEST_CASE("the normal is not turned to the viewer", "[03.8]") {
    const Surface from_below =
        surface_at(right_angled, Ray{{1, 2, -5}, {0, 0, 1}}, Hit{.t = 5, .uv = {0.25, 0.5}});
    INFO("the normal, seen from below");
    CHECK(test::near_direction(from_below.normal, {0, 0, 1}, 0));
}

TEST_CASE("the surface point lies on the triangle's plane within the error that it claims", "[03.8]") {
    Random random(43);
    for (int i = 0; i < cases(20000); ++i) {
        const Triangle t = moved(scaled(random_triangle(random), random.magnitude(-6, 6)),
                                 random.magnitude(-6, 6) * random.in_cube());
        const Vec3 w = random_weights(random, 0);
        const Surface surface = surface_at(t, Ray{}, Hit{.t = 1, .uv = {w.y, w.z}});
        // In twice the precision's exponent: weights that sum to exactly 1 name a point that is on the plane.
        using Wide = long double;
        const Wide wb = w.y, wc = w.z, wa = Wide(Real(Real(1 - w.y) - w.z)), sum = wa + wb + wc;
        for (int k = 0; k < 3; ++k) {
            const Wide exact = (wa * Wide(t.a[k]) + wb * Wide(t.b[k]) + wc * Wide(t.c[k])) / sum;
            INFO(t << ", weights " << w << ": how far coordinate " << k
                   << " of the point is off, and its error");
            REQUIRE(std::abs(surface.point[k] - exact) <= Wide(surface.error[k]));
        }
    }
}

TEST_CASE("three equal normals interpolate to themselves", "[03.8]") {
    const Vec3 n(0, 0.6, 0.8);
    const Vec3 result = interpolate(TriangleNormals{n, n, n}, {0.2, 0.3}, {0, 0, 1});
    INFO("the interpolated normal");
    CHECK(test::near_direction(result, n, 4 * unit_roundoff));
}

TEST_CASE("at a corner the interpolated normal is the corner's", "[03.8]") {
    const TriangleNormals normals{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const auto check = [&](const Vec2& uv, const Vec3& expected) {
        INFO("normals (1, 0, 0) at a, (0, 1, 0) at b, (0, 0, 1) at c; interpolated where b and c weigh "
             << uv);
        CHECK(test::near_direction(interpolate(normals, uv, {0, 0, 1}), expected, 0));
    };
    check({0, 0}, {1, 0, 0});
    check({1, 0}, {0, 1, 0});
    check({0, 1}, {0, 0, 1});
}

TEST_CASE("the normal halfway between two is a unit vector, however long theirs are", "[03.8]") {
    const Vec3 expected = Vec3(1, 1, 0) / std::sqrt(Real(2));
    for (const Real length : {1.0, 5.0, 1e-100, 1e100}) {
        const TriangleNormals normals{{length, 0, 0}, {0, length, 0}, {0, 0, length}};
        const Vec3 actual = interpolate(normals, {0.5, 0}, {0, 0, 1});
        INFO("halfway between normals of length " << length << " along x and y: a unit vector");
        CHECK(test::near_direction(actual, expected, 4 * unit_roundoff));
    }
}

TEST_CASE("where the normals cancel, the flat normal stands in", "[03.8]") {
    const TriangleNormals opposite{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}};
    INFO("halfway between (1, 0, 0) and (-1, 0, 0), where the flat normal is (0, 0, 1)");
    CHECK(interpolate(opposite, {0.5, 0}, {0, 0, 1}) == Vec3(0, 0, 1));
}

TEST_CASE("texture coordinates are interpolated linearly", "[03.8]") {
    const TriangleUvs uvs{{2, 1}, {1, 0}, {0.5, 2}};
    const auto check = [&](const Vec2& weights, const Vec2& expected) {
        INFO("uv (2, 1) at a, (1, 0) at b, (0.5, 2) at c; interpolated where b and c weigh " << weights);
        CHECK(test::near(interpolate(uvs, weights), expected, 0));
    };
    check({0, 0}, {2, 1});
    check({1, 0}, {1, 0});
    check({0, 1}, {0.5, 2});
    check({0.25, 0.5}, {1, 1.25});
}

// ---------------------------------------------------------------------------------------------- 03.9

TEST_CASE("of several triangles the nearest is hit, wherever it stands in the list", "[03.9]") {
    const Ray ray{{1, 1, 9}, {0, 0, -1}};
    for (std::size_t place = 0; place < 3; ++place) {
        std::vector<Triangle> triangles(3, right_angled);
        triangles[place] = moved(right_angled, {0, 0, 4});
        INFO("three triangles across the " << ray << "; number " << place
                                           << ", counted from 0, is at t = 5, the others are at t = 9");
        CHECK(test::same_hit(closest_hit(triangles, ray, Interval{}),
                             Hit{.t = 5, .primitive = static_cast<std::uint32_t>(place)}));
    }
}

TEST_CASE("of equally near triangles the first wins", "[03.9]") {
    const Ray ray{{1, 1, 9}, {0, 0, -1}};
    const Triangle far = moved(right_angled, {0, 0, -3});
    const std::vector<Triangle> triangles = {far, right_angled, right_angled, far};
    {
        INFO("four triangles across the " << ray << ", at t = 12, 9, 9 and 12; primitive counts from 0");
        CHECK(test::same_hit(closest_hit(triangles, ray, Interval{}), Hit{.t = 9, .primitive = 1}));
    }
    // A ray through the edge that two triangles share hits both of them at the same distance.
    const std::vector<Triangle> halves = {{{4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, right_angled};
    const auto shared = closest_hit(halves, Ray{{2, 2, 9}, {0, 0, -1}}, Interval{});
    INFO("at the edge that the two triangles share: the first of them is hit");
    REQUIRE(shared);
    CHECK(shared->primitive == 0);
}

TEST_CASE("no triangles, no hit", "[03.9]") {
    CHECK_FALSE(closest_hit(std::vector<Triangle>{}, Ray{}, Interval{}));
    INFO("whether any_hit finds something where there are no triangles");
    CHECK(any_hit(std::vector<Triangle>{}, Ray{}, Interval{}) == false);
}

TEST_CASE("closest_hit and any_hit keep to the range", "[03.9]") {
    const std::vector<Triangle> triangles = {right_angled, moved(right_angled, {0, 0, 4})};
    const Ray ray{{1, 1, 9}, {0, 0, -1}};
    const auto check = [&](const Interval& range, const std::optional<Hit>& expected) {
        INFO("two triangles at t = 9 and t = 5, range " << range);
        CHECK(test::same_hit(closest_hit(triangles, ray, range), expected));
        INFO("whether any_hit finds something");
        CHECK(any_hit(triangles, ray, range) == expected.has_value());
    };
    check({0, 4}, std::nullopt);
    check({5, 9}, Hit{.t = 9, .primitive = 0});
    check({9, 20}, std::nullopt);
    check({4, 5}, Hit{.t = 5, .primitive = 1});
}

TEST_CASE("closest_hit says to the bit what asking each triangle says", "[03.9]") {
    Random random(44);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 50; ++i) triangles.push_back(random_triangle(random));
    for (int i = 0; i < cases(2000); ++i) {
        Ray ray{2.0 * random.in_cube(), random.in_cube()};
        // Some rays go exactly along an axis: then two components of the direction are zero.
        if (i % 5 == 0) ray.direction = {0, random.uniform(-1, 1) < 0 ? -1 : 1, 0};
        std::optional<Hit> expected;
        for (std::size_t k = 0; k < triangles.size(); ++k) {
            std::optional<Hit> hit = intersect(triangles[k], ray, Interval{});
            if (!hit || (expected && expected->t <= hit->t)) continue;
            expected = hit;
            expected->primitive = static_cast<std::uint32_t>(k);
        }
        const auto actual = closest_hit(triangles, ray, Interval{});
        INFO("50 triangles, " << ray << "; expected what asking each says");
        REQUIRE(test::same_hit(actual, expected));
        if (expected) REQUIRE(actual->uv == expected->uv);
        INFO("whether any_hit finds something");
        REQUIRE(any_hit(triangles, ray, Interval{}) == expected.has_value());
    }
}

// --------------------------------------------------------------------------------------------- 03.11

namespace {

/// A regular tetrahedron around the origin, its faces counterclockwise from outside.
const std::vector<Triangle> tetrahedron = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}},
                                           {{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}},
                                           {{1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}},
                                           {{-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}}};

/// The sides of the cube from −1 to 1, two triangles each, counterclockwise from outside; the last is its
/// lid.
std::vector<Triangle> cube() {
    std::vector<Triangle> triangles;
    for (int axis = 0; axis < 3; ++axis)
        for (const Real way : {-1.0, 1.0}) {
            const auto corner = [&](Real x, Real y) {
                Vec3 p(way);
                p[(axis + 1) % 3] = x * way;
                p[(axis + 2) % 3] = y;
                return p;
            };
            triangles.push_back({corner(-1, -1), corner(1, -1), corner(1, 1)});
            triangles.push_back({corner(-1, -1), corner(1, 1), corner(-1, 1)});
        }
    return triangles;
}

// Some roundings of a sum of a few angles.
constexpr Real few_roundings = 64 * unit_roundoff;

void check_angle(const Triangle& triangle, const Vec3& from, Real expected, Real within = few_roundings) {
    INFO(triangle << ", seen from " << from << ": the solid angle");
    CHECK(test::near(solid_angle(triangle, from), expected, within));
}

void check_winding(const std::vector<Triangle>& triangles, const Vec3& point, Real expected) {
    INFO("how often the triangles go round the point " << point);
    CHECK(test::near(winding_number(triangles, point), expected, few_roundings));
}

}  // namespace

TEST_CASE("a triangle between the axes fills an eighth of the view from the origin", "[03.11]") {
    check_angle({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}, pi / 2);
    check_angle({{4, 2, 3}, {1, 7, 3}, {1, 2, 5}}, {1, 2, 3}, pi / 2);
}

TEST_CASE("a triangle that shows its front has a negative solid angle", "[03.11]") {
    check_angle({{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}, {0, 0, 0}, -pi / 2);
}

TEST_CASE("a large triangle close by fills half of the view", "[03.11]") {
    const Real far = 0x1p40;
    check_angle({{2 * far, 0, -1}, {-far, 2 * far, -1}, {-far, -2 * far, -1}}, {0, 0, 0}, -2 * pi, 1e-9);
}

TEST_CASE("a face of a tetrahedron fills a quarter of the view from its centre", "[03.11]") {
    for (const Triangle& face : tetrahedron) check_angle(face, {0, 0, 0}, pi);
}

TEST_CASE("tiny and huge triangles have the solid angle of ordinary ones", "[03.11]") {
    const Triangle octant{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Real size : {1e-200, 1e-20, 1e20, 1e200}) {
        INFO("size " << size);
        check_angle(scaled(octant, size), {0, 0, 0}, pi / 2);
    }
}

TEST_CASE("a triangle seen edge-on fills nothing", "[03.11]") {
    check_angle({{1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {0, 0, 0}, 0);
}

TEST_CASE("a closed cube goes round a point inside once, and round one outside not at all", "[03.11]") {
    check_winding(cube(), {0, 0, 0}, 1);
    check_winding(cube(), {0.5, -0.25, 0.75}, 1);
    check_winding(cube(), {3, 0.5, -0.25}, 0);
}

TEST_CASE("a cube without its lid goes round its centre five sixths of once", "[03.11]") {
    std::vector<Triangle> box = cube();
    box.resize(10);
    check_winding(box, {0, 0, 0}, 5.0 / 6);
}

TEST_CASE("a cube that is turned inside out goes round its inside once backwards", "[03.11]") {
    std::vector<Triangle> inside_out = cube();
    for (Triangle& triangle : inside_out) std::swap(triangle.b, triangle.c);
    check_winding(inside_out, {0.5, 0.25, 0}, -1);
}

TEST_CASE("no triangles go round nothing", "[03.11]") { check_winding({}, {1, 2, 3}, 0); }

TEST_CASE("a tetrahedron goes round the points that are inside of all its faces", "[03.11]") {
    Random random(45);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 point = 2.0 * random.in_cube();
        // On which side of the nearest face the point is; close to it rounding is larger.
        Real inside = infinity;
        for (const Triangle& face : tetrahedron)
            inside = std::min(inside, dot(unit_normal(face), face.a - point));
        if (std::abs(inside) < 1e-3) continue;
        INFO("the point " << point << ", " << std::abs(inside)
                          << (inside > 0 ? " inside of the nearest face" : " outside of a face")
                          << ": how often the tetrahedron goes round it");
        CHECK(test::near(winding_number(tetrahedron, point), inside > 0 ? 1 : 0, 1e-9));
    }
}
