// Steps 11.16 and 11.17: microfacets, and rough metal.
#include "chapters/11_textures/microfacet.hpp"
#include "common/math/error.hpp"
#include "tests/11_textures/lobe_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::left;
using test::near;
using test::near_color;
using test::Random;
using test::right;
using test::towards;
using test::up;
using test::upper;

namespace {

/// A direction 45 degrees from the normal.
const Vec3 slanted{std::sqrt(0.5), 0, std::sqrt(0.5)};

/// Roughness with α = 1/2.
const Real half_alpha = std::sqrt(0.5);

Real density_by_tangent(Real alpha, const Vec3& h) {
    const Real cosine = h.z, tangent = std::hypot(h.x, h.y) / cosine, slope = tangent / alpha;
    return 1 / (pi * std::pow(alpha * cosine * cosine * (1 + slope * slope), 2));
}

Real shadow_by_tangent(Real alpha, const Vec3& w) {
    const Real tangent = std::hypot(w.x, w.y) / w.z;
    return 2 / (1 + std::sqrt(1 + alpha * alpha * tangent * tangent));
}

Real lobe_by_tangent(Real alpha, const Vec3& l, const Vec3& v) {
    const Vec3 h = normalize(l + v);
    return density_by_tangent(alpha, h) * shadow_by_tangent(alpha, l) * shadow_by_tangent(alpha, v) /
           (4 * l.z * v.z);
}

/// What rounding may do to a lobe, as a part of it: the contract's.
Real part(Real alpha, const Vec3& l, const Vec3& v) {
    return gamma(32) + 16 * unit_roundoff / (alpha * length(l + v));
}

Vec3 furnace(const RoughMetal& metal, const Vec3& v, int n) {
    const test::Chart chart = test::mirrored_by_facets(ggx_alpha(metal.roughness), v);
    return test::sum_over(chart, n,
                          [&](const Vec3& l) { return evaluate(metal, l, v) * std::max(l.z, 0.0); });
}

void check_density(Real alpha, const Vec3& h, Real expected, Real bound) {
    INFO("the density of facets whose normal is " << h << ", for alpha " << alpha);
    CHECK(near(ggx_density(alpha, h), expected, bound));
}

void check_seen(Real alpha, const Vec3& w, Real expected, Real bound) {
    INFO("G1, the part of the facets that is seen from " << w << ", for alpha " << alpha);
    CHECK(near(smith_g1(alpha, w), expected, bound));
}

void check_lobe(const RoughMetal& metal, const Vec3& l, const Vec3& v, const Vec3& expected) {
    INFO("metal of colour " << metal.color << ", alpha 0.5, to the light " << l << ", to the viewer " << v);
    CHECK(near_color(evaluate(metal, l, v), expected, gamma(64)));
}

}  // namespace

TEST_CASE("the density of facets at angles by hand", "[11.16]") {
    // Straight up 1/(π α²).
    check_density(0.5, up, 4 / pi, gamma(20) * 2);
    check_density(0.1, up, 100 / pi, gamma(20) * 40);
    // α = 1: as many in every direction.
    for (const Vec3& h : {up, right, slanted, towards(89, 40)}) check_density(1, h, 1 / pi, gamma(20));
    // 45°: cos² = sin² = 1/2, α²cos² + sin² = 5/8 for α = 1/2.
    check_density(0.5, slanted, 0.64 / pi, gamma(20));
}

TEST_CASE("the density of facets of a nearly smooth surface", "[11.16]") {
    // sin θ = α = 1e-8: a quarter of 1/(π α²). 1 − cos² would be 0.
    check_density(1e-8, {1e-8, 0, 1}, 0.25e16 / pi, gamma(20) * 1e15);
    check_density(1e-8, up, 1e16 / pi, gamma(20) * 4e15);
}

TEST_CASE("no facets lie or hang", "[11.16]") {
    check_density(0.5, {1, 0, 0}, 0, 0);
    check_density(0.5, {0, 0, -1}, 0, 0);
    check_density(1, {std::sqrt(0.5), 0, -std::sqrt(0.5)}, 0, 0);
}

TEST_CASE("the part of facets that is seen, at angles by hand", "[11.16]") {
    check_seen(0.5, up, 1, gamma(12));
    check_seen(1, right, Real(2) / 3, gamma(12));
    // α = 1/2 at 45°: 2/(1 + √(1 + 1/4)).
    check_seen(0.5, slanted, 4 / (2 + std::sqrt(5.0)), gamma(12));
    check_seen(1e-8, right, 1, gamma(12));
    check_seen(0.5, {1, 0, 0}, 0, 0);
    check_seen(0.5, {0, 0, -1}, 0, 0);
}

