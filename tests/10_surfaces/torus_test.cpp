// Steps 10.9 and 10.10: the torus.
#include "chapters/10_surfaces/torus.hpp"
#include "tests/10_surfaces/check_span.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace rt;
using test::ahead;
using test::cases;
using test::describe;
using test::Random;

namespace {

/// A ring of radius 3 that lies flat, with a tube of radius 1: from 2 to 4 away from the axis.
const Torus ring{{0, 0, 0}, {0, 1, 0}, 3, 1};
/// The same with a tube of radius 2, of which the hole is narrow: its radius is 1.
const Torus fat{{0, 0, 0}, {0, 1, 0}, 3, 2};
/// The hole is one point.
const Torus closed{{0, 0, 0}, {0, 1, 0}, 2, 2};
/// The tube is wider than the ring: 8 wide, 5 high, and its dimples reach down to 4 above the centre and
/// below.
const Torus spindle{{0, 0, 0}, {0, 1, 0}, 3, 5};

/// How far t may be from where the ray crosses the surface, by the contract of `inside`: η along the normal,
/// which leads away from the ring, and 8u|t|.
Real allowed(const Torus& torus, const Ray& ray, Real t) {
    const Vec3 n = normalize(torus.axis), f = ray.origin - torus.center, p = f + t * ray.direction;
    const Vec3 across = p - dot(p, n) * n;
    const Vec3 on_ring = across == Vec3(0) ? across : torus.ring * normalize(across);
    const Real eta = gamma(8) * length(f) + gamma(40) * (torus.ring + torus.tube);
    return eta * torus.tube / std::abs(dot(p - on_ring, ray.direction)) + gamma(8) * std::abs(t);
}

void check_quartic(const Torus& torus, const TorusLine& line, Real base,
                   const std::array<Real, 5>& expected) {
    const Polynomial actual = torus_quartic(torus, line, base);
    INFO(torus << "\n"
               << line << "\nbase " << base << ": expected " << Polynomial{expected} << ", actual "
               << actual);
    for (std::size_t i = 0; i < 5; ++i) CHECK(test::near(actual.a[i], expected[i], gamma(16) * 400));
}

void check_inside(const Torus& torus, const Ray& ray, const std::vector<Vec2>& expected) {
    const TorusSpans actual = inside(torus, ray);
    std::string list;
    for (const Vec2& part : expected) list += " from " + test::show(part.x) + " to " + test::show(part.y);
    INFO(describe(torus, ray));
    INFO("expected:" << (list.empty() ? " nowhere" : list) << "; actual: " << actual);
    REQUIRE(actual.count == static_cast<int>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CHECK(test::near(actual.spans[i].enter, expected[i].x, allowed(torus, ray, expected[i].x)));
        CHECK(test::near(actual.spans[i].leave, expected[i].y, allowed(torus, ray, expected[i].y)));
    }
}

void check_hit(const Torus& torus, const Ray& ray, Interval range, Real t) {
    const std::optional<Hit> hit = intersect(torus, ray, range);
    INFO(describe(torus, ray) << "\nrange " << range << "; expected t = " << t << ", actual " << hit);
    REQUIRE(hit.has_value());
    CHECK(test::near(hit->t, t, allowed(torus, ray, t)));
}

void check_miss(const Torus& torus, const Ray& ray, Interval range) {
    const std::optional<Hit> hit = intersect(torus, ray, range);
    INFO(describe(torus, ray) << "\nrange " << range << "; expected no hit, actual " << hit);
    CHECK_FALSE(hit.has_value());
}

void check_surface(const Torus& torus, const Ray& ray, const Vec3& point, const Vec3& normal) {
    const std::optional<Hit> hit = intersect(torus, ray, ahead);
    INFO(describe(torus, ray) << "\n" << hit);
    REQUIRE(hit.has_value());
    const Surface surface = surface_at(torus, ray, *hit);
    INFO("expected point " << point << ", normal " << normal << "; actual " << surface);
    CHECK(test::near(surface.point, point, gamma(64) * 10));
    CHECK(test::near(surface.normal, normal, gamma(64) * 10));
}

/// How far a point is from the ring.
Real from_ring(const Torus& torus, const Vec3& p) {
    const Vec3 n = normalize(torus.axis), f = p - torus.center;
    return std::hypot(length(cross(f, n)) - torus.ring, dot(f, n));
}

/// A torus of any place, size and kind, and a ray at some point near it.
struct Case {
    Torus torus;
    Ray ray;
};
Case some_case(Random& random) {
    const Real size = random.magnitude(-3, 3);
    const Torus torus{size * random.magnitude(-1, 1) * random.direction(),
                      random.magnitude(-2, 2) * random.direction(), size, size * random.magnitude(-1.5, 0.5)};
    const Vec3 target = torus.center + (torus.ring + torus.tube) * random.in_cube();
    const Vec3 eye = target + size * random.magnitude(-1, 1.5) * random.direction();
    return {torus, {eye, random.magnitude(-2, 2) * (target - eye)}};
}

}  // namespace

