// Steps 11.18 and 11.19 near the horizon, and with facets that are nearly all alike.
#include "chapters/11_textures/rough_glass.hpp"
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

TEST_CASE("rough glass from everywhere to everywhere", "[11.18][stability]") {
    Random random(11154);
    for (int i = 0; i < cases(10000); ++i) {
        const RoughGlass glass{Vec3(1), random.magnitude(-4, 0), 1 + random.magnitude(-2, 0.47)};
        const Vec3 v = at_cosine(random.sign() * random.magnitude(-8, 0));
        // Straight through, straight back, mirrored, let through without bending, or anywhere.
        const Vec3 l = i % 5 == 0   ? -v
                       : i % 5 == 1 ? v
                       : i % 5 == 2 ? Vec3(-v.x, 0, v.z)
                       : i % 5 == 3
                           ? Vec3(-v.x, 0, -v.z)
                           : at_cosine(random.sign() * random.magnitude(-8, 0), random.uniform(0, 360));
        INFO("roughness " << glass.roughness << ", index " << glass.ior << ", to the light " << l
                          << ", to the viewer " << v);
        CHECK(test::is_valid(evaluate(glass, l, v)));
        CHECK(test::is_valid(Vec3(pdf(glass, l, v))));
        if (const auto h = glass_facet(glass, l, v)) {
            CHECK(h->z > 0);
            CHECK(near(length(*h), 1, gamma(12)));
        }
    }
}

TEST_CASE("samples of rough glass at the ends of all numbers", "[11.19][stability]") {
    const Real last = 1 - 0x1p-53;
    for (const Real a : {0.0, 1e-300, 1e-10, 0.5, last})
        for (const Real b : {0.0, 0.25, 0.5, last})
            for (const Real c : {0.0, 1e-300, 0.5, last})
                for (const Real cosine : {-1.0, -0.7, -1e-4, -1e-8, 1e-8, 1e-4, 0.5, 1.0})
                    for (const Real roughness : {0.0, 1e-4, 0.01, 1.0}) {
                        const Vec3 v = at_cosine(cosine, 30);
                        INFO("random numbers " << a << ", " << b << ", " << c << ", to the viewer " << v
                                               << ", roughness " << roughness);
                        const auto one = sample(RoughGlass{Vec3(1), roughness, 1.5}, v, {a, b, c});
                        if (!one) continue;
                        CHECK(test::is_valid(one->weight));
                        CHECK(one->weight.x <= 1 + gamma(64));
                        CHECK(near(length(one->to_light), 1, gamma(12)));
                        CHECK(test::is_valid(Vec3(one->pdf)));
                    }
}

TEST_CASE("nearly smooth glass is drawn as densely as it claims", "[11.19][stability]") {
    for (const Real roughness : {1e-4, 1e-2})
        for (const Real cosine : {-1.0, -0.9, -0.3, 0.1, 0.5, 1.0}) {
            const RoughGlass glass{Vec3(1), roughness, 1.5};
            const Vec3 v = at_cosine(cosine);
            INFO("roughness " << roughness << ", index 1.5, to the viewer " << v);
            const auto draw = [&](const Vec3& numbers) { return sample(glass, v, numbers); };
            const auto density = [&](const Vec3& l) { return pdf(glass, l, v); };
            const Real width = roughness * roughness, n_v = v.z > 0 ? 1 : 1.5, n_l = v.z > 0 ? 1.5 : 1;
            const std::vector<test::Chart> charts{test::mirrored_by_facets(width, v),
                                                  test::bent_by_facets(width, v, n_v, n_l)};
            test::check_report(test::compare_samples(charts, draw, density, cases(20000), 11155));
            Real energy = 0;
            for (const test::Chart& chart : charts)
                energy += test::sum_over(
                    chart, 64, [&](const Vec3& l) { return evaluate(glass, l, v).x * std::abs(l.z); });
            CHECK(energy <= 1 + 2e-3);
            CHECK(energy >= 0.99);
        }
}
