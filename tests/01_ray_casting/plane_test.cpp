// Steps 01.4 and 01.5: one plane, and the nearest of several.
#include "chapters/01_ray_casting/plane.hpp"
#include "common/world/search.hpp"

#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

/// Stands for exact arithmetic: 11 more bits than Real where `long double` is the 80-bit format, 60 more
/// where it is quadruple. Where it is no more than double, the comparisons with it are left out.
using Precise = long double;
constexpr bool have_precise = std::numeric_limits<Precise>::digits >= 64;

Precise precise_dot(const Vec3& a, const Precise (&b)[3]) {
    return Precise(a.x) * b[0] + Precise(a.y) * b[1] + Precise(a.z) * b[2];
}

const Plane ground{{0, 0, 0}, {0, 1, 0}};
const Interval everything{0, infinity};

/// Plane and ray with lengths of all orders of magnitude; `far` is the scale of the positions.
struct Case {
    Plane plane;
    Ray ray;
};
Case random_case(Random& random) {
    const Real far = random.magnitude(-6, 6);
    return {{far * random.in_cube(), random.magnitude(-20, 20) * random.direction()},
            {far * random.in_cube(), random.magnitude(-20, 20) * random.direction()}};
}

void check_hit(const Plane& plane, const Ray& ray, const Interval& range, Real t, Real bound = 0) {
    INFO(plane << ", " << ray << " in " << range << ": the t of the hit");
    const std::optional<Hit> hit = intersect(plane, ray, range);
    REQUIRE(hit);
    CHECK(near(hit->t, t, bound));
}

void check_miss(const Plane& plane, const Ray& ray, const Interval& range) {
    INFO(plane << ", " << ray << " in " << range);
    CHECK_FALSE(intersect(plane, ray, range));
}

/// Which of several walls is hit, and where.
void check_nearest(const std::vector<Plane>& walls, const Ray& ray, const Interval& range,
                   std::uint32_t primitive, Real t) {
    std::string text = "walls in this order:";
    for (const Plane& wall : walls) text += "\n  " + show(wall);
    INFO(text << "\n" << ray << " in " << range << "; primitive is the wall's place in the list, from 0");
    CHECK(same_hit(closest_hit(walls, ray, range), Hit{.t = t, .primitive = primitive}));
}

/// Nothing is hit, neither first nor at all.
void check_none(const std::vector<Plane>& walls, const Ray& ray, const Interval& range) {
    INFO(walls.size() << " planes, " << ray << " in " << range);
    CHECK_FALSE(closest_hit(walls, ray, range));
    CHECK(or_say(!any_hit(walls, ray, range), "any_hit says that something is hit, expected nothing"));
}

}  // namespace

TEST_CASE("the lesson's example: from 3 above the ground, down by 0.2 a step, it takes 15 steps", "[01.4]") {
    check_hit(ground, {{0, 3, 4}, {-1.5, -0.2, -1.1}}, everything, 15, 8 * unit_roundoff * 15);
}

TEST_CASE("a ray straight down meets the ground at its height", "[01.4]") {
    check_hit(ground, {{0, 1, 0}, {0, -1, 0}}, everything, 1);
}

TEST_CASE("t counts in lengths of the direction", "[01.4]") {
    check_hit(ground, {{0, 1, 0}, {0, -0.5, 0}}, everything, 2);
}

TEST_CASE("a slanted ray meets a slanted plane", "[01.4]") {
    // (0, 0, 0) + t (1, 1, 1) lies on x + y + z = 6 at t = 2.
    check_hit(Plane{{1, 2, 3}, {1, 1, 1}}, {{0, 0, 0}, {1, 1, 1}}, everything, 2, 8 * unit_roundoff * 2);
}

TEST_CASE("a plane is hit from both sides", "[01.4]") {
    check_hit(ground, {{5, -3, 2}, {0, 1, 0}}, everything, 3);
}

