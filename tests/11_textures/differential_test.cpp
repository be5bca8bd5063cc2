// Steps 11.12 and 11.13: ray differentials, against geometry that can be done by hand and against
// neighbouring rays.
#include "chapters/11_textures/differential.hpp"
#include "chapters/01_ray_casting/camera.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <array>
#include <cmath>

using namespace rt;
using test::cases;
using test::Random;

namespace {

std::string text(const RayDifferential& r) {
    return "origin " + test::show(r.origin_dx) + " to the right, " + test::show(r.origin_dy) +
           " down; direction " + test::show(r.direction_dx) + " to the right, " + test::show(r.direction_dy) +
           " down";
}

void check_same(const RayDifferential& actual, const RayDifferential& expected, Real bound) {
    INFO("per pixel, the ray's change is " << text(actual));
    INFO("expected                         " << text(expected));
    CHECK(test::near(actual.origin_dx, expected.origin_dx, bound));
    CHECK(test::near(actual.origin_dy, expected.origin_dy, bound));
    CHECK(test::near(actual.direction_dx, expected.direction_dx, bound));
    CHECK(test::near(actual.direction_dy, expected.direction_dy, bound));
}

std::string text(const View& view) {
    return std::string(view.projection == Projection::Perspective ? "perspective" : "orthographic") +
           " view of " + test::show(view.width) + " x " + test::show(view.height) + " pixels, half height " +
           test::show(view.half_height) + ", eye " + test::show(view.eye) + ",\n" + test::show(view.frame);
}

/// Looks from (0, 3, 0) down a slope of 3 in 4, along (4, -3, 0)/5. A pixel is 0.03 wide at distance 1.
View slope_view(Projection projection) {
    return {.frame = {{0, 0, 1}, {0.6, 0.8, 0}, {-0.8, 0.6, 0}},
            .eye = {0, 3, 0},
            .projection = projection,
            .half_height = 0.75,
            .width = 80,
            .height = 50};
}

// What neighbouring rays do, in more digits than Real has: so their differences can be trusted.

using Long = long double;
using Long3 = glm::vec<3, Long, glm::defaultp>;

struct LongRay {
    Long3 p;
    Long3 d;
};

/// A derivative by differences, and how far it may be off.
struct Slope {
    Vec3 value{0};
    Real error = 0;
};

/// The slope of `curve` at 0, from differences over 2h and over h. The error of either begins with h² times
/// the third derivative, so a third of what they differ by is that of the finer one, and (4·fine − coarse)/3
/// is free of it (Richardson). What is left is less than the whole difference. `size` is that of the values,
/// each of which is rounded some hundred times.
template <class Curve>
Slope slope(Curve curve, Real size) {
    const Long h = 0x1p-8L;
    const Long3 coarse = (curve(h) - curve(-h)) / (2 * h);
    const Long3 fine = (curve(h / 2) - curve(-h / 2)) / h;
    const Real rounding = 200 * static_cast<Real>(std::numeric_limits<Long>::epsilon() / h) * size;
    return {Vec3((4.0L * fine - coarse) / 3.0L), size_of(Vec3(fine - coarse)) + rounding};
}

/// The ray s pixels to the right of `ray`, if it changes by dp and dd a pixel.
LongRay neighbour(const Ray& ray, const Vec3& dp, const Vec3& dd, Long s) {
    return {Long3(ray.origin) + s * Long3(dp), normalize(Long3(ray.direction) + s * Long3(dd))};
}

Long3 meet_plane(const LongRay& ray, const Vec3& point, const Vec3& normal) {
    const Long3 n(normal);
    return ray.p + ray.d * (dot(n, Long3(point) - ray.p) / dot(n, ray.d));
}

/// Where the ray enters the sphere around 0, or leaves it.
Long3 meet_sphere(const LongRay& ray, Long r, bool enters) {
    const Long along = dot(ray.p, ray.d);
    const Long half = std::sqrt(r * r - dot(ray.p - along * ray.d, ray.p - along * ray.d));
    return ray.p + ray.d * (enters ? -along - half : half - along);
}

Long3 mirror(const Long3& d, const Long3& n) { return d - n * (dot(n, d) * 2.0L); }

/// By the parts along and across the normal.
Long3 bend(const Long3& d, const Long3& n, Long eta) {
    const Long3 across = eta * (d - dot(d, n) * n);
    return across - n * std::sqrt(1.0L - dot(across, across));
}

/// Random changes of a pixel's size, the direction's perpendicular to it.
RayDifferential some_differential(Random& random, const Ray& ray) {
    const Real size = random.magnitude(-4, -2);
    return {size * random.in_cube(), size * random.in_cube(), size * random.perpendicular_to(ray.direction),
            size * random.perpendicular_to(ray.direction)};
}

void check_slope(const Vec3& actual, const Slope& expected, Real rounding) {
    INFO("neighbouring rays say " << expected.value);
    CHECK(test::near(actual, expected.value, expected.error + rounding));
}

/// A ray of length-1 direction that meets the unit sphere where `cosine` is -d·n.
Ray towards_unit_sphere(Random& random, Real cosine) {
    const Vec3 n = random.direction();
    const Vec3 d = normalize(std::sqrt(1 - cosine * cosine) * random.perpendicular_to(n) - cosine * n);
    return {n - random.uniform(0.5, 20) * d, d};
}

}  // namespace

