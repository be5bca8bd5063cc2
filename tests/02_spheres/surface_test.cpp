// Step 02.4: the point, the normal and the texture coordinates at a hit.
#include "chapters/02_spheres/sphere.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <limits>
#include <string>

using namespace rt;
using test::cases;
using test::Random;
using test::show;

namespace {

/// The surface where the ray first meets the sphere ahead; the test fails where it does not.
Surface seen(const Sphere& sphere, const Ray& ray) {
    const std::optional<Hit> hit = intersect(sphere, ray, {0, infinity});
    INFO(sphere << ", " << ray);
    REQUIRE(hit);
    return surface_at(sphere, ray, *hit);
}

void check_surface(const Sphere& sphere, const Ray& ray, const Vec3& point, const Vec3& normal) {
    const Surface surface = seen(sphere, ray);
    INFO(sphere << ", " << ray << "\nexpected point " << point << ", normal " << normal << "; found a "
                << surface);
    // The normal first: the point may follow from it.
    {
        INFO("the normal");
        CHECK(test::near_direction(surface.normal, normal, gamma(8)));
    }
    {
        INFO("the shading normal, which is the same as the normal");
        CHECK(test::near_direction(surface.shading_normal, normal, gamma(8)));
    }
    INFO("the point");
    CHECK(test::near(surface.point, point, gamma(8) * (sphere.radius + length(sphere.center))));
}

void check_near_uv(const Vec2& uv, const Vec2& expected, Real tolerance) {
    {
        INFO("u, once around");
        CHECK(test::near(uv.x, expected.x, tolerance));
    }
    INFO("v, from the south pole to the north pole");
    CHECK(test::near(uv.y, expected.y, tolerance));
}

/// Texture coordinates of the unit sphere's point in direction `out`, seen from outside.
Vec2 uv_towards(const Vec3& out) { return sphere_uv(seen({{0, 0, 0}, 1}, {4.0 * out, -out}).normal); }

void check_uv(const Vec3& out, const Vec2& expected) {
    const Vec2 uv = uv_towards(out);
    INFO("texture coordinates of the unit sphere's point in direction " << out);
    check_near_uv(uv, expected, 4 * unit_roundoff);
}

/// A ray at a sphere of radius 10^±3, up to a thousand radii away, that is sure to hit it.
struct Case {
    Sphere sphere;
    Ray ray;
};
Case aimed(Random& random) {
    const Real radius = random.magnitude(-3, 3);
    const Vec3 center = random.magnitude(-3, 3) * random.direction();
    const Vec3 eye = center + radius * random.magnitude(-1, 3) * random.direction();
    const Vec3 target = center + 0.5 * radius * random.in_cube();
    return {{center, radius}, {eye, random.magnitude(-3, 3) * normalize(target - eye)}};
}

}  // namespace

TEST_CASE("the lesson's example: at (0, 0, -6) the normal is (0, -0.6, 0.8), and u is a quarter", "[02.4]") {
    const Sphere sphere{{0, 3, -10}, 5};
    const Ray ray{{0, 0, 0}, {0, 0, -1}};
    check_surface(sphere, ray, {0, 0, -6}, {0, -0.6, 0.8});
    const Vec2 uv = sphere_uv(seen(sphere, ray).normal);
    INFO("texture coordinates there: v is less than a half, below the equator");
    check_near_uv(uv, {0.25, 0.2951672353008665}, 8 * unit_roundoff);
}

TEST_CASE("the normal of the unit sphere is the point itself", "[02.4]") {
    const Sphere sphere{{0, 0, 0}, 1};
    check_surface(sphere, {{0, 0, 5}, {0, 0, -1}}, {0, 0, 1}, {0, 0, 1});
    check_surface(sphere, {{-3, 0, 0}, {2, 0, 0}}, {-1, 0, 0}, {-1, 0, 0});
}

