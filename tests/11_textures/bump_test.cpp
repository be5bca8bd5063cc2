// Step 11.11: normals of bumps.
#include "chapters/11_textures/bump.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>

using namespace rt;
using test::cases;
using test::Random;

namespace {

const Vec3 up(0, 0, 1);

void check_bumped(const Vec3& normal, const Vec3& gradient, const Vec3& expected) {
    INFO("normal " << normal << " where the height has the gradient " << gradient);
    CHECK(test::near(bumped(normal, gradient), expected, 16 * unit_roundoff * (1 + length(gradient))));
}

struct Tangents {
    Vec3 du, dv;
    Real dh_du, dh_dv;
};

/// Of a height with this gradient.
Tangents tangents(const Vec3& du, const Vec3& dv, const Vec3& gradient) {
    return {du, dv, dot(gradient, du), dot(gradient, dv)};
}

void check_bumped(const Vec3& normal, const Tangents& t, const Vec3& expected, Real bound) {
    INFO("normal " << normal << ", du = " << t.du << ", dv = " << t.dv << ", dh_du = " << t.dh_du
                   << ", dh_dv = " << t.dh_dv);
    CHECK(test::near(bumped(normal, t.du, t.dv, t.dh_du, t.dh_dv), expected, bound));
}

void check_map(const Vec3& rgb, const Vec3& du, const Vec3& dv, const Vec3& normal, const Vec3& expected) {
    INFO("normal map's " << rgb << ", du = " << du << ", dv = " << dv << ", normal " << normal);
    CHECK(test::near(from_normal_map(rgb, du, dv, normal), expected, gamma(32)));
}

/// (sin, 0, cos): leant from z towards x.
Vec3 leant(Real degrees) { return {std::sin(radians(degrees)), 0, std::cos(radians(degrees))}; }

/// `up`, leant away from a viewer who stands at 45 degrees until his mirrored ray has least_rise/sqrt(2) of
/// z.
Vec3 last_good() {
    const Real mirrored = std::acos(least_rise * std::sqrt(Real(0.5))) * 180 / pi;
    return leant(-(mirrored - 45) / 2);
}

void check_kept(const Vec3& shading, const Vec3& geometric, const Vec3& viewer, const Vec3& expected,
                Real bound) {
    INFO("shading normal " << shading << ", geometric normal " << geometric << ", to the viewer " << viewer);
    CHECK(test::near(kept_visible(shading, geometric, viewer), expected, bound));
}

/// What the contract says of every result.
void check_promises(const Vec3& shading, const Vec3& geometric, const Vec3& viewer) {
    const Vec3 n = kept_visible(shading, geometric, viewer);
    const Real c = dot(geometric, viewer), side = c < 0 ? -1 : 1, slack = 64 * unit_roundoff;
    const Real seen = side * dot(n, viewer), rises = side * dot(reflect(-viewer, n), geometric);
    INFO("shading normal " << shading << ", geometric normal " << geometric << ", to the viewer " << viewer
                           << "\ngave " << n << ", which has a product of " << seen
                           << " with the viewer's direction; the mirrored ray has one of " << rises
                           << " with the geometric normal; c = " << std::abs(c));
    CHECK(test::near(length(n), 1, gamma(8)));
    CHECK(seen >= std::abs(c) / 2 - slack);
    CHECK(rises >= least_rise * std::abs(c) - slack);
}

}  // namespace

TEST_CASE("a slope of 3/4 leans the normal by 3 : 4", "[11.11]") {
    check_bumped(up, {0.75, 0, 0}, {-0.6, 0, 0.8});
    check_bumped(up, {0, -0.75, 0}, {0, 0.6, 0.8});
}

TEST_CASE("where the height is even the normal stays", "[11.11]") {
    check_bumped(up, {0, 0, 0}, up);
    check_bumped({0.6, 0, -0.8}, {0, 0, 0}, {0.6, 0, -0.8});
}

