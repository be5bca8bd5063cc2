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
    REQUIRE(hit.has_value());
    return surface_at(sphere, ray, *hit);
}

void check_surface(const Sphere& sphere, const Ray& ray, const Vec3& point, const Vec3& normal) {
    const Surface surface = seen(sphere, ray);
    INFO("expected point " << show(point) << ", normal " << show(normal));
    INFO("actual   point " << show(surface.point) << ", normal " << show(surface.normal));
    CHECK(test::near(surface.point, point, gamma(8) * (sphere.radius + length(sphere.center))));
    CHECK(test::near(surface.normal, normal, gamma(8)));
    CHECK(test::near(surface.shading_normal, normal, gamma(8)));
}

/// Texture coordinates of the unit sphere's point in direction `out`, seen from outside.
Vec2 uv_towards(const Vec3& out) { return sphere_uv(seen({{0, 0, 0}, 1}, {4.0 * out, -out}).normal); }

void check_uv(const Vec3& out, const Vec2& expected) {
    const Vec2 uv = uv_towards(out);
    INFO("towards " << show(out) << ": expected " << expected << ", actual " << uv);
    CHECK(test::near(uv, expected, 4 * unit_roundoff));
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

TEST_CASE("the normal of the unit sphere is the point itself", "[02.4]") {
    const Sphere sphere{{0, 0, 0}, 1};
    check_surface(sphere, {{0, 0, 5}, {0, 0, -1}}, {0, 0, 1}, {0, 0, 1});
    check_surface(sphere, {{-3, 0, 0}, {2, 0, 0}}, {-1, 0, 0}, {-1, 0, 0});
}

TEST_CASE("the normal is a unit vector whatever the radius and the centre", "[02.4]") {
    check_surface({{1, 2, 3}, 4}, {{1, 20, 3}, {0, -1, 0}}, {1, 6, 3}, {0, 1, 0});
    check_surface({{1, 2, 3}, 0.25}, {{1, 2, -9}, {0, 0, 3}}, {1, 2, 2.75}, {0, 0, -1});
}

TEST_CASE("the normal points outwards also where the ray comes from inside", "[02.4]") {
    check_surface({{0, 0, 0}, 2}, {{0, 0, 0}, {0, 0, -1}}, {0, 0, -2}, {0, 0, -1});
}

TEST_CASE("far from the origin normals are as exact as near it", "[02.4]") {
    // There coordinates are multiples of 2^-16: a point in the world would be off by as much, the vector from
    // the centre is not.
    for (const Vec3& center : {Vec3(0), Vec3(0x1p36, 0, 0), Vec3(0x1p36, -0x1p36, 0x1p36)}) {
        const Sphere sphere{center, 5};
        const Surface surface = seen(sphere, {center + Vec3(7, 7, 0), {-1, -1, 0}});
        INFO("centre " << center << ", radius 5; seen from (7, 7, 0) beside the centre");
        CHECK(test::near(surface.normal, {std::sqrt(0.5), std::sqrt(0.5), 0}, gamma(16)));
    }
}

TEST_CASE("u goes once around the y axis and v from the south pole to the north pole", "[02.4]") {
    check_uv({1, 0, 0}, {0, 0.5});
    check_uv({0, 0, 1}, {0.25, 0.5});
    check_uv({-1, 0, 0}, {0.5, 0.5});
    check_uv({0, 0, -1}, {0.75, 0.5});
    CHECK(test::near(uv_towards({0, 1, 0}).y, 1, 4 * unit_roundoff));
    CHECK(test::near(uv_towards({0, -1, 0}).y, 0, 4 * unit_roundoff));
}

TEST_CASE("u stays below 1 just before the seam", "[02.4]") {
    for (const Real z : {1e-3, 1e-15, 1e-16, 1e-17, 1e-30, 1e-300}) {
        const Surface surface = seen({{0, 0, 0}, 1}, {{5, 0, -z}, {-1, 0, 0}});
        const Real u = sphere_uv(surface.normal).x;
        CAPTURE(z, u);
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
        INFO("towards " << show(out) << ": " << uv);
        CHECK((0 <= uv.x && uv.x < 1));
        CHECK((0 <= uv.y && uv.y <= 1 + 2 * unit_roundoff));
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
        INFO("normal " << show(n) << ", uv (" << uv.x << ", " << uv.y << ')');
        // Angles up to 2 pi with a few roundings each.
        CHECK(std::abs(std::sin(latitude) - n.y) <= 32 * unit_roundoff);
        CHECK(std::abs(n.x * std::sin(longitude) - n.z * std::cos(longitude)) <= 32 * unit_roundoff);
        CHECK(n.x * std::cos(longitude) + n.z * std::sin(longitude) >= 0);
    }
}

TEST_CASE("the normal is a unit vector and leads from the centre to the point", "[02.4]") {
    Random random(2403);
    for (int i = 0; i < cases(20000); ++i) {
        const Case c = aimed(random);
        const Surface surface = seen(c.sphere, c.ray);
        const Vec3 outward = surface.point - c.sphere.center;
        INFO("center " << show(c.sphere.center) << ", radius " << c.sphere.radius);
        INFO("point " << show(surface.point) << ", normal " << show(surface.normal));
        CHECK(std::abs(length(surface.normal) - 1) <= gamma(8));
        // The point is rounded to its own last bit, and the normal to a few of its own.
        CHECK(length(outward - c.sphere.radius * surface.normal) <=
              gamma(8) * c.sphere.radius + gamma(2) * length(surface.point));
        CHECK(surface.shading_normal == surface.normal);
    }
}

TEST_CASE("the point is where the ray was at t", "[02.4]") {
    Random random(2404);
    for (int i = 0; i < cases(20000); ++i) {
        const Case c = aimed(random);
        const std::optional<Hit> hit = intersect(c.sphere, c.ray, {0, infinity});
        REQUIRE(hit.has_value());
        const Surface surface = surface_at(c.sphere, c.ray, *hit);
        INFO("at t " << show(point_at(c.ray, hit->t)) << ", point " << show(surface.point));
        const Real size = length(c.ray.origin - c.sphere.center) + c.sphere.radius + length(surface.point);
        CHECK(length(point_at(c.ray, hit->t) - surface.point) <= gamma(16) * size);
    }
}

TEST_CASE("a point that rounding left beside the sphere is moved onto it", "[02.4]") {
    // t is a hundredth of a radius too small: the point moves to the sphere, the normal keeps its direction.
    const Ray ray{{0, 0, 5}, {0, 0, -1}};
    const Surface surface = surface_at(Sphere{{0, 0, 0}, 1}, ray, {.t = 3.99});
    CHECK(surface.point == Vec3(0, 0, 1));
    CHECK(surface.normal == Vec3(0, 0, 1));
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
            CHECK(off[axis] <= surface.error[axis]);
            CHECK(surface.error[axis] <=
                  12 * unit_roundoff * (c.sphere.radius + std::abs(surface.point[axis])));
        }
    }
}
