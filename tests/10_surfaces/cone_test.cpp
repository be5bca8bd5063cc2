// Steps 10.4 to 10.6: cones and cylinders.
#include "chapters/10_surfaces/cone.hpp"

#include "chapters/06_shadows/shadow.hpp"
#include "tests/10_surfaces/check_span.hpp"

#include <algorithm>
#include <cmath>

using namespace rt;
using test::ahead;
using test::cases;
using test::describe;
using test::Random;

namespace {

/// A cylinder of radius 1 that stands on the origin, 2 high.
const Cone can{{0, 0, 0}, 1, {0, 2, 0}, 1};
/// A cone of the same foot and height, with its apex at (0, 2, 0).
const Cone hat{{0, 0, 0}, 1, {0, 2, 0}, 0};
/// The same without its upper half.
const Cone stump{{0, 0, 0}, 1, {0, 1, 0}, 0.5};

/// How far t may be from where the ray crosses a face of the cone, by the contract of `inside`: how far the
/// face is moved along its normal, seen along the ray, and 8u|t|.
Real allowed(const Cone& cone, const Ray& ray, Real t, std::uint32_t face) {
    const Vec3 axis = cone.b - cone.a, f = ray.origin - cone.a, p = f + t * ray.direction;
    const Real height = length(axis), lean = (cone.radius_b - cone.radius_a) / height;
    const Real eta = gamma(8) * length(f) + gamma(40) * (height + std::max(cone.radius_a, cone.radius_b));
    Vec3 normal = axis / height;
    Real moved = eta;
    if (face == 0) {
        const Vec3 out = p - dot(p, normal) * normal;
        // η along the axis, and η(1 + |lean|) across it.
        moved = eta * (1 + 2 * std::abs(lean)) / std::hypot(1, lean);
        normal = ((out == Vec3(0) ? out : normalize(out)) - lean * normal) / std::hypot(1, lean);
    }
    return moved / std::abs(dot(normal, ray.direction)) + gamma(8) * std::abs(t);
}

/// Checks the line within `bound` in each number.
void check_line(const ConeLine& actual, const ConeLine& expected, Real bound) {
    INFO("expected " << expected << "\nactual   " << actual);
    CHECK(test::near(actual.from, expected.from, bound));
    CHECK(test::near(actual.e, expected.e, bound));
    CHECK(test::near(actual.m, expected.m, bound));
    CHECK(test::near(actual.along, expected.along, bound));
    CHECK(test::near(actual.along_step, expected.along_step, bound));
    CHECK(test::near(actual.alpha, expected.alpha, bound));
    CHECK(test::near(actual.beta, expected.beta, bound));
    CHECK(test::near(actual.a, expected.a, bound));
}

void check_roots(ConeLine line, std::initializer_list<Real> expected) {
    line.a = (length(line.m) - line.beta) * (length(line.m) + line.beta);
    const Roots roots{side_roots(line)};
    INFO(line << "\nactual: " << roots);
    std::string list;
    for (const Real t : expected) list += " " + test::show(t);
    INFO("expected:" << (list.empty() ? " no roots" : list));
    REQUIRE(roots.count == static_cast<int>(expected.size()));
    if (expected.size() == 0) return;
    CHECK(test::near(roots.t0, *expected.begin(), gamma(16) * 10));
    CHECK(test::near(roots.t1, *(expected.end() - 1), gamma(16) * 10));
}

void check_inside(const Cone& cone, const Ray& ray, const Span& expected) {
    INFO(describe(cone, ray));
    test::check_span(inside(cone, ray), expected, allowed(cone, ray, expected.enter, expected.enter_face),
                     allowed(cone, ray, expected.leave, expected.leave_face));
}

void check_outside(const Cone& cone, const Ray& ray) {
    INFO(describe(cone, ray));
    test::check_no_span(inside(cone, ray));
}

void check_hit(const OpenCone& open, const Ray& ray, Interval range, Real t) {
    const std::optional<Hit> hit = intersect(open, ray, range);
    INFO(describe(open, ray) << "\nrange " << range << "; expected t = " << t << ", actual " << hit);
    REQUIRE(hit.has_value());
    CHECK(test::near(hit->t, t, allowed(open.cone, ray, t, 0)));
}

void check_miss(const OpenCone& open, const Ray& ray, Interval range) {
    const std::optional<Hit> hit = intersect(open, ray, range);
    INFO(describe(open, ray) << "\nrange " << range << "; expected no hit, actual " << hit);
    CHECK_FALSE(hit.has_value());
}

void check_normal(const Cone& cone, const Vec3& radial, const Vec3& expected) {
    const Vec3 actual = side_normal(cone, radial);
    INFO(cone << ", from the axis along " << radial << "; expected " << expected << ", actual " << actual);
    CHECK(test::near(actual, expected, gamma(12)));
}

/// A cone of any place, size and slenderness, a cylinder now and then, and a ray at some point near it.
struct Case {
    Cone cone;
    Ray ray;
};
Case some_case(Random& random) {
    const Real size = random.magnitude(-3, 3);
    const Vec3 a = size * random.magnitude(-2, 2) * random.direction();
    const Vec3 u = size * random.direction();
    Real r = size * random.magnitude(-2, 1),
         other = random.index(4) == 0 ? 0 : size * random.magnitude(-2, 1);
    if (random.index(3) == 0) other = r;
    if (random.index(2) == 0) std::swap(r, other);
    const Vec3 target = a + random.uniform(-0.2, 1.2) * u +
                        1.2 * std::max(r, other) * random.uniform(0, 1) * random.perpendicular_to(u);
    const Vec3 eye = target + size * random.magnitude(-1, 2) * random.direction();
    return {{a, r, a + u, other}, {eye, random.magnitude(-2, 2) * (target - eye)}};
}

}  // namespace