TEST_CASE("in the middle of the picture, the direction changes by a pixel's size to the right and down",
          "[11.12]") {
    const View view = slope_view(Projection::Perspective);
    INFO(text(view));
    check_same(camera_differential(view, 40, 25),
               {.direction_dx = {0, 0, 0.03}, .direction_dy = {-0.018, -0.024, 0}}, gamma(16) * 0.03);
}

TEST_CASE("away from the middle a pixel is a smaller angle, and the unit direction only turns", "[11.12]") {
    // a = 0.75, so g = (0.75, 0, -1) has length 1.25 and g/|g| is (0.6, 0, -0.8). Of dg = (0.03, 0, 0) only
    // what is perpendicular to it is left, 0.8·0.03 along (0.8, 0, 0.6), divided by 1.25.
    const View view{.frame = {}, .half_height = 0.75, .width = 50, .height = 50};
    INFO(text(view) << "\nat (50, 25)");
    check_same(camera_differential(view, 50, 25),
               {.direction_dx = 0.0192 * Vec3(0.8, 0, 0.6), .direction_dy = {0, -0.024, 0}},
               gamma(16) * 0.03);
}

TEST_CASE("in an orthographic view the origin moves and the direction stays", "[11.12]") {
    const View view = slope_view(Projection::Orthographic);
    INFO(text(view));
    for (const Vec2& at : {Vec2(40, 25), Vec2(3, 49)})
        check_same(camera_differential(view, at.x, at.y),
                   {.origin_dx = {0, 0, 0.03}, .origin_dy = {-0.018, -0.024, 0}}, gamma(16) * 0.03);
}

TEST_CASE("on a floor below, a pixel is wider, and longer where the ray is slanted", "[11.12]") {
    // The middle ray meets the floor y = 0 at distance 5, in (4, 0, 0). There a pixel is 5·0.03 wide; down
    // the picture, which is nearer, it is longer by 1/cos = 5/3.
    const Ray ray{{0, 3, 0}, {0.8, -0.6, 0}};
    const RayDifferential at_eye{.direction_dx = {0, 0, 0.03}, .direction_dy = {-0.018, -0.024, 0}};
    INFO(ray << " meets the floor y = 0 at t = 5; it comes with " << text(at_eye));
    const RayDifferential expected{{0, 0, 0.15}, {-0.25, 0, 0}, {0, 0, 0.03}, {-0.018, -0.024, 0}};
    check_same(transferred(at_eye, ray, 5, {0, 1, 0}), expected, gamma(16) * 0.15 / 0.6);
    INFO("with the normal on the other side");
    check_same(transferred(at_eye, ray, 5, {0, -1, 0}), expected, gamma(16) * 0.15 / 0.6);
}