TEST_CASE("a ray parallel to the plane misses it, even one inside the plane", "[01.4]") {
    check_miss(ground, {{0, 1, 0}, {1, 0, 0}}, everything);
    check_miss(ground, {{0, 0, 0}, {1, 0, 0}}, everything);
    check_miss(Plane{{0, 0, 0}, {1, -1, 0}}, {{0, 1, 0}, {2, 2, 5}}, everything);
}

TEST_CASE("a plane behind the ray is missed", "[01.4]") {
    check_miss(ground, {{0, 1, 0}, {0, 1, 0}}, everything);
}

TEST_CASE("a nearly parallel ray still hits, far away", "[01.4]") {
    check_hit(ground, {{0, 1, 0}, {1, -1e-15, 0}}, everything, 1e15, 8 * unit_roundoff * 1e15);
}

TEST_CASE("a ray that starts on the plane does not hit it there", "[01.4]") {
    check_miss(ground, {{7, 0, 7}, {1, -1, 0}}, everything);
}

TEST_CASE("far from the origin a plane is hit as exactly as near it", "[01.4]") {
    // Positions cancel; subtract them first, while they are exact, and not their products with the normal.
    const Vec3 far(1e9, 2e9, -3e9);
    check_hit(Plane{far, {0.1, 0.2, 0.3}}, {far + Vec3(0, 0, 1), {0, 0, -1}}, everything, 1,
              8 * unit_roundoff);
}

TEST_CASE("the range leaves its beginning out and takes its end in", "[01.4]") {
    const Ray ray{{0, 2, 0}, {0, -1, 0}};  // meets the ground at t = 2
    const Real below = std::nextafter(2.0, 0.0), above = std::nextafter(2.0, 3.0);
    check_miss(ground, ray, {2, 3});
    check_hit(ground, ray, {below, 3}, 2);
    check_hit(ground, ray, {1, 2}, 2);
    check_miss(ground, ray, {1, below});
    check_hit(ground, ray, {1, above}, 2);
}

