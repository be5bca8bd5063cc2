// Steps 12.6, 12.7 and 12.24: points of a lens's opening, rays through it, the blur, and a lens that leans.
#include "chapters/12_distribution/lens.hpp"

#include "common/math/error.hpp"
#include "tests/12_distribution/lens_checks.hpp"
#include "tests/catch.hpp"
#include "tests/chi_square.hpp"
#include "tests/support.hpp"
#include "tests/together.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

using namespace rt;
using test::cases;
using test::near;
using test::Random;

namespace {

const Real root_half = std::sqrt(0.5);

void check_disc(const Vec2& random, const Vec2& expected) {
    INFO("the disc's point for the random numbers " << random);
    CHECK(near(disc_point(random), expected, gamma(16)));
}

void check_polygon(int sides, Real turn, const Vec2& random, const Vec2& expected) {
    INFO("the point of a polygon of " << sides << " sides, turned by " << turn << ", for the random numbers "
                                      << random);
    CHECK(near(polygon_point(sides, turn, random), expected, gamma(64) * (1 + std::abs(turn))));
}

Vec2 random_pair(Random& random) {
    const Real x = random.uniform(0, 1), y = random.uniform(0, 1);
    return {x, y};
}

Vec2 at_angle(Real degrees) { return {std::cos(radians(degrees)), std::sin(radians(degrees))}; }

/// Which of `count` equal parts of [0, 1] has x, which may lie outside by rounding.
std::size_t part_of(Real x, std::size_t count) {
    const Real at = std::floor(x * static_cast<Real>(count));
    return static_cast<std::size_t>(std::clamp(at, Real(0), static_cast<Real>(count - 1)));
}

/// Where a point of a regular polygon with a corner at `turn` is: on which polygon of the same middle, as a
/// part of the whole area, on which side, and where on that from its first corner to its second.
struct InPolygon {
    Real area = 0;
    std::size_t side = 0;
    Real along = 0;
};

InPolygon in_polygon(int sides, Real turn, const Vec2& p) {
    InPolygon found;
    const Real half = pi / sides;
    Real farthest = -1;
    for (int k = 0; k < sides; ++k) {
        const Real middle = turn + (2 * k + 1) * half;
        const Vec2 out(std::cos(middle), std::sin(middle)), on(-out.y, out.x);
        const Real distance = dot(p, out) / std::cos(half);
        if (distance <= farthest) continue;
        farthest = distance;
        const Real along = distance > 0 ? dot(p, on) / (distance * std::sin(half)) : 0;
        found = {distance * distance, static_cast<std::size_t>(k), (along + 1) / 2};
    }
    return found;
}

/// A view of `size` × `size` pixels from the origin along −z.
View plain_view(int size, Real half_height, Projection projection = Projection::Perspective) {
    View view;
    view.projection = projection;
    view.half_height = half_height;
    view.width = view.height = size;
    return view;
}

Lens round_lens(Real radius, Real distance) {
    Lens lens;
    lens.radius = radius;
    lens.distance = distance;
    return lens;
}

void check_ray(const View& view, const Lens& lens, const Vec2& at, const Vec2& on_lens, const Vec3& origin,
               const Vec3& direction) {
    const Ray ray = lens_ray(view, lens, at.x, at.y, on_lens);
    INFO("through the point " << at << " of a picture of " << view.width << " x " << view.height
                              << " pixels, eye " << view.eye << ", lens of radius " << lens.radius
                              << ", in focus at " << lens.distance << ", on the lens at " << on_lens);
    CHECK(near(ray.origin, origin, gamma(16) * (length(view.eye) + length(origin))));
    CHECK(near(ray.direction, direction, test::direction_bound(view)));
    CHECK(ray.time == 0);
}

/// Where the ray meets the plane that is `depth` away along the view, in the frame of the camera, from the
/// eye.
Vec2 at_depth(const View& view, const Ray& ray, Real depth) {
    const Vec3 o = ray.origin - view.eye;
    const auto& [right, up, back] = view.frame;
    const Real t = (depth + dot(o, back)) / -dot(ray.direction, back);
    return {dot(o, right) + t * dot(ray.direction, right), dot(o, up) + t * dot(ray.direction, up)};
}

/// The point of the picture at which a point of the plane at `distance` is seen through the lens's middle.
Vec2 in_picture(const View& view, const Vec2& p, Real distance) {
    const Real pixels = view.height / (2 * view.half_height * distance);
    return {view.width / 2.0 + pixels * p.x, view.height / 2.0 - pixels * p.y};
}

void check_blur(const Lens& lens, Real depth, Real expected) {
    INFO("a lens of radius " << lens.radius << ", in focus at " << lens.distance << ", a point at depth "
                             << depth);
    CHECK(near(blur_radius(lens, depth), expected, gamma(6) * expected));
}

}  // namespace