TEST_CASE("how the height varies across the surface does not matter", "[11.11]") {
    check_bumped(up, {0, 0, 5}, up);
    check_bumped(up, {0.75, 0, -3}, {-0.6, 0, 0.8});
}

TEST_CASE("the normal of bumps is that of the moved plane", "[11.11]") {
    Random random(11701);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 n = random.direction(), gradient = random.magnitude(-3, 1) * random.in_cube();
        // Two directions of the plane, and where the height moves their ends.
        const Vec3 a = random.perpendicular_to(n), b = cross(n, a);
        const Vec3 moved = cross(a + dot(a, gradient) * n, b + dot(b, gradient) * n);
        check_bumped(n, gradient, normalize(moved));
    }
}

TEST_CASE("a height along tangents leans the normal by 3 : 4", "[11.11]") {
    check_bumped(up, {{1, 0, 0}, {0, 1, 0}, 0.75, 0}, {-0.6, 0, 0.8}, gamma(64));
    check_bumped(up, {{1, 0, 0}, {0, 1, 0}, 0, 0.75}, {0, -0.6, 0.8}, gamma(64));
    check_bumped(up, {{1, 0, 0}, {0, 1, 0}, 0, 0}, up, gamma(64));
}

TEST_CASE("the lengths of the tangents do not matter", "[11.11]") {
    check_bumped(up, {{2, 0, 0}, {0, 0.25, 0}, 1.5, 0}, {-0.6, 0, 0.8}, gamma(64));
    check_bumped(up, {{2, 0, 0}, {0, 0.25, 0}, 0, 0.1875}, {0, -0.6, 0.8}, gamma(64));
}

TEST_CASE("the order of the tangents and their angle do not matter", "[11.11]") {
    // The height grows by 3/4 along x.
    check_bumped(up, {{0, 1, 0}, {1, 0, 0}, 0, 0.75}, {-0.6, 0, 0.8}, gamma(64));
    check_bumped(up, {{1, 0, 0}, {1, 1, 0}, 0.75, 0.75}, {-0.6, 0, 0.8}, gamma(128));
    check_bumped(up, {{1, 0, 0}, {-1, 0.5, 0}, 0.75, -0.75}, {-0.6, 0, 0.8}, gamma(320));
}

TEST_CASE("tangents that span no plane leave the normal", "[11.11]") {
    check_bumped(up, {{0, 0, 0}, {0, 1, 0}, 0.5, 0.5}, up, gamma(8));
    check_bumped(up, {{1, 0, 0}, {0, 0, 0}, 0.5, 0.5}, up, gamma(8));
    check_bumped(up, {{0, 0, 0}, {0, 0, 0}, 0, 0}, up, gamma(8));
    check_bumped(up, {{1, 2, 0}, {-2, -4, 0}, 0.5, 0.5}, up, gamma(8));
}

TEST_CASE("the normal by tangents is that of the moved plane", "[11.11]") {
    Random random(11702);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 n = random.direction(), a = random.perpendicular_to(n), b = cross(n, a);
        const Real angle = random.sign() * random.uniform(0.2, 2.9);
        const Vec3 du = random.magnitude(-2, 2) * a;
        const Vec3 dv = random.magnitude(-2, 2) * (std::cos(angle) * a + std::sin(angle) * b);
        const Vec3 gradient = random.magnitude(-2, 0.5) * random.in_cube();
        const Vec3 moved = cross(a + dot(a, gradient) * n, b + dot(b, gradient) * n);
        const Real sine = std::sin(angle), bound = gamma(64) / (sine * sine) * (1 + length(gradient));
        check_bumped(n, tangents(du, dv, gradient), normalize(moved), bound);
    }
}

