// Step 11.15 near the horizon, and at the ends of its numbers.
#include "chapters/11_textures/matte.hpp"
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

TEST_CASE("matte lobes near the horizon", "[11.15][stability]") {
    Random random(11134);
    for (int i = 0; i < cases(5000); ++i) {
        const Real sigma = random.uniform(0, 1), z = random.magnitude(-8, 0), w = random.magnitude(-8, 0);
        const Real turn = i % 3 == 0 ? 0 : i % 3 == 1 ? 180 : random.uniform(0, 360);
        const Vec3 l = at_cosine(z), v = at_cosine(w, turn);
        INFO("roughness " << sigma << ", to the light " << l << ", to the viewer " << v);
        const Vec3 f = evaluate(Matte{Vec3(1), sigma}, l, v);
        REQUIRE(test::is_valid(f));
        // In long double, from the given directions.
        const long double s = static_cast<long double>(l.x) * v.x + static_cast<long double>(l.y) * v.y;
        const long double scale =
            6 / (6 * std::numbers::pi_v<long double> + sigma * (3 * std::numbers::pi_v<long double> - 4));
        const long double bright = s < 0 ? s : s / (z > w ? z : w);
        const Real bound = gamma(12) / std::max(z, w);
        CHECK(near(f.x, std::max(0.0, static_cast<Real>(scale * (1 + sigma * bright))), bound));
        CHECK(oren_nayar_1994(sigma, l, v) >= 0);
        CHECK(std::isfinite(oren_nayar_1994(sigma, l, v)));
    }
}

TEST_CASE("matte samples by the last of the random numbers", "[11.15][stability]") {
    const Real last = 1 - 0x1p-53;
    for (const Real a : {0.0, 1e-300, 0.5, last})
        for (const Real b : {0.0, 1e-300, 0.5, last})
            for (const Real cosine : {1e-8, 0.5, 1.0}) {
                const Vec3 v = at_cosine(cosine);
                INFO("random numbers " << a << ", " << b << ", to the viewer " << v);
                const auto one = sample(Matte{Vec3(1), 1}, v, {a, b, last});
                REQUIRE(one.has_value());
                CHECK(test::is_valid(one->weight));
                CHECK(one->to_light.z > 0);
                CHECK(one->pdf > 0);
                CHECK(near(one->to_light.z, std::sqrt((1 - a)), gamma(8) * std::sqrt(1 - a)));
            }
}
