// Steps 07.1 to 07.4: reflection, refraction, how much of each, and absorption.
#include "chapters/07_recursion/optics.hpp"

#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using namespace rt::test;

namespace {

constexpr Real u = unit_roundoff;

/// A unit direction at the given angle to the normal (0, 1, 0), downwards.
Vec3 down_at(Real angle) { return {std::sin(angle), -std::cos(angle), 0}; }

const Vec3 up(0, 1, 0);

/// Direction d and normal n, unit vectors to rounding, with d·n ≤ 0.
struct Meeting {
    Vec3 d, n;
};
Meeting random_meeting(Random& random) {
    const Vec3 d = random.direction(), n = random.direction();
    return {d, dot(d, n) > 0 ? -n : n};
}

}  // namespace

// 07.1 ---------------------------------------------------------------------------------------------------

TEST_CASE("a ray comes back from a mirror at the angle at which it came", "[07.1]") {
    CHECK(reflect({1, -1, 0}, up) == Vec3(1, 1, 0));
    CHECK(reflect({3, -2, 5}, up) == Vec3(3, 2, 5));
    CHECK(reflect({0, 0, -7}, {0, 0, 1}) == Vec3(0, 0, 7));
}

TEST_CASE("a slanted mirror turns a level ray upwards", "[07.1]") {
    const Real h = std::sqrt(Real(0.5));
    CHECK(near(reflect({1, 0, 0}, {-h, h, 0}), {0, 1, 0}, 4 * u));
}

TEST_CASE("a grazing ray is not turned", "[07.1]") { CHECK(reflect({2, 0, 1}, up) == Vec3(2, 0, 1)); }

TEST_CASE("either side of the normal mirrors alike", "[07.1]") {
    CHECK(reflect({1, -1, 0}, -up) == Vec3(1, 1, 0));
}