TEST_CASE("the middles of the square's sides and its corners, by hand", "[12.6]") {
    check_disc({1, 0.5}, {1, 0});
    check_disc({0.5, 1}, {0, 1});
    check_disc({0, 0.5}, {-1, 0});
    check_disc({0.5, 0}, {0, -1});
    check_disc({1, 1}, {root_half, root_half});
    check_disc({0, 1}, {-root_half, root_half});
    check_disc({0, 0}, {-root_half, -root_half});
    check_disc({1, 0}, {root_half, -root_half});
}

TEST_CASE("the middle of the square is the middle of the disc and of polygons", "[12.6]") {
    check_disc({0.5, 0.5}, {0, 0});
    for (const int sides : {3, 4, 5, 8}) check_polygon(sides, 1, {0.5, 0.5}, {0, 0});
}

TEST_CASE("halfway out is half the radius, halfway along an eighth is half of 45 degrees", "[12.6]") {
    check_disc({0.75, 0.5}, {0.5, 0});
    check_disc({0.5, 0.125}, {0, -0.75});
    check_disc({0.75, 0.75}, at_angle(45) / 2.0);
    check_disc({1, 0.75}, at_angle(22.5));
    check_disc({0.75, 1}, at_angle(67.5));
    check_disc({0.25, 1}, at_angle(112.5));
    check_disc({0, 0.75}, at_angle(157.5));
    check_disc({0, 0.25}, at_angle(202.5));
    check_disc({0.25, 0}, at_angle(247.5));
    check_disc({1, 0.25}, at_angle(-22.5));
    check_disc({0.75, 0.625}, at_angle(22.5) / 2.0);
}

TEST_CASE("points of a square that stands on its corner, by hand", "[12.6]") {
    check_polygon(4, 0, {1, 0.5}, {1, 0});
    check_polygon(4, 0, {0.5, 1}, {0, 1});
    check_polygon(4, 0, {0, 0.5}, {-1, 0});
    check_polygon(4, 0, {0.5, 0}, {0, -1});
    // 45 degrees are an eighth of the way around: the middle of the first side.
    check_polygon(4, 0, {1, 1}, {0.5, 0.5});
    check_polygon(4, 0, {0.75, 0.75}, {0.25, 0.25});
    check_polygon(4, 0, {0, 0}, {-0.5, -0.5});
    check_polygon(4, 0, {1, 0}, {0.5, -0.5});
    // 22.5 degrees: a quarter of the side.
    check_polygon(4, 0, {1, 0.75}, {0.75, 0.25});
    check_polygon(4, 0, {1, 0.25}, {0.75, -0.25});
}

TEST_CASE("a polygon's first corner is where it is turned to", "[12.6]") {
    for (const int sides : {3, 5, 6})
        for (const Real degrees : {0.0, 90.0, -30.0}) {
            check_polygon(sides, radians(degrees), {1, 0.5}, at_angle(degrees));
            check_polygon(sides, radians(degrees), {0.75, 0.5}, at_angle(degrees) / 2.0);
        }
    // Half of the way around a triangle is the middle of the side across from its first corner.
    check_polygon(3, radians(90), {0, 0.5}, {0, -0.5});
    check_polygon(3, radians(90), {1, 1}, (5.0 * at_angle(90) + 3.0 * at_angle(210)) / 8.0);
}

