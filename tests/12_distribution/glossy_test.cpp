// Steps 12.16, 12.17 and 12.23: directions around an axis, and the successor course's glossy surfaces.
#include "chapters/12_distribution/glossy.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/glossy_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"
#include "tests/together.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::near;
using test::near_color;
using test::Random;
using test::towards;

namespace {

const Vec3 up{0, 0, 1};

/// Directions 60 degrees from the normal, by hand, on either side.
const Vec3 right{std::sqrt(3.0) / 2, 0, 0.5}, left{-std::sqrt(3.0) / 2, 0, 0.5};

/// Grey surfaces: of the light 0.3 matte, 0.6 in the highlight; and GGX's with α = ½.
const ModifiedPhong plastic{Vec3(0.3), Vec3(0.6), 10};
const DiffuseGgx satin{Vec3(0.2), Vec3(0.6), 0.5};

Vec3 three(Random& random) {
    const Real x = random.uniform(0, 1), y = random.uniform(0, 1), z = random.uniform(0, 1);
    return {x, y, z};
}

/// What `lobe` returns of an even light of 1 from everywhere, on a chart of directions.
template <class Lobe>
Vec3 furnace(const Lobe& lobe, const Vec3& v, const test::Chart& chart, int n) {
    return test::sum_over(chart, n, [&](const Vec3& l) { return evaluate(lobe, l, v) * std::max(l.z, 0.0); });
}

/// D·G₁·G₁/(4·l.z·v.z) by tangents, as the successor course writes it.
Real facets_by_tangent(Real alpha, const Vec3& l, const Vec3& v) {
    const auto tangent2 = [](const Vec3& w) { return (w.x * w.x + w.y * w.y) / (w.z * w.z); };
    const auto g = [&](const Vec3& w) { return 2 / (1 + std::sqrt(1 + alpha * alpha * tangent2(w))); };
    const Vec3 h = normalize(l + v);
    const Real d = alpha / (h.z * h.z * (alpha * alpha + tangent2(h)));
    return d * d / pi * g(l) * g(v) / (4 * l.z * v.z);
}

/// What rounding may do to a lobe of GGX, as a part of it: the contract's.
Real part(Real alpha, const Vec3& l, const Vec3& v) {
    return gamma(32) + 16 * unit_roundoff / (alpha * length(l + v));
}

}  // namespace

TEST_CASE("the density around an axis by hand", "[12.16]") {
    INFO("60 degrees from the axis, where the cosine is 1/2");
    CHECK(near(around_axis_pdf(up, 3, right), 1 / (4 * pi), gamma(64)));
    INFO("then for the exponents 1, 0 and 2");
    CHECK(near(around_axis_pdf(up, 1, right), 0.5 / pi, gamma(64)));
    CHECK(near(around_axis_pdf(up, 0, right), 0.5 / pi, gamma(64)));
    CHECK(near(around_axis_pdf(right, 2, up), 0.375 / pi, gamma(64)));
    INFO("then on the axis: (s + 1)/(2π)");
    CHECK(near(around_axis_pdf(left, 99, left), 50 / pi, gamma(100) * 50));
}

TEST_CASE("behind the axis there is nothing", "[12.16]") {
    for (const Real exponent : {0.0, 1.0, 2.0, 2.5, 10.0}) {
        INFO("exponent " << exponent << ", axis " << up << ", direction " << Vec3(right.x, 0, -0.5));
        CHECK(near(around_axis_pdf(up, exponent, {right.x, 0, -0.5}), 0, 0));
        CHECK(near(around_axis_pdf(up, exponent, -up), 0, 0));
    }
}

TEST_CASE("half of the directions are within the angle that halves the lobe", "[12.16]") {
    // cos^(s + 1) is uniform: it is more than 1/2 for half of them.
    for (const Real exponent : {0.0, 1.0, 3.0, 100.0})
        for (const Vec3& axis : {up, right, Vec3(0, 1, 0)}) {
            int within = 0;
            test::together(1024, [&](std::size_t i) {
                const Vec2 numbers((static_cast<Real>(i / 32) + 0.5) / 32,
                                   (static_cast<Real>(i % 32) + 0.5) / 32);
                const Vec3 drawn = around_axis(axis, exponent, numbers);
                within += std::pow(dot(drawn, axis), exponent + 1) > 0.5;
            });
            INFO("exponent " << exponent << ", axis " << axis << ": of 1024 directions " << within
                             << " are within");
            CHECK(std::abs(within - 512) <= 64);
        }
}