// ------------------------------------------------------------------------------- 10.4 the line and the side

TEST_CASE("the worked example: a line as the cone sees it", "[10.4]") {
    INFO("u = (0, 2, 0); nearest to the apex is (0, 1, 0), at t = 3");
    check_line(cone_line(hat, {{3, 1, 0}, {-1, 0, 0}}),
               {.e = {0, 0, 0}, .m = {0, 0, -2}, .alpha = 1, .a = 4, .along = 0.5, .from = 3}, gamma(64));
}

TEST_CASE("a line that climbs changes its place along the axis, and the radius there", "[10.4]") {
    INFO("u = (0, 2, 0); nearest to the apex is (0.5, 2, 0), at t = 3");
    check_line(cone_line(hat, {{0.5, -1, 0}, {0, 1, 0}}),
               {.e = {0, 0, 1}, .alpha = 0, .beta = -1, .a = -1, .along = 1, .along_step = 0.5, .from = 3},
               gamma(64));
}

TEST_CASE("the cone may stand anywhere, and the direction have any length", "[10.4]") {
    const Vec3 place(10, 20, 30);
    const Cone cone{place, 3, place + Vec3(4, 0, 0), 5};
    INFO("u = (4, 0, 0); nearest to a, the narrower end, is a + (3, 3, 0)");
    ConeLine expected{.e = {0, 0, -12},
                      .m = {0, 0, 4},
                      .alpha = 4 * 4.5,
                      .beta = 4 * 0.5,
                      .a = 12,
                      .along = 0.75,
                      .along_step = 0.25,
                      .from = 2};
    check_line(cone_line(cone, {place + Vec3(1, 5, 0), {1, -1, 0}}), expected, gamma(256));
    // τ is in units of the direction: half as many of them.
    expected.m *= 2.0, expected.beta *= 2, expected.a *= 4, expected.along_step *= 2, expected.from /= 2;
    check_line(cone_line(cone, {place + Vec3(1, 5, 0), {2, -2, 0}}), expected, gamma(256));
}

TEST_CASE("a line across a cylinder meets its side twice", "[10.4]") {
    check_roots({.e = {0, 0, 6}, .m = {0, 0, -2}, .alpha = 1}, {2.5, 3.5});
    // 3 from the axis, of a cylinder with the radius 5.
    check_roots({.e = {3, 0, -10}, .m = {0, 0, 1}, .alpha = 5}, {6, 14});
}

