// Steps 03.3 to 03.6: normal and weights, the watertight test, the surface, the nearest of many.
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

}  // namespace

// ---------------------------------------------------------------------------------------------- 03.3

TEST_CASE("the normal of a counterclockwise triangle in the xy plane is +z", "[03.3]") {
    CHECK(unit_normal(right_angled) == Vec3(0, 0, 1));
    CHECK(unit_normal({{0, 0, 0}, {0, 4, 0}, {4, 0, 0}}) == Vec3(0, 0, -1));
    CHECK(unit_normal({{5, 1, 1}, {5, 3, 1}, {5, 1, 9}}) == Vec3(1, 0, 0));
}

TEST_CASE("the normal has length 1 and is perpendicular to the edges", "[03.3]") {
    Random random(35);
    for (int i = 0; i < cases(2000); ++i) {
        const Triangle t = random_triangle(random);
        const Vec3 n = unit_normal(t);
        INFO("triangle " << show(t) << ", normal " << show(n));
        REQUIRE(std::abs(glm::length(n) - 1) <= 4 * unit_roundoff);
        // The edges are at most 2√3 long; a cross product of unit vectors is off by a few u, and dividing
        // by its length amplifies that.
        REQUIRE(std::abs(glm::dot(n, t.b - t.a)) <= 32 * unit_roundoff * condition(t));
        REQUIRE(std::abs(glm::dot(n, t.c - t.a)) <= 32 * unit_roundoff * condition(t));
    }
}

TEST_CASE("tiny and huge triangles have the normal of ordinary ones", "[03.3]") {
    for (const Real size : {1e-160, 1e-20, 1e20, 1e150}) {
        INFO("size " << size);
        CHECK(unit_normal(scaled(right_angled, size)) == Vec3(0, 0, 1));
    }
}