TEST_CASE("directions around any axis are unit vectors, on its side", "[12.16]") {
    Random random(121601);
    const Vec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int i = 0; i < cases(3000); ++i) {
        const Vec3 any = random.direction();
        const Vec3 axis = i % 2 == 0 ? axes[i / 2 % 6] : any;
        const Real exponent = random.index(4) == 0 ? 0 : random.magnitude(-1, 8);
        const Vec3 numbers = three(random);
        INFO("axis " << axis << ", exponent " << exponent << ", random numbers " << Vec2(numbers));
        const Vec3 drawn = around_axis(axis, exponent, {numbers.x, numbers.y});
        CHECK(near(length(drawn), 1, gamma(24)));
        CHECK(dot(drawn, axis) >= -gamma(24));
    }
}

TEST_CASE("directions around an axis are as dense as they claim", "[12.16]") {
    for (const Real exponent : {0.0, 1.0, 7.5})
        for (const Vec3& axis : {-up, towards(70, 40)}) {
            INFO("exponent " << exponent << ", axis " << axis);
            const auto draw = [&](const Vec3& numbers) {
                const Vec3 drawn = around_axis(axis, exponent, {numbers.x, numbers.y});
                return std::optional<LobeSample>(LobeSample{drawn, Vec3(1), 1});
            };
            const auto density = [&](const Vec3& l) { return around_axis_pdf(axis, exponent, l); };
            const test::Chart chart = test::around(axis, exponent, false);
            CHECK(near(test::sum_over(chart, 64, density), 1, 1e-3));
            test::check_report(test::compare_samples({chart}, draw, density, cases(20000), 121602));
        }
}

TEST_CASE("what part of the directions Phong's highlight gets", "[12.17]") {
    INFO("diffuse 0.3 and specular 0.6");
    CHECK(near(highlight_part(plastic), 2 / 3.0, gamma(16)));
    INFO("of colours the mean counts");
    CHECK(near(highlight_part(ModifiedPhong{{0.3, 0, 0}, {0, 0.3, 0.6}, 1}), 0.75, gamma(16)));
    INFO("a surface that is only matte, and one that is only a highlight");
    CHECK(near(highlight_part(ModifiedPhong{Vec3(0.5), Vec3(0), 1}), 0, 0));
    CHECK(near(highlight_part(ModifiedPhong{Vec3(0), Vec3(0.5), 1}), 1, 0));
    INFO("a black surface");
    CHECK(near(highlight_part(ModifiedPhong{Vec3(0), Vec3(0), 1}), 0, 0));
}

TEST_CASE("Phong's highlight by hand", "[12.17]") {
    // The light where a mirror sees it: 0.3/π + 0.6·12/(2π) = 3.9/π.
    INFO("diffuse 0.3, specular 0.6, exponent 10, to the light " << left << ", to the viewer " << right);
    CHECK(near_color(evaluate(plastic, left, right), Vec3(3.9 / pi), gamma(256)));
    // A third of 0.5/π and two thirds of 11/(2π).
    CHECK(near(pdf(plastic, left, right), 23 / (6 * pi), gamma(256)));
    // From above it is 60 degrees off: 2^-10.
    INFO("then to the light " << up);
    CHECK(near_color(evaluate(plastic, up, right), Vec3((0.3 + 3.6 / 1024) / pi), gamma(64)));
    CHECK(near(pdf(plastic, up, right), (1 + 11 / 1024.0) / (3 * pi), gamma(64)));
    // Back to the viewer it is 120 degrees off: no highlight, also for an even power.
    INFO("then to the light " << right);
    CHECK(near_color(evaluate(plastic, right, right), Vec3(0.3 / pi), gamma(64)));
    CHECK(near(pdf(plastic, right, right), 1 / (6 * pi), gamma(64)));
    INFO("then in colour");
    CHECK(near_color(evaluate(ModifiedPhong{{0.1, 0.2, 0.3}, {0.6, 0.3, 0}, 10}, left, right),
                     Vec3(3.7, 2.0, 0.3) / pi, gamma(256)));
}

TEST_CASE("below the surface Phong's is 0", "[12.17]") {
    for (const Vec3& below : {Vec3(0, 0, -1), Vec3(right.x, 0, -0.5), Vec3(1, 0, 0), Vec3(-1, 0, 0)}) {
        INFO("one direction is " << below << ", the other " << right);
        CHECK(near_color(evaluate(plastic, below, right), Vec3(0), 0));
        CHECK(near_color(evaluate(plastic, right, below), Vec3(0), 0));
        CHECK(near(pdf(plastic, below, right), 0, 0));
        CHECK(near(pdf(plastic, right, below), 0, 0));
        CHECK_FALSE(sample(plastic, below, Vec3(0.25)).has_value());
    }
}

