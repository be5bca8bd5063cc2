// Steps 11.18 and 11.19: rough glass.
#include "chapters/11_textures/rough_glass.hpp"
#include "common/math/error.hpp"
#include "tests/11_textures/lobe_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::left;
using test::mirrored_by_angles;
using test::near;
using test::near_color;
using test::Random;
using test::right;
using test::towards;
using test::up;

namespace {

const Vec3 down{0, 0, -1};

/// 60 degrees from the normal, below, and what Snell makes of 60 degrees in glass of index 1.5: the sine is
/// (√3/2)/1.5 = 1/√3.
const Vec3 right_below{std::sqrt(0.75), 0, -0.5}, left_below{-std::sqrt(0.75), 0, -0.5};
const Vec3 bent{-std::sqrt(1.0 / 3), 0, -std::sqrt(2.0 / 3)};

/// White glass with α = 1/2 and n = 1.5.
const RoughGlass pane{Vec3(1), std::sqrt(0.5), 1.5};

/// G₁ at 60 degrees for α = 1/2.
const Real g1_right = 4 / (2 + std::sqrt(7.0));

/// Fresnel's reflected part at 60 degrees by n = 1.5, by hand: r⊥ = (½ − √1.5)/(½ + √1.5) and
/// r∥ = (¾ − √(2/3))/(¾ + √(2/3)).
Real mirrored_at_60() {
    const Real across = (0.5 - std::sqrt(1.5)) / (0.5 + std::sqrt(1.5));
    const Real along = (0.75 - std::sqrt(2.0 / 3)) / (0.75 + std::sqrt(2.0 / 3));
    return (across * across + along * along) / 2;
}

/// Walter and others' rough glass by tangents (2007, equations 20, 21, 33 and 34), without their n² of v's
/// side.
Real glass_by_tangents(const RoughGlass& glass, const Vec3& l, const Vec3& v) {
    const Real alpha = std::pow(glass.roughness, 2), n_l = l.z > 0 ? 1 : glass.ior,
               n_v = v.z > 0 ? 1 : glass.ior;
    Vec3 h = n_l == n_v ? l + v : n_l * l + n_v * v;
    const Real far = length(h);
    h *= (h.z > 0 ? 1 : -1) / far;
    const Real across_l = dot(l, h), across_v = dot(v, h);
    if (across_l * l.z <= 0 || across_v * v.z <= 0) return 0;
    const auto tangent = [](const Vec3& w) { return std::hypot(w.x, w.y) / std::abs(w.z); };
    const auto shadow = [&](const Vec3& w) { return 2 / (1 + std::hypot(1.0, alpha * tangent(w))); };
    const Real facets = std::pow(alpha / (h.z * h.z * (alpha * alpha + tangent(h) * tangent(h))), 2) / pi;
    const Real all = facets * shadow(l) * shadow(v) / std::abs(l.z * v.z);
    const Real mirrored = mirrored_by_angles(std::abs(across_v), n_v, n_v == 1 ? glass.ior : 1);
    if (n_l == n_v) return all * mirrored / 4;
    return all * (1 - mirrored) * std::abs(across_l * across_v) *
           std::pow(n_l / (n_l * across_l + n_v * across_v), 2);
}

/// What rounding may do to a lobe, as a part of it: the contract's.
Real part(const RoughGlass& glass, const Vec3& l, const Vec3& v) {
    const Real n_l = l.z > 0 ? 1 : glass.ior, n_v = v.z > 0 ? 1 : glass.ior;
    const Vec3 sum = n_l == n_v ? l + v : n_l * l + n_v * v;
    const Real s = length(sum), cos_l = dot(l, sum) / s, cos_v = dot(v, sum) / s,
               ratio = n_v / (1 + glass.ior - n_v);
    // Of the angle behind the facet, which counts where light is mirrored, too; less than 0 where all of it
    // is.
    const Real behind = std::abs(1 - ratio * ratio * (1 - cos_v * cos_v));
    const Real c_squared = std::min({cos_l * cos_l, cos_v * cos_v, behind});
    const Real alpha = std::pow(std::max(glass.roughness, least_roughness), 2);
    return gamma(64) + 64 * unit_roundoff / (alpha * s * c_squared);
}

std::vector<test::Chart> charts_of(const RoughGlass& glass, const Vec3& v) {
    const Real width = std::pow(std::max(glass.roughness, least_roughness), 2);
    const Real n_v = v.z > 0 ? 1 : glass.ior, n_l = v.z > 0 ? glass.ior : 1;
    return {test::mirrored_by_facets(width, v), test::bent_by_facets(width, v, n_v, n_l)};
}

Vec3 furnace(const RoughGlass& glass, const Vec3& v, int n) {
    Vec3 sum(0);
    for (const test::Chart& chart : charts_of(glass, v))
        sum += test::sum_over(chart, n, [&](const Vec3& l) { return evaluate(glass, l, v) * std::abs(l.z); });
    return sum;
}

/// An eye at `angle` degrees from the normal: from 90 on it is inside the glass.
Vec3 eye(Real angle) { return towards(angle, 25); }

void check_facet(const Vec3& l, const Vec3& v, const Vec3& expected) {
    INFO("glass of index 1.5, to the light " << l << ", to the viewer " << v);
    const std::optional<Vec3> h = glass_facet(pane, l, v);
    INFO("expected the facet's normal " << expected << ", actual " << h);
    REQUIRE(h.has_value());
    CHECK(near(*h, expected, gamma(32)));
}

void check_no_facet(const Vec3& l, const Vec3& v) {
    INFO("glass of index 1.5, to the light " << l << ", to the viewer " << v);
    const std::optional<Vec3> h = glass_facet(pane, l, v);
    INFO("expected nothing, actual " << h);
    CHECK_FALSE(h.has_value());
    CHECK(near(pdf(pane, l, v), 0, 0));
    CHECK(near_color(evaluate(pane, l, v), Vec3(0), 0));
}

void check_lobe(const Vec3& l, const Vec3& v, Real f) {
    INFO("white glass of index 1.5 with alpha 0.5, to the light " << l << ", to the viewer " << v);
    CHECK(near_color(evaluate(pane, l, v), Vec3(f), part(pane, l, v) * f));
}

}  // namespace

