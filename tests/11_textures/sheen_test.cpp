// Steps 11.20 and 11.21: velvet.
#include "chapters/11_textures/sheen.hpp"
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

/// Directions by hand: 60 degrees from the normal to a third side, and 30 and 45 degrees.
const Vec3 forth{0, std::sqrt(0.75), 0.5};
const Vec3 steep{0.5, 0, std::sqrt(0.75)}, slanted{std::sqrt(0.5), 0, std::sqrt(0.5)};

/// What rounding may do to a lobe, as a part of it: the contract's.
Real part(Real sigma, const Vec3& l, const Vec3& v) {
    const Vec3 h = normalize(l + v);
    const Real sine = std::hypot(h.x, h.y);
    return gamma(64) * (1 + (1 + h.z / (sigma * sigma * sine * sine * sine)) / dot(l + v, l + v));
}

/// f·cos as Blender's Cycles has it.
Real cycles_velvet(Real sigma, const Vec3& l, const Vec3& v) {
    const Vec3 h = normalize(l + v);
    const Real theta = std::acos(h.z), toward = dot(v, h);
    const Real shadow = std::min({1.0, 2 * h.z * v.z / toward, 2 * h.z * l.z / toward});
    const Real slope = std::tan(theta) * sigma;
    const Real facets =
        std::exp(-1 / (slope * slope)) / (pi * std::pow(sigma * std::pow(std::sin(theta), 2), 2));
    return 0.25 * facets * shadow / v.z;
}

/// Most of the facets of a small σ stand upright: the chart is as wide as 1/σ.
test::Chart chart_of(const Velvet& velvet, const Vec3& v) {
    return test::mirrored_by_facets(1 / velvet.roughness, v);
}

Vec3 furnace(const Velvet& velvet, const Vec3& v, int n) {
    return test::sum_over(chart_of(velvet, v), n,
                          [&](const Vec3& l) { return evaluate(velvet, l, v) * std::max(l.z, 0.0); });
}

void check_density(Real sigma, const Vec3& h, Real expected, Real bound) {
    INFO("the density of velvet's facets whose normal is " << h << ", for sigma " << sigma);
    CHECK(near(velvet_density(sigma, h), expected, bound));
}

void check_left(const Vec3& w, const Vec3& h, Real expected) {
    INFO("the part of a facet with the normal " << h << " that its partner leaves, seen from " << w);
    CHECK(near(cavity_g1(w, h), expected, gamma(8)));
}

void check_lobe(const Velvet& velvet, const Vec3& l, const Vec3& v, const Vec3& expected, Real bound) {
    INFO("velvet of colour " << velvet.color << ", sigma " << velvet.roughness << ", to the light " << l
                             << ", to the viewer " << v);
    CHECK(near_color(evaluate(velvet, l, v), expected, bound));
}

void check_pdf(const Vec3& l, const Vec3& v, Real expected) {
    INFO("pdf for sigma 1, to the light " << l << ", to the viewer " << v);
    CHECK(near(pdf(Velvet{Vec3(1), 1}, l, v), expected, gamma(64)));
}

}  // namespace

TEST_CASE("the density of velvet's facets at angles by hand", "[11.20]") {
    // Upright facets: cot = 0, sin = 1.
    check_density(1, {1, 0, 0}, 1 / pi, gamma(16));
    check_density(0.5, {0, -1, 0}, 4 / pi, gamma(32));
    // 45°: cot² = 1, sin⁴ = 1/4.
    check_density(1, slanted, 4 / pi * std::exp(-1.0), gamma(32));
    check_density(0.5, slanted, 16 / pi * std::exp(-4.0), gamma(64));
    // 60°: cot² = 1/3, sin⁴ = 9/16.
    check_density(1, right, 16 / (9 * pi) * std::exp(-1.0 / 3), gamma(32));
}

TEST_CASE("no facet of velvet lies flat or hangs", "[11.20]") {
    check_density(1, up, 0, 0);
    check_density(0.3, {1e-200, 0, 1}, 0, 0);
    check_density(0.3, {1e-3, 0, 1}, 0, 0);
    check_density(1, {std::sqrt(0.75), 0, -0.5}, 0, 0);
}