TEST_CASE("a normal map's blue leaves the normal, red and green lean it along du and dv", "[11.11]") {
    const Vec3 du(0, 2, 0), dv(-3, 0, 0);
    check_map({0.5, 0.5, 1}, du, dv, up, up);
    check_map({0.8, 0.5, 0.9}, du, dv, up, {0, 0.6, 0.8});
    check_map({0.5, 0.8, 0.9}, du, dv, up, {-0.6, 0, 0.8});
    check_map({0.5, 0.8, 0.9}, du, -dv, up, {0.6, 0, 0.8});
    check_map({0.8, 0.5, 0.9}, {0, 0, 0}, dv, up, up);
    check_map({0.5, 0.5, 0.5}, du, dv, up, up);
}

TEST_CASE("a shading normal that is good stays", "[11.11]") {
    const Vec3 viewer = leant(45);
    for (const Real degrees : {-20.0, 0.0, 30.0, 60.0})
        check_kept(leant(degrees), up, viewer, leant(degrees), gamma(4));
}

TEST_CASE("one that mirrors the viewer into the surface is led back until it does not", "[11.11]") {
    // The viewer at 45 degrees, the normal at -30: mirrored at -105 degrees, below the surface. At -22.2 it
    // is -89.4 degrees, and the ray has 1/64 of the viewer's height.
    const Vec3 viewer = leant(45);
    check_kept(leant(-30), up, viewer, last_good(), 1e-6);
    check_kept(leant(-44), up, viewer, last_good(), 1e-6);
}

TEST_CASE("one that the viewer sees from behind is led back, too", "[11.11]") {
    const Vec3 viewer = leant(45);
    check_kept(leant(-60), up, viewer, last_good(), 1e-6);
    check_kept(leant(-100), up, viewer, last_good(), 1e-6);
    check_kept(leant(-130), up, viewer, last_good(), 1e-6);
}

TEST_CASE("a viewer inside sees the far side of the normals", "[11.11]") {
    // All is turned: the geometric normal is away from the viewer, and so is what comes out.
    const Vec3 viewer = leant(45);
    check_kept(-leant(30), -up, viewer, -leant(30), gamma(4));
    check_kept(-leant(-30), -up, viewer, -last_good(), 1e-6);
    check_kept(-leant(-60), -up, viewer, -last_good(), 1e-6);
}

TEST_CASE("a viewer in the plane of the surface gets the geometric normal", "[11.11]") {
    check_kept(leant(-30), up, {1, 0, 0}, up, gamma(4));
}

TEST_CASE("whatever the normals, the viewer sees the front and the mirrored ray rises", "[11.11]") {
    Random random(11703);
    for (int i = 0; i < cases(20000); ++i)
        check_promises(random.direction(), random.direction(), random.direction());
}

TEST_CASE("a normal is led back no farther than needed", "[11.11]") {
    Random random(11704);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 shading = random.direction(), geometric = random.direction(), viewer = random.direction();
        const Real c = dot(geometric, viewer), side = c < 0 ? -1 : 1;
        const auto rise = [&](const Vec3& n) { return side * dot(reflect(-viewer, n), geometric); };
        if (dot(shading, geometric) < -0.86) continue;  // 150 degrees
        const Vec3 n = kept_visible(shading, geometric, viewer);
        const bool was_good = side * dot(shading, viewer) > 0 && rise(shading) >= least_rise * std::abs(c);
        // What is good or not by rounding may be either.
        if (std::abs(rise(shading) - least_rise * std::abs(c)) < 1e-9) continue;
        INFO("shading normal " << shading << ", geometric normal " << geometric << ", to the viewer "
                               << viewer << "\ngave " << n << "; the shading normal was "
                               << (was_good ? "" : "not ") << "good");
        if (was_good) {
            CHECK(test::near(n, shading, gamma(8)));
            continue;
        }
        // The mirrored ray turns twice as far as the normal, which is right to 1e-6 in each coordinate.
        CHECK(test::near(rise(n), least_rise * std::abs(c), 4e-6));
        // In the plane of the two.
        CHECK(test::near(dot(n, cross(shading, geometric)), 0, 4e-6));
    }
}