TEST_CASE("a triangle without area has the normal zero", "[03.3]") {
    CHECK(unit_normal({{1, 2, 3}, {1, 2, 3}, {5, 6, 7}}) == Vec3(0));
    CHECK(unit_normal({{1, 2, 3}, {5, 6, 7}, {1, 2, 3}}) == Vec3(0));
    CHECK(unit_normal({{1, 2, 3}, {5, 6, 7}, {5, 6, 7}}) == Vec3(0));
    CHECK(unit_normal({{0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}, {0.4, 0.8, 1.2}}) == Vec3(0));
    CHECK(unit_normal({{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}) == Vec3(0));
}

TEST_CASE("a needle has its normal whichever corner comes first", "[03.3]") {
    // In the plane z = 0, one edge 2^-50 long, turned so that no coordinate is 0.
    const Vec3 tip(0.1, 0.2, 0.3), blunt = tip + Vec3(1, 2, 2);
    const Triangle needle{tip, blunt, blunt + 0x1p-50 * Vec3(2, -1, 0)};
    const auto& [a, b, c] = needle;
    // The corners are rounded; what matters is that the orders agree.
    const Vec3 normal = unit_normal(needle);
    for (const Triangle& turned : {Triangle{b, c, a}, Triangle{c, a, b}}) {
        INFO("actual " << show(unit_normal(turned)) << ", with another corner first " << show(normal));
        CHECK(glm::length(unit_normal(turned) - normal) <= 256 * unit_roundoff);
    }
    for (const Triangle& reversed : {Triangle{a, c, b}, Triangle{c, b, a}, Triangle{b, a, c}}) {
        INFO("actual " << show(unit_normal(reversed)) << ", expected the opposite of " << show(normal));
        CHECK(glm::length(unit_normal(reversed) + normal) <= 256 * unit_roundoff);
    }
}

TEST_CASE("a triangle that is nearly a line, but not quite, has a normal", "[03.3]") {
    // The corners are 1 and 2 steps from the origin, the last one off the line by its last bit.
    const Real off = std::nextafter(2.0, 3.0);
    CHECK(unit_normal({{0, 0, 0}, {1, 1, 0}, {2, off, 0}}) == Vec3(0, 0, 1));
    CHECK(unit_normal({{0, 0, 0}, {1, 1, 0}, {off, 2, 0}}) == Vec3(0, 0, -1));
}

TEST_CASE("the weights at a corner, in the middle of an edge and at the centre", "[03.3]") {
    const auto check = [](const Vec3& point, const Vec3& expected) {
        const auto weights = barycentric(right_angled, point);
        REQUIRE(weights);
        INFO("point " << show(point) << ", actual " << show(*weights) << ", expected " << show(expected));
        CHECK(glm::length(*weights - expected) <= 8 * unit_roundoff);
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
    const auto beyond_bc = barycentric(right_angled, {3, 3, 0});
    REQUIRE(beyond_bc);
    CHECK(test::near(*beyond_bc, {-0.5, 0.75, 0.75}, 8 * unit_roundoff));
    const auto beyond_ca = barycentric(right_angled, {-1, 1, 0});
    REQUIRE(beyond_ca);
    CHECK(beyond_ca->y == -0.25);
    const auto beyond_ab = barycentric(right_angled, {1, -1, 0});
    REQUIRE(beyond_ab);
    CHECK(beyond_ab->z == -0.25);
}

TEST_CASE("the weights that made a point are found again, at any size", "[03.3]") {
    Random random(36);
    for (int i = 0; i < cases(2000); ++i) {
        const Triangle t = scaled(random_triangle(random), random.magnitude(-20, 20));
        const Vec3 w(random.uniform(-2, 2), random.uniform(-2, 2), 0);
        const Vec3 made(w.x, w.y, 1 - w.x - w.y);
        const auto found = barycentric(t, weighted(t, made));
        REQUIRE(found);
        INFO("triangle " << show(t));
        INFO("made from " << show(made) << ", found " << show(*found));
        // Rounding moves the point by some u of its coordinates, which are up to 9 times a corner's. Measured
        // in the triangle that is the ratio of the coordinates to the least height, which the condition
        // bounds when the extent is known.
        const Real extent = glm::length(t.b - t.a) + glm::length(t.c - t.a);
        const Real reach = glm::length(t.a) + glm::length(t.b) + glm::length(t.c) + extent;
        // Weights from dot products have the square of the condition.
        const Real allowed = 64 * unit_roundoff * condition(t) * condition(t) * reach / extent;
        REQUIRE(glm::length(*found - made) <= allowed);
        // Weights that each come from their own area make 1 as well as they are known themselves.
        REQUIRE(std::abs(found->x + found->y + found->z - 1) <= allowed);
    }
}

TEST_CASE("a triangle without area has no weights", "[03.3]") {
    CHECK_FALSE(barycentric({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {1, 1, 1}));
    CHECK_FALSE(barycentric({{3, 3, 3}, {3, 3, 3}, {3, 3, 3}}, {3, 3, 3}));
}

// ---------------------------------------------------------------------------------------------- 03.4

TEST_CASE("an edge function is positive for a counterclockwise turn", "[03.4]") {
    CHECK(edge_function({1, 0}, {0, 1}) == 1);
    CHECK(edge_function({0, 1}, {1, 0}) == -1);
    CHECK(edge_function({3, 1}, {1, 2}) == 5);
    CHECK(edge_function({3, 1}, {6, 2}) == 0);
}

TEST_CASE("an edge function has the right sign where both products round to the same number", "[03.4]") {
    // (1 + e)(1 − e) − 1·1 = −e², far below the last digit of 1.
    const Real e = 0x1p-30;
    CHECK(edge_function({1 + e, 1}, {1, 1 - e}) == -e * e);
    CHECK(edge_function({1, 1 - e}, {1 + e, 1}) == e * e);
}

TEST_CASE("exchanging the ends of an edge changes the sign and nothing else", "[03.4]") {
    Random random(37);
    for (int i = 0; i < cases(20000); ++i) {
        const Vec2 p(random.uniform(-1, 1), random.uniform(-1, 1));
        // Half of the cases are nearly parallel: that is where rounding matters.
        Vec2 q(random.uniform(-1, 1), random.uniform(-1, 1));
        if (i % 2 == 0) q = p * random.uniform(-2, 2);
        INFO("p = " << show(p) << ", q = " << show(q));
        REQUIRE(edge_function(p, q) == -edge_function(q, p));
    }
}

TEST_CASE("seen along the ray, its own points have x = y = 0", "[03.4]") {
    for (const Vec3& direction : {Vec3(0, 0, -2), Vec3(0.5, 4, -1), Vec3(-8, 2, 4), Vec3(0, -1, 0)}) {
        const Ray ray{{3, -1, 2}, direction};
        const Vec3 p = seen(shear(ray), point_at(ray, 4));
        INFO("direction " << show(direction) << ", the ray's point at t = 4 is seen at " << show(p));
        CHECK(p.x == 0);
        CHECK(p.y == 0);
        // Its depth is that along the direction's greatest coordinate.
        const Vec3 size = glm::abs(direction);
        CHECK(std::abs(p.z) == 4 * max_component(size));
    }
}

TEST_CASE("seen along a ray in the direction of z, points keep their places", "[03.4]") {
    const ShearedRay down = shear({{1, 2, 5}, {0, 0, -1}});
    INFO("actual " << show(seen(down, {4, 6, 5})) << " and " << show(seen(down, {1, 2, 2})));
    CHECK(seen(down, {4, 6, 5}) == Vec3(3, 4, 0));
    CHECK(seen(down, {1, 2, 2}) == Vec3(0, 0, -3));
    // Along x the other two coordinates follow in cyclic order: y, then z.
    const ShearedRay along_x = shear({{0, 0, 0}, {4, 1, 2}});
    INFO("actual " << show(seen(along_x, {4, 3, 5})));
    CHECK(seen(along_x, {4, 3, 5}) == Vec3(2, 3, 4));
}

TEST_CASE("rays exactly at an edge or corner hit, in every order of the corners", "[03.4]") {
    // None of these numbers is rounded: a slanted triangle, and rays at whole multiples of an edge's tenth.
    const Vec3 a(3, -7, 11), step(2, 5, -3), b = a + 10.0 * step, c(-20, 13, 4);
    for (int i = 0; i <= 10; ++i) {
        for (const Vec3& origin : {Vec3(50, 1, -60), Vec3(-17, -90, 33), Vec3(1, 2, 300)}) {
            const Vec3 direction = a + Real(i) * step - origin;
            INFO("at " << i << " tenths of the edge, ray " << show(Ray{origin, direction}));
            CHECK(shoot({a, b, c}, origin, direction));
            CHECK(shoot({b, c, a}, origin, direction));
            CHECK(shoot({c, a, b}, origin, direction));
            CHECK(shoot({c, b, a}, origin, direction));
        }
    }
}

TEST_CASE("a ray that passes a corner by the last bit of a coordinate misses", "[03.4]") {
    // The corner (1, 1, 0) is seen from above, and from 1 aside; beyond it is nothing.
    const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    const Real above = std::nextafter(1.0, 2.0), below = std::nextafter(1.0, 0.0);
    CHECK(shoot(triangle, {1, 1, 5}, {0, 0, -1}));
    CHECK_FALSE(shoot(triangle, {1, above, 5}, {0, 0, -1}));
    CHECK_FALSE(shoot(triangle, {above, 1, 5}, {0, 0, -1}));
    CHECK_FALSE(shoot(triangle, {below, 1, 5}, {0, 0, -1}));
    CHECK(shoot(triangle, {1, below, 5}, {0, 0, -1}));
}

TEST_CASE("a ray down onto the triangle hits it at its height, weights by head", "[03.4]") {
    const auto hit = shoot(right_angled, {1, 2, 5}, {0, 0, -1});
    REQUIRE(hit);
    CHECK(hit->t == 5);
    INFO("weights of b and c: " << show(hit->uv));
    CHECK(hit->uv == Vec2(0.25, 0.5));
}

TEST_CASE("t counts lengths of the direction", "[03.4]") {
    const auto hit = shoot(right_angled, {1, 2, 5}, {0, 0, -4});
    REQUIRE(hit);
    CHECK(hit->t == 1.25);
}

TEST_CASE("both sides of a triangle are hit", "[03.4]") {
    const auto hit = shoot(right_angled, {1, 2, -5}, {0, 0, 1});
    REQUIRE(hit);
    CHECK(hit->t == 5);
    CHECK(hit->uv == Vec2(0.25, 0.5));
}

TEST_CASE("rays past each of the edges miss", "[03.4]") {
    CHECK_FALSE(shoot(right_angled, {2.5, 2.5, 5}, {0, 0, -1}));
    CHECK_FALSE(shoot(right_angled, {-0.5, 1, 5}, {0, 0, -1}));
    CHECK_FALSE(shoot(right_angled, {1, -0.5, 5}, {0, 0, -1}));
}

TEST_CASE("edges and corners belong to the triangle", "[03.4]") {
    for (const Vec3& w :
         {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.5, 0.5, 0), Vec3(0, 0.25, 0.75)}) {
        const Vec3 target = weighted(right_angled, w);
        INFO("target " << show(target));
        const auto hit = shoot(right_angled, target + Vec3(0, 0, 5), {0, 0, -1});
        REQUIRE(hit);
        CHECK(hit->uv == Vec2(w.y, w.z));
    }
}

TEST_CASE("a triangle behind the ray is missed", "[03.4]") {
    CHECK_FALSE(shoot(right_angled, {1, 1, 5}, {0, 0, 1}));
    CHECK_FALSE(shoot(right_angled, {1, 1, -5}, {0, 0, -1}));
}

TEST_CASE("the range leaves out its beginning and includes its end", "[03.4]") {
    CHECK_FALSE(shoot(right_angled, {1, 1, 5}, {0, 0, -1}, {5, 10}));
    CHECK(shoot(right_angled, {1, 1, 5}, {0, 0, -1}, {4, 5}));
    CHECK_FALSE(shoot(right_angled, {1, 1, 5}, {0, 0, -1}, {0, 4}));
    CHECK(shoot(right_angled, {1, 1, -5}, {0, 0, -1}, {-10, 0}));
}

TEST_CASE("a triangle seen edge-on is missed", "[03.4]") {
    CHECK_FALSE(shoot(right_angled, {-3, 1, 0}, {1, 0, 0}));
    CHECK_FALSE(shoot(right_angled, {1, -3, 0}, {0, 1, 0}));
    CHECK_FALSE(shoot(right_angled, {-1, -1, 0}, {1, 1, 0}));
}

TEST_CASE("a triangle without area is missed, wherever the ray points", "[03.4]") {
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

TEST_CASE("rays along each axis, both ways, hit a triangle across the axis", "[03.4]") {
    const Triangle across{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}};
    for (int axis = 0; axis < 3; ++axis) {
        for (const Real way : {-1.0, 1.0}) {
            Vec3 direction(0);
            direction[axis] = way;
            const Vec3 origin = Vec3(1) - 7.0 * direction;
            INFO("ray " << show(Ray{origin, direction}));
            const auto hit = shoot(across, origin, direction);
            REQUIRE(hit);
            CHECK(hit->t == 7);
            CHECK(glm::length(hit->uv - Vec2(1.0 / 3)) <= 8 * unit_roundoff);
        }
    }
}

TEST_CASE("a ray hits where it is aimed, and misses where it is aimed outside", "[03.4]") {
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
        INFO("triangle " << show(t) << "\nray " << show(Ray{origin, direction}));
        const auto hit = shoot(t, origin, direction);
        REQUIRE(hit);
        REQUIRE(std::abs(hit->t - 1) <= 64 * unit_roundoff * kappa);
        REQUIRE(glm::length(hit->uv - Vec2(w.y, w.z)) <= 64 * unit_roundoff * kappa);

        Vec3 outside = w;
        const int corner = static_cast<int>(random.index(3));
        outside[corner] = -0.01;
        outside /= outside.x + outside.y + outside.z;
        REQUIRE_FALSE(shoot(t, origin, weighted(t, outside) - origin));
    }
}

TEST_CASE("the order of the corners changes neither hit nor miss", "[03.4]") {
    Random random(40);
    for (int i = 0; i < cases(5000); ++i) {
        const Triangle t = random_triangle(random);
        const Vec3 origin = 3.0 * random.direction();
        // On the edge between a and b, or at a corner: rounding decides, but always in the same way.
        const Real at = i % 3 == 0 ? 0 : random.uniform(0, 1);
        const Vec3 direction = t.a + at * (t.b - t.a) - origin;
        INFO("triangle " << show(t) << "\nray " << show(Ray{origin, direction}));
        const bool hit = shoot(t, origin, direction).has_value();
        REQUIRE(shoot({t.b, t.c, t.a}, origin, direction).has_value() == hit);
        REQUIRE(shoot({t.c, t.b, t.a}, origin, direction).has_value() == hit);
    }
}

TEST_CASE("directions and triangles of any size", "[03.4]") {
    for (const Real size : {1e-20, 1e-10, 1e10, 1e20}) {
        for (const Real length : {1e-20, 1e-10, 1e10, 1e20}) {
            INFO("triangle scaled by " << size << ", direction of length " << length);
            const auto hit = shoot(scaled(right_angled, size), Vec3(1, 2, 5) * size, {0, 0, -length});
            REQUIRE(hit);
            CHECK(hit->t == Approx(5 * size / length).epsilon(1e-15));
            CHECK(hit->uv.x == Approx(0.25).epsilon(1e-15));
            CHECK_FALSE(shoot(scaled(right_angled, size), Vec3(3, 3, 5) * size, {0, 0, -length}));
        }
    }
}

TEST_CASE("no ray escapes through the edges and corners of a closed octahedron", "[03.4]") {
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
            INFO("ray " << show(aimed) << " aimed at an edge of " << show(face));
            REQUIRE(hits >= 1);
        }
    }
}

