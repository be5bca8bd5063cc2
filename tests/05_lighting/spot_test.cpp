// Step 05.6, which is optional: what a spot light sends to a point.
#include "chapters/05_lighting/spot.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <utility>

using namespace rt;
using namespace rt::test;

namespace {

/// Ten units above the floor, pointing straight down; cosines of the cones 0.8 and 0.6.
const SpotLight downwards{{.position = {0, 10, 0}, .color = {1, 2, 4}}, {0, -1, 0}, 0.8, 0.6};

/// A point that is seen from the lamp at this cosine from straight down, in a direction around the axis.
Vec3 below(Real cosine, Real around) {
    const Real sine = std::sqrt(1 - cosine * cosine);
    return Vec3(0, 10, 0) + Real(5) * Vec3(sine * std::cos(around), -cosine, sine * std::sin(around));
}

std::string words_of(const SpotLight& light) {
    return show(light.lamp) + " that shines along " + show(light.axis) + ", cosines of its cones " +
           show(light.inner) + " and " + show(light.outer);
}

void check_part(const SpotLight& light, const Vec3& point, Real cosine, Real part, Real bound) {
    INFO(words_of(light) << "\nseen from " << point << ", where the cosine is " << cosine
                         << ": the colour of the light that arrives");
    CHECK(near_color(sample_light(light, point).color, part * light.lamp.color, bound));
}

}  // namespace

TEST_CASE("by hand: a quarter of the way across the edge 5/32 of the light arrives, halfway 1/2", "[05.6]") {
    check_part(downwards, below(0.65, 0), 0.65, 5.0 / 32, 1e-13);
    check_part(downwards, below(0.7, 0), 0.7, 0.5, 1e-13);
    check_part(downwards, below(0.75, 2), 0.75, 27.0 / 32, 1e-13);
}

TEST_CASE("all of the light inside the inner cone, none outside the outer one", "[05.6]") {
    for (const Real cosine : {1.0, 0.95, 0.81}) check_part(downwards, below(cosine, 1), cosine, 1, 0);
    for (const Real cosine : {0.59, 0.3, 0.0, -0.5, -1.0})
        check_part(downwards, below(cosine, 1), cosine, 0, 0);
}

TEST_CASE("direction and distance of a spot light are those of its lamp, in the dark as well", "[05.6]") {
    for (const Real cosine : {0.9, 0.7, 0.2}) {
        const Vec3 point = below(cosine, 3);
        const LightSample sample = sample_light(downwards, point);
        INFO(words_of(downwards) << "\nseen from " << point << ": the direction, and the distance, 5");
        CHECK(near_direction(sample.direction, Vec3(0, 2, 0) - Real(0.2) * point, 16 * unit_roundoff));
        CHECK(near(sample.distance, 5, 40 * unit_roundoff));
    }
}

TEST_CASE("a spot light is attenuated as its lamp is", "[05.6]") {
    SpotLight light = downwards;
    light.lamp.attenuation = {0, 0, 1};
    const Vec3 point = below(0.7, 0);
    INFO(words_of(light) << "\nseen from " << point
                         << ", halfway across the edge at distance 5: a fiftieth of its colour");
    CHECK(near_color(sample_light(light, point).color, Vec3(0.02, 0.04, 0.08), 1e-13));
}

TEST_CASE("equal cones make a hard edge, without NaN", "[05.6]") {
    SpotLight light = downwards;
    light.outer = light.inner;
    check_part(light, below(0.81, 0), 0.81, 1, 0);
    check_part(light, below(0.79, 0), 0.79, 0, 0);
    light.axis = {0, -1, 0};
    light.inner = light.outer = 1;
    check_part(light, {0, 3, 0}, 1, 1, 0);
}

TEST_CASE("a spot light on the very point sends nothing", "[05.6]") {
    for (const Vec3& axis : {Vec3(0, -1, 0), Vec3(0, 1, 0), Vec3(0.6, 0, 0.8)}) {
        SpotLight light = downwards;
        light.axis = axis;
        const LightSample sample = sample_light(light, light.lamp.position);
        INFO(words_of(light) << "\nseen from where it is: black, at distance 0");
        CHECK(near_color(sample.color, Vec3(0), 0));
        CHECK(sample.distance == 0);
    }
}

TEST_CASE("across the edge the light grows without a jump or a kink", "[05.6]") {
    const int steps = 1000;
    Real before = 0, slope_before = 0;
    for (int i = 0; i <= steps; ++i) {
        const Real cosine = 0.59 + 0.22 * i / steps;
        const Real part = sample_light(downwards, below(cosine, 0)).color.x;
        const Real slope = (part - before) * steps / 0.22;
        INFO("the part of the light at the cosine " << cosine << ", expected at least that before it, "
                                                    << before);
        REQUIRE(part >= before - 1e-13);
        INFO("by how much the slope has changed, at most by what a cubic's does in a step");
        // The second derivative of x²(3 − 2x) is 6 at most, and x grows by 5 for each unit of the cosine.
        REQUIRE(std::abs(slope - slope_before) <= 6 * 25 * 0.22 / steps + 1e-6);
        before = part;
        slope_before = slope;
    }
}
