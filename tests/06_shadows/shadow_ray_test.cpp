// Steps 06.1 and 06.2: where a shadow ray starts, where it goes and where it ends.
#include "chapters/01_ray_casting/plane.hpp"
#include "common/math/error.hpp"
#include "tests/06_shadows/things.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

using namespace rt;
using namespace rt::test;

namespace {

Surface surface_with(const Vec3& point, const Vec3& error, const Vec3& normal) {
    return {.point = point, .error = error, .normal = normal, .shading_normal = normal};
}

Surface some_surface(Random& random) {
    const Vec3 point = random.magnitude(-9, 9) * random.in_cube();
    const Vec3 error =
        random.magnitude(-18, -12) * (length(point) + random.magnitude(-9, 9)) * Vec3(0.1, 1, 3);
    return surface_with(point, error, random.direction());
}

/// Where a ray to `direction` starts. `what` says why there.
void check_origin(const Surface& surface, const Vec3& direction, const Vec3& expected, const char* what,
                  Real bound = 0) {
    INFO(surface << "\nwhere a ray to " << direction << " starts: " << what);
    CHECK(near(offset_origin(surface, direction), expected, bound));
}

/// The next floating-point number, upwards and downwards.
Real up_from(Real x) { return std::nextafter(x, infinity); }
Real down_from(Real x) { return std::nextafter(x, -infinity); }

}  // namespace

// -------------------------------------------------------------------------------------- 06.1 offset_origin

TEST_CASE("by hand: on a slope the box of the error reaches 0.6 · 1/8 + 0.8 · 1/16 = 1/8", "[06.1]") {
    const Surface slope = surface_with({0, 0, 7}, {0.125, 0.0625, 1}, {0.6, 0.8, 0});
    check_origin(slope, {0, 1, 0}, {0.075, 0.1, 7}, "1/8 of the normal away", 2 * unit_roundoff);
    INFO("its z, which the normal does not change");
    CHECK(offset_origin(slope, {0, 1, 0}).z == 7);
}

TEST_CASE("a level surface: the origin moves up by the error in height", "[06.1]") {
    const Surface floor = surface_with({1, 2, 3}, {4, 0.25, 8}, {0, 1, 0});
    check_origin(floor, {0.6, 0.8, 0}, {1, up_from(2.25), 3},
                 "at the number next above y = 2 + 0.25, outside of the error's box");
}

TEST_CASE("a direction to the other side moves the origin to the other side", "[06.1]") {
    const Surface floor = surface_with({1, 2, 3}, {4, 0.25, 8}, {0, 1, 0});
    check_origin(floor, {0.6, -0.8, 0}, {1, down_from(1.75), 3},
                 "below the surface, at the number next below y = 2 - 0.25");
}

TEST_CASE("a surface that is known exactly needs no offset", "[06.1]") {
    const Surface exact = surface_with({1, 2, 3}, Vec3(0), {0.6, 0.8, 0});
    check_origin(exact, {0, 1, 0}, {1, 2, 3}, "at the point itself");
}

TEST_CASE("the normal of the geometry counts, not the interpolated one", "[06.1]") {
    Surface surface = surface_with({0, 2, 0}, Vec3(0.25), {0, 1, 0});
    surface.shading_normal = {0.6, -0.8, 0};
    check_origin(surface, {0, 1, 0}, {0, up_from(2.25), 0},
                 "on the side of the normal, not of the shading normal");
}

TEST_CASE("an offset too small to change the point still moves it on to the next number", "[06.1]") {
    const Surface surface = surface_with({1, 1, -1}, Vec3(1e-30), {0.48, -0.6, 0.64});
    check_origin(surface, {1, 0, 0}, {up_from(1), down_from(1), up_from(-1)},
                 "at the next number in each coordinate, on the normal's side");
}

