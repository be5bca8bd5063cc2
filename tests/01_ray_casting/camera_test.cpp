// Steps 01.1 to 01.3: the camera's frame, and the rays through the picture.
#include "chapters/01_ray_casting/camera.hpp"

#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using namespace rt::test;

namespace {

constexpr Real u_round = unit_roundoff;

Camera camera_at(Vec3 eye, Vec3 look_at, Vec3 up = {0, 1, 0}) {
    Camera camera;
    camera.eye = eye;
    camera.look_at = look_at;
    camera.up = up;
    return camera;
}

/// A view of width × height pixels from the origin along −z, the world's axes as its frame.
View plain_view(int width, int height, Real half_height, Projection projection = Projection::Perspective) {
    View view;
    view.projection = projection;
    view.half_height = half_height;
    view.width = width;
    view.height = height;
    return view;
}

/// Some view of up to 2000 × 2000 pixels. Its frame does not come from the student's camera_frame.
View random_view(Random& random, Projection projection) {
    View view = plain_view(1 + static_cast<int>(random.index(2000)), 1 + static_cast<int>(random.index(2000)),
                           random.magnitude(-2, 2), projection);
    view.frame.w = random.direction();
    const Vec3 helper = std::abs(view.frame.w.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    view.frame.u = glm::normalize(glm::cross(helper, view.frame.w));
    view.frame.v = glm::cross(view.frame.w, view.frame.u);
    view.eye = random.magnitude(-6, 6) * random.in_cube();
    return view;
}

/// The sine of the angle between two vectors of any length.
Real sine(const Vec3& a, const Vec3& b) {
    return glm::length(glm::cross(glm::normalize(a), glm::normalize(b)));
}

}  // namespace

TEST_CASE("the lesson's example: a camera at (0, 3, 4) that looks down on the origin", "[01.1]") {
    // The camera looks down on the origin along (0, -3, -4), which is 5 long.
    const CameraFrame frame = camera_frame(camera_at({0, 3, 4}, {0, 0, 0}));
    INFO("eye (0, 3, 4), look at (0, 0, 0), up (0, 1, 0)\n" << show(frame));
    CHECK(near_direction(frame.u, {1, 0, 0}, 4 * u_round));
    CHECK(near_direction(frame.v, {0, 0.8, -0.6}, 8 * u_round));
    CHECK(near_direction(frame.w, {0, 0.6, 0.8}, 4 * u_round));
}

TEST_CASE("a camera that looks along -z has the world's axes", "[01.1]") {
    const CameraFrame frame = camera_frame(camera_at({0, 0, 5}, {0, 0, 0}));
    INFO("eye (0, 0, 5), look at (0, 0, 0), up (0, 1, 0)\n" << show(frame));
    CHECK(near_direction(frame.u, {1, 0, 0}, 4 * u_round));
    CHECK(near_direction(frame.v, {0, 1, 0}, 4 * u_round));
    CHECK(near_direction(frame.w, {0, 0, 1}, 4 * u_round));
}

TEST_CASE("a camera on the x axis that looks at the origin has -z on its right", "[01.1]") {
    const CameraFrame frame = camera_frame(camera_at({3, 0, 0}, {0, 0, 0}));
    INFO("eye (3, 0, 0), look at (0, 0, 0), up (0, 1, 0)\n" << show(frame));
    CHECK(near_direction(frame.u, {0, 0, -1}, 4 * u_round));
    CHECK(near_direction(frame.v, {0, 1, 0}, 4 * u_round));
    CHECK(near_direction(frame.w, {1, 0, 0}, 4 * u_round));
}

TEST_CASE("a camera held upside down has its right on the other side", "[01.1]") {
    const CameraFrame frame = camera_frame(camera_at({0, 0, 5}, {0, 0, 0}, {0, -2, 0}));
    INFO("eye (0, 0, 5), look at (0, 0, 0), up (0, -2, 0)\n" << show(frame));
    CHECK(near_direction(frame.u, {-1, 0, 0}, 4 * u_round));
    CHECK(near_direction(frame.v, {0, -1, 0}, 4 * u_round));
    CHECK(near_direction(frame.w, {0, 0, 1}, 4 * u_round));
}

TEST_CASE("every camera frame is orthonormal and right-handed, and looks where it should", "[01.1]") {
    Random random(11);
    for (int i = 0; i < cases(100'000); ++i) {
        Camera camera;
        if (i % 2 == 0) {  // any direction, lengths from 1e-20 to 1e20
            camera = camera_at(random.magnitude(-20, 20) * random.direction(), Vec3(0),
                               random.magnitude(-20, 20) * random.direction());
        } else {  // up ever closer to the view, the eye anywhere
            const Vec3 eye = random.magnitude(-3, 3) * random.in_cube(), view = random.direction();
            camera = camera_at(eye, eye - view, view + random.magnitude(-6, 0) * random.direction());
        }
        const Vec3 back = camera.eye - camera.look_at;
        // The cross product of up and w is off by a few roundings of |up|, however short it is itself: an
        // angle θ between the two leaves 1/sin θ of the error.
        const Real bound = 16 * u_round / sine(camera.up, back);
        const CameraFrame frame = camera_frame(camera);
        const auto& [u, v, w] = frame;
        const bool unit = std::abs(glm::length(u) - 1) <= 8 * u_round &&
                          std::abs(glm::length(v) - 1) <= bound &&
                          std::abs(glm::length(w) - 1) <= 8 * u_round;
        const bool perpendicular = std::abs(glm::dot(u, v)) <= bound && std::abs(glm::dot(v, w)) <= bound &&
                                   std::abs(glm::dot(w, u)) <= bound;
        const bool right_handed = near(glm::cross(u, v), w, bound);
        const bool backwards = near(w, glm::normalize(back), 16 * u_round);
        const bool upright = glm::dot(v, glm::normalize(camera.up)) > 0 &&
                             std::abs(glm::dot(u, glm::normalize(camera.up))) <= bound;
        if (!(unit && perpendicular && right_handed && backwards && upright)) {
            INFO("eye " << show(camera.eye) << ", look at " << show(camera.look_at) << ", up "
                        << show(camera.up) << "\n"
                        << show(frame) << "\nallowed error " << show(bound));
            CHECK(or_say(unit, "u, v or w is not 1 long"));
            CHECK(or_say(perpendicular, "u, v and w are not perpendicular to one another"));
            CHECK(or_say(right_handed, "u x v is not w"));
            CHECK(or_say(backwards, "w does not point from what is looked at to the eye"));
            REQUIRE(or_say(upright, "v does not point up, or u has a part along up"));
            return;
        }
    }
    SUCCEED();
}

TEST_CASE("a camera frame does not depend on the unit of length, to the bit", "[01.1]") {
    Random random(12);
    for (int i = 0; i < cases(10'000); ++i) {
        const Camera camera = camera_at(random.in_cube(), random.in_cube(), random.in_cube());
        const Real scale = std::ldexp(1.0, static_cast<int>(random.index(81)) - 40);
        const CameraFrame frame = camera_frame(camera);
        const CameraFrame scaled =
            camera_frame(camera_at(scale * camera.eye, scale * camera.look_at, camera.up / scale));
        const bool same = frame.u == scaled.u && frame.v == scaled.v && frame.w == scaled.w;
        if (!same) {
            INFO("scale " << show(scale) << "\n" << show(frame) << "\nscaled:\n" << show(scaled));
            REQUIRE(or_say(same, "the frame is another in another unit of length"));
        }
    }
    SUCCEED();
}

TEST_CASE("the lesson's example: the ray of the top left pixel goes along (-1.5, -0.2, -1.1)", "[01.2]") {
    // The eye at (0, 3, 4) looks at the origin; 4 x 2 pixels, a field of view of 90 degrees.
    View view = plain_view(4, 2, 1);
    view.frame = {{1, 0, 0}, {0, 0.8, -0.6}, {0, 0.6, 0.8}};
    view.eye = {0, 3, 4};
    const Ray ray = pixel_ray(view, 0.5, 0.5);
    INFO("the eye at (0, 3, 4), 4 x 2 pixels, half height 1, the point (0.5, 0.5): " << ray);
    CHECK(ray.origin == Vec3(0, 3, 4));
    CHECK(near_direction(ray.direction, Vec3(-1.5, -0.2, -1.1) / std::sqrt(3.5), 8 * u_round));
}

TEST_CASE("the ray through the middle of the picture looks along -w", "[01.2]") {
    View view = plain_view(640, 480, 0.75);
    view.eye = {1, 2, 3};
    const Ray ray = pixel_ray(view, 320, 240);
    INFO("640 x 480 pixels, the eye at (1, 2, 3), the point (320, 240): " << ray);
    CHECK(ray.origin == Vec3(1, 2, 3));
    CHECK(near_direction(ray.direction, {0, 0, -1}, 4 * u_round));
}

TEST_CASE("the rays through the corners of a 4 x 2 picture", "[01.2]") {
    // A field of view of 90 degrees: the image plane at distance 1 goes from -1 to 1, and from -2 to 2.
    const View view = plain_view(4, 2, 1);
    const auto check = [&](const char* corner, Real x, Real y, const Vec3& on_plane) {
        INFO("the direction of the ray through the " << corner << " corner, the point (" << x << ", " << y
                                                     << "), where the image plane has " << on_plane);
        CHECK(near_direction(pixel_ray(view, x, y).direction, on_plane / std::sqrt(6.0), 4 * u_round));
    };
    check("top left", 0, 0, {-2, 1, -1});
    check("top right", 4, 0, {2, 1, -1});
    check("bottom left", 0, 2, {-2, -1, -1});
    check("bottom right", 4, 2, {2, -1, -1});
}

TEST_CASE("the ray through the centre of the top left pixel of a 4 x 2 picture", "[01.2]") {
    const Ray ray = pixel_ray(plain_view(4, 2, 1), 0.5, 0.5);
    INFO("half height 1, the point (0.5, 0.5), where the image plane has (-1.5, 0.5, -1): " << ray);
    CHECK(near_direction(ray.direction, Vec3(-1.5, 0.5, -1) / std::sqrt(3.5), 4 * u_round));
}

TEST_CASE("the frame turns the rays", "[01.2]") {
    // From (3, 0, 0) to the origin: u = -z, v = y, w = x. The right edge of the picture is towards -z.
    View view = plain_view(2, 2, 1);
    view.frame = {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
    view.eye = {3, 0, 0};
    const Ray ray = pixel_ray(view, 2, 1);
    INFO("the middle of the right edge of 2 x 2 pixels, u = -z, v = y, w = x: " << ray);
    CHECK(ray.origin == Vec3(3, 0, 0));
    CHECK(near_direction(ray.direction, Vec3(-1, 0, -1) / std::sqrt(2.0), 4 * u_round));
}

TEST_CASE("the middles of the top and bottom edge are the field of view apart", "[01.2]") {
    Random random(21);
    for (int i = 0; i < cases(1000); ++i) {
        const Real fovy = radians(random.uniform(1, 170));
        View view = random_view(random, Projection::Perspective);
        view.half_height = std::tan(fovy / 2);
        const Vec3 top = pixel_ray(view, view.width / 2.0, 0).direction;
        const Vec3 bottom = pixel_ray(view, view.width / 2.0, view.height).direction;
        const Real angle = 2 * std::atan2(glm::length(top - bottom), glm::length(top + bottom));
        // Both vectors are off by some roundings of their length 1, and so is the angle between them.
        if (!(std::abs(angle - fovy) <= 32 * u_round)) {
            INFO("the angle between the two rays, which is the field of view");
            REQUIRE(near(angle, fovy, 32 * u_round));
        }
    }
    SUCCEED();
}

TEST_CASE("every perspective ray has length 1 and passes through its point of the image plane", "[01.2]") {
    Random random(22);
    for (int i = 0; i < cases(100'000); ++i) {
        const View view = random_view(random, Projection::Perspective);
        const Real x = random.uniform(0, view.width), y = random.uniform(0, view.height);
        const Real pixel = 2 * view.half_height / view.height;  // the edge of a pixel on the image plane
        const Real a = pixel * (x - view.width / 2.0), b = pixel * (view.height / 2.0 - y);
        const Ray ray = pixel_ray(view, x, y);
        const auto [u, v, w] = view.frame;
        const Vec3 d = ray.direction;
        // In the frame, d is (a, b, -1) times some length: compare products, so that nothing is divided.
        // a and b are off by a few roundings of the picture's extent, from the difference with its middle.
        const Real bound = 32 * u_round * pixel * (view.width + view.height) + 32 * u_round;
        const bool through = std::abs(glm::dot(d, u) + a * glm::dot(d, w)) <= bound &&
                             std::abs(glm::dot(d, v) + b * glm::dot(d, w)) <= bound && glm::dot(d, w) < 0;
        const bool unit = std::abs(glm::length(d) - 1) <= 8 * u_round;
        if (!(through && unit && ray.origin == view.eye)) {
            INFO(view.width << " x " << view.height << " pixels, half height " << show(view.half_height)
                            << ", point (" << show(x) << ", " << show(y) << ")\n"
                            << show(ray));
            CHECK(or_say(unit, "the direction is not 1 long"));
            CHECK(or_say(through, "the ray does not pass through its point of the image plane"));
            REQUIRE(ray.origin == view.eye);
            return;
        }
    }
    SUCCEED();
}

TEST_CASE("pixels are square and evenly spaced, from left to right and from top to bottom", "[01.2]") {
    const View view = plain_view(320, 200, 0.5);
    const Real pixel = 2 * 0.5 / 200;
    const auto on_plane = [&](Real x, Real y) {
        const Vec3 d = pixel_ray(view, x, y).direction;
        return Vec2(d.x, d.y) / -d.z;
    };
    for (int i = 0; i < 199; ++i) {
        const Vec2 here = on_plane(i + 0.5, i + 0.5), next = on_plane(i + 1.5, i + 1.5);
        INFO("how far it is on the image plane from pixel (" << i << ", " << i << ") to (" << i + 1 << ", "
                                                             << i + 1 << "), to the right and down");
        REQUIRE(near(next.x - here.x, pixel, 16 * u_round));
        REQUIRE(near(here.y - next.y, pixel, 16 * u_round));
    }
}

TEST_CASE("pixels that mirror each other have rays that mirror each other", "[01.2]") {
    const View view = plain_view(31, 18, 0.6);
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const Vec3 d = pixel_ray(view, x + 0.5, y + 0.5).direction;
            const Vec3 across = pixel_ray(view, view.width - x - 0.5, y + 0.5).direction;
            const Vec3 below = pixel_ray(view, x + 0.5, view.height - y - 0.5).direction;
            INFO("pixel (" << x << ", " << y << "): " << show(d) << "\nacross the middle " << show(across)
                           << ", below it " << show(below));
            REQUIRE(near_direction(across, {-d.x, d.y, d.z}, 16 * u_round));
            REQUIRE(near_direction(below, {d.x, -d.y, d.z}, 16 * u_round));
        }
    }
}

TEST_CASE("a perspective ray does not depend on the unit of length, to the bit", "[01.2]") {
    Random random(23);
    for (int i = 0; i < cases(10'000); ++i) {
        View view = random_view(random, Projection::Perspective);
        const Real x = random.uniform(0, view.width), y = random.uniform(0, view.height);
        const Real scale = std::ldexp(1.0, static_cast<int>(random.index(81)) - 40);
        const Ray ray = pixel_ray(view, x, y);
        view.eye *= scale;
        const Ray scaled = pixel_ray(view, x, y);
        if (scaled.direction != ray.direction || scaled.origin != scale * ray.origin) {
            INFO("scale " << show(scale) << ": " << show(ray) << ", scaled " << show(scaled));
            CHECK(scaled.direction == ray.direction);
            REQUIRE(scaled.origin == scale * ray.origin);
            return;
        }
    }
    SUCCEED();
}

TEST_CASE("the orthographic ray through the centre of the top left pixel of a 4 x 2 picture", "[01.3]") {
    View view = plain_view(4, 2, 1, Projection::Orthographic);
    view.eye = {10, 20, 30};
    const Ray ray = pixel_ray(view, 0.5, 0.5);
    INFO("the eye is at (10, 20, 30); a ray starts beside it, and runs along -w: " << ray);
    CHECK(near(ray.origin, {10 - 1.5, 20 + 0.5, 30}, 64 * u_round));
    CHECK(near_direction(ray.direction, {0, 0, -1}, 0));
}

TEST_CASE("an orthographic picture is as high as the view says, and wide as its pixels are square",
          "[01.3]") {
    const View view = plain_view(4, 2, 3, Projection::Orthographic);
    const auto check = [&](const char* corner, Real x, Real y, const Vec3& origin) {
        INFO("where the ray through the " << corner << " corner starts, half height 3");
        CHECK(near(pixel_ray(view, x, y).origin, origin, 16 * u_round));
    };
    check("top left", 0, 0, {-6, 3, 0});
    check("top right", 4, 0, {6, 3, 0});
    check("bottom left", 0, 2, {-6, -3, 0});
    check("bottom right", 4, 2, {6, -3, 0});
}

TEST_CASE("all orthographic rays are parallel and start on the plane through the eye", "[01.3]") {
    Random random(31);
    for (int i = 0; i < cases(100'000); ++i) {
        const View view = random_view(random, Projection::Orthographic);
        const Real x = random.uniform(0, view.width), y = random.uniform(0, view.height);
        const Real pixel = 2 * view.half_height / view.height;
        const Real a = pixel * (x - view.width / 2.0), b = pixel * (view.height / 2.0 - y);
        const Ray ray = pixel_ray(view, x, y);
        const Vec3 expected = view.eye + a * view.frame.u + b * view.frame.v;
        const Real bound = 16 * u_round * (pixel * (view.width + view.height) + glm::length(view.eye));
        if (!(near(ray.origin, expected, bound) && ray.direction == -view.frame.w)) {
            INFO(show(ray) << "\nexpected from " << show(expected) << " along " << show(-view.frame.w));
            CHECK(near(ray.origin, expected, bound));
            REQUIRE(ray.direction == -view.frame.w);
            return;
        }
    }
    SUCCEED();
}

TEST_CASE("an orthographic view scales with the unit of length, to the bit", "[01.3]") {
    Random random(32);
    for (int i = 0; i < cases(10'000); ++i) {
        View view = random_view(random, Projection::Orthographic);
        const Real x = random.uniform(0, view.width), y = random.uniform(0, view.height);
        const Real scale = std::ldexp(1.0, static_cast<int>(random.index(81)) - 40);
        const Ray ray = pixel_ray(view, x, y);
        view.eye *= scale;
        view.half_height *= scale;
        const Ray scaled = pixel_ray(view, x, y);
        if (scaled.origin != scale * ray.origin || scaled.direction != ray.direction) {
            INFO("scale " << show(scale) << ": " << show(ray) << ", scaled " << show(scaled));
            CHECK(scaled.origin == scale * ray.origin);
            REQUIRE(scaled.direction == ray.direction);
            return;
        }
    }
    SUCCEED();
}