TEST_CASE("a sample of Phong's is weighed by both ways together", "[12.17]") {
    Random random(121701);
    int drawn = 0;
    for (int i = 0; i < cases(3000); ++i) {
        const Vec3 diffuse = random.index(4) == 0 ? Vec3(0) : random.uniform(0, 1) * Vec3(1, 0.5, 0);
        const Vec3 specular = random.index(4) == 0 ? Vec3(0) : random.uniform(0, 1) * Vec3(0.5, 1, 0);
        const ModifiedPhong phong{diffuse, specular, random.magnitude(-1, 3)};
        const Real s = phong.exponent;
        const Vec3 v = upper(random), numbers = three(random);
        INFO("diffuse " << phong.diffuse << ", specular " << phong.specular << ", exponent " << s
                        << ", to the viewer " << v << ", random numbers " << numbers);
        const auto one = sample(phong, v, numbers);
        if (!one) continue;
        ++drawn;
        const Vec3 l = one->to_light;
        INFO("to the light " << l);
        CHECK(l.z > 0);
        CHECK(near(length(l), 1, gamma(24)));
        const Real density = pdf(phong, l, v), bound = gamma(64) * (1 + s);
        CHECK(near(one->pdf, density, bound * density));
        const Vec3 expected = evaluate(phong, l, v) * l.z;
        CHECK(near_color(one->weight * one->pdf, expected, 2 * bound * max_component(expected)));
        const Real share = highlight_part(phong);
        for (int c = 0; c < 3; ++c) {
            const Real matte = phong.diffuse[c] > 0 ? phong.diffuse[c] / (1 - share) : 0;
            const Real shiny = phong.specular[c] > 0 ? phong.specular[c] / share * (s + 2) / (s + 1) : 0;
            CHECK(one->weight[c] <= (matte + shiny) * (1 + bound));
        }
    }
    INFO("of " << cases(3000)
               << " samples that were asked for, how many there are; some lead below the surface");
    CHECK(drawn >= test::demanded(cases(1500), cases(800)));
}

TEST_CASE("directions from Phong's surface are as dense as they claim", "[12.17]") {
    const ModifiedPhong surfaces[] = {
        plastic, {Vec3(0.5), Vec3(0), 5}, {Vec3(0), Vec3(0.5), 1}, {Vec3(0.8), Vec3(0.1), 20}};
    for (const ModifiedPhong& phong : surfaces)
        for (const Real angle : {0.0, 70.0}) {
            const Vec3 v = towards(angle, 25);
            INFO("diffuse " << phong.diffuse << ", specular " << phong.specular << ", exponent "
                            << phong.exponent << ", the viewer " << angle << " degrees from the normal");
            const auto draw = [&](const Vec3& numbers) { return sample(phong, v, numbers); };
            const auto density = [&](const Vec3& l) { return pdf(phong, l, v); };
            test::check_report(test::compare_samples({test::dome()}, draw, density, cases(20000), 121703));
        }
}

TEST_CASE("Phong's surface is the same with light and viewer exchanged", "[12.17]") {
    Random random(121705);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 l = upper(random), v = upper(random);
        const ModifiedPhong phong{{0.1, 0.2, 0.3}, {0.6, 0.4, 0.2}, random.magnitude(0, 3)};
        INFO("exponent " << phong.exponent << ", one direction " << l << ", the other " << v);
        const Vec3 f = evaluate(phong, l, v);
        CHECK(near(f, evaluate(phong, v, l), gamma(32) * (1 + phong.exponent) * max_component(f)));
    }
}

TEST_CASE("what Phong's surface returns of an even light", "[12.17]") {
    // Straight from above diffuse + specular. The midpoint rule errs by less than 1e-3.
    const ModifiedPhong blue{Vec3(0.3, 0, 0.5), Vec3(0.6, 1, 0), 10};
    {
        INFO("diffuse (0.3, 0, 0.5), specular (0.6, 1, 0), exponent 10, the viewer above");
        CHECK(near_color(furnace(blue, up, test::dome(), 128), Vec3(0.9, 1, 0.5), 1e-3));
    }
    for (const Real exponent : {0.0, 1.0, 10.0, 5000.0}) {
        INFO("exponent " << exponent << ", the viewer above, the ground black");
        const ModifiedPhong shiny{Vec3(0), Vec3(0.6, 1, 0), exponent};
        CHECK(near_color(furnace(shiny, up, test::around(up, exponent), 64), Vec3(0.6, 1, 0), 1e-3));
    }
    // For s = 1 the integral of two cosines that are θ apart is ⅔(sin θ + (π − θ)·cos θ).
    for (const Real angle : {30.0, 60.0, 89.0}) {
        INFO("exponent 1, the viewer " << angle << " degrees from the normal");
        const Real theta = radians(angle), expected = (std::sin(theta) + (pi - theta) * std::cos(theta)) / pi;
        const ModifiedPhong shiny{Vec3(0), Vec3(1), 1};
        CHECK(near_color(furnace(shiny, towards(angle, 10), test::dome(), 128), Vec3(expected), 1e-3));
    }
}