TEST_CASE("no ray passes between the slices of a fan", "[03.4]") {
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
        INFO("ray " << show(ray) << " aimed at the edge to " << show(rim[k]));
        REQUIRE(hit);
    }
}

// ---------------------------------------------------------------------------------------------- 03.5

TEST_CASE("the surface at a hit: point by weights, flat normal, weights as uv", "[03.5]") {
    const Surface surface =
        surface_at(right_angled, Ray{{1, 2, 5}, {0, 0, -1}}, Hit{.t = 5, .uv = {0.25, 0.5}});
    CHECK(surface.point == Vec3(1, 2, 0));
    CHECK(surface.normal == Vec3(0, 0, 1));
    CHECK(surface.shading_normal == Vec3(0, 0, 1));
    CHECK(surface.uv == Vec2(0.25, 0.5));
}

TEST_CASE("the normal is not turned to the viewer", "[03.5]") {
    const Surface from_below =
        surface_at(right_angled, Ray{{1, 2, -5}, {0, 0, 1}}, Hit{.t = 5, .uv = {0.25, 0.5}});
    CHECK(from_below.normal == Vec3(0, 0, 1));
}

TEST_CASE("the surface point lies on the triangle's plane within the error that it claims", "[03.5]") {
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
            INFO("triangle " << show(t) << ", weights " << show(w) << ", coordinate " << k);
            INFO("off by " << static_cast<Real>(surface.point[k] - exact) << ", claimed "
                           << surface.error[k]);
            REQUIRE(std::abs(surface.point[k] - exact) <= Wide(surface.error[k]));
        }
    }
}

