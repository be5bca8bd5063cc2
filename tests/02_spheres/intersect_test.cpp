// Steps 02.2 and 02.3: where a line meets a sphere, and which of these points a ray hits.
#include "chapters/02_spheres/sphere.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <string>

using namespace rt;
using test::ahead;
using test::cases;
using test::Random;

namespace {

const Sphere unit_sphere{{0, 0, 0}, 1};

/// The lesson's example: radius 5, 10 ahead and 3 above the ray, which runs along -z.
const Sphere above{{0, 3, -10}, 5};
const Ray level{{0, 0, 0}, {0, 0, -1}};

struct Case {
    Sphere sphere;
    Ray ray;
};

/// A random line and a sphere at `miss` radii from it, nearest to the centre at a t in [-reach, reach).
Case aimed(Random& random, Real miss, Real reach) {
    const Real foot = random.uniform(-reach, reach);
    const Vec3 d = random.direction();
    const Vec3 side = normalize(cross(d, random.direction()));
    const Ray ray{10.0 * random.in_cube(), random.magnitude(-3, 3) * d};
    const Real radius = random.magnitude(-3, 3);
    return {{point_at(ray, foot) + miss * radius * side, radius}, ray};
}

std::string describe(const Case& c) { return test::show(c.sphere) + "\n" + test::show(c.ray); }

/// What rounding can add to the distance between the centre and a point of the surface, seen from the ray's
/// origin: a dozen rounded operations, each off by u times the greatest length that occurs.
Real slack(const Case& c) { return gamma(12) * (length(c.ray.origin - c.sphere.center) + c.sphere.radius); }

void check_roots(const Sphere& sphere, const Ray& ray, Real t0, Real t1) {
    const Roots actual = intersections(sphere, ray);
    INFO(describe({sphere, ray}));
    INFO("expected t0 = " << t0 << ", t1 = " << t1 << "; found " << actual);
    {
        INFO("how many roots there are");
        CHECK(actual.count == (t0 == t1 ? 1 : 2));
    }
    INFO("t0 is the smaller one, t1 the larger");
    const Real few_roundings = gamma(8) * std::max(std::abs(t0), std::abs(t1));
    CHECK(test::near(actual.t0, t0, few_roundings));
    CHECK(test::near(actual.t1, t1, few_roundings));
}

void check_hit(const Sphere& sphere, const Ray& ray, Interval range, Real t) {
    const std::optional<Hit> hit = intersect(sphere, ray, range);
    INFO(describe({sphere, ray}) << "\nrange " << range << "; the t of the hit");
    REQUIRE(hit);
    CHECK(test::near(hit->t, t, gamma(8) * std::abs(t)));
}

void check_miss(const Sphere& sphere, const Ray& ray, Interval range) {
    const std::optional<Hit> hit = intersect(sphere, ray, range);
    INFO(describe({sphere, ray}) << "\nrange " << range);
    CHECK_FALSE(hit);
}

}  // namespace

// ------------------------------------------------------------------------------------ 02.2 intersections

TEST_CASE("the lesson's example: a line 3 from the centre of a sphere of radius 5 meets it at 6 and 14",
          "[02.2]") {
    check_roots(above, level, 6, 14);
}

TEST_CASE("a line through the unit sphere from five units away meets it at 4 and 6", "[02.2]") {
    check_roots(unit_sphere, {{0, 0, 5}, {0, 0, -1}}, 4, 6);
}

TEST_CASE("t counts lengths of the direction", "[02.2]") {
    check_roots(unit_sphere, {{0, 0, 5}, {0, 0, -2}}, 2, 3);
    check_roots(unit_sphere, {{0, 0, 5}, {0, 0, -0.5}}, 8, 12);
}

TEST_CASE("a sphere behind the origin has negative roots", "[02.2]") {
    check_roots(unit_sphere, {{0, 0, -5}, {0, 0, -1}}, -6, -4);
}

TEST_CASE("from the centre the roots are a radius away on both sides", "[02.2]") {
    check_roots({{1, 2, 3}, 4}, {{1, 2, 3}, {0, 1, 0}}, -4, 4);
}

TEST_CASE("from inside of a sphere one root is behind", "[02.2]") {
    check_roots(above, {{0, 0, -12}, {0, 0, -1}}, -6, 2);
}