TEST_CASE("velvet's facets together cover the surface once", "[11.20]") {
    for (const Real sigma : {0.1, 0.5, 1.0}) {
        test::Chart facets;
        facets.at = [=](Real a, Real b) -> std::optional<test::ChartPoint> {
            return test::facet_at(1 / sigma, a, b);
        };
        INFO("sigma " << sigma);
        const Real all =
            test::sum_over(facets, 64, [&](const Vec3& h) { return velvet_density(sigma, h) * h.z; });
        CHECK(near(all, 1, 1e-3));
    }
}

TEST_CASE("the part of a facet that its partner leaves, by hand", "[11.20]") {
    check_left(up, up, 1);
    // w and h 60° from the normal: 2·½·½/1.
    check_left(right, right, 0.5);
    // 45°: just all of it.
    check_left(slanted, slanted, 1);
    // 30°: 2·¾ is more than all.
    check_left(steep, steep, 1);
    // From above a facet leaning by 60° is seen wholly: 2·½·1/½ is more than all.
    check_left(up, right, 1);
    // From 60° a facet leaning by 30° to that side: 2·(√3/2)·½/(√3/2) = 1.
    check_left(right, steep, 1);
    // From 60° one leaning by 60° crosswise: w·h = ¼, 2·½·½/¼ is more than all.
    check_left(right, forth, 1);
}

TEST_CASE("velvet is black from above", "[11.20]") {
    const Velvet velvet{Vec3(1), 0.3};
    check_lobe(velvet, up, up, Vec3(0), 0);
    // Mirrored by the surface itself, too: the facet would have to lie flat.
    check_lobe(velvet, left, right, Vec3(0), 0);
}

TEST_CASE("velvet at angles by hand", "[11.20]") {
    const Velvet velvet{{1, 0.5, 0}, 1};
    // 60° and back: D = 16/(9π)·exp(−1/3), G = ½, 4·l.z·v.z = 1.
    check_lobe(velvet, right, right, Vec3(1, 0.5, 0) * (8 / (9 * pi) * std::exp(-1.0 / 3)), gamma(64));
    // 30° and back: cot² = 3, sin⁴ = 1/16, G = 1, 4·l.z·v.z = 3.
    check_lobe(velvet, steep, steep, Vec3(1, 0.5, 0) * (16 / (3 * pi) * std::exp(-3.0)), gamma(64));
    // 60° and 60° crosswise: l + v = (√3/2, √3/2, 1) of length √2.5, cot² = 2/3, sin⁴ = 0.36, G = 0.8.
    check_lobe(velvet, forth, right, Vec3(1, 0.5, 0) * (20 / (9 * pi) * std::exp(-2.0 / 3)), gamma(64));
    // 60° and 30°, σ = 1: h at 45°, D = 4/(π e); v·h = cos 15°, of l 2·√½·½/cos 15°, which is the lesser.
    const Real narrow = std::sqrt(0.5) / std::cos(radians(15));
    check_lobe(velvet, right, steep, Vec3(1, 0.5, 0) * (4 / (pi * std::exp(1.0)) * narrow / std::sqrt(3.0)),
               gamma(64));
}

TEST_CASE("below the surface velvet is 0", "[11.20]") { test::check_below(Velvet{Vec3(1), 0.7}); }

TEST_CASE("the density of velvet's directions by hand", "[11.20]") {
    // 60° and back: D·½/(4·½).
    check_pdf(right, right, 4 / (9 * pi) * std::exp(-1.0 / 3));
    // To the light 60°, to the viewer 30°: D = 4/(π e), of v 2·√½·(√3/2)/cos 15° is more than all, 4·v.z =
    // 2√3.
    check_pdf(right, steep, 2 / (pi * std::exp(1.0) * std::sqrt(3.0)));
}

TEST_CASE("nobody below the surface is shown velvet", "[11.21]") {
    test::check_nothing_drawn_below(Velvet{Vec3(1), 0.7});
}