TEST_CASE("a line that touches a cylinder meets it once, one that passes it not at all", "[10.4]") {
    check_roots({.e = {1, 0, 0}, .m = {0, 0, 1}, .alpha = 1}, {0});
    check_roots({.e = {1.125, 0, 0}, .m = {0, 0, 1}, .alpha = 1}, {});
}

TEST_CASE("a line along the axis of a cylinder meets its side nowhere", "[10.4]") {
    check_roots({.e = {2, 0, 0}, .m = {0, 0, 0}, .alpha = 1}, {});
    check_roots({.e = {0.5, 0, 0}, .m = {0, 0, 0}, .alpha = 1}, {});
}

TEST_CASE("a line along the axis of a cone meets it and its mirror image", "[10.4]") {
    // |1| = |3 - t|
    check_roots({.e = {0, 0, 1}, .m = {0, 0, 0}, .alpha = 3, .beta = -1}, {2, 4});
}

TEST_CASE("a line parallel to the side of a cone meets it once", "[10.4]") {
    // |1 + t| = |2 - t|
    check_roots({.e = {0, 0, 1}, .m = {0, 0, 1}, .alpha = 2, .beta = -1}, {0.5});
}

TEST_CASE("a line through the apex meets the cone there", "[10.4]") {
    // |(1 - t, 0)| = |2 - 2t|, and |(0, 2 - 2t)| = |1 - t|
    check_roots({.e = {1, 0, 0}, .m = {-1, 0, 0}, .alpha = 2, .beta = -2}, {1});
    check_roots({.e = {0, 0, 2}, .m = {0, 0, -2}, .alpha = 1, .beta = -1}, {1});
}

TEST_CASE("a far cylinder is not flattened: radius 1 at distance 10^8", "[10.4]") {
    // The line passes the axis at 0.6, so half the chord is 0.8.
    const Real far = 1e8, ulp = far * 2 * unit_roundoff;
    const Cone pole{{0.6, -1, -far}, 1, {0.6, 1, -far}, 1};
    const Ray ray{{0, 0, 0}, {0, 0, -1}};
    const ConeLine line = cone_line(pole, ray);
    const Roots roots{side_roots(line)};
    INFO(describe(pole, ray) << "\n" << line << "; " << roots);
    REQUIRE(roots.count == 2);
    // η is 4 ulps, which are 5 along the line; and t may be wrong by 4.
    CHECK(test::near(line.from + roots.t0, far - 0.8, 9.5 * ulp));
    CHECK(test::near(line.from + roots.t1, far + 0.8, 9.5 * ulp));
    const Cone beside{{1.001, -1, -far}, 1, {1.001, 1, -far}, 1};
    const Roots none = side_roots(cone_line(beside, ray));
    INFO("a line that passes the axis at 1.001 radii: " << none);
    CHECK(none.count == 0);
}

TEST_CASE("a far cone is as exact as a near one: tau is counted from near the cone", "[10.4]") {
    // Across a cone of 45 degrees at the height where its radius is 1, again with half a chord of 0.8.
    const Real far = 1e8, ulp = far * 2 * unit_roundoff;
    const Cone cone{{0.6, -2, -far}, 3, {0.6, 1, -far}, 0};
    const ConeLine line = cone_line(cone, {{0, 0, 0}, {0, 0, -1}});
    const Roots roots{side_roots(line)};
    INFO(cone << "\n" << line << "; " << roots);
    REQUIRE(roots.count == 2);
    CHECK(test::near(line.from + roots.t0, far - 0.8, 16 * ulp));
    CHECK(test::near(line.from + roots.t1, far + 0.8, 16 * ulp));
    INFO("the chord, which is as exact as near the eye");
    CHECK(test::near(roots.t1 - roots.t0, 1.6, gamma(16) * 2));
}