TEST_CASE("what the origin has moved already counts", "[11.12]") {
    const Ray ray{{0, 3, 0}, {0.8, -0.6, 0}};
    const RayDifferential parallel{.origin_dx = {0, 0, 0.03}, .origin_dy = {-0.018, -0.024, 0}};
    INFO(ray << " meets the floor y = 0 at t = 5; it comes with " << text(parallel));
    check_same(transferred(parallel, ray, 5, {0, 1, 0}), {{0, 0, 0.03}, {-0.05, 0, 0}, Vec3(0), Vec3(0)},
               gamma(16) * 0.03 / 0.6);
}

TEST_CASE("a wall that faces the ray is met without sliding", "[11.12]") {
    const RayDifferential at_eye{{0.5, 0, 0}, {0, -0.25, 0}, {0.125, 0, 0}, {0, -0.125, 0}};
    const Ray ray{{0, 0, 0}, {0, 0, -1}};
    INFO(ray << " meets the wall z = -4 at t = 4; it comes with " << text(at_eye));
    check_same(transferred(at_eye, ray, 4, {0, 0, 1}),
               {{1, 0, 0}, {0, -0.75, 0}, {0.125, 0, 0}, {0, -0.125, 0}}, gamma(16));
}

TEST_CASE("a ray that grazes the surface has a finite differential", "[11.12]") {
    const RayDifferential at_eye{.direction_dx = {0, 0, 0.03}, .direction_dy = {0, -0.03, 0}};
    const RayDifferential answer = transferred(at_eye, {{0, 0, 0}, {1, 0, 0}}, 5, {0, 1, 0});
    INFO("the ray runs along the plane: " << text(answer));
    for (const Vec3& part : {answer.origin_dx, answer.origin_dy, answer.direction_dx, answer.direction_dy})
        CHECK(test::or_say(test::is_finite(part), test::show(part) + " is not finite"));
}

TEST_CASE("the camera's differential is the slope between neighbouring rays of the picture", "[11.12]") {
    Random random(111001);
    for (int i = 0; i < cases(4000); ++i) {
        const Vec3 w = random.direction(), u = random.perpendicular_to(w);
        View view{.frame = {u, cross(w, u), w}, .eye = 10.0 * random.in_cube()};
        view.projection = i % 3 == 0 ? Projection::Orthographic : Projection::Perspective;
        view.width = 100 + static_cast<int>(random.index(900));
        view.height = 100 + static_cast<int>(random.index(900));
        view.half_height = random.magnitude(-2, 0.5);
        const Real x = random.uniform(0, view.width), y = random.uniform(0, view.height);
        INFO(text(view) << "\nat (" << x << ", " << y << ")");
        const RayDifferential actual = camera_differential(view, x, y);
        // Real rays, so rounding is that of Real: of half a dozen lengths no greater than |eye| and a and b.
        const Real k = 2 * view.half_height / view.height, h = 0.25;
        const Real size = 20 + k * (view.width + view.height);
        const auto check_part = [&](const Vec3& dp, const Vec3& dd, Vec2 step) {
            const auto difference = [&](Real s) {
                const Ray here = pixel_ray(view, x + s * step.x, y + s * step.y);
                const Ray back = pixel_ray(view, x - s * step.x, y - s * step.y);
                return std::array{(here.origin - back.origin) / (2 * s),
                                  (here.direction - back.direction) / (2 * s)};
            };
            const auto fine = difference(h / 2), coarse = difference(h);
            const Vec3 answers[] = {dp, dd};
            for (std::size_t part : {0u, 1u}) {
                const Vec3 value = (4.0 * fine[part] - coarse[part]) / 3.0;
                const Real error = size_of(fine[part] - coarse[part]) + gamma(32) * size / h;
                INFO((part == 0 ? "origin" : "direction")
                     << (step.x > 0 ? ", a pixel to the right" : ", a pixel down"));
                check_slope(answers[part], {value, error}, gamma(16) * k);
            }
        };
        check_part(actual.origin_dx, actual.direction_dx, {1, 0});
        check_part(actual.origin_dy, actual.direction_dy, {0, 1});
    }
}

