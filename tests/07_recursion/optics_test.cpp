// Steps 07.1 to 07.4: reflection, refraction, how much of each, and absorption; and 07.7, soap films.
#include "chapters/07_recursion/optics.hpp"

#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <complex>

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

void check_reflected(const Vec3& d, const Vec3& n, const Vec3& expected, Real bound = 0) {
    INFO("the direction " << d << " mirrored at the normal " << n);
    CHECK(near_direction(reflect(d, n), expected, bound));
}

/// `eta` is the index in front by that behind.
void check_refracted(const Vec3& d, const Vec3& n, Real eta, const Vec3& expected, Real bound = 0) {
    INFO("the direction " << d << " refracted at the normal " << n << " with eta " << eta);
    const std::optional<Vec3> refracted = refract(d, n, eta);
    REQUIRE(refracted);
    CHECK(near_direction(*refracted, expected, bound));
}

void check_reflectance(const char* law, Real (*reflectance)(Real, Real), Real cos_i, Real eta, Real expected,
                       Real bound = 0) {
    INFO("the part that is mirrored by " << law << ", cosine of incidence " << cos_i << ", eta " << eta);
    CHECK(near(reflectance(cos_i, eta), expected, bound));
}

void check_fresnel(Real cos_i, Real eta, Real expected, Real bound = 0) {
    check_reflectance("Fresnel's formulas", fresnel, cos_i, eta, expected, bound);
}

void check_schlick(Real cos_i, Real eta, Real expected, Real bound = 0) {
    check_reflectance("Schlick's approximation", schlick, cos_i, eta, expected, bound);
}

void check_transmitted(const Vec3& absorption, Real way, const Vec3& expected, Real bound = 0) {
    INFO("what is left of light after a way of " << way << " with absorption " << absorption);
    CHECK(near_color(transmitted(absorption, way), expected, bound));
}

}  // namespace

// 07.1 ---------------------------------------------------------------------------------------------------

TEST_CASE("by hand: a level mirror sends the direction (0.6, -0.8, 0) back along (0.6, 0.8, 0)", "[07.1]") {
    check_reflected({0.6, -0.8, 0}, up, {0.6, 0.8, 0}, 4 * u);
}

TEST_CASE("a ray comes back from a mirror at the angle at which it came", "[07.1]") {
    check_reflected({1, -1, 0}, up, {1, 1, 0});
    check_reflected({3, -2, 5}, up, {3, 2, 5});
    check_reflected({0, 0, -7}, {0, 0, 1}, {0, 0, 7});
}

TEST_CASE("a slanted mirror turns a level ray upwards", "[07.1]") {
    const Real h = std::sqrt(Real(0.5));
    check_reflected({1, 0, 0}, {-h, h, 0}, {0, 1, 0}, 4 * u);
}

TEST_CASE("a grazing ray is not turned", "[07.1]") { check_reflected({2, 0, 1}, up, {2, 0, 1}); }

TEST_CASE("either side of the normal mirrors alike", "[07.1]") {
    check_reflected({1, -1, 0}, -up, {1, 1, 0});
}