TEST_CASE("a long rod is not flattened: radius 1, length 10^8, met near its far end", "[10.4]") {
    // The line passes the axis at 0.6, and sinks by 1 where it goes on by 1.
    const Real far = 1e8;
    const Cone rod{{0, 0, 0}, 1, {0, far, 0}, 1};
    const ConeLine line = cone_line(rod, {{-10, far + 5, 0.6}, {1, -1, 0}});
    const Roots roots{side_roots(line)};
    INFO(rod << "\n" << line << "; " << roots);
    REQUIRE(roots.count == 2);
    // η is 48u of the length, which are 60 along the line.
    CHECK(test::near(line.from + roots.t0, 9.2, gamma(61) * far));
    CHECK(test::near(line.from + roots.t1, 10.8, gamma(61) * far));
}

// -------------------------------------------------------------------------------------- 10.5 the solid

TEST_CASE("a ray across a cylinder enters and leaves by its side", "[10.5]") {
    check_inside(can, {{5, 1, 0}, {-1, 0, 0}}, {4, 6, 0, 0});
    check_inside(can, {{5, 1, 0}, {-2, 0, 0}}, {2, 3, 0, 0});
}

TEST_CASE("a ray along the axis enters by one cap and leaves by the other", "[10.5]") {
    check_inside(can, {{0.5, 5, 0}, {0, -1, 0}}, {3, 5, 2, 1});
    check_inside(can, {{0.5, -5, 0.25}, {0, 1, 0}}, {5, 7, 1, 2});
    check_outside(can, {{1.5, 5, 0}, {0, -1, 0}});
}

TEST_CASE("a ray that goes in by the cap and out by the side", "[10.5]") {
    check_inside(can, {{-0.5, 3, 0}, {1, -1, 0}}, {1, 1.5, 2, 0});
    check_inside(can, {{2.5, 2, 0}, {-1, -1, 0}}, {1.5, 2, 0, 1});
}

TEST_CASE("a ray beside a cylinder's end misses", "[10.5]") {
    check_outside(can, {{5, 2.5, 0}, {-1, 0, 0}});
    check_outside(can, {{5, -0.5, 0}, {-1, 0, 0}});
    check_outside(can, {{-3, 3, 0}, {1, -0.1875, 0}});
    check_outside(can, {{5, 1, 1.125}, {-1, 0, 0}});
}

TEST_CASE("a ray across a cone", "[10.5]") {
    check_inside(hat, {{3, 1, 0}, {-1, 0, 0}}, {2.5, 3.5, 0, 0});
    check_inside(stump, {{3, 0.5, 0}, {-1, 0, 0}}, {2.25, 3.75, 0, 0});
}

TEST_CASE("the mirror image of a cone beyond its apex is not there", "[10.5]") {
    check_outside(hat, {{3, 3, 0}, {-1, 0, 0}});
    check_outside(stump, {{3, 3, 0}, {-1, 0, 0}});
    check_outside(stump, {{3, 1.25, 0}, {-1, 0, 0}});
}

TEST_CASE("a ray along the axis of a cone goes in by the side and out by the foot", "[10.5]") {
    check_inside(hat, {{0.5, 5, 0}, {0, -1, 0}}, {4, 5, 0, 1});
    check_inside(hat, {{0.5, -5, 0}, {0, 1, 0}}, {5, 6, 1, 0});
    check_outside(hat, {{1.5, 5, 0}, {0, -1, 0}});
}

TEST_CASE("a ray along the axis of a cone meets it at its apex, by the side or by a cap of radius 0",
          "[10.5]") {
    const std::optional<Span> span = inside(hat, {{0, 5, 0}, {0, -1, 0}});
    INFO("expected from 3 (face 0 or 2) to 5 (face 1), actual " << span);
    REQUIRE(span.has_value());
    CHECK(test::near(span->enter, 3, allowed(hat, {{0, 5, 0}, {0, -1, 0}}, 3, 0)));
    CHECK((span->enter_face == 0 || span->enter_face == 2));
    CHECK(span->leave_face == 1);
}

TEST_CASE("a steep ray that goes in by the foot of a cone", "[10.5]") {
    check_inside(hat, {{0.25, -1, 0}, {0, 2, 0}}, {0.5, 1.25, 1, 0});
    check_inside(stump, {{0.25, -1, 0}, {0, 1, 0}}, {1, 2, 1, 2});
}