// ---------------------------------------------------------------------------------------- the quartic

TEST_CASE("the worked example: the quartic of a line across the ring", "[10.9]") {
    // Q = s^2 - 10, P = 36: (s^2 - 16)(s^2 - 4).
    check_quartic(ring, {.q = {0, 0, 0}, .e = {1, 0, 0}, .n = {0, 1, 0}}, 0, {64, 0, -20, 0, 1});
    // At the height 0.6, half of the tube is 0.8 wide: from 2.2 to 3.8.
    check_quartic(ring, {.q = {0, 0.6, 0}, .e = {1, 0, 0}, .n = {0, 1, 0}}, 0,
                  {2.2 * 2.2 * 3.8 * 3.8, 0, -2.2 * 2.2 - 3.8 * 3.8, 0, 1});
}

TEST_CASE("the same quartic from another base", "[10.9]") {
    // (s + 6)(s + 4)(s - 2)s
    check_quartic(ring, {.q = {0, 0, 0}, .e = {1, 0, 0}, .n = {0, 1, 0}}, 2, {0, -48, 4, 8, 1});
    check_quartic(ring, {.q = {0, 0, 0}, .e = {1, 0, 0}, .n = {0, 1, 0}}, -2, {0, 48, 4, -8, 1});
    check_quartic(fat, {.q = {0, 0, 0}, .e = {0, 0, 1}, .n = {0, 1, 0}}, 1, {0, -48, -20, 4, 1});
}

TEST_CASE("the quartic of a torus with a narrow hole, and of a spindle", "[10.9]") {
    // (s^2 - 25)(s^2 - 1), and (s^2 - 64)(s^2 - 4), of which 2 is on the lemon.
    check_quartic(fat, {.q = {0, 0, 0}, .e = {1, 0, 0}, .n = {0, 1, 0}}, 0, {25, 0, -26, 0, 1});
    check_quartic(spindle, {.q = {0, 0, 0}, .e = {1, 0, 0}, .n = {0, 1, 0}}, 0, {256, 0, -68, 0, 1});
}

TEST_CASE("the quartic of a line along the axis, or parallel to it", "[10.9]") {
    // On the axis of the ring it is (s^2 + 8)^2; down through the tube, 3 from the axis, (s^2 - 1)(s^2 + 35).
    check_quartic(ring, {.q = {0, 0, 0}, .e = {0, 1, 0}, .n = {0, 1, 0}}, 0, {64, 0, 16, 0, 1});
    check_quartic(ring, {.q = {3, 0, 0}, .e = {0, 1, 0}, .n = {0, 1, 0}}, 0, {-35, 0, 34, 0, 1});
    // On the axis of the fat one (s^2 + 5)^2.
    check_quartic(fat, {.q = {0, 0, 0}, .e = {0, 1, 0}, .n = {0, 1, 0}}, 0, {25, 0, 10, 0, 1});
}