TEST_CASE("mirroring keeps the length, keeps what is along the mirror, turns the rest, and undoes itself",
          "[07.1]") {
    Random random(71);
    for (int i = 0; i < cases(20'000); ++i) {
        const Real size = random.magnitude(-20, 20);
        auto [d, n] = random_meeting(random);
        d *= size;
        const Vec3 r = reflect(d, n);
        INFO("d = " << d.x << " " << d.y << " " << d.z << ", n = " << n.x << " " << n.y << " " << n.z);
        INFO("actual " << r.x << " " << r.y << " " << r.z);
        // d·n has three products and two sums, n is a unit vector to 2u: 16u covers them twice.
        const bool right = std::abs(length(r) - length(d)) <= 16 * u * size &&
                           std::abs(dot(r, n) + dot(d, n)) <= 16 * u * size &&
                           near(cross(r, n), cross(d, n), 16 * u * size) &&
                           near(reflect(r, n), d, 32 * u * size);
        if (!right) REQUIRE(right);
    }
}

// 07.2 ---------------------------------------------------------------------------------------------------

TEST_CASE("a perpendicular ray goes straight through", "[07.2]") {
    for (const Real eta : {0.4, 1.0, 1.5}) {
        const auto t = refract({0, -1, 0}, up, eta);
        REQUIRE(t);
        CHECK(*t == Vec3(0, -1, 0));
    }
}

TEST_CASE("from air into glass at 60 degrees light goes on at 35.26", "[07.2]") {
    // sin 60° / 1.5 = 1/√3, and the angle with that sine has the cosine √(2/3).
    const auto t = refract(down_at(pi / 3), up, 1 / 1.5);
    REQUIRE(t);
    INFO("expected (0.57735, -0.81650, 0), actual (" << t->x << ", " << t->y << ", " << t->z << ")");
    CHECK(near(*t, {1 / std::sqrt(3.0), -std::sqrt(2.0 / 3.0), 0}, 8 * u));
}

TEST_CASE("between equal media nothing is bent", "[07.2]") {
    Random random(72);
    for (int i = 0; i < cases(10'000); ++i) {
        const auto [d, n] = random_meeting(random);
        const auto t = refract(d, n, 1);
        REQUIRE(t);
        if (!near(*t, d, 16 * u)) REQUIRE(near(*t, d, 16 * u));
    }
}

TEST_CASE("from glass into air nothing gets out at 45 degrees", "[07.2]") {
    CHECK_FALSE(refract(down_at(pi / 4), up, 1.5));
    CHECK(refract(down_at(radians(41.8)), up, 1.5));
    CHECK_FALSE(refract(down_at(radians(41.9)), up, 1.5));
}

TEST_CASE("at exactly the critical angle the ray goes along the surface", "[07.2]") {
    // eta·sinᵢ = 1.25 · 0.8 = 1, but 0.8 and 0.6 are rounded: that leaves cosₜ² = 0 ± some u, which may be
    // none, and its root.
    const auto t = refract({0.8, -0.6, 0}, up, 1.25);
    if (t) CHECK(near(*t, {1, 0, 0}, std::sqrt(16 * u)));
    // eta = 1: a ray in the surface stays there.
    const auto along = refract({1, 0, 0}, up, 1);
    REQUIRE(along);
    CHECK(*along == Vec3(1, 0, 0));
    CHECK_FALSE(refract({1, 0, 0}, up, 1 + 16 * u));
}

TEST_CASE("Snell's law holds, the ray stays in its plane and goes to the other side", "[07.2]") {
    Random random(73);
    for (int i = 0; i < cases(50'000); ++i) {
        const auto [d, n] = random_meeting(random);
        const Real eta = std::pow(Real(2.5), random.uniform(-1, 1));
        const Real sine = length(cross(d, n));
        const auto t = refract(d, n, eta);
        INFO("eta = " << eta << ", sine of incidence " << sine);
        // A thousandth away from the critical angle there is no doubt which case it is.
        if (std::abs(eta * sine - 1) > 1e-3) REQUIRE(t.has_value() == (eta * sine < 1));
        if (!t) continue;
        INFO("refracted " << t->x << " " << t->y << " " << t->z);
        // n × t = eta · (n × d) says both: sines and plane. Each side has rounding of a few u of its factors.
        const bool right = near(cross(n, *t), eta * cross(n, d), 32 * u) && dot(*t, n) <= 0 &&
                           std::abs(length(*t) - 1) <= 4 * u;
        if (!right) REQUIRE(right);
    }
}

TEST_CASE("refraction never returns NaN, whatever the angle", "[07.2]") {
    Random random(74);
    int total = 0;
    for (int i = 0; i < cases(20'000); ++i) {
        const auto [d, n] = random_meeting(random);
        const auto t = refract(d, n, random.magnitude(-3, 3));
        total += !t;
        if (t && !is_finite(*t)) FAIL("NaN or infinity for d·n = " << dot(d, n));
    }
    CHECK(total > cases(20'000) / 10);
}

// 07.3 ---------------------------------------------------------------------------------------------------

TEST_CASE("glass mirrors 4 percent of the light that meets it squarely, from outside and from inside",
          "[07.3]") {
    CHECK(std::abs(fresnel(1, 1 / 1.5) - 0.04) <= 4 * u);
    CHECK(std::abs(fresnel(1, 1.5) - 0.04) <= 4 * u);
    CHECK(std::abs(schlick(1, 1 / 1.5) - 0.04) <= 4 * u);
    CHECK(std::abs(schlick(1, 1.5) - 0.04) <= 4 * u);
}

TEST_CASE("at 45 degrees glass mirrors 5.02 percent", "[07.3]") {
    // With cosᵢ² = 1/2 and eta = 2/3, cosₜ² = 7/9: r∥ = (1/√2 − 2√7/9)/(1/√2 + 2√7/9) and so on, by hand
    // 0.0502.
    CHECK(std::abs(fresnel(std::sqrt(0.5), 1 / 1.5) - 0.0502399) < 1e-7);
}

TEST_CASE("at Brewster's angle only half of the light, the perpendicular polarisation, is mirrored",
          "[07.3]") {
    // tan θ = 1.5: cosᵢ = 2/√13, cosₜ = 3/√13, r∥ = 0 and r⊥ = (4/3 − 3)/(4/3 + 3) = −5/13.
    CHECK(std::abs(fresnel(2 / std::sqrt(13.0), 1 / 1.5) - 25.0 / 338) <= 8 * u);
}

TEST_CASE("grazing light and light beyond the critical angle is mirrored whole", "[07.3]") {
    for (const auto reflectance : {fresnel, schlick}) {
        CHECK(reflectance(0, 1 / 1.5) == 1);
        CHECK(reflectance(0, 1.5) == 1);
        CHECK(reflectance(0.7, 1.5) == 1);  // the critical cosine is √5/3 = 0.745
        CHECK(reflectance(0.8, 1.5) < 1);
        CHECK(reflectance(1e-12, 1 / 1.5) > 0.999);
    }
}

TEST_CASE("where there is no difference nothing is mirrored", "[07.3]") {
    for (const Real cosine : {1e-9, 0.1, 0.5, 1.0}) CHECK(fresnel(cosine, 1) == 0);
    CHECK(schlick(1, 1) == 0);
}

TEST_CASE("the reflectance is the same from both sides of the surface", "[07.3]") {
    Random random(75);
    for (int i = 0; i < cases(20'000); ++i) {
        const Real eta = random.uniform(0.4, 1), cos_i = random.uniform(0.05, 1);
        const Real cos_t = std::sqrt((1 - eta) * (1 + eta) + eta * eta * cos_i * cos_i);
        INFO("eta = " << eta << ", cos_i = " << cos_i << ", cos_t = " << cos_t);
        // cosₜ is off by 3u, and the way back divides what that does by cosᵢ ≥ 0.05 and its own by it again.
        const Real bound = 32 * u / (cos_i * cos_i);
        const bool right = std::abs(fresnel(cos_i, eta) - fresnel(cos_t, 1 / eta)) <= bound &&
                           std::abs(schlick(cos_i, eta) - schlick(cos_t, 1 / eta)) <= bound;
        if (!right) REQUIRE(right);
    }
}

TEST_CASE("the reflectance is a part of the light: from 0 to 1, never NaN", "[07.3]") {
    Random random(76);
    for (int i = 0; i < cases(20'000); ++i) {
        // Cosines come from rounded vectors: a little more than 1 may be asked for.
        const Real cos_i = i % 4 == 0 ? random.magnitude(-18, 0) : random.uniform(0, 1 + 4 * u);
        const Real eta = random.magnitude(-2, 2);
        for (const auto reflectance : {fresnel, schlick}) {
            const Real r = reflectance(cos_i, eta);
            INFO("cos_i = " << cos_i << ", eta = " << eta << ", reflected " << r);
            if (!(r >= 0 && r <= 1 + 4 * u)) REQUIRE((r >= 0 && r <= 1 + 4 * u));
        }
    }
}

TEST_CASE("Schlick's curve starts at F0, ends at 1 and falls with the cosine's fifth power", "[07.3]") {
    CHECK(std::abs(schlick(0.5, 1 / 1.5) - (0.04 + 0.96 / 32)) <= 4 * u);
    // From inside the cosine is the one outside: cosᵢ² = 2/3 gives cosₜ² = 1 − 2.25/3 = 1/4.
    CHECK(std::abs(schlick(std::sqrt(2.0 / 3.0), 1.5) - (0.04 + 0.96 / 32)) <= 16 * u);
}

TEST_CASE("Schlick's approximation stays within 0.04 of Fresnel's formulas for glass", "[07.3]") {
    Real worst = 0;
    for (int i = 0; i <= 1000; ++i) {
        const Real cosine = i / 1000.0;
        worst = std::max(worst, std::abs(schlick(cosine, 1 / 1.5) - fresnel(cosine, 1 / 1.5)));
    }
    INFO("greatest difference " << worst);
    CHECK(worst < 0.04);
    CHECK(worst > 0.01);  // and it is an approximation
}

// 07.4, absorption ---------------------------------------------------------------------------------------

TEST_CASE("what is left of light falls by the same factor on every unit of its way", "[07.4]") {
    const Real half = std::log(2.0);
    const Vec3 left = transmitted({half, 2 * half, 0}, 1);
    CHECK(near(left, {0.5, 0.25, 1}, 4 * u));
    CHECK(near(transmitted({half, 2 * half, 0}, 3), {0.125, 1 / 64.0, 1}, 8 * u));
    CHECK(transmitted({1, 2, 3}, 0) == Vec3(1));
    CHECK(transmitted(Vec3(0), 1e300) == Vec3(1));
}

TEST_CASE("two ways one after the other absorb like one way of their sum", "[07.4]") {
    Random random(77);
    for (int i = 0; i < cases(10'000); ++i) {
        const Vec3 a = abs(random.in_cube());
        const Real x = random.uniform(0, 4), y = random.uniform(0, 4);
        const Vec3 both = transmitted(a, x + y), product = transmitted(a, x) * transmitted(a, y);
        INFO("absorption " << a.x << " " << a.y << " " << a.z << ", ways " << x << " and " << y);
        // exp(−p) with p rounded by pu, p ≤ 8, and the rounding of exp itself, on both sides.
        if (!near(both, product, 32 * u)) REQUIRE(near(both, product, 32 * u));
    }
}

TEST_CASE("an infinite way leaves nothing, and all of it where nothing is absorbed", "[07.4]") {
    CHECK(transmitted({1, 1e-300, 0}, infinity) == Vec3(0, 0, 1));
}