TEST_CASE("Phong's surface returns no more light than it gets", "[12.17]") {
    for (const Real angle : {0.0, 45.0, 80.0, 89.0})
        for (const Real exponent : {0.0, 1.0, 10.0, 100.0}) {
            INFO("exponent " << exponent << ", the viewer " << angle << " degrees from the normal");
            const Vec3 v = towards(angle, 10);
            CHECK(furnace(ModifiedPhong{Vec3(0.4), Vec3(0.6), exponent}, v, test::dome(), 128).x <= 1 + 5e-3);
        }
}

// 12.23 --------------------------------------------------------------------------------------------------

TEST_CASE("what part of the directions the facets get", "[12.23]") {
    INFO("diffuse 0.2 and specular 0.6");
    CHECK(near(highlight_part(satin), 0.75, gamma(16)));
    INFO("facets get at least a quarter");
    CHECK(near(highlight_part(DiffuseGgx{Vec3(0.5), Vec3(0), 1}), 0.25, 0));
    CHECK(near(highlight_part(DiffuseGgx{Vec3(0.9), Vec3(0.1), 1}), 0.25, 0));
    INFO("a black surface");
    CHECK(near(highlight_part(DiffuseGgx{Vec3(0), Vec3(0), 1}), 1, 0));
}

TEST_CASE("satin by hand", "[12.23]") {
    // h is the normal, D = 4/π, G₁ = 4/(2 + √7) twice, 4·l.z·v.z = 1; F = 0.6 + 0.4/32.
    const Real g1 = 4 / (2 + std::sqrt(7.0));
    INFO("alpha 0.5, to the light " << left << ", to the viewer " << right);
    CHECK(near_color(evaluate(satin, left, right), Vec3((0.2 + 2.45 * g1 * g1) / pi), gamma(64)));
    // A quarter of 0.5/π; three quarters of D/(4·½).
    CHECK(near(pdf(satin, left, right), 1.625 / pi, gamma(64)));
    INFO("then straight up and back: D/4 = 1/π, F = 0.6");
    CHECK(near_color(evaluate(satin, up, up), Vec3(0.8 / pi), gamma(64)));
    CHECK(near(pdf(satin, up, up), 1 / pi, gamma(64)));
    // Even a black one reflects: F = 1/32.
    INFO("then black, to the light " << left << ", to the viewer " << right);
    CHECK(near_color(evaluate(DiffuseGgx{Vec3(0), Vec3(0), 0.5}, left, right), Vec3(g1 * g1 / (8 * pi)),
                     gamma(64)));
    CHECK(near(pdf(DiffuseGgx{Vec3(0), Vec3(0), 0.5}, left, right), 2 / pi, gamma(64)));
}

TEST_CASE("below the surface satin is 0", "[12.23]") {
    for (const Vec3& below : {Vec3(0, 0, -1), Vec3(right.x, 0, -0.5), Vec3(1, 0, 0), Vec3(-1, 0, 0)}) {
        INFO("one direction is " << below << ", the other " << right);
        CHECK(near_color(evaluate(satin, below, right), Vec3(0), 0));
        CHECK(near_color(evaluate(satin, right, below), Vec3(0), 0));
        CHECK(near(pdf(satin, below, right), 0, 0));
        CHECK(near(pdf(satin, right, below), 0, 0));
        CHECK_FALSE(sample(satin, below, Vec3(0.25)).has_value());
    }
}