TEST_CASE("a cone that widens from its apex is the same cone", "[10.5]") {
    const Cone turned{hat.b, 0, hat.a, 1};
    check_inside(turned, {{3, 1, 0}, {-1, 0, 0}}, {2.5, 3.5, 0, 0});
    check_inside(turned, {{0.5, 5, 0}, {0, -1, 0}}, {4, 5, 0, 2});
    check_outside(turned, {{3, 3, 0}, {-1, 0, 0}});
}

TEST_CASE("a steep ray goes into a cone by its apex, wherever the cone stands", "[10.5]") {
    Random random(10503);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 apex = 10.0 * random.in_cube(), u = random.direction();
        const Cone cone{apex - 2.0 * u, 2, apex, 0};
        const Vec3 d = normalize(-u + 0.3 * random.perpendicular_to(u));
        const Ray ray{apex - 3.0 * d, d};
        const std::optional<Span> span = inside(cone, ray);
        INFO(describe(cone, ray) << "\nthrough the apex, at t = 3, and 2 / cos further; actual " << span);
        REQUIRE(span.has_value());
        CHECK(test::near(span->enter, 3, gamma(64) * 20));
        CHECK(test::near(span->leave, 3 - 2 / dot(u, d), gamma(64) * 20));
    }
}

TEST_CASE("a ray parallel to the side of a cone is inside from the foot to the side", "[10.5]") {
    // The side runs from (1, 0) to (0, 2); the ray is half a unit to its left, and meets the other side.
    check_inside(hat, {{1, -1, 0}, {-0.5, 1, 0}}, {1, 2.5, 1, 0});
    check_outside(hat, {{2, -1, 0}, {-0.5, 1, 0}});
}

TEST_CASE("inside is where points of the ray are no farther from the axis than the radius", "[10.5]") {
    Random random(10501);
    int inner = 0, outer = 0;
    for (int i = 0; i < cases(20000); ++i) {
        const auto [cone, ray] = some_case(random);
        const std::optional<Span> span = inside(cone, ray);
        const Vec3 u = cone.b - cone.a;
        const Real reach = length(u) + std::max(cone.radius_a, cone.radius_b);
        for (int k = 0; k < 4; ++k) {
            const Real t = random.uniform(0, 2);
            const Vec3 p = (ray.origin - cone.a) + t * ray.direction;
            const Real s = dot(p, u) / dot(u, u);
            const Real radius = cone.radius_a + s * (cone.radius_b - cone.radius_a);
            // How far inside the point is, at least or at most: of the side and of both ends.
            const Real depth = std::min({radius - length(p - s * u), s * length(u), (1 - s) * length(u)});
            const Real widened = 1 + std::abs(cone.radius_b - cone.radius_a) / length(u);
            const Real slack = gamma(64) * widened *
                               (reach + length(cone.a) + length(ray.origin) + t * length(ray.direction));
            if (std::abs(depth) < slack) continue;
            ++(depth > 0 ? inner : outer);
            INFO(describe(cone, ray) << "\n"
                                     << span << "\nthe point at t = " << t << " is " << depth << " inside");
            CHECK((span && span->enter <= t && t <= span->leave) == (depth > 0));
        }
    }
    CHECK(inner > cases(20000) / 8);
    CHECK(outer > cases(20000) / 8);
}

TEST_CASE("a ray that touches a cylinder is inside of it there, if anywhere", "[10.5]") {
    // Where it touches is also the point nearest to the end a; so what rounding says of the discriminant and
    // of the distance there may contradict each other. A ray that goes clearly deeper may not miss.
    Random random(10504);
    for (int i = 0; i < cases(20000); ++i) {
        const Real r = random.uniform(0.5, 2), depth = i % 2 == 0 ? 0 : 1e-12 * r;
        const Vec3 u = random.uniform(1, 3) * random.direction(), radial = random.perpendicular_to(u);
        const Cone cylinder{{0, 0, 0}, r, u, r};
        const bool at_rim = random.index(2) == 0;
        const Vec3 across = normalize(cross(u, radial));
        const Vec3 d = at_rim ? across + random.uniform(-2, 2) * u : across;
        const Vec3 touched = (at_rim ? 0 : random.uniform(0, 1)) * u + (r - depth) * radial;
        const Ray ray{touched - 5.0 * d, d};
        const std::optional<Span> span = inside(cylinder, ray);
        INFO(describe(cylinder, ray) << "\nis at most " << depth << " inside, at t = 5; actual " << span);
        if (depth > 0) REQUIRE(span.has_value());
        if (!span) continue;
        // Half a chord is as long as the root of 2r times its depth: at most 3e-6.
        CHECK(test::near(span->enter, 5, 1e-5));
        CHECK(test::near(span->leave, 5, 1e-5));
    }
}

