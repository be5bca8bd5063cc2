// Steps 11.16 and 11.17 near the horizon, and with facets that are nearly all alike.
#include "chapters/11_textures/microfacet.hpp"
#include "common/math/error.hpp"
#include "tests/11_textures/lobe_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::at_cosine;
using test::cases;
using test::near;
using test::Random;

namespace {

using Long = long double;

/// White rough metal in long double, from the given directions; nothing is known of how the solution does it.
Real exact_lobe(Real alpha, const Vec3& l, const Vec3& v) {
    const Long x = Long(l.x) + v.x, y = Long(l.y) + v.y, z = Long(l.z) + v.z;
    const Long slope = (x * x + y * y) / (z * z), square = Long(alpha) * alpha;
    const Long secant = 1 + slope, slopes = 1 + slope / square;
    const auto seen = [&](const Vec3& w) {
        const Long tangent = (Long(w.x) * w.x + Long(w.y) * w.y) / (Long(w.z) * w.z);
        return 2 / (1 + std::sqrt(1 + square * tangent)) / w.z;
    };
    const Long facets = secant * secant / (std::numbers::pi_v<Long> * square * slopes * slopes);
    return static_cast<Real>(facets * seen(l) * seen(v) / 4);
}

}  // namespace

TEST_CASE("densities of facets from smooth to rough", "[11.16][stability]") {
    Random random(11145);
    for (int i = 0; i < cases(5000); ++i) {
        const Real alpha = random.magnitude(-8, 0), sine = random.magnitude(-12, 0) * 0.999999;
        const Vec3 h(sine, 0, std::sqrt((1 - sine) * (1 + sine)));
        INFO("alpha " << alpha << ", facets along " << h);
        const Long square = Long(alpha) * alpha, below = square * h.z * h.z + Long(sine) * sine;
        const Real expected = static_cast<Real>(square / (below * below * std::numbers::pi_v<Long>));
        CHECK(near(ggx_density(alpha, h), expected, gamma(16) * expected));
    }
}

TEST_CASE("rough metal near the horizon and nearly smooth", "[11.16][stability]") {
    Random random(11146);
    for (int i = 0; i < cases(5000); ++i) {
        const Real roughness = random.magnitude(-4, 0), z = random.magnitude(-8, 0);
        const Real alpha = ggx_alpha(roughness);
        const Vec3 v = at_cosine(z);
        // The light in the mirror's direction, near it, back to the viewer, or anywhere.
        const Vec3 tilt = alpha * random.magnitude(-2, 2) * random.in_cube();
        const Vec3 near_mirror = normalize(Vec3(-v.x, 0, v.z) + tilt);
        const Vec3 l = i % 4 == 0   ? Vec3(-v.x, 0, v.z)
                       : i % 4 == 1 ? near_mirror
                       : i % 4 == 2 ? v
                                    : at_cosine(random.magnitude(-8, 0), random.uniform(0, 360));
        if (!(l.z > 0)) continue;
        const RoughMetal white{Vec3(1), roughness};
        INFO("roughness " << roughness << ", to the light " << l << ", to the viewer " << v);
        const Vec3 f = evaluate(white, l, v);
        REQUIRE(test::is_valid(f));
        const Real expected = exact_lobe(alpha, l, v);
        const Real bound = gamma(32) + 16 * unit_roundoff / (alpha * length(l + v));
        CHECK(near(f.x, expected, bound * expected));
        CHECK(test::is_valid(Vec3(pdf(white, l, v))));
    }
}

TEST_CASE("samples of rough metal at the ends of all numbers", "[11.17][stability]") {
    const Real last = 1 - 0x1p-53;
    for (const Real a : {0.0, 1e-300, 1e-10, 0.25, 0.5, 0.75, last})
        for (const Real b : {0.0, 1e-300, 1e-10, 0.25, 0.5, 0.75, last})
            for (const Real cosine : {1e-8, 1e-4, 0.5, 1.0})
                for (const Real roughness : {0.0, 1e-4, 0.01, 1.0}) {
                    const Vec3 v = at_cosine(cosine, 30);
                    INFO("random numbers " << a << ", " << b << ", to the viewer " << v << ", roughness "
                                           << roughness);
                    const Vec3 h = visible_normal(ggx_alpha(roughness), v, a, b);
                    CHECK(near(length(h), 1, gamma(12)));
                    CHECK(h.z >= 0);
                    CHECK(dot(v, h) >= -gamma(12));
                    const auto one = sample(RoughMetal{Vec3(1), roughness}, v, {a, b, last});
                    if (!one) continue;
                    CHECK(test::is_valid(one->weight));
                    CHECK(one->weight.x <= 1 + gamma(32));
                    CHECK(one->to_light.z > 0);
                    CHECK(near(length(one->to_light), 1, gamma(12)));
                    CHECK(test::is_valid(Vec3(one->pdf)));
                }
}

TEST_CASE("nearly smooth metal is drawn as densely as it claims", "[11.17][stability]") {
    for (const Real roughness : {1e-4, 1e-2})
        for (const Real cosine : {1e-2, 0.5, 1.0}) {
            const RoughMetal metal{Vec3(1), roughness};
            const Vec3 v = at_cosine(cosine);
            INFO("roughness " << roughness << ", to the viewer " << v);
            const auto draw = [&](const Vec3& numbers) { return sample(metal, v, numbers); };
            const auto density = [&](const Vec3& l) { return pdf(metal, l, v); };
            const auto chart = test::mirrored_by_facets(ggx_alpha(roughness), v);
            test::check_report(test::compare_samples({chart}, draw, density, cases(20000), 11147));
            // All that is drawn is drawn somewhere; what it brings is nearly all.
            const Real all = test::sum_over(chart, 64, density);
            CHECK(all <= 1 + 2e-3);
            const Real energy = test::sum_over(
                chart, 64, [&](const Vec3& l) { return evaluate(metal, l, v).x * std::max(l.z, 0.0); });
            CHECK(energy <= 1 + 2e-3);
            CHECK(energy >= 0.98);
        }
}