TEST_CASE("all facets together cover the surface once", "[11.16]") {
    // The sum of D·cos is 1, and that of the facets seen from v, G₁·(v·h)·D, as much as v sees of the
    // surface.
    for (const Real alpha : {0.01, 0.3, 1.0}) {
        test::Chart facets;
        facets.at = [=](Real a, Real b) -> std::optional<test::ChartPoint> {
            return test::facet_at(alpha, a, b);
        };
        INFO("alpha " << alpha);
        const Real flat =
            test::sum_over(facets, 64, [&](const Vec3& h) { return ggx_density(alpha, h) * h.z; });
        CHECK(near(flat, 1, 1e-9));
        for (const Real angle : {0.0, 45.0, 80.0}) {
            const Vec3 v = towards(angle);
            INFO("the viewer is " << angle << " degrees from the normal");
            const Real seen = test::sum_over(facets, 128, [&](const Vec3& h) {
                return smith_g1(alpha, v) * ggx_density(alpha, h) * std::max(dot(v, h), 0.0);
            });
            // The midpoint rule on 128² cells errs by 1e-4 where facets turn away.
            CHECK(near(seen, v.z, 1e-3));
        }
    }
}

TEST_CASE("rough metal at angles by hand", "[11.16]") {
    const RoughMetal white{Vec3(1), half_alpha};
    // Straight up and back: D/4 = 1/(4π α²).
    check_lobe(white, up, up, Vec3(1 / pi));
    // 60° to either side: h is up, D = 4/π, G₁ = 4/(2 + √7) twice, 4·l.z·v.z = 1.
    const Real g1 = 4 / (2 + std::sqrt(7.0));
    check_lobe(white, left, right, Vec3(4 / pi * g1 * g1));
    // Schlick's (1 − 1/2)⁵ = 1/32 of what is missing to white is added.
    const RoughMetal gold{{1, 0.68, 0.04}, half_alpha};
    check_lobe(gold, left, right, Vec3(1, 0.69, 0.07) * (4 / pi * g1 * g1));
    check_lobe(gold, up, up, Vec3(1, 0.68, 0.04) / pi);
    // From straight above to 60°: h is 30° from both, D = 64/(49π), 4·l.z·v.z = 2. Little is missing at the
    // facet.
    const Real missing = std::pow(1 - std::sqrt(0.75), 5);
    check_lobe(gold, up, right,
               (Vec3(1, 0.68, 0.04) + missing * Vec3(0, 0.32, 0.96)) * (32 / (49 * pi) * g1));
}

TEST_CASE("below the surface rough metal is 0", "[11.16]") { test::check_below(RoughMetal{Vec3(1), 0.7}); }

TEST_CASE("the density of rough metal's directions by hand", "[11.16]") {
    const RoughMetal metal{Vec3(1), half_alpha};
    {
        INFO("pdf for alpha 0.5, to the light and to the viewer straight up: D/4 = 1/pi");
        CHECK(near(pdf(metal, up, up), 1 / pi, gamma(64)));
    }
    INFO("pdf for alpha 0.5, to the light and to the viewer 60 degrees to either side");
    // G₁·D/(4·v.z) with G₁ = 4/(2 + √7), D = 4/π, v.z = 1/2.
    CHECK(near(pdf(metal, left, right), 8 / (pi * (2 + std::sqrt(7.0))), gamma(64)));
}

TEST_CASE("half of the facets seen from above are within alpha", "[11.17]") {
    // tan²θ = α²·u/(1 − u) for uniform u: u < 1/2 is tan θ < α.
    for (const Real alpha : {1e-8, 0.1, 1.0}) {
        int within = 0;
        for (int i = 0; i < 32; ++i)
            for (int j = 0; j < 32; ++j) {
                const Vec3 h = visible_normal(alpha, up, (i + 0.5) / 32, (j + 0.5) / 32);
                within += std::hypot(h.x, h.y) < alpha * h.z;
            }
        INFO("alpha " << alpha << ": of 1024 facets " << within << " are within");
        CHECK(std::abs(within - 512) <= 64);
    }
}

TEST_CASE("nobody below the surface is shown rough metal", "[11.17]") {
    test::check_nothing_drawn_below(RoughMetal{Vec3(1), 0.7});
}

TEST_CASE("facets are drawn as they are seen", "[11.17]") {
    for (const Real alpha : {0.01, 0.4, 1.0})
        for (const Real angle : {0.0, 50.0, 85.0}) {
            const Vec3 v = towards(angle, 25);
            INFO("alpha " << alpha << ", the viewer " << angle << " degrees from the normal");
            test::Chart facets;
            facets.at = [=](Real a, Real b) -> std::optional<test::ChartPoint> {
                return test::facet_at(alpha, a, b);
            };
            facets.find = [=](const Vec3& h) -> std::optional<Vec2> { return test::facet_place(alpha, h); };
            const auto draw = [&](const Vec3& numbers) {
                const Vec3 h = visible_normal(alpha, v, numbers.x, numbers.y);
                return std::optional<LobeSample>(LobeSample{h, Vec3(1), 1});
            };
            const auto density = [&](const Vec3& h) {
                return shadow_by_tangent(alpha, v) * std::max(dot(v, h), 0.0) * density_by_tangent(alpha, h) /
                       v.z;
            };
            test::check_report(test::compare_samples({facets}, draw, density, cases(20000), 11140));
        }
}