TEST_CASE("a scene in other units gives the same picture: t of a cone does not change", "[10.5]") {
    Random random(10502);
    int hits = 0;
    for (int i = 0; i < cases(2000); ++i) {
        const auto [cone, ray] = some_case(random);
        const Real s = std::ldexp(1, static_cast<int>(random.index(81)) - 40);
        const auto one = inside(cone, ray);
        const auto scaled = inside(Cone{s * cone.a, s * cone.radius_a, s * cone.b, s * cone.radius_b},
                                   Ray{s * ray.origin, s * ray.direction});
        INFO(describe(cone, ray) << "\nunit " << s << "\n" << one << "\n" << scaled);
        REQUIRE(one.has_value() == scaled.has_value());
        if (!one) continue;
        ++hits;
        CHECK(scaled->enter == one->enter);
        CHECK(scaled->leave == one->leave);
    }
    CHECK(hits > cases(2000) / 4);
}

// ------------------------------------------------------------------------------- 10.6 the side, and normals

TEST_CASE("a tube is met from outside, and one can look through it", "[10.6]") {
    check_hit({can}, {{5, 1, 0}, {-1, 0, 0}}, ahead, 4);
    check_miss({can}, {{0.5, 5, 0}, {0, -1, 0}}, ahead);
    check_miss({hat}, {{1.5, 5, 0}, {0, -1, 0}}, ahead);
}

TEST_CASE("through the open end one sees the inside of the far wall", "[10.6]") {
    check_hit({can}, {{-0.5, 3, 0}, {1, -1, 0}}, ahead, 1.5);
    check_hit({can}, {{-2, 4, 0}, {1, -1, 0}}, ahead, 3);  // above the near wall, at t = 1
    check_hit({hat}, {{0.5, -5, 0}, {0, 1, 0}}, ahead, 6);
}

TEST_CASE("from inside a tube its wall is met", "[10.6]") {
    check_hit({can}, {{0, 1, 0}, {1, 0, 0}}, ahead, 1);
    check_miss({can}, {{0, 1, 0}, {0, 1, 0}}, ahead);
}

TEST_CASE("the ends belong to the tube, and beyond them there is nothing", "[10.6]") {
    check_hit({can}, {{5, 2, 0}, {-1, 0, 0}}, ahead, 4);
    check_hit({can}, {{5, 0, 0}, {-1, 0, 0}}, ahead, 4);
    check_miss({can}, {{5, 2.001, 0}, {-1, 0, 0}}, ahead);
    check_miss({stump}, {{3, 3, 0}, {-1, 0, 0}}, ahead);
}

TEST_CASE("the range decides which wall of the tube", "[10.6]") {
    const Ray ray{{5, 1, 0}, {-1, 0, 0}};
    check_hit({can}, ray, {4.5, infinity}, 6);
    check_miss({can}, ray, {4.5, 5.5});
    check_miss({can}, ray, {0, 3.5});
}

TEST_CASE("the normal of a cylinder leads straight away from its axis", "[10.6]") {
    check_normal(can, {1, 0, 0}, {1, 0, 0});
    check_normal(can, {0, 0, -1}, {0, 0, -1});
}

TEST_CASE("the normal of a cone leans to where it gets narrower", "[10.6]") {
    const Real root = std::sqrt(0.5);
    check_normal({{0, 0, 0}, 2, {0, 2, 0}, 0}, {1, 0, 0}, {root, root, 0});
    check_normal({{0, 0, 0}, 0, {0, 2, 0}, 2}, {1, 0, 0}, {root, -root, 0});
    check_normal({{0, 0, 0}, 4, {0, 3, 0}, 0}, {0, 0, 1}, {0, 0.8, 0.6});
}