TEST_CASE("as many points in each part of the disc as its area demands", "[12.6]") {
    // 8 rings of equal area in 24 sectors; false alarms once in ten million.
    const auto pairs = test::many(static_cast<std::size_t>(cases(60'000)), 12601, random_pair);
    const std::vector<Vec2> points = test::answers(pairs, disc_point);
    std::vector<int> counts(8 * 24);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Vec2& p = points[i];
        if (!(length(p) <= 1 + gamma(24)))
            FAIL("random numbers " << pairs[i] << ": point " << p << " is outside");
        ++counts[part_of(dot(p, p), 8) * 24 + part_of(std::atan2(p.y, p.x) / (2 * pi) + 0.5, 24)];
    }
    INFO("points in 8 rings of equal area, each in 24 sectors");
    CHECK(test::chi_square(counts) < test::chi_square_limit(counts.size()));
}

TEST_CASE("as many points in each part of a polygon as its area demands", "[12.6]") {
    // Rings of equal area, the sides, and five parts of each; false alarms less than once in a million.
    Random random(12602);
    for (const int sides : {3, 5, 8}) {
        const Real turn = random.uniform(-4, 4);
        const auto pairs = test::many(static_cast<std::size_t>(cases(40'000)), random.engine(), random_pair);
        const std::vector<Vec2> points =
            test::answers(pairs, [&](const Vec2& numbers) { return polygon_point(sides, turn, numbers); });
        std::vector<int> counts(static_cast<std::size_t>(6 * 5 * sides));
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const InPolygon at = in_polygon(sides, turn, points[i]);
            if (!(at.area <= 1 + gamma(300)))
                FAIL("a polygon of " << sides << " sides, turned by " << turn << ", random numbers "
                                     << pairs[i] << ": point " << points[i] << " is outside");
            const std::size_t part = at.side * 5 + part_of(at.along, 5);
            ++counts[part * 6 + part_of(at.area, 6)];
        }
        INFO("points in 6 rings of equal area of a polygon of " << sides << " sides, 5 parts of each side");
        CHECK(test::chi_square(counts) < test::chi_square_limit(counts.size()));
    }
}

TEST_CASE("neighbours in the square are neighbours in the disc and in polygons", "[12.6]") {
    Random random(12603);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec2 a = random_pair(random), way = 1e-6 * Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
        const Vec2 b = glm::clamp(a + way, 0.0, 1.0);
        const int sides = 3 + static_cast<int>(random.index(6));
        INFO("random numbers " << a << " and " << b << ", " << sides << " sides");
        // A side of the square, 2, becomes a quarter of the circle, π/2, or less than 2.6 of a triangle; the
        // greatest stretching of both together is less than 8.
        const Real apart = length(a - b);
        CHECK(length(disc_point(a) - disc_point(b)) <= 8 * apart + gamma(64));
        CHECK(length(polygon_point(sides, 0.5, a) - polygon_point(sides, 0.5, b)) <= 8 * apart + gamma(256));
    }
}

TEST_CASE("a ray from 2 above the middle of the lens to (4, 0, -4), by hand", "[12.7]") {
    // The point (2, 1) is in the middle of the right edge, where a = 1 and b = 0: (1, 0, -1) meets the plane
    // z = -4 at (4, 0, -4). From (0, 2, 0) that is (4, -2, -4) away, which is 6 long.
    const View view = plain_view(2, 1);
    check_ray(view, round_lens(2, 4), {2, 1}, {0, 1}, {0, 2, 0}, Vec3(2, -1, -2) / 3.0);
    // In the middle of the picture: from (3, 0, 0) to (0, 0, -4), which is 5 away.
    check_ray(view, round_lens(3, 4), {1, 1}, {1, 0}, {3, 0, 0}, {-0.6, 0, -0.8});
    check_ray(view, round_lens(6, 4), {1, 1}, {0, -0.5}, {0, -3, 0}, {0, 0.6, -0.8});
    // Straight ahead: the point in focus is as far to the right as the ray's origin is.
    check_ray(view, round_lens(8, 4), {2, 1}, {0.5, 0}, {4, 0, 0}, {0, 0, -1});
}

TEST_CASE("the lens stands across the view, wherever the camera looks", "[12.7]") {
    // A camera at (10, 20, 30) that looks along -x: -z is to the right.
    View view = plain_view(2, 1);
    view.frame = {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
    view.eye = {10, 20, 30};
    check_ray(view, round_lens(2, 4), {2, 1}, {0, 1}, {10, 22, 30}, Vec3(-2, -1, -2) / 3.0);
    check_ray(view, round_lens(3, 4), {1, 1}, {1, 0}, {10, 20, 27}, {-0.8, 0, 0.6});
}

TEST_CASE("the lens of an orthographic view starts where the ray does", "[12.7]") {
    const View view = plain_view(2, 1, Projection::Orthographic);
    check_ray(view, round_lens(3, 4), {2, 1}, {1, 0}, {4, 0, 0}, {-0.6, 0, -0.8});
    check_ray(view, round_lens(3, 4), {1, 0}, {0, -1}, {0, -2, 0}, {0, 0.6, -0.8});
}

TEST_CASE("a camera far from the world's origin looks in the same directions", "[12.7]") {
    View view = plain_view(2, 1);
    view.eye = {1e9, -1e9, 1e9};
    const Ray ray = lens_ray(view, round_lens(0.2, 0.4), 2, 1, {0, 1});
    INFO("a camera at " << view.eye << ": " << ray);
    CHECK(near(ray.direction, Vec3(2, -1, -2) / 3.0, test::direction_bound(view)));
}

TEST_CASE("a lens of radius 0 is a pinhole", "[12.7]") {
    Random random(12701);
    for (int i = 0; i < cases(5000); ++i) {
        const Projection projection = i % 2 == 0 ? Projection::Perspective : Projection::Orthographic;
        const View view = test::some_view(random, projection);
        const Real x = random.uniform(0, view.width), y = random.uniform(0, view.height);
        const Ray middle = pixel_ray(view, x, y);
        check_ray(view, round_lens(0, random.magnitude(-3, 3)), {x, y}, disc_point(random_pair(random)),
                  middle.origin, middle.direction);
    }
}

TEST_CASE("all rays of a point of the picture meet in the plane in focus", "[12.7]") {
    Random random(12702);
    for (int i = 0; i < cases(5000); ++i) {
        View view = test::some_view(random, Projection::Perspective);
        view.half_height = random.uniform(0.1, 1.5);
        view.eye = random.in_cube();
        const Lens lens = round_lens(random.magnitude(-3, 0), random.magnitude(-1, 2));
        const Real x = random.uniform(0, view.width), y = random.uniform(0, view.height);
        const Real pixel = 2 * view.half_height / view.height;
        const Vec2 expected =
            lens.distance * Vec2(pixel * (x - view.width / 2.0), pixel * (view.height / 2.0 - y));
        for (int k = 0; k < 4; ++k) {
            const Real phi = random.uniform(0, 2 * pi), r = k == 0 ? 1 : random.uniform(0, 1);
            const Vec2 on_lens(r * std::cos(phi), r * std::sin(phi));
            const Ray ray = lens_ray(view, lens, x, y, on_lens);
            INFO("eye " << view.eye << ", lens of radius " << lens.radius << ", in focus at " << lens.distance
                        << ", on the lens at " << on_lens << ": the " << ray
                        << " in the plane in focus, from the axis, to the right and up");
            // Where a direction is off by e, its ray is off by e times its way and once more by how steeply
            // it meets the plane; the origin adds its own.
            const Real way = length(Vec3(expected - lens.radius * on_lens, lens.distance));
            const Real error = 2 * test::direction_bound(view) * way * way / lens.distance +
                               gamma(64) * (length(view.eye) + lens.radius) * way / lens.distance;
            CHECK(near(at_depth(view, ray, lens.distance), expected, error));
        }
    }
}

TEST_CASE("rays of a point of the picture are parallel where the focus is infinitely far away", "[12.7]") {
    const View view = plain_view(2, 1);
    for (const Vec2 on_lens : {Vec2(0, 0), Vec2(1, 0), Vec2(-0.6, 0.8)})
        for (const Real distance : {1e200, infinity})
            check_ray(view, round_lens(2, distance), {2, 1}, on_lens, {2 * on_lens.x, 2 * on_lens.y, 0},
                      {root_half, 0, -root_half});
}

TEST_CASE("the blur of points before, in and behind the focus, by hand", "[12.7]") {
    const Lens lens = round_lens(2, 4);
    check_blur(lens, 4, 0);
    check_blur(lens, 8, 1);
    check_blur(lens, 2, 2);
    check_blur(lens, 1, 6);
    check_blur(lens, 16, 1.5);
    check_blur(lens, infinity, 2);
    check_blur(round_lens(0, 4), 8, 0);
}

TEST_CASE("the blur nearly in focus has all its digits", "[12.7]") {
    // Behind the focus by a part d: 3·d/(1 + d), by its series.
    const Real d = 0x1p-30;
    check_blur(round_lens(3, 1), 1 + d, 3 * (d - d * d + d * d * d));
    check_blur(round_lens(3, 1), 1 - d, 3 * (d + d * d + d * d * d));
    check_blur(round_lens(3, 1), 1 + 0x1p-52, 3 * 0x1p-52);
}

TEST_CASE("the blur is what the lens equation says of the picture behind the lens", "[12.7]") {
    Random random(12703);
    for (int i = 0; i < cases(5000); ++i) {
        const Real focal = random.magnitude(-2, 0);
        const Lens lens = round_lens(random.magnitude(-3, 1), focal * random.uniform(1.5, 100));
        const Real depth = focal * random.uniform(1.1, 200);
        // 1/focal = 1/depth + 1/behind says where light from that depth comes together behind the lens.
        const auto behind = [&](Real before) { return focal * before / (before - focal); };
        const Real sensor = behind(lens.distance), sharp = behind(depth);
        const Real on_sensor = lens.radius * std::abs(sharp - sensor) / sharp;
        // Whatever is in focus is sensor/distance as large on the sensor.
        const Real expected = on_sensor * lens.distance / sensor;
        INFO("focal length " << focal << ", the sensor " << sensor << " behind the lens of radius "
                             << lens.radius << ", in focus at " << lens.distance << ", a point at depth "
                             << depth);
        // Its difference loses digits near the focus, each quotient up to a factor of 10.
        const Real error = gamma(64) * 10 * lens.radius * lens.distance * (1 / depth + 1 / sensor);
        CHECK(near(blur_radius(lens, depth), expected, error + gamma(6) * expected));
    }
}

TEST_CASE("rays from the rim of the lens through a point meet the plane in focus on a circle", "[12.7]") {
    // The other way round: aimed at that circle, they must meet in the point.
    Random random(12704);
    for (int i = 0; i < cases(3000); ++i) {
        const View view = plain_view(200, 1);
        const Lens lens = round_lens(random.magnitude(-3, -0.5), random.magnitude(0, 1));
        const Real depth = lens.distance * random.uniform(0.5, 3);
        const Real blur = blur_radius(lens, depth);
        for (const Real phi : {0.5, 2.5, 4.5}) {
            const Vec2 rim(std::cos(phi), std::sin(phi));
            // Behind the focus rays have not crossed yet when they come to the plane; before it, they have.
            const Vec2 seen = in_picture(view, (depth > lens.distance ? blur : -blur) * rim, lens.distance);
            const Ray ray = lens_ray(view, lens, seen.x, seen.y, rim);
            INFO("lens of radius " << lens.radius << ", in focus at " << lens.distance
                                   << ", a point on the axis at depth " << depth << ", blur " << blur
                                   << ", the ray from " << rim << " of the lens there, right and up");
            CHECK(near(at_depth(view, ray, depth), Vec2(0), 8 * test::direction_bound(view) * depth));
        }
    }
}

TEST_CASE("a pentagon's blur is a pentagon, upside down before the focus", "[12.7]") {
    // A point on the axis lights the picture where a ray through some point of the opening meets it.
    Lens lens = round_lens(0.5, 4);
    lens.sides = 5;
    lens.turn = pi / 2;
    const View view = plain_view(200, 1);
    for (const Real depth : {8.0, 2.0}) {
        Real highest = -infinity, lowest = infinity;
        for (int k = 0; k < 64; ++k) {
            const Vec2 on_lens = polygon_point(lens.sides, lens.turn, {(k % 8) / 7.0, (k / 8) / 7.0});
            const Real blur = blur_radius(lens, depth) * (depth > lens.distance ? 1 : -1);
            const Vec2 seen = in_picture(view, blur * on_lens, lens.distance);
            const Ray ray = lens_ray(view, lens, seen.x, seen.y, on_lens);
            INFO("a point on the axis at depth " << depth << ", through " << on_lens
                                                 << " of the lens: " << ray << ", there");
            CHECK(near(at_depth(view, ray, depth), Vec2(0), 8 * test::direction_bound(view) * depth));
            highest = std::max(highest, 100 - seen.y);
            lowest = std::min(lowest, 100 - seen.y);
        }
        // The lens's own pentagon has its corner at the top, 1 above the middle, and a side 0.809 below it.
        INFO("depth " << depth << ": the blur reaches " << highest << " pixels above its middle and "
                      << -lowest << " below");
        CHECK((highest > -lowest) == (depth > lens.distance));
    }
}

// 12.24 --------------------------------------------------------------------------------------------------

namespace {

/// The floor, 3 below the eye of a plain view.
const FocusPlane below{Vec3(7, -3, 5), Vec3(0, 2, 0)};

/// What rounding may do to a direction of tilted_lens_ray: the contract's.
Real tilted_bound(const View& view, Real radius, const FocusPlane& plane, const Vec3& eye) {
    const Real h = std::abs(dot(plane.point - eye, plane.normal)) / length(plane.normal);
    return test::direction_bound(view) * (1 + radius / h * (1 + (length(eye) + length(plane.point)) / h));
}

void check_tilted(const View& view, Real radius, const FocusPlane& plane, const Vec2& at, const Vec2& on_lens,
                  const Vec3& origin, const Vec3& direction) {
    const Ray ray = tilted_lens_ray(view, radius, plane, at.x, at.y, on_lens);
    INFO("a lens of radius " << radius << ", in focus the plane through " << plane.point
                             << " with the normal " << plane.normal << ", the point " << at
                             << " of the picture, on the lens at " << on_lens << ": origin, then direction");
    CHECK(near(ray.origin, origin, gamma(64) * (length(view.eye) + radius + 1)));
    CHECK(near(ray.direction, direction, tilted_bound(view, radius, plane, view.eye)));
}

}  // namespace

TEST_CASE("with the floor in focus, a ray from 2 beside the middle to (0, -3, -4), by hand", "[12.24]") {
    // (1, 1.75) is the ray (0, -3, -4)/5. From (2, 0, 0) the point is (-2, -3, -4) away.
    const View view = plain_view(2, 1);
    check_tilted(view, 2, below, {1, 1.75}, {1, 0}, {2, 0, 0}, Vec3(-2, -3, -4) / std::sqrt(29.0));
    // From the top, (0, 2, 0), it is (0, -5, -4) away.
    check_tilted(view, 2, below, {1, 1.75}, {0, 1}, {0, 2, 0}, Vec3(0, -5, -4) / std::sqrt(41.0));
}

TEST_CASE("rays along the plane in focus are parallel", "[12.24]") {
    const View view = plain_view(2, 1);
    for (const Vec2 on_lens : {Vec2(0, 0), Vec2(1, 0), Vec2(-0.6, 0.8)})
        check_tilted(view, 2, below, {1, 1}, on_lens, {2 * on_lens.x, 2 * on_lens.y, 0}, {0, 0, -1});
}

TEST_CASE("above the horizon of the plane in focus rays part, by hand", "[12.24]") {
    // (1, 0.25) is the ray (0, 3, -4)/5, which would come from (0, -3, 4). From there to (2, 0, 0).
    check_tilted(plain_view(2, 1), 2, below, {1, 0.25}, {1, 0}, {2, 0, 0}, Vec3(2, 3, -4) / std::sqrt(29.0));
}

TEST_CASE("a lens that does not lean is that of lens_ray", "[12.24]") {
    Random random(122401);
    for (int i = 0; i < cases(3000); ++i) {
        View view = test::some_view(random, i % 2 == 0 ? Projection::Perspective : Projection::Orthographic);
        view.eye = random.in_cube();
        const Lens lens = round_lens(random.magnitude(-3, 0), random.magnitude(-1, 2));
        const FocusPlane plane{view.eye - lens.distance * view.frame.w,
                               random.magnitude(-3, 3) * view.frame.w};
        const Real x = random.uniform(0, view.width), y = random.uniform(0, view.height);
        const Vec2 on_lens = disc_point(random_pair(random));
        const Ray expected = lens_ray(view, lens, x, y, on_lens);
        const Ray ray = tilted_lens_ray(view, lens.radius, plane, x, y, on_lens);
        INFO("eye " << view.eye << ", lens of radius " << lens.radius << ", in focus at " << lens.distance
                    << ", on the lens at " << on_lens << ": origin, then direction");
        CHECK(near(ray.origin, expected.origin, gamma(64) * (length(expected.origin) + lens.radius)));
        const Vec3 middle = pixel_ray(view, x, y).origin;
        CHECK(near(ray.direction, expected.direction,
                   tilted_bound(view, lens.radius, plane, middle) + test::direction_bound(view)));
    }
}

TEST_CASE("rays through a lens that leans meet in the plane in focus", "[12.24]") {
    Random random(122402);
    for (int i = 0; i < cases(3000); ++i) {
        View view = test::some_view(random, Projection::Perspective);
        view.half_height = random.uniform(0.1, 1);
        view.eye = random.in_cube();
        const Real radius = random.magnitude(-3, 0);
        const Vec3 away = random.direction();
        const Real size = random.magnitude(-1, 1);
        const FocusPlane plane{view.eye + size * away, random.direction()};
        const Real x = random.uniform(0, view.width), y = random.uniform(0, view.height);
        const Vec2 on_lens = disc_point(random_pair(random));
        const Ray middle = pixel_ray(view, x, y);
        const Ray ray = tilted_lens_ray(view, radius, plane, x, y, on_lens);
        const Real t = dot(plane.point - middle.origin, plane.normal) / dot(middle.direction, plane.normal);
        if (!(std::abs(t) < 1e3)) continue;
        const Vec3 meeting = middle.origin + t * middle.direction, way = meeting - ray.origin;
        INFO("eye " << view.eye << ", lens of radius " << radius << ", in focus the plane through "
                    << plane.point << " with the normal " << plane.normal << ", on the lens at " << on_lens
                    << ": the direction to the point in focus, or from it");
        if (!(length(way) > 1e-3)) continue;
        const Real bound = tilted_bound(view, radius, plane, view.eye);
        CHECK(near(ray.direction, (t > 0 ? 1.0 : -1.0) * normalize(way), bound * (1 + 1e3)));
    }
}