TEST_CASE("the transferred differential is the slope between points where neighbours meet a plane",
          "[11.12]") {
    Random random(111002);
    for (int i = 0; i < cases(4000); ++i) {
        const Ray ray{10.0 * random.in_cube(), random.direction()};
        const RayDifferential in = some_differential(random, ray);
        const Real t = random.magnitude(-1, 1), cosine = random.uniform(0.1, 1);
        const Vec3 n =
            random.sign() * normalize(cosine * ray.direction + std::sqrt(1 - cosine * cosine) *
                                                                   random.perpendicular_to(ray.direction));
        INFO(ray << " meets a plane with normal " << n << " at t = " << t << "\nit comes with " << text(in));
        const RayDifferential actual = transferred(in, ray, t, n);
        const Vec3 q = point_at(ray, t);
        const auto expected = [&](const Vec3& dp, const Vec3& dd) {
            const auto point = [&](Long s) { return meet_plane(neighbour(ray, dp, dd, s), q, n); };
            return slope(point, 100);
        };
        const Real rounding = gamma(16) * (1 + t) * 0.02 / cosine;
        check_slope(actual.origin_dx, expected(in.origin_dx, in.direction_dx), rounding);
        check_slope(actual.origin_dy, expected(in.origin_dy, in.direction_dy), rounding);
        CHECK(test::near(actual.direction_dx, in.direction_dx, gamma(2) * 0.02));
        CHECK(test::near(actual.direction_dy, in.direction_dy, gamma(2) * 0.02));
    }
}

TEST_CASE("a mirror ball of radius 2 makes parallel rays spread from a point 1 behind its face", "[11.13]") {
    // The focal length of a mirror is r/2. Rays along -z meet the ball around 0 in (0, 0, 2); the pixel to
    // the right is 0.01 farther in x, where the normal leans by 0.005 and the mirrored ray by 0.01.
    const RayDifferential at_ball{.origin_dx = {0.01, 0, 0}, .origin_dy = {0, -0.01, 0}};
    const Vec3 d(0, 0, -1), n(0, 0, 1);
    const NormalChange change{{0.005, 0, 0}, {0, -0.005, 0}};
    INFO("a ray along (0, 0, -1) is mirrored at (0, 0, 2); it comes with " << text(at_ball));
    const RayDifferential away = reflected(at_ball, d, n, change);
    check_same(away, {{0.01, 0, 0}, {0, -0.01, 0}, {0.01, 0, 0}, {0, -0.01, 0}}, gamma(24) * 0.01);
    INFO("transferred backwards by 1, to the focus:");
    const RayDifferential focus = transferred(away, {{0, 0, 2}, {0, 0, 1}}, -1, n);
    check_same(focus, {Vec3(0), Vec3(0), {0.01, 0, 0}, {0, -0.01, 0}}, gamma(48) * 0.02);
}

TEST_CASE("on a flat thing the normal stays, on a sphere it tilts by dp/r", "[11.13]") {
    const RayDifferential moved{.origin_dx = {0.5, 0, 0}, .origin_dy = {0, -0.25, 0}};
    const NormalChange flat = normal_change(moved, {0, 0, 1}, 0);
    {
        INFO(
            "on a flat thing, of curvature 0, the point moves by (0.5, 0, 0) and (0, -0.25, 0); the normal "
            "by");
        CHECK(test::near(flat.dx, Vec3(0), 0));
        CHECK(test::near(flat.dy, Vec3(0), 0));
    }
    INFO("at (0, 0, 2) on a sphere around 0 of radius 2, the point moves by (0.5, 0, 0) and (0, -0.25, 0)");
    const NormalChange round = normal_change(moved, {0, 0, 1}, 0.5);
    CHECK(test::near(round.dx, Vec3(0.25, 0, 0), gamma(8)));
    CHECK(test::near(round.dy, Vec3(0, -0.125, 0), gamma(8)));
    INFO("with the normal turned inwards, and so the curvature negative");
    const NormalChange hollow = normal_change(moved, {0, 0, -1}, -0.5);
    CHECK(test::near(hollow.dx, Vec3(-0.25, 0, 0), gamma(8)));
    CHECK(test::near(hollow.dy, Vec3(0, 0.125, 0), gamma(8)));
}