TEST_CASE("the quartic of a line that is askew", "[10.9]") {
    // n = (0, 1, 0), q = (1, 0, 0), e = (0, 0.6, 0.8): z = 0.6s, x.x = 1 + s^2, and the distance from the
    // axis squared is 1 + 0.64s^2.
    const TorusLine line{.q = {1, 0, 0}, .e = {0, 0.6, 0.8}, .n = {0, 1, 0}};
    check_quartic(ring, line, 0, {81 - 36, 0, -18 + 36 * 0.36, 0, 1});
    check_quartic(fat, line, 0, {36 - 36, 0, 12 - 36 * 0.64, 0, 1});
    // From s = 1 on.
    check_quartic(ring, line, 1, {64 - 36 * 0.64, -32 + 36 * 0.72, 4 - 16 + 36 * 0.36, 4, 1});
}

TEST_CASE("the quartic of a thin ring keeps its digits", "[10.9]") {
    // Where the line meets the ring itself, Q is -r^2 and P is 4r^2; the ring's radius is a million times r.
    const Torus thin{{0, 0, 0}, {0, 1, 0}, 1, 1e-6};
    const Polynomial quartic = torus_quartic(thin, {.q = {0, 0, 0}, .e = {1, 0, 0}, .n = {0, 1, 0}}, 1);
    INFO(thin << ", a line along x through the centre, base 1: " << quartic);
    INFO("expected at the base r^4 - 4r^2 = -3.999999999999e-12, actual " << test::show(quartic.a[0]));
    CHECK(test::near(quartic.a[0], -3.999999999999e-12, 1e-20));
}

TEST_CASE("the quartic beside the axis keeps its digits where the hole is one point", "[10.9]") {
    // A millionth from the axis x.x is 1e-12, and the quartic is that squared, less 16 times it.
    const Polynomial quartic = torus_quartic(closed, {.q = {1e-6, 0, 0}, .e = {0, 1, 0}, .n = {0, 1, 0}}, 0);
    INFO(closed << ", a line along y, 1e-6 from the axis, base 0: " << quartic);
    INFO("expected at the base -1.5999999999999e-11, actual " << test::show(quartic.a[0]));
    CHECK(test::near(quartic.a[0], -1.5999999999999e-11, 1e-20));
}

// ------------------------------------------------------------------------------------- what is inside

TEST_CASE("a line across the ring is inside twice", "[10.10]") {
    check_inside(ring, {{10, 0, 0}, {-1, 0, 0}}, {{6, 8}, {12, 14}});
    check_inside(ring, {{10, 0, 0}, {-2, 0, 0}}, {{3, 4}, {6, 7}});
    check_inside(ring, {{10, 0.6, 0}, {-1, 0, 0}}, {{6.2, 7.8}, {12.2, 13.8}});
    check_inside(fat, {{10, 0, 0}, {-1, 0, 0}}, {{5, 9}, {11, 15}});
}

TEST_CASE("a line down through the tube is inside once", "[10.10]") {
    check_inside(ring, {{3, 10, 0}, {0, -1, 0}}, {{9, 11}});
    check_inside(ring, {{0, 10, 3.6}, {0, -1, 0}}, {{9.2, 10.8}});
    check_inside(fat, {{0, 10, 3}, {0, -1, 0}}, {{8, 12}});
}

TEST_CASE("a line beside the hole is inside once, and long", "[10.10]") {
    // 3 from the axis, it is inside as long as it is no farther than 4.
    check_inside(ring, {{10, 0, 3}, {-1, 0, 0}}, {{10 - std::sqrt(7.0), 10 + std::sqrt(7.0)}});
}

TEST_CASE("lines through the hole, above it and beside the torus are nowhere inside", "[10.10]") {
    check_inside(ring, {{0, 10, 0}, {0, -1, 0}}, {});
    check_inside(ring, {{1.5, 10, 0}, {0, -1, 0}}, {});
    check_inside(ring, {{10, 1.5, 0}, {-1, 0, 0}}, {});
    check_inside(ring, {{10, 0, 4.5}, {-1, 0, 0}}, {});
    check_inside(ring, {{1, 3, 0}, {-0.25, -1, 0}}, {});
}

TEST_CASE("a line that begins inside is inside also behind its beginning", "[10.10]") {
    check_inside(ring, {{3, 0, 0}, {1, 0, 0}}, {{-7, -5}, {-1, 1}});
}