TEST_CASE("the facet that mirrors, outside and inside", "[11.18]") {
    check_facet(up, up, up);
    check_facet(left, right, up);
    check_facet(up, right, {0.5, 0, std::sqrt(0.75)});
    // Inside, its normal is up all the same.
    check_facet(down, down, up);
    check_facet(left_below, right_below, up);
    check_facet(down, left_below, {0.5, 0, std::sqrt(0.75)});
}

TEST_CASE("the facet that lets through", "[11.18]") {
    check_facet(down, up, up);
    check_facet(up, down, up);
    check_facet(bent, right, up);
    check_facet(right, bent, up);
    // v from above, l 30° on in the glass: −1.5·l − v = (−0.75, 0, 0.75√3 − 1), of which the slope is small.
    const Vec3 l(0.5, 0, -std::sqrt(0.75));
    const Vec3 sum(-0.75, 0, 1.5 * std::sqrt(0.75) - 1);
    check_facet(l, up, sum / std::sqrt(sum.x * sum.x + sum.z * sum.z));
}

TEST_CASE("no facet bends light that far, or is seen from behind", "[11.18]") {
    // On the same side of the normal, 60° above and 60° below.
    check_no_facet(right_below, right);
    check_no_facet(right, right_below);
    // Lying in the surface.
    check_no_facet({1, 0, 0}, up);
    check_no_facet(up, {1, 0, 0});
    check_no_facet({1, 0, 0}, down);
    check_no_facet(down, {1, 0, 0});
    // n_l·l + n_v·v points up: the facet would hang.
    check_no_facet({-std::sqrt(1 - 0.01), 0, -0.1}, {0.6, 0, 0.8});
    check_no_facet({0.6, 0, 0.8}, {-std::sqrt(1 - 0.01), 0, -0.1});
}