TEST_CASE("a sample of satin is weighed by both ways together", "[12.23]") {
    Random random(121702);
    int drawn = 0;
    for (int i = 0; i < cases(3000); ++i) {
        const Vec3 diffuse = random.index(4) == 0 ? Vec3(0) : random.uniform(0, 1) * Vec3(1, 0.5, 0);
        const Vec3 specular = random.index(4) == 0 ? Vec3(0) : random.uniform(0, 1) * Vec3(0.5, 1, 0);
        const DiffuseGgx ggx{diffuse, specular, random.uniform(0.02, 1)};
        const Vec3 v = upper(random), numbers = three(random);
        INFO("diffuse " << ggx.diffuse << ", specular " << ggx.specular << ", alpha " << ggx.roughness
                        << ", to the viewer " << v << ", random numbers " << numbers);
        const auto one = sample(ggx, v, numbers);
        if (!one) continue;
        ++drawn;
        const Vec3 l = one->to_light;
        INFO("to the light " << l);
        CHECK(l.z > 0);
        CHECK(near(length(l), 1, gamma(24)));
        const Real density = pdf(ggx, l, v), bound = 4 * part(ggx.roughness, l, v);
        CHECK(near(one->pdf, density, bound * density));
        const Real white = facets_by_tangent(ggx.roughness, l, v) + 1 / pi;
        CHECK(near_color(one->weight * one->pdf, evaluate(ggx, l, v) * l.z, bound * white));
    }
    INFO("of " << cases(3000)
               << " samples that were asked for, how many there are; some lead below the surface");
    CHECK(drawn >= test::demanded(cases(1500), cases(800)));
}

TEST_CASE("directions from satin are as dense as they claim", "[12.23]") {
    const DiffuseGgx surfaces[] = {
        satin, {Vec3(0.9), Vec3(0), 0.4}, {Vec3(0), Vec3(0.5), 1}, {Vec3(0), Vec3(0), 0.6}};
    for (const DiffuseGgx& ggx : surfaces)
        for (const Real angle : {0.0, 70.0}) {
            const Vec3 v = towards(angle, 25);
            INFO("diffuse " << ggx.diffuse << ", specular " << ggx.specular << ", alpha " << ggx.roughness
                            << ", the viewer " << angle << " degrees from the normal");
            const auto draw = [&](const Vec3& numbers) { return sample(ggx, v, numbers); };
            const auto density = [&](const Vec3& l) { return pdf(ggx, l, v); };
            test::check_report(test::compare_samples({test::dome()}, draw, density, cases(20000), 121704));
        }
}

TEST_CASE("satin is the same with light and viewer exchanged", "[12.23]") {
    Random random(122305);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 l = upper(random), v = upper(random);
        const DiffuseGgx ggx{{0.1, 0.2, 0.3}, {0.6, 0.4, 0.2}, random.uniform(0.05, 1)};
        INFO("alpha " << ggx.roughness << ", one direction " << l << ", the other " << v);
        CHECK(near(evaluate(ggx, l, v), evaluate(ggx, v, l),
                   2 * part(ggx.roughness, l, v) * (facets_by_tangent(ggx.roughness, l, v) + 1)));
    }
}

TEST_CASE("GGX by tangents, as the successor course writes it", "[12.23]") {
    Random random(121706);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 l = upper(random), v = upper(random);
        const DiffuseGgx ggx{Vec3(0.5, 0.2, 0), Vec3(1, 0.5, 0), random.uniform(0.05, 1)};
        INFO("alpha " << ggx.roughness << ", to the light " << l << ", to the viewer " << v);
        const Real white = facets_by_tangent(ggx.roughness, l, v),
                   missing = std::pow(1 - dot(l, normalize(l + v)), 5);
        const Vec3 expected = ggx.diffuse / pi + white * Vec3(1, 0.5 + 0.5 * missing, missing);
        CHECK(near_color(evaluate(ggx, l, v), expected, 2 * part(ggx.roughness, l, v) * (white + 1)));
    }
}

TEST_CASE("facets over a black ground return no more light than they get", "[12.23]") {
    for (const Real angle : {0.0, 45.0, 80.0, 89.0})
        for (const Real alpha : {0.05, 0.3, 1.0}) {
            INFO("alpha " << alpha << ", the viewer " << angle << " degrees from the normal");
            const Vec3 v = towards(angle, 10);
            const test::Chart chart = test::mirrored_by_facets(alpha, v);
            CHECK(furnace(DiffuseGgx{Vec3(0), Vec3(1), alpha}, v, chart, 64).x <= 1 + 2e-3);
        }
    // Straight from above with α = 1: 1 − ln 2, as for rough metal. The matte ground adds its colour.
    const test::Chart chart = test::mirrored_by_facets(1, up);
    INFO("facets with alpha 1 over a ground of 0.3, seen from straight above: 0.3 + 1 - ln 2");
    CHECK(near(furnace(DiffuseGgx{Vec3(0.3), Vec3(1), 1}, up, chart, 64).x, 1.3 - std::log(2.0), 2e-3));
}
