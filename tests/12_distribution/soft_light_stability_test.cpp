// Step 12.18 where lights are huge or tiny, far away or touched.
#include "chapters/12_distribution/soft_light.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/soft_light_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::both_ways;
using test::cases;
using test::name_of;
using test::near;
using test::Random;

namespace {

/// A light of any shape at the origin, about `size` large; its bright side faces +z.
AreaLight any_light(Random& random, Real size) {
    const Vec3 radiance(random.magnitude(-3, 3));
    const Real x = size * random.uniform(0.1, 1), y = size * random.uniform(0.1, 1);
    switch (random.index(5)) {
        case 0:
            return {QuadLight{Vec3(0), {0, y, 0}, {x, 0, 0}}, radiance};
        case 1:
            return {QuadLight{Vec3(0), {x / 3, y, 0}, {x, 0, 0}}, radiance};
        case 2:
            return {DiscLight{Vec3(0), {0, 0, 1}, x}, radiance};
        case 3:
            return {SphereLight{Vec3(0), x}, radiance};
        default:
            return {TriangleLight{Vec3(0), {x, 0, 0}, {0, y, 0}}, radiance};
    }
}

Vec2 any_numbers(Random& random) {
    const Real x = test::ends_and_between[random.index(7)];
    return {x, test::ends_and_between[random.index(7)]};
}

/// A sample of a light is a unit direction, a distance and a colour that are numbers and not negative.
void require_sound(const AreaLight& light, const Vec3& point, LightSampling how, const Vec2& numbers) {
    const auto sample = sample_light(light, point, how, numbers);
    if (!sample) return;
    INFO(name_of(light) << " seen from " << point << ", random numbers " << numbers << ", " << name_of(how)
                        << ": " << *sample);
    const bool sound = std::abs(length(sample->direction) - 1) <= gamma(16) && sample->distance >= 0 &&
                       sample->distance < infinity && sample->color.x >= 0 && sample->color.x < infinity;
    if (!sound) REQUIRE(sound);
}

}  // namespace

TEST_CASE("lights of any size at any distance: samples are numbers", "[12.18][stability]") {
    Random random(12195);
    for (int i = 0; i < cases(10000); ++i) {
        const AreaLight light = any_light(random, random.magnitude(-12, 12));
        const Vec3 point = random.magnitude(-12, 12) * random.direction();
        const Vec2 numbers = any_numbers(random);
        for (const LightSampling how : both_ways) require_sound(light, point, how, numbers);
    }
}

TEST_CASE("in the plane of a lamp, on its edges and on it there is no NaN", "[12.18][stability]") {
    Random random(12196);
    for (int i = 0; i < cases(10000); ++i) {
        const Real size = random.magnitude(-6, 6);
        const AreaLight light = any_light(random, size);
        Vec3 point = 2 * size * random.in_cube();
        for (int axis = 0; axis < 3; ++axis)
            if (random.index(3) == 0) point[axis] = 0;
        point.z = random.index(2) == 0 ? 0 : random.sign() * size * random.magnitude(-20, -6);
        const Vec2 numbers = any_numbers(random);
        for (const LightSampling how : both_ways) require_sound(light, point, how, numbers);
    }
}

TEST_CASE("small lamps far away send radiance·area·cosine/(pi d²) both ways", "[12.18][stability]") {
    Random random(12197);
    for (int i = 0; i < cases(5000); ++i) {
        // In the lamp's units: up to 1e8 away, at least 6 degrees above its plane.
        const Real size = random.magnitude(-8, 8), part = random.magnitude(-8, -4), d = size / part;
        Vec3 w = random.direction();
        w.z = std::abs(w.z);
        if (w.z < 0.1) continue;
        const Real x = size * random.uniform(0.1, 1), y = size * random.uniform(0.1, 1);
        const bool is_quad = random.index(2) == 0;
        const AreaLight light = is_quad ? AreaLight{QuadLight{Vec3(0), {0, y, 0}, {x, 0, 0}}, Vec3(pi)}
                                        : AreaLight{TriangleLight{Vec3(0), {x, 0, 0}, {0, y, 0}}, Vec3(pi)};
        const Real area = is_quad ? x * y : x * y / 2, expected = area * w.z / (d * d);
        const Vec2 numbers = test::square_point(random);
        for (const LightSampling how : both_ways) {
            const auto sample = sample_light(light, d * w, how, numbers);
            INFO(name_of(light) << " of radiance pi seen from " << d * w << ", random numbers " << numbers
                                << ", " << name_of(how));
            REQUIRE(sample.has_value());
            // The lamp's places differ by 1.5·size: the cosine by part/w.z of itself, the square by 3·part.
            const Real bound = 8 * part / w.z + gamma(4096);
            REQUIRE(near(sample->color.x / expected, 1, bound));
        }
    }
}