TEST_CASE("rough glass mirrors, by hand", "[11.18]") {
    // Straight F = 0.04 and D/4 = 1/π, on both sides.
    check_lobe(up, up, 0.04 / pi);
    check_lobe(down, down, 0.04 / pi);
    check_lobe(left, right, mirrored_at_60() * 4 / pi * g1_right * g1_right);
    // From straight above to 60°: at the facet both are 30°, D = 64/(49π), 4·l.z·v.z = 2, and Snell's sine is
    // 1/3.
    const Real cosine = std::sqrt(0.75), behind = std::sqrt(8.0) / 3;
    const Real across = (cosine - 1.5 * behind) / (cosine + 1.5 * behind);
    const Real along = (1.5 * cosine - behind) / (1.5 * cosine + behind);
    check_lobe(up, right, (across * across + along * along) / 2 * 32 / (49 * pi) * g1_right);
    // Inside, 60° is beyond the critical angle: all is mirrored.
    check_lobe(left_below, right_below, 4 / pi * g1_right * g1_right);
}

TEST_CASE("rough glass lets through, by hand", "[11.18]") {
    // Straight from outside: 0.96·D·1.5²/(1.5 − 1)² = 0.96·(4/π)·9; from inside without the 1.5².
    check_lobe(down, up, 34.56 / pi);
    check_lobe(up, down, 15.36 / pi);
    // 60° to Snell's direction: the cosines at the facet cancel those at the surface.
    const Real below = std::sqrt(2.0 / 3), g1_bent = 2 * below / (below + std::sqrt(0.75));
    const Real f =
        (1 - mirrored_at_60()) * 4 / pi * g1_right * g1_bent * std::pow(1.5 / (1.5 * below - 0.5), 2);
    check_lobe(bent, right, f);
    check_lobe(right, bent, f / 2.25);
}

TEST_CASE("coloured glass colours what it mirrors and what it lets through", "[11.18]") {
    const RoughGlass green{{0, 1, 0.5}, pane.roughness, 1.5};
    INFO("glass of colour (0, 1, 0.5), light and viewer straight above: what it mirrors");
    CHECK(near_color(evaluate(green, up, up), Vec3(0, 1, 0.5) * (0.04 / pi), gamma(128)));
    INFO("and with the light straight below: what it lets through");
    CHECK(near_color(evaluate(green, down, up), Vec3(0, 1, 0.5) * (34.56 / pi), gamma(128) * 12));
}

TEST_CASE("the density of rough glass's directions by hand", "[11.18]") {
    const auto check_pdf = [](const Vec3& l, const Vec3& v, Real expected, Real bound) {
        INFO("pdf for alpha 0.5 and index 1.5, to the light " << l << ", to the viewer " << v);
        CHECK(near(pdf(pane, l, v), expected, bound));
    };
    check_pdf(up, up, 0.04 / pi, gamma(64));
    check_pdf(down, up, 34.56 / pi, gamma(64) * 12);
    check_pdf(up, down, 15.36 / pi, gamma(64) * 5);
    // Of the viewer at 60°, with his G₁: 4·v.z = 2.
    check_pdf(left_below, right_below, 2 / pi * g1_right, gamma(128));
}

TEST_CASE("nearly smooth glass bends light as smooth glass does", "[11.19]") {
    const auto check_bent = [](const Vec3& v, const Vec3& expected) {
        INFO("roughness 0.001 and index 1.5, to the viewer " << v
                                                             << ", a number that lets through: to the light");
        const auto one = sample(RoughGlass{Vec3(1), 1e-3, 1.5}, v, {0.5, 0.5, 0.99});
        REQUIRE(test::or_say(one.has_value(), "nothing"));
        // Half of the facets lean by less than alpha, 1e-6.
        CHECK(test::near_direction(one->to_light, expected, 1e-4));
    };
    check_bent(right, bent);
    check_bent(bent, right);
}