TEST_CASE("only what is tangential in dp tilts the normal", "[11.13]") {
    const RayDifferential moved{.origin_dx = {0.5, 0, 8}, .origin_dy = {0, 0, 3}};
    const NormalChange round = normal_change(moved, {0, 0, 1}, 0.5);
    INFO("the point moves by (0.5, 0, 8) and (0, 0, 3), the normal is (0, 0, 1), the curvature 1/2");
    CHECK(test::near(round.dx, Vec3(0.25, 0, 0), gamma(8) * 4));
    CHECK(test::near(round.dy, Vec3(0, 0, 0), gamma(8) * 4));
}

TEST_CASE("a flat mirror turns the differential as it turns the direction", "[11.13]") {
    const RayDifferential in{{0, 0, 0.15}, {-0.25, 0, 0}, {0, 0, 0.03}, {-0.018, -0.024, 0}};
    INFO("a ray along (0.8, -0.6, 0) is mirrored by the floor; it comes with " << text(in));
    check_same(reflected(in, {0.8, -0.6, 0}, {0, 1, 0}, {}),
               {{0, 0, 0.15}, {-0.25, 0, 0}, {0, 0, 0.03}, {-0.018, 0.024, 0}}, gamma(24) * 0.03);
}

TEST_CASE("a slanted ray on a curved mirror: the normal's tilt counts twice", "[11.13]") {
    // The normal (0, 1, 0) tilts by 0.1 towards x: the ray along (0.8, -0.6, 0) leaves along (0.8, 0.6, 0),
    // turned by 0.2 about z.
    INFO("d = (0.8, -0.6, 0), n = (0, 1, 0), dn/dx = (0.1, 0, 0)");
    check_same(reflected({}, {0.8, -0.6, 0}, {0, 1, 0}, {{0.1, 0, 0}, Vec3(0)}),
               {Vec3(0), Vec3(0), {0.12, -0.16, 0}, Vec3(0)}, gamma(24) * 0.1);
}

TEST_CASE("through a flat surface the angle between neighbours shrinks as Snell's law says", "[11.13]") {
    // sin i = 0.8, eta = 3/4, so sin t = 0.6; from cos t dt = eta cos i di, dt = 0.75·0.6/0.8 di = 0.5625 di.
    // The one pixel turns the ray by 0.016 in the plane of incidence; across it, eta alone counts.
    const RayDifferential in{.direction_dx = {0, 0, 0.016}, .direction_dy = 0.016 * Vec3(0.6, 0.8, 0)};
    INFO("d = (0.8, -0.6, 0), n = (0, 1, 0), eta = 0.75; it comes with " << text(in));
    check_same(refracted(in, {0.8, -0.6, 0}, {0, 1, 0}, {}, 0.75),
               {Vec3(0), Vec3(0), {0, 0, 0.012}, {0.0072, 0.0054, 0}}, gamma(16) * 10 * 0.016 / 0.512);
}

TEST_CASE("a ball of glass bundles parallel rays at 3 radii behind its face", "[11.13]") {
    // Behind one surface of index n the focus is at n r/(n - 1), which for 1.5 is 3 r, here 6.
    const RayDifferential in{.origin_dx = {0.01, 0, 0}, .origin_dy = {0, -0.01, 0}};
    const Vec3 d(0, 0, -1), n(0, 0, 1);
    const NormalChange change{{0.005, 0, 0}, {0, -0.005, 0}};
    INFO("a ray along (0, 0, -1) enters a ball of radius 2 at (0, 0, 2), eta = 2/3; it comes with "
         << text(in));
    const RayDifferential out = refracted(in, d, n, change, 1 / 1.5);
    check_same(out, {{0.01, 0, 0}, {0, -0.01, 0}, {-0.005 / 3, 0, 0}, {0, 0.005 / 3, 0}},
               gamma(16) * 8 * 0.01);
    INFO("transferred to the focus:");
    const RayDifferential focus = transferred(out, {{0, 0, 2}, d}, 6, n);
    check_same(focus, {Vec3(0), Vec3(0), out.direction_dx, out.direction_dy}, gamma(16) * 8 * 0.1);
}