TEST_CASE("rough metal mirrors light by a facet", "[11.17]") {
    Random random(11141);
    int drawn = 0;
    for (int i = 0; i < cases(2000); ++i) {
        const RoughMetal metal{{random.uniform(0, 1), 1, 0.5}, random.uniform(0.1, 1)};
        const Real spread = ggx_alpha(metal.roughness);
        const Vec3 v = upper(random),
                   numbers(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
        INFO("roughness " << metal.roughness << ", to the viewer " << v << ", random numbers " << numbers);
        const auto one = sample(metal, v, numbers);
        if (!one) continue;
        ++drawn;
        const Vec3 l = one->to_light, expected = evaluate(metal, l, v) * l.z;
        INFO("to the light " << l);
        CHECK(l.z > 0);
        CHECK(near(length(l), 1, gamma(12)));
        const Real bound = 2 * part(spread, l, v) * (1 + pdf(metal, l, v));
        CHECK(near(one->pdf, pdf(metal, l, v), bound));
        CHECK(near_color(one->weight * one->pdf, expected, bound));
        CHECK(one->weight.y <= 1 + gamma(32));
    }
    INFO("of " << cases(2000)
               << " samples that were asked for, how many there are; some lead below the surface");
    CHECK(drawn >= test::demanded(cases(1000), cases(500)));
}

TEST_CASE("directions from rough metal are as dense as they claim", "[11.17]") {
    for (const Real roughness : {0.1, 0.5, 1.0})
        for (const Real angle : {0.0, 60.0, 85.0}) {
            const RoughMetal metal{Vec3(1), roughness};
            const Vec3 v = towards(angle, 25);
            INFO("roughness " << roughness << ", the viewer " << angle << " degrees from the normal");
            const auto draw = [&](const Vec3& numbers) { return sample(metal, v, numbers); };
            const auto density = [&](const Vec3& l) { return pdf(metal, l, v); };
            test::check_report(test::compare_samples({test::mirrored_by_facets(ggx_alpha(roughness), v)},
                                                     draw, density, cases(20000), 11142));
        }
}

TEST_CASE("rough metal is the same with light and viewer exchanged", "[11.16]") {
    Random random(11143);
    for (int i = 0; i < cases(2000); ++i) {
        const RoughMetal metal{{0.3, 0.6, 1}, random.uniform(0.1, 1)};
        const Vec3 l = upper(random), v = upper(random);
        INFO("roughness " << metal.roughness << ", one direction " << l << ", the other " << v);
        const Vec3 f = evaluate(metal, l, v);
        CHECK(near(f, evaluate(metal, v, l), 2 * part(ggx_alpha(metal.roughness), l, v) * f.z));
    }
}

TEST_CASE("rough metal by tangents, as Walter and others wrote it", "[11.16]") {
    Random random(11144);
    for (int i = 0; i < cases(2000); ++i) {
        const RoughMetal metal{{1, 0.5, 0}, random.uniform(0.1, 1)};
        const Real spread = ggx_alpha(metal.roughness);
        const Vec3 l = upper(random), v = upper(random);
        INFO("roughness " << metal.roughness << ", to the light " << l << ", to the viewer " << v);
        const Real white = lobe_by_tangent(spread, l, v), missing = std::pow(1 - dot(l, normalize(l + v)), 5);
        const Real bound = 2 * part(spread, l, v) * white;
        CHECK(near_color(evaluate(metal, l, v), white * Vec3(1, 0.5 + 0.5 * missing, missing), bound));
        const Real density = white / shadow_by_tangent(spread, l) * l.z;
        CHECK(near(pdf(metal, l, v), density, 2 * part(spread, l, v) * density));
    }
}

TEST_CASE("rough metal returns no more light than it gets", "[11.16]") {
    for (const Real roughness : {0.05, 0.3, 0.6, 1.0})
        for (const Real angle : {0.0, 45.0, 80.0}) {
            INFO("roughness " << roughness << ", viewer " << angle << " degrees from the normal");
            // The midpoint rule on 64² cells errs by less than 2e-3.
            CHECK(furnace({Vec3(1), roughness}, towards(angle), 64).x <= 1 + 2e-3);
        }
    // Straight from above with α = 1 it is 1 − ln 2: the facets are as many in all directions, and all others
    // hide what they mirror. Nearly smooth, it returns nearly all.
    INFO("what white metal of roughness 1 returns of an even light, seen from straight above");
    CHECK(near(furnace({Vec3(1), 1}, up, 64).x, 1 - std::log(2.0), 2e-3));
    INFO("and of roughness 0.05");
    CHECK(near(furnace({Vec3(1), 0.05}, up, 64).x, 1, 2e-3));
}