TEST_CASE("a tangent line meets the sphere once", "[02.2]") {
    check_roots(unit_sphere, {{1, 0, 5}, {0, 0, -1}}, 5, 5);
}

TEST_CASE("a line that passes beside the sphere has no roots", "[02.2]") {
    for (const Real x : {-1.5, 1.5, 1.125}) {
        const Roots roots = intersections(unit_sphere, {{x, 0, 5}, {0, 0, -1}});
        INFO("the line passes the centre at " << std::abs(x) << " radii: " << roots
                                              << "\nhow many roots there are");
        CHECK(roots.count == 0);
    }
}

TEST_CASE("a far sphere is not flattened: radius 1 at distance 10^8", "[02.2]") {
    // The line passes the centre at 0.6, so half the chord is 0.8. h*h - a*c is 10^16 - 10^16 here.
    const Real far = 1e8, ulp = far * 2 * unit_roundoff;
    const Roots roots = intersections({{0.6, 0, -far}, 1}, {{0, 0, 0}, {0, 0, -1}});
    {
        INFO("a line that passes the centre at 0.6 radii: " << roots << "\nhow many roots there are");
        CHECK(roots.count == 2);
    }
    {
        INFO("the line enters half a chord, 0.8, before t = 10^8, and leaves as much behind it");
        CHECK(test::near(roots.t0, far - 0.8, ulp));
        CHECK(test::near(roots.t1, far + 0.8, ulp));
    }
    const Roots beside = intersections({{1.001, 0, -far}, 1}, {{0, 0, 0}, {0, 0, -1}});
    INFO("a line that passes the centre at 1.001 radii: " << beside << "\nhow many roots there are");
    CHECK(beside.count == 0);
}

TEST_CASE("both roots are points of the sphere and ascend", "[02.2]") {
    Random random(2201);
    for (int i = 0; i < cases(20000); ++i) {
        const Case c = aimed(random, random.uniform(0, 1), 100);
        const Roots roots = intersections(c.sphere, c.ray);
        INFO(describe(c) << "\n" << roots);
        REQUIRE(test::or_say(roots.count > 0, "no roots, but the line passes inside of the sphere"));
        CHECK(test::or_say(roots.t0 <= roots.t1, "t0 is greater than t1"));
        INFO("how far the point at t0, and that at t1, is from the centre: a radius");
        const Vec3 f = c.ray.origin - c.sphere.center;
        // A root is only as good as its last bit: that moves the point along the ray by u·|t|·|d|.
        const Real last_bits = gamma(4) * length(c.ray.direction);
        CHECK(test::near(length(f + roots.t0 * c.ray.direction), c.sphere.radius,
                         slack(c) + last_bits * std::abs(roots.t0)));
        CHECK(test::near(length(f + roots.t1 * c.ray.direction), c.sphere.radius,
                         slack(c) + last_bits * std::abs(roots.t1)));
    }
}

TEST_CASE("lines that pass clearly inside hit and lines clearly outside miss", "[02.2]") {
    Random random(2202);
    for (int i = 0; i < cases(20000); ++i) {
        const Real gap = random.magnitude(-6, 0);
        const bool inside = i % 2 == 0;
        // Up to some thousands of radii away; there the position of the line is good to 10^-9 radii.
        const Case c = aimed(random, inside ? 1 - gap : 1 + gap, 3);
        if (slack(c) > gap * c.sphere.radius) continue;
        INFO(describe(c) << "\npasses " << gap << " radii " << (inside ? "inside" : "outside")
                         << " of it; whether there are roots");
        CHECK((intersections(c.sphere, c.ray).count > 0) == inside);
    }
}

TEST_CASE("a scene in other units gives the same picture: t does not change", "[02.2]") {
    Random random(2203);
    for (int i = 0; i < cases(5000); ++i) {
        const Case c = aimed(random, random.uniform(0, 1.5), 3);
        const Real s = std::ldexp(1, static_cast<int>(random.index(81)) - 40);
        const Roots one = intersections(c.sphere, c.ray);
        const Roots scaled = intersections({s * c.sphere.center, s * c.sphere.radius},
                                           {s * c.ray.origin, s * c.ray.direction});
        const Roots stretched = intersections(c.sphere, {c.ray.origin, s * c.ray.direction});
        INFO(describe(c) << ": " << one << "\nall lengths times " << s << ": " << scaled
                         << "\nonly the direction times that: " << stretched);
        CHECK(scaled.count == one.count);
        CHECK(scaled.t0 == one.t0);
        CHECK(scaled.t1 == one.t1);
        CHECK(stretched.count == one.count);
        CHECK(stretched.t0 == one.t0 / s);
        CHECK(stretched.t1 == one.t1 / s);
    }
}

