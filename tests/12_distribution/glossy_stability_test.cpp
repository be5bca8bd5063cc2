// Steps 12.16, 12.17 and 12.23 with narrow lobes, smooth surfaces and grazing viewers.
#include "chapters/12_distribution/glossy.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/glossy_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <numbers>

using namespace rt;
using test::at_cosine;
using test::cases;
using test::near;
using test::Random;
using test::towards;

namespace {

using Long = long double;

constexpr Real last = 1 - 0x1p-53;

constexpr Long whole_pi = std::numbers::pi_v<Long>;

/// White facets in long double: the lobe, and the density of the directions that they mirror.
struct Facets {
    Real lobe = 0;
    Real density = 0;
};

Facets exact_facets(Real alpha, const Vec3& l, const Vec3& v) {
    const Long x = Long(l.x) + v.x, y = Long(l.y) + v.y, z = Long(l.z) + v.z;
    const Long slope = (x * x + y * y) / (z * z), square = Long(alpha) * alpha, secant = 1 + slope;
    const auto seen = [&](const Vec3& w) {
        const Long tangent = (Long(w.x) * w.x + Long(w.y) * w.y) / (Long(w.z) * w.z);
        return 2 / (1 + std::sqrt(1 + square * tangent)) / w.z;
    };
    const Long slopes = 1 + slope / square, normals = secant * secant / (whole_pi * square * slopes * slopes);
    // h.z/(4·l·h), where h is the sum over its size, and l·h half of that size.
    const Long mirrored = z / (2 * (x * x + y * y + z * z));
    return {static_cast<Real>(normals * seen(l) * seen(v) / 4), static_cast<Real>(normals * mirrored)};
}

/// What a sample must be, if there is one.
void check_usable(const std::optional<LobeSample>& one) {
    if (!one) return;
    CHECK(test::is_valid(one->weight));
    CHECK(one->to_light.z > 0);
    CHECK(near(length(one->to_light), 1, gamma(24)));
    CHECK((one->pdf > 0 && std::isfinite(one->pdf)));
}

}  // namespace

TEST_CASE("the narrowest lobes are as dense as they claim", "[12.16][stability]") {
    for (const Real exponent : {1e5, 1e8})
        for (const Vec3& axis : {Vec3(0, 0, -1), towards(120, 33)}) {
            INFO("exponent " << exponent << ", axis " << axis);
            const auto draw = [&](const Vec3& numbers) {
                const Vec3 drawn = around_axis(axis, exponent, {numbers.x, numbers.y});
                return std::optional<LobeSample>(LobeSample{drawn, Vec3(1), 1});
            };
            const auto density = [&](const Vec3& l) { return around_axis_pdf(axis, exponent, l); };
            const test::Chart chart = test::around(axis, exponent, false);
            CHECK(near(test::sum_over(chart, 64, density), 1, 1e-3));
            test::check_report(test::compare_samples({chart}, draw, density, cases(20000), 121610));
        }
}

TEST_CASE("directions from extreme random numbers", "[12.16][stability]") {
    for (const Real a : {0.0, 1e-300, 1e-10, 0.5, last})
        for (const Real b : {0.0, 1e-300, 0.25, 0.75, last})
            for (const Real exponent : {0.0, 1e-300, 1.0, 1e8})
                for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1), at_cosine(1e-8)}) {
                    INFO("random numbers " << a << ", " << b << ", exponent " << exponent << ", axis "
                                           << axis);
                    const Vec3 drawn = around_axis(axis, exponent, {a, b});
                    CHECK(near(length(drawn), 1, gamma(24)));
                    CHECK(dot(drawn, axis) >= -gamma(24));
                    CHECK(test::is_valid(Vec3(around_axis_pdf(axis, exponent, drawn))));
                }
}