TEST_CASE("at a critical angle the differential is finite", "[11.13]") {
    // sin i = 0.8, eta = 1.25: the refracted ray lies in the surface.
    const RayDifferential in{.direction_dx = {0, 0, 0.016}, .direction_dy = 0.016 * Vec3(0.6, 0.8, 0)};
    const RayDifferential out = refracted(in, {0.8, -0.6, 0}, {0, 1, 0}, {{0.1, 0, 0}, {0, 0, 0.1}}, 1.25);
    INFO("d = (0.8, -0.6, 0), n = (0, 1, 0), eta = 1.25: " << text(out));
    CHECK(test::is_finite(out.direction_dx));
    CHECK(test::is_finite(out.direction_dy));
}

TEST_CASE("the mirrored differential is the slope between rays that neighbours send off a ball", "[11.13]") {
    Random random(111101);
    for (int i = 0; i < cases(4000); ++i) {
        const Real cosine = random.uniform(0.2, 1);
        const bool is_inside = i % 3 == 0;  // of a hollow ball: the far hit, where the normal was turned
        Ray ray = towards_unit_sphere(random, cosine);
        const RayDifferential in = some_differential(random, ray);
        const Long3 q = meet_sphere({Long3(ray.origin), Long3(ray.direction)}, 1, !is_inside);
        const Vec3 outward = normalize(Vec3(q)), n = is_inside ? -outward : outward;
        const Real t = dot(Vec3(q) - ray.origin, ray.direction);
        INFO(ray << " meets the unit sphere at t = " << t << " with normal " << n << "\nit comes with "
                 << text(in));
        const RayDifferential there = transferred(in, ray, t, n);
        const NormalChange change = normal_change(there, n, is_inside ? -1 : 1);
        const RayDifferential actual = reflected(there, ray.direction, n, change);
        const auto check_part = [&](const Vec3& dp, const Vec3& dd, const Vec3& origin,
                                    const Vec3& direction) {
            const auto point = [&](Long s) { return meet_sphere(neighbour(ray, dp, dd, s), 1, !is_inside); };
            const auto away = [&](Long s) { return mirror(neighbour(ray, dp, dd, s).d, point(s)); };
            // |dp| + t·|dd| is less than 0.44, on the ball by 1/cos more. Beside what the functions promise,
            // n and t were rounded some thirty times, and an error of n counts by 1/cos once more.
            const Real rounding = gamma(60) * 0.44 / (cosine * cosine);
            check_slope(origin, slope(point, 100), rounding);
            check_slope(direction, slope(away, 100), 6 * rounding);
        };
        check_part(in.origin_dx, in.direction_dx, actual.origin_dx, actual.direction_dx);
        check_part(in.origin_dy, in.direction_dy, actual.origin_dy, actual.direction_dy);
    }
}