TEST_CASE("rough glass, drawn by a facet", "[11.19]") {
    Random random(11150);
    int mirrored = 0, through = 0;
    for (int i = 0; i < cases(4000); ++i) {
        const RoughGlass glass{
            {random.uniform(0, 1), 1, 0.5}, random.uniform(0.1, 1), random.uniform(1.1, 2.5)};
        const Vec3 v = random.direction(),
                   numbers(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
        INFO("roughness " << glass.roughness << ", index " << glass.ior << ", to the viewer " << v
                          << ", random numbers " << numbers);
        const auto one = sample(glass, v, numbers);
        if (!one) continue;
        const Vec3 l = one->to_light, expected = evaluate(glass, l, v) * std::abs(l.z);
        INFO("to the light " << l);
        ++(l.z * v.z > 0 ? mirrored : through);
        CHECK(near(length(l), 1, gamma(12)));
        const Real bound = 2 * part(glass, l, v) * (1 + one->pdf);
        CHECK(near(one->pdf, pdf(glass, l, v), bound));
        CHECK(near_color(one->weight * one->pdf, expected, bound));
        CHECK(one->weight.y <= 1 + part(glass, l, v));
    }
    INFO("of " << cases(4000) << " samples that were asked for, how many mirror the light");
    CHECK(mirrored >= test::demanded(cases(400), cases(200)));
    INFO("and how many let it through: all the others should, but those whose facet is turned away");
    CHECK(through >= test::demanded(cases(1000), cases(500)));
}

TEST_CASE("directions from rough glass are as dense as they claim", "[11.19]") {
    for (const Real roughness : {0.2, 0.6})
        for (const Real angle : {0.0, 60.0, 85.0, 105.0, 145.0, 180.0}) {
            const RoughGlass glass{Vec3(1), roughness, 1.5};
            const Vec3 v = eye(angle);
            INFO("roughness " << roughness << ", index 1.5, the viewer " << angle
                              << " degrees from the normal");
            const auto draw = [&](const Vec3& numbers) { return sample(glass, v, numbers); };
            const auto density = [&](const Vec3& l) { return pdf(glass, l, v); };
            test::check_report(
                test::compare_samples(charts_of(glass, v), draw, density, cases(20000), 11151));
        }
}

TEST_CASE("rough glass with light and viewer exchanged is another by n squared", "[11.18]") {
    Random random(11152);
    for (int i = 0; i < cases(4000); ++i) {
        const RoughGlass glass{{0.3, 0.6, 1}, random.uniform(0.1, 1), random.uniform(1.1, 2.5)};
        const Vec3 l = random.direction(), v = random.direction();
        INFO("roughness " << glass.roughness << ", index " << glass.ior << ", one direction " << l
                          << ", the other " << v);
        const Real n_l = l.z > 0 ? 1 : glass.ior, n_v = v.z > 0 ? 1 : glass.ior;
        const Vec3 there = evaluate(glass, l, v) / (n_l * n_l), back = evaluate(glass, v, l) / (n_v * n_v);
        // On one side alone rounding may see no facet: then the other sees next to nothing.
        if (there.z == 0 || back.z == 0) continue;
        CHECK(near(there, back, 2 * part(glass, l, v) * there.z));
    }
}

TEST_CASE("rough glass by tangents, as Walter and others wrote it", "[11.18]") {
    Random random(11153);
    for (int i = 0; i < cases(4000); ++i) {
        const RoughGlass glass{{1, 0.5, 0}, random.uniform(0.1, 1), random.uniform(1.1, 2.5)};
        const Vec3 l = random.direction(), v = random.direction();
        const Real bound = part(glass, l, v);
        // Within some roundings of what no facet can do the oracle's angles are no better.
        if (bound > 1e-9) continue;
        INFO("roughness " << glass.roughness << ", index " << glass.ior << ", to the light " << l
                          << ", to the viewer " << v);
        const Real expected = glass_by_tangents(glass, l, v);
        CHECK(near_color(evaluate(glass, l, v), Vec3(1, 0.5, 0) * expected, 1e-8 * expected));
    }
}

TEST_CASE("rough glass returns no more light than it gets", "[11.18]") {
    for (const Real roughness : {0.1, 0.4, 1.0})
        for (const Real angle : {0.0, 45.0, 80.0, 100.0, 135.0, 180.0}) {
            INFO("roughness " << roughness << ", index 1.5, viewer " << angle << " degrees from the normal");
            CHECK(furnace({Vec3(1), roughness, 1.5}, eye(angle), 64).x <= 1 + 2e-3);
        }
    // Nearly smooth, it loses nearly nothing.
    INFO("what glass of roughness 0.05 and index 1.5 returns of an even light, seen from straight above");
    CHECK(near(furnace({Vec3(1), 0.05, 1.5}, up, 64).x, 1, 2e-3));
    INFO("and seen from below, 60 degrees from the normal");
    CHECK(near(furnace({Vec3(1), 0.05, 1.5}, right_below, 64).x, 1, 2e-3));
}