TEST_CASE("neither the length nor the sign of the normal matters", "[01.4]") {
    Random random(41);
    for (int i = 0; i < cases(10'000); ++i) {
        const auto [plane, ray] = random_case(random);
        const Real factor = std::ldexp(i % 2 ? 1.0 : -1.0, static_cast<int>(random.index(81)) - 40);
        const auto hit = intersect(plane, ray, everything);
        const auto other = intersect(Plane{plane.point, factor * plane.normal}, ray, everything);
        const bool same = hit.has_value() == other.has_value() && (!hit || hit->t == other->t);
        if (!same) {
            INFO(plane << "\n" << ray << ": " << hit << "\nnormal times " << factor);
            REQUIRE(same_hit(other, hit));
        }
    }
    SUCCEED();
}

TEST_CASE("t does not depend on the unit of length, to the bit", "[01.4]") {
    Random random(42);
    for (int i = 0; i < cases(10'000); ++i) {
        const auto [plane, ray] = random_case(random);
        const Real scale = std::ldexp(1.0, static_cast<int>(random.index(81)) - 40);
        const auto hit = intersect(plane, ray, everything);
        const auto other = intersect(Plane{scale * plane.point, plane.normal},
                                     {scale * ray.origin, scale * ray.direction}, everything);
        const bool same = hit.has_value() == other.has_value() && (!hit || hit->t == other->t);
        if (!same) {
            INFO(plane << "\n" << ray << ": " << hit << "\nlengths times " << scale);
            REQUIRE(same_hit(other, hit));
        }
    }
    SUCCEED();
}

TEST_CASE("t is right for planes and rays of every size", "[01.4]") {
    if (!have_precise) return;
    Random random(43);
    int hits = 0, misses = 0;
    for (int i = 0; i < cases(100'000); ++i) {
        const auto [plane, ray] = random_case(random);
        const Vec3 n = plane.normal, q = plane.point, o = ray.origin, d = ray.direction;
        const Precise to_plane[3] = {Precise(q.x) - o.x, Precise(q.y) - o.y, Precise(q.z) - o.z};
        const Precise along[3] = {d.x, d.y, d.z};
        const Precise above = precise_dot(n, to_plane), slope = precise_dot(n, along);
        const Precise exact = above / slope;
        // Condition number: by how much the terms of both dot products are larger than their sums.
        Real terms = 0, slope_terms = 0;
        for (int k = 0; k < 3; ++k) {
            terms += std::abs(n[k] * static_cast<Real>(to_plane[k]));
            slope_terms += std::abs(n[k] * d[k]);
        }
        const Real kappa =
            terms / static_cast<Real>(std::abs(above)) + slope_terms / static_cast<Real>(std::abs(slope));
        if (8 * kappa * unit_roundoff > 1e-3) continue;  // hit or miss may be decided by rounding
        const auto hit = intersect(plane, ray, everything);
        const bool right = hit.has_value() == (exact > 0) &&
                           (!hit || std::abs(hit->t - exact) <= 8 * kappa * unit_roundoff * exact);
        ++(hit ? hits : misses);
        if (!right) {
            INFO(plane << "\n"
                       << ray << "\nexpected t = " << static_cast<Real>(exact)
                       << (exact > 0 ? "" : ", which is a miss"));
            REQUIRE(or_say(
                right, show(hit) + (hit ? ", off by " + show_size(static_cast<Real>(std::abs(hit->t - exact)))
                                        : "")));
        }
    }
    CHECK(hits > cases(100'000) / 4);
    CHECK(misses > cases(100'000) / 4);
}

TEST_CASE("the surface of a plane: the point on it, the unit normal", "[01.4]") {
    const Plane floor{{0, -1, 0}, {0, 4, 0}};
    const Ray ray{{0, 1, 0}, {1, -0.5, 2}};
    const auto hit = intersect(floor, ray, everything);
    REQUIRE(hit);
    const Surface surface = surface_at(floor, ray, *hit);
    INFO(floor << ", " << ray << "; point, normal and shading normal of the " << surface);
    CHECK(near(surface.point, {4, -1, 8}, 0));
    CHECK(near_direction(surface.normal, {0, 1, 0}, 0));
    CHECK(near_direction(surface.shading_normal, {0, 1, 0}, 0));
}

TEST_CASE("the error of a surface point is a true bound, and not a lazy one", "[01.4]") {
    if (!have_precise) return;
    Random random(44);
    int off_plane = 0;
    Real worst = 0;
    for (int i = 0; i < cases(100'000); ++i) {
        auto [plane, ray] = random_case(random);
        if (i % 3 == 0) plane.normal = Vec3(0, random.magnitude(-20, 20), 0);
        const auto hit = intersect(plane, ray, everything);
        if (!hit) continue;
        const Vec3 p = point_at(ray, hit->t), q = plane.point, n = plane.normal;
        const Surface surface = surface_at(plane, ray, *hit);
        // The exact foot of p on the plane.
        const Precise from_q[3] = {Precise(p.x) - q.x, Precise(p.y) - q.y, Precise(p.z) - q.z};
        const Precise normal[3] = {n.x, n.y, n.z};
        const Precise share = precise_dot(n, from_q) / precise_dot(n, normal);
        bool bounded = true;
        for (int k = 0; k < 3; ++k) {
            const Precise foot = p[k] - share * normal[k];
            const Precise error = std::abs(surface.point[k] - foot);
            bounded = bounded && error <= surface.error[k];
            if (error > 0) worst = std::max(worst, static_cast<Real>(error) / surface.error[k]);
        }
        const Precise rest[3] = {Precise(surface.point.x) - q.x, Precise(surface.point.y) - q.y,
                                 Precise(surface.point.z) - q.z};
        if (precise_dot(n, rest) != 0) ++off_plane;
        if (!bounded) {
            INFO(show(plane) << "\n"
                             << show(ray) << "\npoint " << show(surface.point) << ", error "
                             << show(surface.error));
            REQUIRE(or_say(bounded, "the point is farther from the plane than its error says"));
        }
    }
    CHECK(off_plane > cases(100'000) / 10);  // a bound of zero would not do
    CHECK(worst > 0.1);                      // nor is it ten times what it must be
}

TEST_CASE("points on a floor along an axis lie exactly on it", "[01.4]") {
    Random random(45);
    for (int i = 0; i < cases(10'000); ++i) {
        const Plane floor{{0, random.uniform(-2, 2), 0}, {0, 1, 0}};
        const Ray ray{10.0 * random.in_cube(), random.direction()};
        const auto hit = intersect(floor, ray, everything);
        if (!hit || hit->t > 1e3) continue;
        const Surface surface = surface_at(floor, ray, *hit);
        if (surface.point.y != floor.point.y) {
            INFO(show(floor) << "\n" << show(ray) << "\npoint " << show(surface.point));
            REQUIRE(surface.point.y == floor.point.y);
            return;
        }
    }
    SUCCEED();
}

TEST_CASE("of three walls the nearest is hit, in whichever order they stand", "[01.5]") {
    const Plane near_wall{{0, 0, -1}, {0, 0, 1}}, wall{{0, 0, -2}, {0, 0, 1}},
        far_wall{{0, 0, -3}, {0, 0, 1}};
    const Ray ray{{0, 0, 0}, {0, 0, -1}};
    check_nearest({near_wall, wall, far_wall}, ray, everything, 0, 1);
    check_nearest({far_wall, near_wall, wall}, ray, everything, 1, 1);
    check_nearest({far_wall, wall, near_wall}, ray, everything, 2, 1);
}

TEST_CASE("of walls at the same distance the first is hit", "[01.5]") {
    const Plane far_wall{{0, 0, -3}, {0, 0, 1}}, wall{{0, 0, -2}, {0, 0, 1}}, back{{5, 5, -2}, {0, 0, -4}};
    check_nearest({far_wall, wall, back, wall}, {{0, 0, 0}, {0, 0, -1}}, everything, 1, 2);
}

TEST_CASE("where no plane is hit there is no nearest one", "[01.5]") {
    const Ray up{{0, 1, 0}, {0, 1, 0}};
    check_none({}, up, everything);
    check_none({ground, ground}, up, everything);
}

TEST_CASE("walls before the range do not hide those in it", "[01.5]") {
    const std::vector<Plane> walls{{{0, 0, -1}, {0, 0, 1}}, {{0, 0, -2}, {0, 0, 1}}, {{0, 0, -3}, {0, 0, 1}}};
    const Ray ray{{0, 0, 0}, {0, 0, -1}};
    check_nearest(walls, ray, {1, infinity}, 1, 2);  // the beginning is left out
    check_nearest(walls, ray, {2, 3}, 2, 3);         // the end is taken in
    check_none(walls, ray, {1, 1.5});
}

TEST_CASE("the nearest of many planes is what asking each of them says", "[01.5]") {
    Random random(51);
    for (int i = 0; i < cases(10'000); ++i) {
        std::vector<Plane> planes(random.index(9));
        for (Plane& plane : planes) {
            plane = {random.in_cube(), random.direction()};
            // Sometimes a plane comes twice.
            if (&plane != planes.data() && random.index(3) == 0) plane = planes[0];
        }
        const Ray ray{random.in_cube(), random.magnitude(-20, 20) * random.direction()};
        const Real length = glm::length(ray.direction);
        const Interval range{random.uniform(0, 0.2) / length, random.uniform(0.5, 5) / length};
        std::optional<Hit> expected;
        for (std::size_t k = planes.size(); k-- > 0;) {
            const auto hit = intersect(planes[k], ray, range);
            if (hit && (!expected || hit->t <= expected->t)) {
                expected = hit;
                expected->primitive = static_cast<std::uint32_t>(k);
            }
        }
        const auto hit = closest_hit(planes, ray, range);
        if (same_hit(hit, expected) && any_hit(planes, ray, range) == expected.has_value()) continue;
        INFO(planes.size() << " planes, " << ray << " in " << range);
        CHECK(same_hit(hit, expected));
        INFO("whether any_hit finds something");
        REQUIRE(any_hit(planes, ray, range) == expected.has_value());
    }
    SUCCEED();
}
