// Step 01.7, which is optional: rays of a fisheye camera.
#include "chapters/01_ray_casting/fisheye.hpp"

#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <string>

using namespace rt;
using namespace rt::test;

namespace {

/// A view of width × height pixels from the origin along −z, the world's axes as its frame.
View plain_view(int width, int height) {
    View view;
    view.width = width;
    view.height = height;
    return view;
}

void check_direction(const View& view, Real x, Real y, Real degrees, const Vec3& direction) {
    const Ray ray = fisheye_ray(view, x, y, radians(degrees));
    INFO(view.width << " x " << view.height << " pixels, " << degrees
                    << " degrees from top to bottom, the point (" << x << ", " << y << "): " << ray);
    CHECK(near_direction(ray.direction, direction, 8 * unit_roundoff));
    CHECK(near(glm::length(ray.direction), 1, 8 * unit_roundoff));
    CHECK(ray.origin == view.eye);
}

}  // namespace

TEST_CASE("in the middle of its picture a fisheye looks straight ahead", "[01.7]") {
    View view = plain_view(640, 480);
    view.eye = {1, 2, 3};
    check_direction(view, 320, 240, 180, {0, 0, -1});
}

TEST_CASE("a fisheye of 180 degrees looks straight up at the top of its picture", "[01.7]") {
    const View view = plain_view(2, 2);
    check_direction(view, 1, 0, 180, {0, 1, 0});
    check_direction(view, 1, 2, 180, {0, -1, 0});
    check_direction(view, 2, 1, 180, {1, 0, 0});
    check_direction(view, 0, 1, 180, {-1, 0, 0});
}

TEST_CASE("halfway up the angle is half as large", "[01.7]") {
    const Real half = std::sqrt(0.5), quarter = std::cos(pi / 8), rest = std::sin(pi / 8);
    check_direction(plain_view(2, 4), 1, 1, 180, {0, half, -half});
    check_direction(plain_view(2, 4), 1, 1, 90, {0, rest, -quarter});
    check_direction(plain_view(6, 4), 4, 2, 180, {half, 0, -half});
}

TEST_CASE("a fisheye of 360 degrees looks back along the top edge", "[01.7]") {
    check_direction(plain_view(4, 4), 2, 0, 360, {0, 0, 1});
    check_direction(plain_view(4, 4), 2, 1, 360, {0, 1, 0});
}

TEST_CASE("3 pixels to the right and 4 up is 5 from the middle, whatever the field", "[01.7]") {
    // Of half heights of 5 pixels that is one: the angle is half of the field.
    for (const Real degrees : {30.0, 90.0, 180.0, 250.0}) {
        const Real across = std::sin(radians(degrees / 2)), along = std::cos(radians(degrees / 2));
        check_direction(plain_view(12, 10), 9, 1, degrees, {0.6 * across, 0.8 * across, -along});
    }
}

TEST_CASE("the frame turns the rays of a fisheye", "[01.7]") {
    View view = plain_view(2, 2);
    view.frame = {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
    view.eye = {3, 0, 0};
    check_direction(view, 1, 1, 180, {-1, 0, 0});
    check_direction(view, 2, 1, 180, {0, 0, -1});
}

TEST_CASE("the angle grows evenly from the middle, and points to the side of the point", "[01.7]") {
    Random random(71);
    for (int i = 0; i < cases(20'000); ++i) {
        const int width = 1 + static_cast<int>(random.index(2000));
        const int height = 1 + static_cast<int>(random.index(2000));
        View view = plain_view(width, height);
        view.frame.w = random.direction();
        view.frame.u = glm::normalize(any_across(view.frame.w));
        view.frame.v = glm::cross(view.frame.w, view.frame.u);
        view.projection = i % 2 == 0 ? Projection::Perspective : Projection::Orthographic;
        view.half_height = random.magnitude(-2, 2);
        const Real field = random.uniform(0.01, 2 * pi);
        // A distance and a side, and the point that is there.
        const Real rho = random.uniform(0, 1), side = random.uniform(-pi, pi);
        const Real x = view.width / 2.0 + rho * view.height / 2.0 * std::cos(side);
        const Real y = view.height / 2.0 - rho * view.height / 2.0 * std::sin(side);
        const Vec3 d = fisheye_ray(view, x, y, field).direction;
        const Vec3 across =
            glm::dot(d, view.frame.u) * view.frame.u + glm::dot(d, view.frame.v) * view.frame.v;
        const Real angle = std::atan2(glm::length(across), -glm::dot(d, view.frame.w));
        // The point is rounded by where the middle is, in half heights.
        const Real rounding = 64 * unit_roundoff * (1 + static_cast<Real>(view.width) / view.height);
        INFO(view.width << " x " << view.height << " pixels, the point " << show(Vec2(x, y)) << ", "
                        << show(rho) << " half heights from the middle, field " << show(field) << ": "
                        << show(d));
        {
            INFO("the angle between the ray and -w");
            REQUIRE(near(angle, rho * field / 2, rounding * pi));
        }
        const Vec3 out = std::cos(side) * view.frame.u + std::sin(side) * view.frame.v;
        INFO("the part of the direction across the view: to the point's side, as long as the angle's sine");
        REQUIRE(near(across, std::sin(rho * field / 2) * out, rounding * 8));
    }
}