TEST_CASE("the origin is outside of the box of the error, and hardly more", "[06.1]") {
    Random random(61);
    for (int i = 0; i < cases(50'000); ++i) {
        const Surface surface = some_surface(random);
        const Vec3 direction = random.direction();
        const Vec3 origin = offset_origin(surface, direction);
        const Vec3 side = dot(direction, surface.normal) < 0 ? -surface.normal : surface.normal;
        const Real d = dot(glm::abs(side), surface.error);
        INFO(surface << "\na ray to " << direction << " starts at " << origin);
        // How far the farthest corner of the box is from the origin, along the normal; 16 roundings of d in
        // all. Origin and point are so near each other that their difference is exact, or else larger than d.
        const Real moved = dot(origin - surface.point, side);
        REQUIRE(or_say(moved - d >= -16 * unit_roundoff * d, "that is inside of the error's box"));
        for (int k = 0; k < 3; ++k) {
            const Real wanted = surface.point[k] + d * side[k];
            const Real step = 4 * unit_roundoff * std::max(std::abs(wanted), d);
            INFO("its "
                 << "xyz"[k] << ", where the point is moved along the normal by what the box reaches");
            REQUIRE(near(origin[k], wanted, step));
        }
    }
}

TEST_CASE("a scene larger or smaller by a power of two has the same origin, larger or smaller, to the bit",
          "[06.1]") {
    Random random(62);
    for (int i = 0; i < cases(5'000); ++i) {
        Surface surface = some_surface(random);
        const Vec3 direction = random.direction();
        const Vec3 origin = offset_origin(surface, direction);
        for (const int k : {-40, -1, 1, 40}) {
            Surface scaled = surface;
            scaled.point *= std::ldexp(1.0, k);
            scaled.error *= std::ldexp(1.0, k);
            INFO(surface << "\nall lengths times 2^" << k << ": where a ray to " << direction << " starts");
            REQUIRE(offset_origin(scaled, direction) == std::ldexp(1.0, k) * origin);
        }
    }
}

// ----------------------------------------------------------------------------------------- 06.2 shadow_ray

namespace {

void check_ray(const ShadowRay& shadow, const Vec3& origin, const Vec3& direction, Real bound) {
    {
        INFO("where it starts");
        CHECK(near(shadow.ray.origin, origin, 0));
    }
    INFO("its direction");
    CHECK(near_direction(shadow.ray.direction, direction, bound));
}

/// From 0 to a little before the lamp.
void check_range(const ShadowRay& shadow, Real distance) {
    {
        INFO("where its range begins: the origin is offset, so nothing in front of it may be left out");
        CHECK(shadow.range.min == 0);
    }
    INFO("where its range ends: " << distance << " from the lamp, and a few roundings before it");
    CHECK(shadow.range.max < distance);
    CHECK(shadow.range.max >= distance * (1 - gamma(20)));
}

}  // namespace

TEST_CASE("by hand: the ray starts at (0, 1, 0), so the lamp at (3, 5, 0) is 5 away along (0.6, 0.8, 0)",
          "[06.2]") {
    // 3 to the side and 4 up from the offset origin, which is 1 above the point.
    const Surface floor = surface_with({0, 0, 0}, Vec3(1), {0, 1, 0});
    const Vec3 to_lamp(3, 5, 0);
    const ShadowRay shadow =
        shadow_ray(floor, {.direction = normalize(to_lamp), .distance = length(to_lamp)});
    INFO("from a " << floor << ": " << shadow);
    INFO("the direction from where the ray starts, (0, 1, 0), to the lamp at (3, 5, 0), and the distance");
    CHECK(near_direction(shadow.ray.direction, {0.6, 0.8, 0}, 8 * unit_roundoff));
    CHECK(near(shadow.range.max, 5, 5 * gamma(24)));
}

TEST_CASE("a shadow ray goes from the point to the lamp, and ends just before it", "[06.2]") {
    const Surface floor = surface_with({3, 0, 0}, Vec3(0), {0, 1, 0});
    const ShadowRay shadow = shadow_ray(floor, {.direction = {-0.6, 0.8, 0}, .distance = 5});
    INFO("from a " << floor << ": " << shadow);
    check_ray(shadow, {3, 0, 0}, {-0.6, 0.8, 0}, 4 * unit_roundoff);
    check_range(shadow, 5);
}

TEST_CASE("a shadow ray to the sun has no end", "[06.2]") {
    const Surface floor = surface_with({3, 0, 0}, Vec3(0.25), {0, 1, 0});
    const ShadowRay shadow = shadow_ray(floor, {.direction = {-0.6, 0.8, 0}, .distance = infinity});
    INFO("from a " << floor << ": " << shadow);
    check_ray(shadow, offset_origin(floor, {-0.6, 0.8, 0}), {-0.6, 0.8, 0}, 0);
    INFO("the range, from 0 without an end");
    CHECK(shadow.range.min == 0);
    CHECK(shadow.range.max == infinity);
}

TEST_CASE("the ray is shorter by what the offset has moved its start", "[06.2]") {
    const Surface floor = surface_with({3, 0, 0}, Vec3(0.25), {0, 1, 0});
    const ShadowRay shadow = shadow_ray(floor, {.direction = {0, 1, 0}, .distance = 5});
    INFO("from a " << floor << ": " << shadow);
    check_range(shadow, 4.75);
}

TEST_CASE("to a lamp behind the surface the ray starts behind it", "[06.2]") {
    const Surface floor = surface_with({0, 2, 0}, Vec3(0.25), {0, 1, 0});
    const ShadowRay shadow = shadow_ray(floor, {.direction = {0, -1, 0}, .distance = 2});
    check_ray(shadow, {0, down_from(1.75), 0}, {0, -1, 0}, 4 * unit_roundoff);
    INFO("the end of the range, before the lamp at 1.75");
    CHECK(shadow.range.max < 1.75);
}

TEST_CASE("a lamp on the surface makes no NaN", "[06.2]") {
    for (const Real error : {0.0, 0.25}) {
        const Surface floor = surface_with({0, 2, 0}, Vec3(error), {0, 1, 0});
        for (const Real distance : {0.0, error}) {
            const ShadowRay shadow = shadow_ray(floor, {.direction = {0, 1, 0}, .distance = distance});
            INFO("error " << error << ", distance " << distance << ": " << show(shadow));
            CHECK(or_say(is_finite(shadow.ray.origin), "the origin is not finite"));
            CHECK(or_say(is_finite(shadow.ray.direction), "the direction is not finite"));
            INFO("where its range ends");
            CHECK(shadow.range.max >= 0);
            CHECK(shadow.range.max <= error);
        }
    }
}

TEST_CASE("a lamp that hangs in the ceiling is not hidden by the ceiling", "[06.2]") {
    Random random(63);
    const Plane floor{{7, 0.1, -5}, {0, 1, 0}}, ceiling{{-3, 2.7, 40}, {0, -1, 0}};
    int hidden = 0;
    const int rays = cases(20'000);
    for (int i = 0; i < rays; ++i) {
        const Ray view{{0, 1.5, 0}, normalize(Vec3(random.uniform(-9, 9), -1, random.uniform(-9, 9)))};
        const std::optional<Hit> hit = intersect(floor, view, Interval{});
        if (!hit) continue;
        const Surface surface = surface_at(floor, view, *hit);
        const PointLight lamp{.position = {random.uniform(-9, 9), 2.7, random.uniform(-9, 9)},
                              .color = Vec3(1)};
        const ShadowRay shadow = shadow_ray(surface, sample_light(lamp, surface.point));
        if (intersect(ceiling, shadow.ray, shadow.range)) ++hidden;
    }
    INFO("of " << rays << " lamps in the ceiling, how many are hidden by it");
    CHECK(hidden == 0);
}