TEST_CASE("three equal normals interpolate to themselves", "[03.5]") {
    const Vec3 n(0, 0.6, 0.8);
    const Vec3 result = interpolate(TriangleNormals{n, n, n}, {0.2, 0.3}, {0, 0, 1});
    INFO("actual " << show(result));
    CHECK(glm::length(result - n) <= 4 * unit_roundoff);
}

TEST_CASE("at a corner the interpolated normal is the corner's", "[03.5]") {
    const TriangleNormals normals{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    CHECK(interpolate(normals, {0, 0}, {0, 0, 1}) == Vec3(1, 0, 0));
    CHECK(interpolate(normals, {1, 0}, {0, 0, 1}) == Vec3(0, 1, 0));
    CHECK(interpolate(normals, {0, 1}, {0, 0, 1}) == Vec3(0, 0, 1));
}

TEST_CASE("the normal half-way between two is a unit vector, however long theirs are", "[03.5]") {
    const Vec3 expected = Vec3(1, 1, 0) / std::sqrt(Real(2));
    for (const Real length : {1.0, 5.0, 1e-100, 1e100}) {
        const TriangleNormals normals{{length, 0, 0}, {0, length, 0}, {0, 0, length}};
        const Vec3 actual = interpolate(normals, {0.5, 0}, {0, 0, 1});
        INFO("length " << length << ", actual " << show(actual) << ", expected " << show(expected));
        CHECK(glm::length(actual - expected) <= 4 * unit_roundoff);
    }
}

TEST_CASE("where the normals cancel, the flat normal stands in", "[03.5]") {
    const TriangleNormals opposite{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}};
    CHECK(interpolate(opposite, {0.5, 0}, {0, 0, 1}) == Vec3(0, 0, 1));
}