TEST_CASE("velvet mirrors light by a facet", "[11.21]") {
    Random random(11160);
    int drawn = 0;
    for (int i = 0; i < cases(2000); ++i) {
        const Velvet velvet{{random.uniform(0, 1), 1, 0.5}, random.uniform(0.1, 1)};
        const Vec3 v = upper(random),
                   numbers(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
        INFO("roughness " << velvet.roughness << ", to the viewer " << v << ", random numbers " << numbers);
        const auto one = sample(velvet, v, numbers);
        if (!one) continue;
        ++drawn;
        const Vec3 l = one->to_light, expected = evaluate(velvet, l, v) * l.z;
        INFO("to the light " << l);
        CHECK(l.z > 0);
        CHECK(near(length(l), 1, gamma(12)));
        const Real bound = 2 * part(velvet.roughness, l, v) * (1 + one->pdf);
        CHECK(near(one->pdf, pdf(velvet, l, v), bound));
        CHECK(near_color(one->weight * one->pdf, expected, bound));
        CHECK(one->weight.y <= 1 + part(velvet.roughness, l, v));
    }
    INFO("of " << cases(2000)
               << " samples that were asked for, how many there are; some lead below the surface");
    CHECK(drawn >= test::demanded(cases(400), cases(200)));
}

TEST_CASE("directions from velvet are as dense as they claim", "[11.21]") {
    for (const Real roughness : {0.2, 0.5, 1.0})
        for (const Real angle : {0.0, 60.0, 85.0}) {
            const Velvet velvet{Vec3(1), roughness};
            const Vec3 v = towards(angle, 25);
            INFO("roughness " << roughness << ", the viewer " << angle << " degrees from the normal");
            const auto draw = [&](const Vec3& numbers) { return sample(velvet, v, numbers); };
            const auto density = [&](const Vec3& l) { return pdf(velvet, l, v); };
            test::check_report(
                test::compare_samples({chart_of(velvet, v)}, draw, density, cases(20000), 11161));
        }
}

TEST_CASE("velvet is the same with light and viewer exchanged", "[11.20]") {
    Random random(11162);
    for (int i = 0; i < cases(2000); ++i) {
        const Velvet velvet{{0.3, 0.6, 1}, random.uniform(0.1, 1)};
        const Vec3 l = upper(random), v = upper(random);
        INFO("roughness " << velvet.roughness << ", one direction " << l << ", the other " << v);
        const Vec3 f = evaluate(velvet, l, v);
        CHECK(near(f, evaluate(velvet, v, l), 2 * part(velvet.roughness, l, v) * f.z + 1e-300));
    }
}

TEST_CASE("velvet by angles, as in Cycles", "[11.20]") {
    Random random(11163);
    for (int i = 0; i < cases(2000); ++i) {
        const Velvet velvet{Vec3(1), random.uniform(0.1, 1)};
        const Vec3 l = upper(random), v = upper(random), h = normalize(l + v);
        // The angle from its cosine is wrong by a rounding over the sine: where facets lie flat all is 0.
        if (h.z > 0.999) continue;
        INFO("roughness " << velvet.roughness << ", to the light " << l << ", to the viewer " << v);
        const Real expected = cycles_velvet(velvet.roughness, l, v), sine = std::hypot(h.x, h.y);
        const Real bound = part(velvet.roughness, l, v) * (2 + 1 / sine) * expected + 1e-300;
        CHECK(near(evaluate(velvet, l, v).x * l.z, expected, bound));
    }
}

TEST_CASE("velvet returns no more light than it gets", "[11.20]") {
    // The midpoint rule on 64² cells errs by 2e-4 at most.
    for (const Real roughness : {0.1, 0.3, 0.6, 1.0}) {
        for (const Real angle : {0.0, 45.0, 80.0}) {
            INFO("roughness " << roughness << ", viewer " << angle << " degrees from the normal");
            CHECK(furnace({Vec3(1), roughness}, towards(angle), 64).x <= 1 + 2e-4);
        }
        // Who looks along the surface sees upper ends of facets alone, which hide nothing from the light.
        INFO("roughness " << roughness << ", viewer at the horizon");
        CHECK(near_color(furnace({Vec3(1), roughness}, test::at_cosine(1e-8), 64), Vec3(1), 2e-4));
    }
}