TEST_CASE("the refracted differential is the slope between rays that neighbours send into a ball",
          "[11.13]") {
    Random random(111102);
    int asked = 0;
    for (int i = 0; i < cases(4000); ++i) {
        const Real cosine = random.uniform(0.2, 1), eta = random.uniform(0.4, 1.6);
        const Real cos_t_squared = 1 - eta * eta * (1 - cosine * cosine);
        if (cos_t_squared < 0.04) continue;
        ++asked;
        const Ray ray = towards_unit_sphere(random, cosine);
        const bool is_flat = i % 2 == 0;
        const RayDifferential in = some_differential(random, ray);
        const Long3 q = meet_sphere({Long3(ray.origin), Long3(ray.direction)}, 1, true);
        const Vec3 n = normalize(Vec3(q));
        const Real t = dot(Vec3(q) - ray.origin, ray.direction);
        INFO(ray << " meets " << (is_flat ? "a plane" : "the unit sphere") << " at t = " << t
                 << " with normal " << n << ", eta = " << eta << "\nit comes with " << text(in));
        const RayDifferential there = transferred(in, ray, t, n);
        const NormalChange change = normal_change(there, n, is_flat ? 0 : 1);
        const RayDifferential actual = refracted(there, ray.direction, n, change, eta);
        const auto check_part = [&](const Vec3& dp, const Vec3& dd, const Vec3& origin,
                                    const Vec3& direction) {
            const auto point = [&](Long s) {
                const LongRay beside = neighbour(ray, dp, dd, s);
                return is_flat ? meet_plane(beside, Vec3(q), n) : meet_sphere(beside, 1, true);
            };
            const auto away = [&](Long s) {
                const Long3 normal = is_flat ? normalize(Long3(n)) : point(s);
                return bend(neighbour(ray, dp, dd, s).d, normal, static_cast<Long>(eta));
            };
            const Real rounding = gamma(60) * 0.44 / (cosine * cosine);
            check_slope(origin, slope(point, 100), rounding);
            check_slope(direction, slope(away, 100),
                        rounding * std::pow(1 + eta, 4) / std::pow(cos_t_squared, 1.5));
        };
        check_part(in.origin_dx, in.direction_dx, actual.origin_dx, actual.direction_dx);
        check_part(in.origin_dy, in.direction_dy, actual.origin_dy, actual.direction_dy);
    }
    CHECK(asked > cases(4000) / 2);
}

TEST_CASE("from the camera by a mirror ball to the floor: as neighbouring rays of the picture", "[11.13]") {
    // The whole way of a pixel, through four functions: the eye at (0, 1, 4) looks along -z at a unit sphere
    // around 0, which mirrors the floor y = -1.
    const View view{.frame = {}, .eye = {0, 1, 4}, .half_height = 0.5, .width = 100, .height = 100};
    const auto way = [&](Long x, Long y) {  // the point on the floor
        const Long a = (x - 50) / 100, b = (50 - y) / 100;
        const LongRay in{Long3(view.eye), normalize(Long3(a, b, -1))};
        const Long3 q = meet_sphere(in, 1, true);
        return meet_plane({q, mirror(in.d, q)}, {0, -1, 0}, {0, 1, 0});
    };
    for (const Vec2& at : {Vec2(50, 81), Vec2(40, 82), Vec2(62, 84)}) {
        const Ray ray = pixel_ray(view, at.x, at.y);
        const Vec3 n = Vec3(meet_sphere({Long3(ray.origin), Long3(ray.direction)}, 1, true));
        const RayDifferential there =
            transferred(camera_differential(view, at.x, at.y), ray, length(n - ray.origin), n);
        const RayDifferential away = reflected(there, ray.direction, n, normal_change(there, n, 1));
        const Vec3 down = Vec3(mirror(Long3(ray.direction), Long3(n)));
        const Real t = (-1 - n.y) / down.y;
        const RayDifferential actual = transferred(away, {n, down}, t, {0, 1, 0});
        INFO("pixel " << at << " sees by the ball the floor at " << point_at({n, down}, t));
        const auto by_x = [&](Long s) { return way(static_cast<Long>(at.x) + s, static_cast<Long>(at.y)); };
        const auto by_y = [&](Long s) { return way(static_cast<Long>(at.x), static_cast<Long>(at.y) + s); };
        const Real amplified = 100 / (std::abs(down.y) * std::abs(dot(ray.direction, n)));
        check_slope(actual.origin_dx, slope(by_x, 100), gamma(100) * amplified);
        check_slope(actual.origin_dy, slope(by_y, 100), gamma(100) * amplified);
    }
}