// --------------------------------------------------------------------------------------- 02.3 intersect

TEST_CASE("the lesson's example: of the roots 6 and 14 the nearer is hit", "[02.3]") {
    check_hit(above, level, ahead, 6);
}

TEST_CASE("of two roots ahead the nearer is hit", "[02.3]") {
    check_hit(unit_sphere, {{0, 0, 5}, {0, 0, -1}}, ahead, 4);
}

TEST_CASE("a tangent ray hits", "[02.3]") { check_hit(unit_sphere, {{1, 0, 5}, {0, 0, -1}}, ahead, 5); }

TEST_CASE("t of a hit counts lengths of the direction", "[02.3]") {
    check_hit(unit_sphere, {{0, 0, 5}, {0, 0, -2}}, ahead, 2);
}

TEST_CASE("from inside the far side is hit", "[02.3]") {
    check_hit(unit_sphere, {{0, 0, 0}, {0, 0, -1}}, ahead, 1);
    check_hit(unit_sphere, {{0, 0, 0.5}, {0, 0, -1}}, ahead, 1.5);
}

TEST_CASE("a sphere beside the line is missed", "[02.3]") {
    check_miss(unit_sphere, {{1.5, 0, 5}, {0, 0, -1}}, ahead);
}

TEST_CASE("a sphere behind the ray is missed", "[02.3]") {
    check_miss(unit_sphere, {{0, 0, -5}, {0, 0, -1}}, ahead);
    check_miss(unit_sphere, {{1, 0, -5}, {0, 0, -1}}, ahead);
}

TEST_CASE("a ray that leaves the surface does not hit where it starts", "[02.3]") {
    check_miss(unit_sphere, {{0, 0, 1}, {0, 0, 1}}, ahead);
    check_hit(unit_sphere, {{0, 0, 1}, {0, 0, -1}}, ahead, 2);
}

TEST_CASE("the range decides: its start is excluded and its end included", "[02.3]") {
    const Ray ray{{0, 0, 5}, {0, 0, -1}};
    const auto [count, t0, t1] = intersections(unit_sphere, ray);  // 4 and 6, but for rounding
    check_hit(unit_sphere, ray, {0, t0}, 4);
    check_miss(unit_sphere, ray, {0, std::nextafter(t0, 0.0)});
    check_hit(unit_sphere, ray, {t0, infinity}, 6);
    check_hit(unit_sphere, ray, {t0, t1}, 6);
    check_miss(unit_sphere, ray, {t0, std::nextafter(t1, 0.0)});
    check_miss(unit_sphere, ray, {t1, infinity});
    check_hit(unit_sphere, {{0, 0, -5}, {0, 0, -1}}, {-5, 0}, -4);
}

TEST_CASE("the hit is the first root in the range", "[02.3]") {
    Random random(2301);
    int hits = 0, misses = 0;
    for (int i = 0; i < cases(20000); ++i) {
        const Case c = aimed(random, random.uniform(0, 1.2), 3);
        const Real a = random.uniform(-4, 4), b = random.uniform(-4, 4);
        const Interval range{std::min(a, b), std::max(a, b)};
        const Roots roots = intersections(c.sphere, c.ray);
        const std::optional<Hit> hit = intersect(c.sphere, c.ray, range);
        INFO(describe(c) << "\nrange " << range << ", " << roots);
        const bool first = roots.count > 0 && contains(range, roots.t0);
        const bool second = roots.count > 0 && contains(range, roots.t1);
        std::optional<Hit> expected;
        if (first || second) expected = Hit{.t = first ? roots.t0 : roots.t1};
        CHECK(test::same_hit(hit, expected));
        ++(hit ? hits : misses);
    }
    CHECK(hits > 0);
    CHECK(misses > 0);
}