TEST_CASE("the torus may stand anywhere, and its axis have any length", "[10.10]") {
    const Vec3 place(10, 20, 30);
    const Torus moved{place, {0, 0, -5}, 3, 1};
    check_inside(moved, {place + Vec3(10, 0, 0), {-1, 0, 0}}, {{6, 8}, {12, 14}});
    check_inside(moved, {place + Vec3(0, 3, 10), {0, 0, -1}}, {{9, 11}});
    check_inside(moved, {place + Vec3(0, 10, 0.6), {0, -1, 0}}, {{6.2, 7.8}, {12.2, 13.8}});
}

TEST_CASE("where the hole is one point, a line across is inside to either side of it", "[10.10]") {
    const Ray ray{{10, 0, 0}, {-1, 0, 0}};
    const TorusSpans spans = inside(closed, ray);
    INFO(describe(closed, ray) << "\nexpected from 6 to 14, perhaps but for the centre at 10; actual: "
                               << spans);
    REQUIRE(spans.count > 0);
    const std::size_t last = static_cast<std::size_t>(spans.count) - 1;
    CHECK(test::near(spans.spans[0].enter, 6, allowed(closed, ray, 6)));
    CHECK(test::near(spans.spans[last].leave, 14, allowed(closed, ray, 14)));
    if (spans.count == 2) {
        // A surface that is moved by η = 8u·10 + 40u·4 has a hole as wide as that; and t may be wrong by
        // 8u·10.
        CHECK(test::near(spans.spans[0].leave, 10, gamma(320)));
        CHECK(test::near(spans.spans[1].enter, 10, gamma(320)));
    }
}

TEST_CASE("beside the axis of a torus whose hole is one point", "[10.10]") {
    // A distance x from the axis, it is inside where y^2 <= 4x - x^2.
    check_inside(closed, {{0.5, 10, 0}, {0, -1, 0}}, {{10 - std::sqrt(1.75), 10 + std::sqrt(1.75)}});
    const Real x = 0x1p-40, half = std::sqrt(4 * x - x * x);
    check_inside(closed, {{x, 0, 0}, {0, -1, 0}}, {{-half, half}});
}

TEST_CASE("a spindle has no hole, and the lemon inside is no surface", "[10.10]") {
    check_inside(spindle, {{10, 0, 0}, {-1, 0, 0}}, {{2, 18}});
    check_inside(spindle, {{0, 10, 0}, {0, -1, 0}}, {{6, 14}});
    check_inside(spindle, {{1, 0, 0}, {0, 1, 0}}, {{-std::sqrt(21.0), std::sqrt(21.0)}});
    check_inside(spindle, {{10, 3, 0}, {-1, 0, 0}}, {{3, 17}});
}

TEST_CASE("a line across the dimple of a spindle is inside twice", "[10.10]") {
    // At the height 4.8 the tube is 2.8 wide: from 1.6 to 4.4.
    check_inside(spindle, {{10, 4.8, 0}, {-1, 0, 0}}, {{5.6, 8.4}, {11.6, 14.4}});
}

TEST_CASE("a far torus is as exact as a near one", "[10.10]") {
    const Real far = 1e8;
    const Torus away{{0, -0.6, -far}, {0, 1, 0}, 3, 1};
    check_inside(away, {{0, 0, 0}, {0, 0, -1}}, {{far - 3.8, far - 2.2}, {far + 2.2, far + 3.8}});
    check_inside({{0, -1.001, -far}, {0, 1, 0}, 3, 1}, {{0, 0, 0}, {0, 0, -1}}, {});
}

TEST_CASE("a thin ring is as round as a thick one: radius 1, tube 2^-20", "[10.10]") {
    const Real r = 0x1p-20;
    const Torus thin{{0, 0, 0}, {0, 1, 0}, 1, r};
    check_inside(thin, {{2, 0.6 * r, 0}, {-1, 0, 0}},
                 {{1 - 0.8 * r, 1 + 0.8 * r}, {3 - 0.8 * r, 3 + 0.8 * r}});
    check_inside(thin, {{1 + 0.6 * r, 1, 0}, {0, -1, 0}}, {{1 - 0.8 * r, 1 + 0.8 * r}});
    check_inside(thin, {{2, 1.001 * r, 0}, {-1, 0, 0}}, {});
}