TEST_CASE("the normal is a unit vector whatever the radius and the centre", "[02.4]") {
    check_surface({{1, 2, 3}, 4}, {{1, 20, 3}, {0, -1, 0}}, {1, 6, 3}, {0, 1, 0});
    check_surface({{1, 2, 3}, 0.25}, {{1, 2, -9}, {0, 0, 3}}, {1, 2, 2.75}, {0, 0, -1});
}

TEST_CASE("the normal points outwards even where the ray comes from inside", "[02.4]") {
    check_surface({{0, 0, 0}, 2}, {{0, 0, 0}, {0, 0, -1}}, {0, 0, -2}, {0, 0, -1});
}

TEST_CASE("far from the origin, normals are as exact as near it", "[02.4]") {
    // There coordinates are multiples of 2^-16: a point in the world would be off by as much, the vector from
    // the centre is not.
    for (const Vec3& center : {Vec3(0), Vec3(0x1p36, 0, 0), Vec3(0x1p36, -0x1p36, 0x1p36)}) {
        const Sphere sphere{center, 5};
        const Surface surface = seen(sphere, {center + Vec3(7, 7, 0), {-1, -1, 0}});
        INFO("centre " << center << ", radius 5; seen from (7, 7, 0) beside the centre: the normal");
        CHECK(test::near_direction(surface.normal, {std::sqrt(0.5), std::sqrt(0.5), 0}, gamma(16)));
    }
}

TEST_CASE("u goes once around the y axis and v from the south pole to the north pole", "[02.4]") {
    check_uv({1, 0, 0}, {0, 0.5});
    check_uv({0, 0, 1}, {0.25, 0.5});
    check_uv({-1, 0, 0}, {0.5, 0.5});
    check_uv({0, 0, -1}, {0.75, 0.5});
    INFO("v at the north pole, and at the south pole");
    CHECK(test::near(uv_towards({0, 1, 0}).y, 1, 4 * unit_roundoff));
    CHECK(test::near(uv_towards({0, -1, 0}).y, 0, 4 * unit_roundoff));
}

TEST_CASE("u stays below 1 just before the seam", "[02.4]") {
    for (const Real z : {1e-3, 1e-15, 1e-16, 1e-17, 1e-30, 1e-300}) {
        const Surface surface = seen({{0, 0, 0}, 1}, {{5, 0, -z}, {-1, 0, 0}});
        const Real u = sphere_uv(surface.normal).x;
        INFO("u where the point's z is -" << z << ", just before a whole turn: from 0, and less than 1");
        CHECK(u >= 0);
        CHECK(u < 1);
    }
}

TEST_CASE("u and v are numbers in [0, 1] at the poles too", "[02.4]") {
    Random random(2401);
    for (int i = 0; i < cases(20000); ++i) {
        const Vec3 out =
            normalize(Vec3(random.magnitude(-9, 0), i % 2 == 0 ? 1 : -1, random.magnitude(-9, 0)));
        const Vec2 uv = uv_towards(out);
        INFO("u and v of the unit sphere's point in direction " << out << ": " << uv);
        CHECK(test::or_say(0 <= uv.x && uv.x < 1, "u is not from 0 to less than 1"));
        CHECK(test::or_say(0 <= uv.y && uv.y <= 1 + 2 * unit_roundoff, "v is not from 0 to 1"));
    }
}

TEST_CASE("u and v are the angles of the normal", "[02.4]") {
    Random random(2402);
    for (int i = 0; i < cases(5000); ++i) {
        const Case c = aimed(random);
        const Surface surface = seen(c.sphere, c.ray);
        const Vec3 n = surface.normal;
        const Vec2 uv = sphere_uv(n);
        const Real longitude = uv.x * 2 * pi, latitude = (uv.y - 0.5) * pi;
        INFO("normal " << n << ", uv " << uv);
        // Angles up to 2 pi with a few roundings each.
        const Real around = n.x * std::sin(longitude) - n.z * std::cos(longitude);
        CHECK(test::or_say(std::abs(std::sin(latitude) - n.y) <= 32 * unit_roundoff,
                           "v is another latitude than the normal's"));
        CHECK(test::or_say(std::abs(around) <= 32 * unit_roundoff &&
                               n.x * std::cos(longitude) + n.z * std::sin(longitude) >= 0,
                           "u is another longitude than the normal's"));
    }
}

