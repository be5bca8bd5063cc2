// Step 11.22 near the horizon, and at the ends of its numbers.
#include "chapters/11_textures/coat.hpp"
#include "common/math/error.hpp"
#include "tests/11_textures/lobe_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::at_cosine;
using test::cases;
using test::Random;

TEST_CASE("paint near the horizon, under coats of all kinds", "[11.22][stability]") {
    Random random(11174);
    for (int i = 0; i < cases(5000); ++i) {
        const Real ior = i % 2 == 0 ? 1 + random.magnitude(-15, 0) : random.uniform(1, 4);
        const Coated coated{Vec3(random.uniform(0, 1), 1, 0), ior};
        const Vec3 l = at_cosine(random.magnitude(-8, 0)), v = at_cosine(random.magnitude(-8, 0), 200);
        INFO("index " << ior << ", to the light " << l << ", to the viewer " << v);
        const Real inside = inner_reflectance(ior);
        CHECK((inside >= 0 && inside < 1));
        CHECK(test::is_valid(evaluate(coated, l, v)));
        CHECK(test::is_valid(Vec3(pdf(coated, l, v))));
        CHECK(pdf(coated, l, v) <= l.z / pi * (1 + gamma(16)));
    }
}

TEST_CASE("samples of paint at the ends of all numbers", "[11.22][stability]") {
    const Real last = 1 - 0x1p-53;
    for (const Real a : {0.0, 1e-300, 0.5, last})
        for (const Real c : {0.0, 1e-300, 0.04, 0.5, last})
            for (const Real cosine : {1e-8, 1e-4, 0.5, 1.0})
                for (const Real ior : {1.0, 1.0000001, 1.5, 4.0}) {
                    const Vec3 v = at_cosine(cosine, 30);
                    INFO("random numbers " << a << ", " << c << ", to the viewer " << v << ", index " << ior);
                    const auto one = sample(Coated{Vec3(1), ior}, v, {a, last, c});
                    REQUIRE(one.has_value());
                    CHECK(test::is_valid(one->weight));
                    CHECK(one->to_light.z > 0);
                    CHECK(one->pdf > 0);
                }
}
