// Steps 11.20 and 11.21 near the horizon, and with facets that are nearly all upright.
#include "chapters/11_textures/sheen.hpp"
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

}  // namespace

TEST_CASE("densities of velvet's facets from upright to flat", "[11.20][stability]") {
    Random random(11164);
    for (int i = 0; i < cases(5000); ++i) {
        const Real sigma = random.magnitude(-4, 0);
        const Real cosine = i % 2 == 0 ? sigma * random.uniform(0, 5) / 6 : random.uniform(0, 1);
        const Vec3 h = at_cosine(cosine, random.uniform(0, 360));
        INFO("sigma " << sigma << ", facets along " << h);
        const Long flat = Long(h.x) * h.x + Long(h.y) * h.y, square = Long(sigma) * sigma;
        const Long power = Long(h.z) * h.z / flat / square;
        const Real expected =
            static_cast<Real>(std::exp(-power) / square / flat / flat / std::numbers::pi_v<Long>);
        const Real bound = gamma(16) * (1 + static_cast<Real>(power)) * expected + 1e-300;
        CHECK(near(velvet_density(sigma, h), expected, bound));
    }
}

TEST_CASE("velvet near the horizon", "[11.20][stability]") {
    Random random(11165);
    for (int i = 0; i < cases(5000); ++i) {
        const Real sigma = random.magnitude(-4, 0), z = random.magnitude(-8, 0), w = random.magnitude(-8, 0);
        const Real turn = i % 3 == 0 ? 0 : i % 3 == 1 ? 180 : random.uniform(0, 360);
        const Vec3 l = at_cosine(z), v = at_cosine(w, turn);
        INFO("roughness " << sigma << ", to the light " << l << ", to the viewer " << v);
        CHECK(test::is_valid(evaluate(Velvet{Vec3(1), sigma}, l, v)));
        CHECK(test::is_valid(Vec3(pdf(Velvet{Vec3(1), sigma}, l, v))));
        // In long double, from the given directions: l + v = 2(v·h)·h.
        const Long x = Long(l.x) + v.x, y = Long(l.y) + v.y, height = Long(l.z) + v.z;
        const Long flat = x * x + y * y, all = flat + height * height, square = Long(sigma) * sigma;
        const Long shadow = std::min(Long(1), 4 * height / all * std::min(z, w));
        const Long facets = std::exp(-height * height / flat / square) / square * (all / flat) * (all / flat);
        const Real expected =
            flat == 0 ? 0 : static_cast<Real>(facets * shadow / 4 / l.z / v.z / std::numbers::pi_v<Long>);
        const Real sine = static_cast<Real>(std::sqrt(flat / all)),
                   cosine = static_cast<Real>(height / std::sqrt(all));
        const Real part =
            gamma(64) * (1 + (1 + cosine / (sigma * sigma * sine * sine * sine)) / dot(l + v, l + v));
        if (flat > 0)
            CHECK(near(evaluate(Velvet{Vec3(1), sigma}, l, v).x, expected, part * expected + 1e-290));
    }
}

TEST_CASE("samples of velvet at the ends of all numbers", "[11.21][stability]") {
    const Real last = 1 - 0x1p-53;
    for (const Real a : {0.0, 1e-300, 1e-10, 0.5, last})
        for (const Real b : {0.0, 1e-300, 0.25, 0.5, last})
            for (const Real c : {0.0, 0.5, last})
                for (const Real cosine : {1e-8, 1e-4, 0.5, 1.0})
                    for (const Real roughness : {0.0, 1e-4, 0.01, 1.0}) {
                        const Vec3 v = at_cosine(cosine, 30);
                        INFO("random numbers " << a << ", " << b << ", " << c << ", to the viewer " << v
                                               << ", roughness " << roughness);
                        const auto one = sample(Velvet{Vec3(1), roughness}, v, {a, b, c});
                        if (!one) continue;
                        CHECK(test::is_valid(one->weight));
                        CHECK(one->weight.x <= 1 + 1e-6);
                        CHECK(one->to_light.z > 0);
                        CHECK(test::is_valid(Vec3(one->pdf)));
                    }
}