TEST_CASE("densities around an axis in long double", "[12.16][stability]") {
    Random random(121611);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 axis = random.direction(), across = random.perpendicular_to(axis);
        const Real exponent = random.magnitude(-3, 8), angle = random.magnitude(-8, 0) * 1.57;
        const Vec3 l = std::cos(angle) * axis + std::sin(angle) * across;
        INFO("axis " << axis << ", exponent " << exponent << ", direction " << l);
        const Long cosine = Long(l.x) * axis.x + Long(l.y) * axis.y + Long(l.z) * axis.z;
        const Long expected = std::exp(exponent * std::log(cosine)) * (1 + Long(exponent)) / 2 / whole_pi;
        const Real bound = gamma(8) * (1 + exponent / static_cast<Real>(cosine));
        CHECK(near(around_axis_pdf(axis, exponent, l), static_cast<Real>(expected),
                   bound * static_cast<Real>(expected) + 1e-300));
    }
}

TEST_CASE("Phong's surface with narrow highlights and grazing viewers", "[12.17][stability]") {
    Random random(121710);
    for (int i = 0; i < cases(5000); ++i) {
        const ModifiedPhong phong{Vec3(0.3), Vec3(0.6), random.magnitude(-3, 8)};
        const Real s = phong.exponent, z = random.magnitude(-8, 0), turn = random.uniform(0, 360);
        const Vec3 v = at_cosine(z, turn), aside = random.direction();
        const Vec3 near_mirror = normalize(Vec3(-v.x, -v.y, v.z) + random.magnitude(-6, 0) * aside);
        const Real other = random.magnitude(-8, 0);
        const Vec3 l = i % 2 == 0 ? near_mirror : at_cosine(other, random.uniform(0, 360));
        if (!(l.z > 0)) continue;
        INFO("exponent " << s << ", to the light " << l << ", to the viewer " << v);
        const Long cosine = Long(l.z) * v.z - Long(l.x) * v.x - Long(l.y) * v.y;
        const Long power = cosine > 0 ? std::exp(s * std::log(cosine)) / whole_pi : 0;
        const Real bound = gamma(16) * (cosine > 0 ? 1 + s / static_cast<Real>(cosine) : 1);
        const Real shine = static_cast<Real>(0.3L * (s + 2) * power);
        const Real chance = static_cast<Real>((s + 1) * power / 3);
        const Real matte = 0.3 / pi, ground = l.z / (3 * pi);
        CHECK(near(evaluate(phong, l, v).x, matte + shine, gamma(16) * matte + bound * shine));
        CHECK(near(pdf(phong, l, v), ground + chance, gamma(16) * ground + bound * chance));
    }
}

TEST_CASE("facets nearly smooth and near the horizon", "[12.23][stability]") {
    Random random(121711);
    for (int i = 0; i < cases(5000); ++i) {
        const DiffuseGgx white{Vec3(0), Vec3(1), random.magnitude(-8, 0)};
        const Real alpha = white.roughness, z = random.magnitude(-8, 0), turn = random.uniform(0, 360);
        const Vec3 v = at_cosine(z, turn);
        const Real tilt = alpha * random.magnitude(-2, 2), other = random.magnitude(-8, 0);
        const Vec3 near_mirror = normalize(Vec3(-v.x, -v.y, v.z) + tilt * random.in_cube());
        const Vec3 l = i % 3 == 0 ? near_mirror : i % 3 == 1 ? v : at_cosine(other, random.uniform(0, 360));
        if (!(l.z > 0)) continue;
        INFO("alpha " << alpha << ", to the light " << l << ", to the viewer " << v);
        const Vec3 f = evaluate(white, l, v);
        REQUIRE(test::is_valid(f));
        const Facets expected = exact_facets(alpha, l, v);
        const Real size = length(l + v), bound = gamma(32) + 16 * unit_roundoff / (alpha * size);
        CHECK(near(f.x, expected.lobe, bound * expected.lobe));
        const Real more = bound + 16 * unit_roundoff / (size * size);
        if (more < 1) CHECK(near(pdf(white, l, v), expected.density, more * expected.density));
    }
}

TEST_CASE("samples of Phong's surface from extreme random numbers", "[12.17][stability]") {
    const Vec3 grey(0.5), black(0);
    for (const Real a : {0.0, 1e-300, 1e-10, 0.5, last})
        for (const Real b : {0.0, 0.25, 0.75, last})
            for (const Real c : {0.0, 0.5, last})
                for (const Real cosine : {1e-6, 1e-3, 0.5, 1.0})
                    for (const Real size : {0.0, 1.0, 1e4, 1e8})
                        for (const int colours : {0, 1, 2, 3}) {
                            const Vec3 diffuse = colours % 2 == 0 ? black : grey;
                            const Vec3 specular = colours < 2 ? black : grey;
                            const Vec3 v = at_cosine(cosine, 30), numbers(a, b, c);
                            INFO("diffuse " << diffuse << ", specular " << specular << ", exponent " << size
                                            << ", random numbers " << numbers << ", to the viewer " << v);
                            check_usable(sample(ModifiedPhong{diffuse, specular, size}, v, numbers));
                        }
}