TEST_CASE("inside is where points of the ray are no farther from the ring than the tube's radius",
          "[10.10]") {
    Random random(10801);
    int inner = 0, outer = 0;
    for (int i = 0; i < cases(20000); ++i) {
        const auto [torus, ray] = some_case(random);
        const TorusSpans spans = inside(torus, ray);
        for (int k = 0; k < 4; ++k) {
            const Real t = random.uniform(0, 2);
            const Real distance = from_ring(torus, point_at(ray, t));
            if (std::abs(distance - torus.tube) < 1e-9 * (torus.ring + torus.tube)) continue;
            const bool is_inside = distance < torus.tube;
            bool said = false;
            for (std::size_t s = 0; s < static_cast<std::size_t>(spans.count); ++s)
                said |= spans.spans[s].enter <= t && t <= spans.spans[s].leave;
            INFO(describe(torus, ray)
                 << "\n"
                 << spans << "\nthe point at t = " << t << " is " << distance << " from the ring");
            REQUIRE(said == is_inside);
            ++(is_inside ? inner : outer);
        }
    }
    CHECK(inner > cases(20000) / 8);
    CHECK(outer > cases(20000) / 8);
}

// ------------------------------------------------------------------------------- hits, surface, bounds

TEST_CASE("the nearest hit is the first crossing in the range", "[10.10]") {
    const Ray across{{10, 0, 0}, {-1, 0, 0}};
    check_hit(ring, across, ahead, 6);
    check_hit(ring, across, {7, infinity}, 8);
    check_hit(ring, across, {9, infinity}, 12);
    check_hit(ring, across, {13, infinity}, 14);
    check_hit(ring, {{0, 0, 0}, {1, 0, 0}}, ahead, 2);
    check_hit(spindle, {{0, 0, 0}, {1, 0, 0}}, ahead, 8);
    check_miss(ring, across, {14.5, infinity});
    check_miss(ring, across, {0, 5.5});
    check_miss(ring, {{10, 0, 0}, {1, 0, 0}}, ahead);
}

TEST_CASE("the surface of a torus: at the equators, on top, and in between", "[10.10]") {
    check_surface(ring, {{10, 0, 0}, {-1, 0, 0}}, {4, 0, 0}, {1, 0, 0});
    check_surface(ring, {{0, 0, 0}, {1, 0, 0}}, {2, 0, 0}, {-1, 0, 0});
    check_surface(ring, {{0, 10, 3}, {0, -1, 0}}, {0, 1, 3}, {0, 1, 0});
    check_surface(ring, {{10, 0.6, 0}, {-1, 0, 0}}, {3.8, 0.6, 0}, {0.8, 0.6, 0});
    check_surface(spindle, {{10, 4.8, 0}, {-1, 0, 0}}, {4.4, 4.8, 0}, {0.28, 0.96, 0});
}

TEST_CASE("so near to the axis that the square of the distance is 0, a torus has a normal", "[10.10]") {
    const Ray ray{{1e-200, 10, 0}, {0, -1, 0}};
    const Surface surface = surface_at(spindle, ray, {.t = 6});
    INFO(describe(spindle, ray) << "\n" << surface);
    CHECK(test::near(surface.normal, Vec3(-0.6, 0.8, 0), 1e-12));
    CHECK(test::near(surface.point, Vec3(0, 4, 0), 1e-12));
}

TEST_CASE("the box around a torus touches it on all sides", "[10.10]") {
    const Bounds flat = bounds_of(ring);
    INFO(flat);
    CHECK(test::near(flat.low, {-4, -1, -4}, gamma(8) * 4));
    CHECK(test::near(flat.high, {4, 1, 4}, gamma(8) * 4));
    const Bounds askew = bounds_of(Torus{{1, 2, 3}, {0, 3, 4}, 5, 2});
    INFO("axis (0, 3, 4), ring 5, tube 2, around (1, 2, 3): " << askew);
    CHECK(test::near(askew.low, {-6, -4, -2}, gamma(8) * 8));
    CHECK(test::near(askew.high, {8, 8, 8}, gamma(8) * 8));
}