TEST_CASE("mirroring keeps the length, keeps what is along the mirror, turns the rest, and undoes itself",
          "[07.1]") {
    Random random(71);
    for (int i = 0; i < cases(20'000); ++i) {
        const Real size = random.magnitude(-20, 20);
        auto [d, n] = random_meeting(random);
        d *= size;
        const Vec3 r = reflect(d, n);
        INFO("the direction " << d << " mirrored at the normal " << n << " is " << r);
        // d·n has three products and two sums, n is a unit vector to 2u: 16u covers them twice.
        REQUIRE(
            or_say(std::abs(length(r) - length(d)) <= 16 * u * size, "it is longer or shorter than before"));
        REQUIRE(or_say(std::abs(dot(r, n) + dot(d, n)) <= 16 * u * size,
                       "its part along the normal is not turned"));
        REQUIRE(
            or_say(near(cross(r, n), cross(d, n), 16 * u * size), "its part along the mirror has changed"));
        REQUIRE(or_say(near(reflect(r, n), d, 32 * u * size), "mirrored again it is not what it was"));
    }
}

// 07.2 ---------------------------------------------------------------------------------------------------

TEST_CASE("by hand: from air into glass the direction (0.6, -0.8, 0) becomes (0.4, -0.9165, 0)", "[07.2]") {
    check_refracted({0.6, -0.8, 0}, up, 1 / 1.5, {0.4, -0.9165151389911680, 0}, 8 * u);
}

TEST_CASE("by hand: from glass into air a sine of 0.8 would become 1.2, so nothing gets out", "[07.2]") {
    INFO("the refracted direction of (0.8, -0.6, 0) at the normal (0, 1, 0) with eta 1.5");
    CHECK_FALSE(refract({0.8, -0.6, 0}, up, 1.5));
}

TEST_CASE("a perpendicular ray goes straight through", "[07.2]") {
    for (const Real eta : {0.4, 1.0, 1.5}) {
        check_refracted({0, -1, 0}, up, eta, {0, -1, 0});
    }
}

TEST_CASE("from air into glass at 60 degrees light goes on at 35.26", "[07.2]") {
    // sin 60° / 1.5 = 1/√3, and the angle with that sine has the cosine √(2/3).
    check_refracted(down_at(pi / 3), up, 1 / 1.5, {1 / std::sqrt(3.0), -std::sqrt(2.0 / 3.0), 0}, 8 * u);
}

TEST_CASE("between equal media nothing is bent", "[07.2]") {
    Random random(72);
    for (int i = 0; i < cases(10'000); ++i) {
        const auto [d, n] = random_meeting(random);
        check_refracted(d, n, 1, d, 16 * u);
    }
}

TEST_CASE("from glass into air nothing gets out at 45 degrees", "[07.2]") {
    INFO(
        "the refracted direction at 45, 41.8 and 41.9 degrees from glass, eta 1.5; the critical angle is "
        "41.81");
    CHECK_FALSE(refract(down_at(pi / 4), up, 1.5));
    CHECK(refract(down_at(radians(41.8)), up, 1.5));
    CHECK_FALSE(refract(down_at(radians(41.9)), up, 1.5));
}

TEST_CASE("at exactly the critical angle the ray goes along the surface", "[07.2]") {
    // eta·sinᵢ = 1.25 · 0.8 = 1, but 0.8 and 0.6 are rounded: that leaves cosₜ² = 0 ± some u, which may be
    // none, and its root.
    const auto t = refract({0.8, -0.6, 0}, up, 1.25);
    if (t) check_refracted({0.8, -0.6, 0}, up, 1.25, {1, 0, 0}, std::sqrt(16 * u));
    // eta = 1: a ray in the surface stays there.
    check_refracted({1, 0, 0}, up, 1, {1, 0, 0});
    INFO("a ray in the surface, eta a little more than 1");
    CHECK_FALSE(refract({1, 0, 0}, up, 1 + 16 * u));
}

TEST_CASE("Snell's law holds, the ray stays in its plane and goes to the other side", "[07.2]") {
    Random random(73);
    for (int i = 0; i < cases(50'000); ++i) {
        const auto [d, n] = random_meeting(random);
        const Real eta = std::pow(Real(2.5), random.uniform(-1, 1));
        const Real sine = length(cross(d, n));
        const auto t = refract(d, n, eta);
        INFO("the direction " << d << " at the normal " << n << ", eta = " << eta << ", sine of incidence "
                              << sine << "; refracted: " << t);
        // A thousandth away from the critical angle there is no doubt which case it is.
        if (std::abs(eta * sine - 1) > 1e-3)
            REQUIRE(or_say(t.has_value() == (eta * sine < 1),
                           t ? "light goes through beyond the critical angle" : "nothing goes through"));
        if (!t) continue;
        // n × t = eta · (n × d) says both: sines and plane. Each side has rounding of a few u of its factors.
        REQUIRE(or_say(near(cross(n, *t), eta * cross(n, d), 32 * u),
                       "the sines are not in the ratio of Snell's law"));
        REQUIRE(or_say(dot(*t, n) <= 0, "it comes back on the side that it came from"));
        REQUIRE(or_say(std::abs(length(*t) - 1) <= 4 * u, "it is not a unit vector"));
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
    INFO("how often reflection is total");
    CHECK(total > cases(20'000) / 10);
}

// 07.3 ---------------------------------------------------------------------------------------------------

TEST_CASE("glass mirrors 4 percent of the light that meets it squarely, from outside and from inside",
          "[07.3]") {
    check_fresnel(1, 1 / 1.5, 0.04, 4 * u);
    check_fresnel(1, 1.5, 0.04, 4 * u);
    check_schlick(1, 1 / 1.5, 0.04, 4 * u);
    check_schlick(1, 1.5, 0.04, 4 * u);
}

TEST_CASE("by hand: glass that is met at a cosine of 0.8 mirrors 0.0439 of the light", "[07.3]") {
    // With cosₜ = √0.84 = 0.9165 the amplitudes are 0.1339 and −0.2643.
    check_fresnel(0.8, 1 / 1.5, 0.0439, 0.00005);
    // Schlick: 0.04 + 0.96 · 0.2⁵.
    check_schlick(0.8, 1 / 1.5, 0.0403, 0.00005);
}

TEST_CASE("at 45 degrees glass mirrors 5.02 percent", "[07.3]") {
    // With cosᵢ² = 1/2 and eta = 2/3, cosₜ² = 7/9: r∥ = (1/√2 − 2√7/9)/(1/√2 + 2√7/9) and so on, by hand
    // 0.0502.
    check_fresnel(std::sqrt(0.5), 1 / 1.5, 0.0502399, 1e-7);
}

TEST_CASE("at Brewster's angle only half of the light, the perpendicular polarisation, is mirrored",
          "[07.3]") {
    // tan θ = 1.5: cosᵢ = 2/√13, cosₜ = 3/√13, r∥ = 0 and r⊥ = (4/3 − 3)/(4/3 + 3) = −5/13.
    check_fresnel(2 / std::sqrt(13.0), 1 / 1.5, 25.0 / 338, 8 * u);
}

TEST_CASE("grazing light and light beyond the critical angle are mirrored whole", "[07.3]") {
    for (const auto check : {check_fresnel, check_schlick}) {
        check(0, 1 / 1.5, 1, 0);
        check(0, 1.5, 1, 0);
        check(0.7, 1.5, 1, 0);  // the critical cosine is √5/3 = 0.745
        check(1e-12, 1 / 1.5, 1, 0.001);
    }
    INFO(
        "the part that is mirrored inside of glass at a cosine of 0.8, which is not beyond the critical "
        "angle");
    CHECK(fresnel(0.8, 1.5) < 1);
    CHECK(schlick(0.8, 1.5) < 1);
}

TEST_CASE("where there is no difference nothing is mirrored", "[07.3]") {
    for (const Real cosine : {1e-9, 0.1, 0.5, 1.0}) check_fresnel(cosine, 1, 0);
    check_schlick(1, 1, 0);
}

TEST_CASE("the reflectance is the same from both sides of the surface", "[07.3]") {
    Random random(75);
    for (int i = 0; i < cases(20'000); ++i) {
        const Real eta = random.uniform(0.4, 1), cos_i = random.uniform(0.05, 1);
        const Real cos_t = std::sqrt((1 - eta) * (1 + eta) + eta * eta * cos_i * cos_i);
        INFO("cosine " << cos_i << " with eta " << eta << " becomes cosine " << cos_t
                       << "; the part that is mirrored, expected that of the way back");
        // cosₜ is off by 3u, and the way back divides what that does by cosᵢ ≥ 0.05 and its own by it again.
        const Real bound = 32 * u / (cos_i * cos_i);
        REQUIRE(near(fresnel(cos_i, eta), fresnel(cos_t, 1 / eta), bound));
        INFO("by Schlick's approximation");
        REQUIRE(near(schlick(cos_i, eta), schlick(cos_t, 1 / eta), bound));
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
            INFO("cosine of incidence " << cos_i << ", eta " << eta
                                        << ": the part that is mirrored, from 0 to 1");
            REQUIRE(r >= 0);
            REQUIRE(r <= 1 + 4 * u);
        }
    }
}

TEST_CASE("Schlick's curve starts at F0, ends at 1 and falls with the cosine's fifth power", "[07.3]") {
    check_schlick(0.5, 1 / 1.5, (0.04 + 0.96 / 32), 4 * u);
    // From inside the cosine is the one outside: cosᵢ² = 2/3 gives cosₜ² = 1 − 2.25/3 = 1/4.
    check_schlick(std::sqrt(2.0 / 3.0), 1.5, (0.04 + 0.96 / 32), 16 * u);
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
    check_transmitted({half, 2 * half, 0}, 1, {0.5, 0.25, 1}, 4 * u);
    check_transmitted({half, 2 * half, 0}, 3, {0.125, 1 / 64.0, 1}, 8 * u);
    check_transmitted({1, 2, 3}, 0, Vec3(1));
    check_transmitted(Vec3(0), 1e300, Vec3(1));
}

TEST_CASE("two ways one after the other absorb like one way of their sum", "[07.4]") {
    Random random(77);
    for (int i = 0; i < cases(10'000); ++i) {
        const Vec3 a = abs(random.in_cube());
        const Real x = random.uniform(0, 4), y = random.uniform(0, 4);
        const Vec3 both = transmitted(a, x + y), product = transmitted(a, x) * transmitted(a, y);
        INFO("absorption " << a << ": what is left after " << x << " + " << y
                           << ", expected what both ways leave one after the other");
        // exp(−p) with p rounded by pu, p ≤ 8, and the rounding of exp itself, on both sides.
        REQUIRE(near_color(both, product, 32 * u));
    }
}

TEST_CASE("an infinite way leaves no light, and all of it where nothing is absorbed", "[07.4]") {
    check_transmitted({1, 1e-300, 0}, infinity, {0, 0, 1});
}

// 07.7 ---------------------------------------------------------------------------------------------------

namespace {

void check_film(Real cos_i, Real ior, Real thickness, int channel, Real expected, Real bound) {
    INFO("a film of ior " << ior << ", " << thickness << " nm thick, cosine of incidence " << cos_i
                          << ": the part that is mirrored of light of " << wavelengths[channel] << " nm");
    CHECK(near(soap_film(cos_i, ior, thickness)[channel], expected, bound));
}

}  // namespace

TEST_CASE("by hand: a film without thickness is black", "[07.7]") {
    for (const Real cosine : {1.0, 0.8, 0.1})
        for (const int channel : {0, 1, 2}) check_film(cosine, 1.33, 0, channel, 0, 0);
}

TEST_CASE("by hand: a quarter of the wave in the film mirrors most, 0.1479, and half of it nothing",
          "[07.7]") {
    // Straight on, glass mirrors 0.04 at each side: 4 · 0.04/1.04² where the waves agree.
    for (const int channel : {0, 1, 2}) {
        const Real in_film = wavelengths[channel] / 1.5;
        check_film(1, 1.5, in_film / 4, channel, 0.16 / 1.0816, 32 * u);
        check_film(1, 1.5, in_film / 2, channel, 0, 32 * u);
    }
}

TEST_CASE("by hand: aslant the film acts like a thinner one, by the cosine inside it", "[07.7]") {
    // The angle of the cosine 0.8: 0.9165 inside, amplitudes 0.1339 and 0.2643.
    const Real inside = std::sqrt(0.84);
    check_film(0.8, 1.5, 532 / 1.5 / 4 / inside, 1, 0.15669, 0.00002);
    check_film(0.8, 1.5, 532 / 1.5 / 2 / inside, 1, 0, 32 * u);
}

TEST_CASE("a film mirrors what all its reflections, added up as waves, make", "[07.7]") {
    Random random(86);
    for (int i = 0; i < cases(2000); ++i) {
        const Real ior = random.uniform(1.01, 2.5), cos_i = random.uniform(0.05, 1);
        const Real thickness = random.uniform(0, 2000);
        const Real cos_t = std::sqrt(1 - (1 - cos_i * cos_i) / (ior * ior));
        const Vec3 part = soap_film(cos_i, ior, thickness);
        INFO("a film of ior " << ior << ", " << thickness << " nm thick, cosine of incidence " << cos_i
                              << ": the parts that are mirrored of red, green and blue are " << part);
        for (const int channel : {0, 1, 2}) {
            const Real turn = 4 * pi * ior * thickness * cos_t / wavelengths[channel];
            const std::complex<Real> wave = std::polar(Real(1), turn);
            Real expected = 0;
            for (const Real r : {(ior * cos_i - cos_t) / (ior * cos_i + cos_t),
                                 (cos_i - ior * cos_t) / (cos_i + ior * cos_t)})
                expected += std::norm(r * (Real(1) - wave) / (Real(1) - r * r * wave)) / 2;
            REQUIRE(near(part[channel], expected, 1e-10));
        }
    }
}