TEST_CASE("the normal of a side is perpendicular to the line along it", "[10.6]") {
    Random random(10601);
    for (int i = 0; i < cases(5000); ++i) {
        const Cone cone = some_case(random).cone;
        const Vec3 u = cone.b - cone.a, radial = random.perpendicular_to(u);
        const Vec3 along = normalize(u + (cone.radius_b - cone.radius_a) * radial);
        const Vec3 n = side_normal(cone, radial);
        INFO(cone << ", from the axis along " << radial << "; normal " << n << ", along the side " << along);
        CHECK(test::near(length(n), 1, gamma(8)));
        // `radial` itself is perpendicular to the axis but for rounding.
        CHECK(test::near(dot(n, along), 0, gamma(32) + 2 * std::abs(dot(radial, normalize(u)))));
        CHECK(dot(n, radial) > 0);
    }
}

TEST_CASE("the surface of a solid cone: side and caps", "[10.6]") {
    const auto check = [](const Cone& cone, const Ray& ray, const Vec3& point, const Vec3& normal) {
        const std::optional<Hit> hit = intersect(cone, ray, ahead);
        INFO(describe(cone, ray) << "\n" << hit);
        REQUIRE(hit.has_value());
        const Surface surface = surface_at(cone, ray, *hit);
        INFO("expected point " << point << ", normal " << normal << "; actual " << surface);
        CHECK(test::near(surface.point, point, gamma(16) * 10));
        CHECK(test::near(surface.normal, normal, gamma(16)));
    };
    check(can, {{5, 1, 0}, {-1, 0, 0}}, {1, 1, 0}, {1, 0, 0});
    check(can, {{0.5, 5, 0}, {0, -1, 0}}, {0.5, 2, 0}, {0, 1, 0});
    check(can, {{0.5, -5, 0}, {0, 1, 0}}, {0.5, 0, 0}, {0, -1, 0});
    check(can, {{0, 1, 0}, {1, 0, 0}}, {1, 1, 0}, {1, 0, 0});
    const Vec3 slanted = normalize(Vec3(2, 1, 0));
    check(hat, {{3, 1, 0}, {-1, 0, 0}}, {0.5, 1, 0}, slanted);
}

TEST_CASE("so near to the axis that the square of the distance is 0, there is a normal", "[10.6]") {
    const Ray ray{{1e-200, 5, 0}, {0, -1, 0}};
    const Surface surface = surface_at(hat, ray, {.t = 3});
    INFO(describe(hat, ray) << "\n" << surface);
    CHECK(test::near(surface.normal, normalize(Vec3(2, 1, 0)), gamma(16)));
    CHECK(test::near(surface.point, Vec3(0, 2, 0), 1e-12));
}

TEST_CASE("who goes into a flat cone beside its rim meets the far side next, not the end", "[10.6]") {
    // Far from the origin, where points are rounded most. The way in is along the thin edge between the side
    // and the end at b.
    Random random(1066);
    for (int i = 0; i < cases(20000); ++i) {
        const Vec3 a = random.uniform(500, 2000) * random.direction(), u = 10.0 * random.direction();
        const Cone flat{a, 0, a + u, 120};
        const Vec3 across = random.perpendicular_to(u), rim = a + u + 120.0 * across;
        const Vec3 outwards = normalize(across - 12.0 / 10 * u);
        const Ray incoming{rim + 5.0 * outwards - random.magnitude(-16, -10) * across, -outwards};
        const std::optional<Hit> hit = intersect(flat, incoming, ahead);
        if (!hit || hit->element != 0) continue;
        const Vec3 inside = a + random.uniform(0.9, 0.999) * u;
        const Vec3 direction = normalize(inside - rim);
        const Vec3 start = offset_origin(surface_at(flat, incoming, *hit), direction);
        const std::optional<Hit> next = intersect(flat, {start, direction}, ahead);
        INFO(describe(flat, {start, direction}) << ", which came in by the side beside the rim at b");
        REQUIRE(next);
        CHECK(next->t > 1);
    }
}