TEST_CASE("samples of facets over a ground from extreme random numbers", "[12.23][stability]") {
    const Vec3 grey(0.5), black(0);
    for (const Real a : {0.0, 1e-300, 1e-10, 0.5, last})
        for (const Real b : {0.0, 0.25, 0.75, last})
            for (const Real c : {0.0, 0.5, last})
                for (const Real cosine : {1e-6, 1e-3, 0.5, 1.0})
                    for (const Real size : {0.0, 1e-8, 1e-4, 1.0})
                        for (const int colours : {0, 1, 2, 3}) {
                            const Vec3 diffuse = colours % 2 == 0 ? black : grey;
                            const Vec3 specular = colours < 2 ? black : grey;
                            const Vec3 v = at_cosine(cosine, 30), numbers(a, b, c);
                            INFO("diffuse " << diffuse << ", specular " << specular << ", roughness " << size
                                            << ", random numbers " << numbers << ", to the viewer " << v);
                            check_usable(sample(DiffuseGgx{diffuse, specular, size}, v, numbers));
                        }
}

TEST_CASE("narrow highlights are drawn as densely as they claim", "[12.17][stability]") {
    for (const Real cosine : {1e-6, 0.1})
        for (const Real exponent : {1e4, 1e8}) {
            const Vec3 v = at_cosine(cosine, 70), mirror(-v.x, -v.y, v.z);
            INFO("exponent " << exponent << ", to the viewer " << v);
            const ModifiedPhong phong{Vec3(0), Vec3(1), exponent};
            const auto draw = [&](const Vec3& numbers) { return sample(phong, v, numbers); };
            const auto density = [&](const Vec3& l) { return pdf(phong, l, v); };
            const test::Chart chart = test::around(mirror, exponent);
            test::check_report(test::compare_samples({chart}, draw, density, cases(20000), 121712));
        }
}

TEST_CASE("highlights of smooth facets are drawn as densely as they claim", "[12.23][stability]") {
    for (const Real cosine : {1e-6, 0.1})
        for (const Real alpha : {1e-4, 1e-2}) {
            // Facets that are wider than the viewer is high mostly send light below the surface.
            if (cosine < alpha) continue;
            const Vec3 v = at_cosine(cosine, 70);
            INFO("alpha " << alpha << ", to the viewer " << v);
            const DiffuseGgx ggx{Vec3(0), Vec3(1), alpha};
            const auto draw = [&](const Vec3& numbers) { return sample(ggx, v, numbers); };
            const auto density = [&](const Vec3& l) { return pdf(ggx, l, v); };
            const test::Chart chart = test::mirrored_by_facets(alpha, v);
            test::check_report(test::compare_samples({chart}, draw, density, cases(20000), 121713));
        }
}

TEST_CASE("with a narrow highlight the ground gets its part", "[12.17][stability]") {
    // Two thirds of the directions are in the highlight, of which half are where cos^(s + 1) > 1/2.
    const Vec3 v = towards(40, 10), mirror(-v.x, -v.y, v.z);
    const ModifiedPhong phong{Vec3(0.3), Vec3(0.6), 1e6};
    const int count = cases(30000);
    int inner = 0;
    Random random(121714);
    for (int i = 0; i < count; ++i) {
        const Real x = random.uniform(0, 1), y = random.uniform(0, 1), z = random.uniform(0, 1);
        const auto one = sample(phong, v, {x, y, z});
        if (one) inner += dot(one->to_light, mirror) > 1 - std::log(2.0) / 1e6;
    }
    INFO("of " << count << " directions " << inner << " are in the inner half of the highlight");
    // Five standard deviations and a half: once in ten million times.
    CHECK(std::abs(inner - count / 3.0) < 5.5 * std::sqrt(count * 2 / 9.0));
}
