// Step 05.1: what a light sends to a point.
#include "chapters/05_lighting/lighting.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

using namespace rt;
using namespace rt::test;

namespace {

/// Some light at some distance from some point, sizes over many orders of magnitude.
struct Case {
    PointLight light;
    Vec3 point;
};

Case some_case(Random& random) {
    const Real scale = random.magnitude(-9, 9);
    Case made;
    made.point = scale * random.in_cube();
    made.light.position = scale * random.in_cube();
    made.light.color = Vec3(random.uniform(0, 1), random.uniform(0, 1), random.magnitude(-3, 3));
    made.light.attenuation = {random.uniform(0, 1), random.uniform(0, 1) / scale,
                              random.uniform(0, 1) / (scale * scale)};
    return made;
}

}  // namespace

TEST_CASE("a point light two units above", "[05.1]") {
    const PointLight light{.position = {1, 5, -1}, .color = {0.5, 0.25, 1}};
    const LightSample sample = sample_light(light, {1, 3, -1});
    CHECK(sample.direction == Vec3(0, 1, 0));
    CHECK(sample.distance == 2);
    CHECK(sample.color == Vec3(0.5, 0.25, 1));
}

TEST_CASE("light at distance 5 is divided by 1 + 2·5 + 3·25", "[05.1]") {
    const PointLight light{.position = {3, 4, 0}, .color = {86, 172, 43}, .attenuation = {1, 2, 3}};
    const LightSample sample = sample_light(light, {0, 0, 0});
    INFO(show(sample));
    CHECK(near(sample.direction, {0.6, 0.8, 0}, 2 * unit_roundoff));
    CHECK(near(sample.distance, 5, 16 * unit_roundoff));
    CHECK(near(sample.color, {1, 2, 0.5}, 16 * unit_roundoff));
}

TEST_CASE("each term of the attenuation works alone", "[05.1]") {
    const Vec3 point(0, 0, -4);
    const auto color_with = [&](const Vec3& attenuation) {
        return sample_light(PointLight{.color = Vec3(1), .attenuation = attenuation}, point).color;
    };
    CHECK(color_with({2, 0, 0}) == Vec3(1.0 / 2));
    CHECK(color_with({0, 2, 0}) == Vec3(1.0 / 8));
    CHECK(color_with({0, 0, 2}) == Vec3(1.0 / 32));
}

TEST_CASE("a directional light is the same everywhere", "[05.1]") {
    const DirectionalLight sun{.direction = {0, 0.6, 0.8}, .color = {0.9, 0.8, 0.7}};
    for (const Vec3& point : {Vec3(0), Vec3(1e9, -3, 0), Vec3(0, 0, 1e-9)}) {
        const LightSample sample = sample_light(sun, point);
        INFO("at " << show(point) << ": " << show(sample));
        CHECK(sample.direction == Vec3(0, 0.6, 0.8));
        CHECK(sample.distance == infinity);
        CHECK(sample.color == Vec3(0.9, 0.8, 0.7));
    }
}

TEST_CASE("a light on the very point gives nothing, at distance 0", "[05.1]") {
    for (const Vec3& attenuation : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0)}) {
        const PointLight light{.position = {1, 2, 3}, .color = Vec3(1), .attenuation = attenuation};
        const LightSample sample = sample_light(light, {1, 2, 3});
        INFO(show(light) << " gives " << show(sample));
        CHECK(sample.color == Vec3(0));
        CHECK(sample.distance == 0);
        CHECK(is_finite(sample.direction));
    }
}

TEST_CASE("attenuation 0 0 0 gives nothing rather than infinity", "[05.1]") {
    const PointLight light{.position = {0, 3, 0}, .color = {1, 0, 1}, .attenuation = Vec3(0)};
    const LightSample sample = sample_light(light, Vec3(0));
    INFO(show(sample));
    CHECK(sample.color == Vec3(0));
    CHECK(sample.direction == Vec3(0, 1, 0));
    CHECK(sample.distance == 3);
}

TEST_CASE("light is a finite number however near or far the lamp", "[05.1]") {
    for (int exponent = -320; exponent <= 308; ++exponent) {
        const Real distance = std::pow(10.0, exponent);
        for (const Vec3& attenuation : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0)}) {
            const PointLight light{
                .position = {0, 0, distance}, .color = {1, 0, 1e6}, .attenuation = attenuation};
            const LightSample sample = sample_light(light, Vec3(0));
            INFO(show(light) << " gives " << show(sample));
            REQUIRE(is_finite(sample.color));
            REQUIRE(is_finite(sample.direction));
            REQUIRE(sample.distance >= 0);
        }
    }
}

TEST_CASE("direction and distance lead from the point to the light", "[05.1]") {
    Random random(51);
    for (int i = 0; i < cases(20'000); ++i) {
        const auto [light, point] = some_case(random);
        const LightSample sample = sample_light(light, point);
        const Vec3 way = light.position - point;
        INFO(show(light) << " seen from " << show(point) << " is " << show(sample));
        // One rounding in the difference, 2.5 in its length, one in the quotient.
        REQUIRE(std::abs(length(sample.direction) - 1) <= 8 * unit_roundoff);
        REQUIRE(near(sample.distance * sample.direction, way, 8 * unit_roundoff * length(way)));
    }
}

TEST_CASE("colour times divisor is the light's colour", "[05.1]") {
    Random random(52);
    for (int i = 0; i < cases(20'000); ++i) {
        const auto [light, point] = some_case(random);
        const LightSample sample = sample_light(light, point);
        const Vec3 attenuation = light.attenuation;
        const Real d = length(light.position - point);
        const Vec3 back = sample.color * (attenuation.x + attenuation.y * d + attenuation.z * d * d);
        INFO(show(light) << " at " << show(point) << " gives " << show(sample));
        // Twice up to 4 roundings for d, squared, and 5 for sums and products; all terms are positive.
        for (int k = 0; k < 3; ++k)
            REQUIRE(std::abs(back[k] - light.color[k]) <= 32 * unit_roundoff * light.color[k]);
    }
}

TEST_CASE("in a scene twice as large, lights are twice as far and have the same direction, to the bit",
          "[05.1]") {
    Random random(53);
    for (int i = 0; i < cases(2'000); ++i) {
        auto [light, point] = some_case(random);
        light.attenuation = {1, 0, 0};
        const LightSample sample = sample_light(light, point);
        for (const int k : {-40, -1, 1, 40}) {
            const Real factor = std::ldexp(1.0, k);
            light.position *= factor;
            const LightSample scaled = sample_light(light, factor * point);
            light.position /= factor;
            INFO(show(light) << " at " << show(point) << ", all times " << show(factor));
            REQUIRE(scaled.direction == sample.direction);
            REQUIRE(scaled.distance == factor * sample.distance);
            REQUIRE(scaled.color == sample.color);
        }
    }
}
