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

void check_sample(const LightSample& sample, const Vec3& direction, Real distance, const Vec3& color,
                  Real bound = 0) {
    {
        INFO("the direction, from the point to the light");
        CHECK(near_direction(sample.direction, direction, bound));
    }
    {
        INFO("the distance");
        CHECK(near(sample.distance, distance, bound));
    }
    INFO("the colour of the light that arrives");
    CHECK(near_color(sample.color, color, bound));
}

}  // namespace

TEST_CASE("by hand: light from (3, 4, 0), at distance 5, is divided by 1 + 2·5 + 3·25", "[05.1]") {
    const PointLight light{.position = {3, 4, 0}, .color = {86, 172, 43}, .attenuation = {1, 2, 3}};
    INFO(light << "\nseen from (0, 0, 0), at distance 5: its colour is divided by 86");
    check_sample(sample_light(light, {0, 0, 0}), {0.6, 0.8, 0}, 5, {1, 2, 0.5}, 16 * unit_roundoff);
}

TEST_CASE("a weak lamp that is very near shines like a strong one farther away", "[05.1]") {
    // Its colour is divided by what the divisor is, however small: by 2^-80 at distance 2^-40.
    const Real d = 0x1p-40;
    const PointLight light{.position = {0, d, 0}, .color = d * d * Vec3(1, 2, 0.5), .attenuation = {0, 0, 1}};
    INFO(light << "\nseen from (0, 0, 0): its colour is divided by the square of the distance, " << d * d);
    check_sample(sample_light(light, Vec3(0)), {0, 1, 0}, d, {1, 2, 0.5}, 16 * unit_roundoff);
}

TEST_CASE("a point light two units above", "[05.1]") {
    const PointLight light{.position = {1, 5, -1}, .color = {0.5, 0.25, 1}};
    INFO(light << "\nseen from (1, 3, -1)");
    check_sample(sample_light(light, {1, 3, -1}), {0, 1, 0}, 2, {0.5, 0.25, 1});
}

TEST_CASE("each term of the attenuation works alone", "[05.1]") {
    const Vec3 point(0, 0, -4);
    const auto check = [&](const Vec3& attenuation, Real divisor) {
        INFO("a white light at distance 4, attenuation " << attenuation << ": its colour is divided by "
                                                         << divisor);
        const LightSample sample =
            sample_light(PointLight{.color = Vec3(1), .attenuation = attenuation}, point);
        CHECK(near_color(sample.color, Vec3(1 / divisor), 0));
    };
    check({2, 0, 0}, 2);
    check({0, 2, 0}, 8);
    check({0, 0, 2}, 32);
}

TEST_CASE("a directional light is the same everywhere", "[05.1]") {
    const DirectionalLight sun{.direction = {0, 0.6, 0.8}, .color = {0.9, 0.8, 0.7}};
    for (const Vec3& point : {Vec3(0), Vec3(1e9, -3, 0), Vec3(0, 0, 1e-9)}) {
        INFO(sun << "\nseen from " << point);
        check_sample(sample_light(sun, point), {0, 0.6, 0.8}, infinity, {0.9, 0.8, 0.7});
    }
}

TEST_CASE("a light on the very point gives nothing, at distance 0", "[05.1]") {
    for (const Vec3& attenuation : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0)}) {
        const PointLight light{.position = {1, 2, 3}, .color = Vec3(1), .attenuation = attenuation};
        const LightSample sample = sample_light(light, {1, 2, 3});
        INFO(light << "\nseen from where it is gives " << sample);
        {
            INFO("the colour of the light that arrives");
            CHECK(near_color(sample.color, Vec3(0), 0));
        }
        {
            INFO("the distance");
            CHECK(sample.distance == 0);
        }
        INFO("the direction, whichever, with which others go on computing");
        CHECK(or_say(is_finite(sample.direction), show(sample.direction) + ", expected finite numbers"));
    }
}

TEST_CASE("attenuation 0 0 0 gives nothing rather than infinity", "[05.1]") {
    const PointLight light{.position = {0, 3, 0}, .color = {1, 0, 1}, .attenuation = Vec3(0)};
    INFO(light << "\nseen from (0, 0, 0): where the divisor is 0 no light arrives");
    check_sample(sample_light(light, Vec3(0)), {0, 1, 0}, 3, Vec3(0));
}

TEST_CASE("a lamp is black where one channel alone would be infinite", "[05.1]") {
    for (int channel = 0; channel < 3; ++channel) {
        PointLight light{.position = {0, 3, 0}, .color = Vec3(1), .attenuation = {1e-20, 0, 0}};
        light.color[channel] = 1e300;
        INFO(light << "\nseen from (0, 0, 0): divided by 1e-20, one channel is not a finite number");
        check_sample(sample_light(light, Vec3(0)), {0, 1, 0}, 3, Vec3(0));
    }
}

TEST_CASE("light is a finite number however near or far the lamp", "[05.1]") {
    for (int exponent = -320; exponent <= 308; ++exponent) {
        const Real distance = std::pow(10.0, exponent);
        for (const Vec3& attenuation : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0)}) {
            const PointLight light{
                .position = {0, 0, distance}, .color = {1, 0, 1e6}, .attenuation = attenuation};
            const LightSample sample = sample_light(light, Vec3(0));
            INFO(light << "\nseen from (0, 0, 0) gives " << sample);
            REQUIRE(or_say(is_finite(sample.color),
                           "the colour " + show(sample.color) + ", expected finite numbers"));
            REQUIRE(or_say(is_finite(sample.direction),
                           "the direction " + show(sample.direction) + ", expected finite numbers"));
            REQUIRE(or_say(sample.distance >= 0,
                           "the distance " + show(sample.distance) + ", expected 0 or more"));
        }
    }
}

TEST_CASE("direction and distance lead from the point to the light", "[05.1]") {
    Random random(51);
    for (int i = 0; i < cases(20'000); ++i) {
        const auto [light, point] = some_case(random);
        const LightSample sample = sample_light(light, point);
        const Vec3 way = light.position - point;
        INFO(light << "\nseen from " << point << " gives direction " << sample.direction << " and distance "
                   << sample.distance);
        // One rounding in the difference, 2.5 in its length, one in the quotient.
        {
            INFO("the length of the direction");
            REQUIRE(near(length(sample.direction), 1, 8 * unit_roundoff));
        }
        INFO("distance times direction: the way from the point to the light");
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
        INFO(light << "\nseen from " << point << ", at distance " << d << " the colour " << sample.color
                   << " arrives: that times the divisor");
        // Twice up to 4 roundings for d, squared, and 5 for sums and products; all terms are positive.
        for (int k = 0; k < 3; ++k) {
            const char* const channels[] = {"red", "green", "blue"};
            INFO("its " << channels[k] << " channel, expected the lamp's");
            REQUIRE(near(back[k], light.color[k], 32 * unit_roundoff * light.color[k]));
        }
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
            INFO(light << "\nseen from " << point << " gives " << sample << ";\nin a scene " << factor
                       << " times as large");
            {
                INFO("the direction, which is the same");
                REQUIRE(scaled.direction == sample.direction);
            }
            {
                INFO("the distance, which is as many times as large");
                REQUIRE(scaled.distance == factor * sample.distance);
            }
            INFO("the colour, which is the same, as the attenuation is 1 0 0");
            REQUIRE(scaled.color == sample.color);
        }
    }
}