TEST_CASE("the normal is a unit vector and leads from the centre to the point", "[02.4]") {
    Random random(2403);
    for (int i = 0; i < cases(20000); ++i) {
        const Case c = aimed(random);
        const Surface surface = seen(c.sphere, c.ray);
        const Vec3 outward = surface.point - c.sphere.center;
        INFO(c.sphere << ": point " << surface.point << ", normal " << surface.normal);
        {
            INFO(
                "the length of the normal; divided by its own length, not by the radius, it is 1 to the last "
                "bits");
            CHECK(test::near(length(surface.normal), 1, gamma(8)));
        }
        // The point is rounded to its own last bit, and the normal to a few of its own.
        INFO("the way from the centre to the point: a radius along the normal, however far the ray has come");
        CHECK(test::near(outward, c.sphere.radius * surface.normal,
                         gamma(8) * c.sphere.radius + gamma(2) * length(surface.point)));
        INFO("the shading normal, which is the same as the normal");
        CHECK(surface.shading_normal == surface.normal);
    }
}

TEST_CASE("the point is where the ray was at t", "[02.4]") {
    Random random(2404);
    for (int i = 0; i < cases(20000); ++i) {
        const Case c = aimed(random);
        const std::optional<Hit> hit = intersect(c.sphere, c.ray, {0, infinity});
        REQUIRE(hit);
        const Surface surface = surface_at(c.sphere, c.ray, *hit);
        INFO(c.sphere << ", " << c.ray << "\nthe surface's point, and the ray's at t = " << hit->t);
        const Real size = length(c.ray.origin - c.sphere.center) + c.sphere.radius + length(surface.point);
        CHECK(test::near(surface.point, point_at(c.ray, hit->t), gamma(16) * size));
    }
}

TEST_CASE("a point that rounding left beside the sphere is moved onto it", "[02.4]") {
    // t is a hundredth of a radius too small: the point moves to the sphere, the normal keeps its direction.
    const Ray ray{{0, 0, 5}, {0, 0, -1}};
    const Surface surface = surface_at(Sphere{{0, 0, 0}, 1}, ray, {.t = 3.99});
    INFO("unit sphere, " << ray << ", t = 3.99 where 4 is right: the point, and the normal");
    CHECK(test::near(surface.point, {0, 0, 1}, 0));
    CHECK(test::near_direction(surface.normal, {0, 0, 1}, 0));
}

TEST_CASE("the error bound of the point holds and is not wasteful", "[02.4]") {
    if (std::numeric_limits<long double>::digits < 64) return;  // needs more digits than double has
    using Exact = glm::vec<3, long double, glm::defaultp>;
    Random random(2405);
    for (int i = 0; i < cases(20000); ++i) {
        const Case c = aimed(random);
        const Surface surface = seen(c.sphere, c.ray);
        const Exact n = normalize(Exact(surface.normal));
        const Exact point = Exact(c.sphere.center) + static_cast<long double>(c.sphere.radius) * n;
        const Exact off = abs(Exact(surface.point) - point);
        INFO("point " << show(surface.point) << ", bound " << show(surface.error) << ", actual error "
                      << show(Vec3(off)));
        for (int axis = 0; axis < 3; ++axis) {
            CHECK(test::or_say(off[axis] <= surface.error[axis],
                               "the point is farther off than its bound says"));
            CHECK(test::or_say(
                surface.error[axis] <= 12 * unit_roundoff * (c.sphere.radius + std::abs(surface.point[axis])),
                "the bound is far larger than what rounding can do"));
        }
    }
}
