// Step 11.11: normals of bumps on cases made to break them.
#include "chapters/11_textures/bump.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::Random;

namespace {

void check_unit(const Vec3& n) {
    INFO("gave " << n);
    CHECK(test::near(length(n), 1, gamma(8)));
}

}  // namespace

TEST_CASE("slopes of every size give a unit normal", "[11.11][stability]") {
    Random random(11711);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 n = random.direction(), gradient = random.magnitude(-300, 300) * random.in_cube();
        INFO("normal " << n << " where the height has the gradient " << gradient);
        check_unit(bumped(n, gradient));
        // At right angles to a normal, up to rounding, it is a matter of how much of it there is.
        const Real slope = random.magnitude(-12, 12);
        const Vec3 along = random.perpendicular_to(n);
        const Vec3 expected = n / std::hypot(1, slope) - along * (slope / std::hypot(1, slope));
        INFO("and where it has " << slope * along);
        // perpendicular_to and the product with n are right to a few u of the slope, and so is their sum.
        CHECK(test::near(bumped(n, slope * along), expected, gamma(32)));
    }
}

TEST_CASE("tangents of every length and angle give a unit normal", "[11.11][stability]") {
    Random random(11712);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 n = random.direction(), a = random.perpendicular_to(n);
        const Vec3 du = random.magnitude(-100, 99) * a;
        const Vec3 dv = random.magnitude(-100, 99) * (a + random.magnitude(-18, 0) * cross(n, a));
        const Real dh_du = random.magnitude(-100, 99) * random.sign();
        const Real dh_dv = random.magnitude(-100, 99) * random.sign();
        INFO("normal " << n << ", du = " << du << ", dv = " << dv << ", dh_du = " << dh_du
                       << ", dh_dv = " << dh_dv);
        check_unit(bumped(n, du, dv, dh_du, dh_dv));
        check_unit(bumped(n, du, Vec3(0), dh_du, dh_dv));
        check_unit(bumped(n, du, Real(-2) * du, dh_du, dh_dv));
        INFO("and a height that is even");
        CHECK(test::near(bumped(n, du, dv, 0, 0), n, gamma(8)));
    }
}

TEST_CASE("a scene times a power of two has the same normals", "[11.11][stability]") {
    Random random(11713);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 n = random.direction(), du = random.in_cube(), dv = random.in_cube();
        const Real dh_du = random.uniform(-1, 1), dh_dv = random.uniform(-1, 1);
        const Real scale = std::ldexp(1.0, static_cast<int>(random.index(400)) - 200);
        INFO("normal " << n << ", du = " << du << ", dv = " << dv << ", dh_du = " << dh_du
                       << ", dh_dv = " << dh_dv << ", and all but the normal times " << scale);
        CHECK(bumped(n, scale * du, scale * dv, scale * dh_du, scale * dh_dv) ==
              bumped(n, du, dv, dh_du, dh_dv));
    }
}

TEST_CASE("normal maps give a unit normal whatever they say", "[11.11][stability]") {
    Random random(11714);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 n = random.direction();
        const Vec3 rgb = Vec3(0.5) + random.magnitude(-17, -0.31) * random.in_cube();
        const Vec3 du =
            i % 3 == 0 ? random.magnitude(-100, 99) * n : random.magnitude(-100, 99) * random.in_cube();
        INFO("normal map's " << rgb << ", du = " << du << ", normal " << n);
        check_unit(from_normal_map(rgb, du, random.magnitude(-100, 99) * random.in_cube(), n));
    }
}

TEST_CASE("shading normals are kept visible at grazing views and against opposite normals",
          "[11.11][stability]") {
    Random random(11715);
    for (int i = 0; i < cases(20000); ++i) {
        const Vec3 geometric = random.direction(), along = random.perpendicular_to(geometric);
        const Real height = random.sign() * random.magnitude(-20, 0);
        const Vec3 viewer = normalize(along + height * geometric);
        // Nearly opposite to the geometric normal, opposite, nearly the same, across, or nearly seen edge on.
        const Vec3 jitter = random.magnitude(-20, 0) * random.in_cube();
        const Vec3 bases[] = {-geometric, geometric, along, -along, random.perpendicular_to(viewer)};
        const Vec3 shading = i % 7 == 0 ? -geometric : normalize(bases[i % 5] + jitter);
        const Vec3 n = kept_visible(shading, geometric, viewer);
        const Real c = dot(geometric, viewer), side = c < 0 ? -1 : 1;
        const Real seen = side * dot(n, viewer), rises = side * dot(reflect(-viewer, n), geometric);
        INFO("shading normal " << shading << ", geometric normal " << geometric << ", to the viewer "
                               << viewer);
        INFO("gave " << n << ", product with the viewer's direction " << seen
                     << ", of the mirrored ray with the "
                     << "geometric normal " << rises << ", c = " << std::abs(c));
        CHECK(test::near(length(n), 1, gamma(8)));
        CHECK(seen >= std::abs(c) / 2 - 64 * unit_roundoff);
        CHECK(rises >= least_rise * std::abs(c) - 64 * unit_roundoff);
    }
}