TEST_CASE("texture coordinates are interpolated linearly", "[03.5]") {
    const TriangleUvs uvs{{2, 1}, {1, 0}, {0.5, 2}};
    CHECK(interpolate(uvs, {0, 0}) == Vec2(2, 1));
    CHECK(interpolate(uvs, {1, 0}) == Vec2(1, 0));
    CHECK(interpolate(uvs, {0, 1}) == Vec2(0.5, 2));
    CHECK(interpolate(uvs, {0.25, 0.5}) == Vec2(1, 1.25));
}

// ---------------------------------------------------------------------------------------------- 03.6

TEST_CASE("of several triangles the nearest is hit, wherever it stands in the list", "[03.6]") {
    const Ray ray{{1, 1, 9}, {0, 0, -1}};
    for (std::size_t place = 0; place < 3; ++place) {
        std::vector<Triangle> triangles(3, right_angled);
        triangles[place] = moved(right_angled, {0, 0, 4});
        const auto hit = closest_hit(triangles, ray, Interval{});
        REQUIRE(hit);
        CHECK(hit->t == 5);
        CHECK(hit->primitive == place);
    }
}

TEST_CASE("of equally near triangles the first wins", "[03.6]") {
    const Ray ray{{1, 1, 9}, {0, 0, -1}};
    const Triangle far = moved(right_angled, {0, 0, -3});
    const std::vector<Triangle> triangles = {far, right_angled, right_angled, far};
    const auto hit = closest_hit(triangles, ray, Interval{});
    REQUIRE(hit);
    CHECK(hit->primitive == 1);
    // A ray through the edge that two triangles share hits both of them at the same distance.
    const std::vector<Triangle> halves = {{{4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, right_angled};
    const auto shared = closest_hit(halves, Ray{{2, 2, 9}, {0, 0, -1}}, Interval{});
    REQUIRE(shared);
    CHECK(shared->primitive == 0);
}

TEST_CASE("no triangles, no hit", "[03.6]") {
    CHECK_FALSE(closest_hit(std::vector<Triangle>{}, Ray{}, Interval{}));
    CHECK_FALSE(any_hit(std::vector<Triangle>{}, Ray{}, Interval{}));
}

TEST_CASE("closest_hit and any_hit keep to the range", "[03.6]") {
    const std::vector<Triangle> triangles = {right_angled, moved(right_angled, {0, 0, 4})};
    const Ray ray{{1, 1, 9}, {0, 0, -1}};
    CHECK_FALSE(closest_hit(triangles, ray, {0, 4}));
    CHECK_FALSE(any_hit(triangles, ray, {0, 4}));
    const auto behind_the_first = closest_hit(triangles, ray, {5, 9});
    REQUIRE(behind_the_first);
    CHECK(behind_the_first->primitive == 0);
    CHECK(behind_the_first->t == 9);
    CHECK(any_hit(triangles, ray, {5, 9}));
    CHECK_FALSE(any_hit(triangles, ray, {9, 20}));
    // Two candidates in one range: the nearer one is at its very end.
    CHECK(closest_hit(triangles, ray, {4, 5}).has_value());
}

TEST_CASE("closest_hit says to the bit what asking each triangle says", "[03.6]") {
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
        INFO("ray " << show(ray));
        REQUIRE(actual.has_value() == expected.has_value());
        REQUIRE(any_hit(triangles, ray, Interval{}) == expected.has_value());
        if (!expected) continue;
        REQUIRE(actual->primitive == expected->primitive);
        REQUIRE(actual->t == expected->t);
        REQUIRE(actual->uv == expected->uv);
    }
}
