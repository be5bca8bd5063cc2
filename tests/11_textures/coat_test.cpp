// Step 11.22: paint under a clear coat.
#include "chapters/11_textures/coat.hpp"
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
using test::upper;

namespace {

/// What mean_fresnel promises.
const Real promised = 1e-7;

Vec3 furnace(const Coated& coated, const Vec3& v, int n) {
    return test::sum_over(test::dome(), n, [&](const Vec3& l) { return evaluate(coated, l, v) * l.z; });
}

void check_kept(Real ior, Real expected, Real bound) {
    INFO("the part of the light from within that a coat of index " << ior << " mirrors back inside");
    CHECK(near(inner_reflectance(ior), expected, bound));
}

void check_from_above(const Vec3& color, const Vec3& expected, Real bound) {
    INFO("paint of colour " << color << " under a coat of index 1.5, light and viewer straight above");
    CHECK(near_color(evaluate({color, 1.5}, up, up), expected, bound));
}

}  // namespace

TEST_CASE("a coat of index 1 is none", "[11.22]") {
    check_kept(1, 0, promised);
    const Coated bare{{0.2, 0.4, 0.6}, 1};
    for (const Vec3& v : {up, right, towards(85, 30)}) {
        INFO("to the viewer " << v);
        CHECK(near_color(evaluate(bare, left, v), Vec3(0.2, 0.4, 0.6) / pi, promised));
        CHECK(near(pdf(bare, left, v), 0.5 / pi, promised));
    }
}

TEST_CASE("the part of light that the coat keeps inside", "[11.22]") {
    // For n = 1.5 the outside mirrors 0.0917780 in the mean, so inside it is 1 − 0.9082220/2.25 = 0.5963458.
    check_kept(1.5, 0.5963458, 2e-7);
    // For n = 2: 1 − (1 − 0.1605966)/4.
    check_kept(2, 0.7901492, 2e-7);
}

TEST_CASE("paint straight from above, by hand", "[11.22]") {
    // F = 0.04, T² = 0.9216. Of white paint f = T²/(π · (n² − n² + 1 − 0.0917780)).
    check_from_above(Vec3(1), Vec3(0.9216 / (pi * 0.908222)), 4e-7);
    // Of grey paint of 0.5: 0.5·0.9216/(π · 2.25 · (1 − 0.5·0.5963458)) = 0.2918098/π.
    check_from_above(Vec3(0.5), Vec3(0.2918098 / pi), 4e-7);
    check_from_above(Vec3(0), Vec3(0), 0);
    INFO("pdf of a direction straight up, seen from there: 0.96/pi, for 0.04 are mirrored by the coat");
    CHECK(near(pdf({Vec3(0.5), 1.5}, up, up), 0.96 / pi, gamma(32)));
}

TEST_CASE("the channels of paint are apart", "[11.22]") {
    check_from_above({1, 0.5, 0}, Vec3(0.9216 / 0.908222, 0.2918098, 0) / pi, 4e-7);
}

TEST_CASE("below the surface paint is 0", "[11.22]") {
    test::check_below(Coated{Vec3(1), 1.5});
    test::check_nothing_drawn_below(Coated{Vec3(1), 1.5});
}

TEST_CASE("the coat mirrors if the random number is below Fresnel's part", "[11.22]") {
    const Coated coated{Vec3(0.5), 1.5};
    const auto mirrored = sample(coated, up, {0.3, 0.6, 0.0399});
    INFO("straight from above the part is 0.04; the number is 0.0399");
    REQUIRE(mirrored.has_value());
    CHECK(near(mirrored->to_light, up, gamma(4)));
    CHECK(near(mirrored->weight, Vec3(1), gamma(8)));
    CHECK(std::isinf(mirrored->pdf));
    const auto slanted = sample(coated, right, {0.3, 0.6, 0});
    REQUIRE(slanted.has_value());
    CHECK(near(slanted->to_light, left, gamma(8)));
    CHECK(near(slanted->weight, Vec3(1), gamma(8)));
    CHECK(std::isinf(slanted->pdf));
    const auto through = sample(coated, up, {0.75, 0.5, 0.0401});
    REQUIRE(through.has_value());
    INFO("now the number is 0.0401");
    CHECK(test::or_say(std::isfinite(through->pdf), "an infinite pdf: the coat's mirror, not the ground"));
    CHECK(through->to_light.z > 0);
}

TEST_CASE("the weight of a sample of paint is f cos/pdf", "[11.22]") {
    Random random(11170);
    for (int i = 0; i < cases(2000); ++i) {
        const Coated coated{{random.uniform(0, 1), 1, 0.5}, random.uniform(1, 4)};
        const Vec3 v = upper(random),
                   numbers(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
        INFO("colour " << coated.color << ", index " << coated.ior << ", to the viewer " << v
                       << ", random numbers " << numbers);
        const auto one = sample(coated, v, numbers);
        REQUIRE(one.has_value());
        CHECK(near(length(one->to_light), 1, gamma(12)));
        if (std::isinf(one->pdf)) continue;
        const Vec3 expected = evaluate(coated, one->to_light, v) * one->to_light.z;
        CHECK(near(one->pdf, pdf(coated, one->to_light, v), gamma(128)));
        CHECK(near_color(one->weight * one->pdf, expected, gamma(128) * (1 + one->weight.y)));
    }
}

TEST_CASE("white paint loses no light", "[11.22]") {
    // What the coat does not mirror comes back: the furnace is 1 − F(v). The midpoint rule on 64² cells errs
    // by 2.1e-5 at most.
    for (const Real ior : {1.0, 1.1, 1.5, 2.5})
        for (const Real angle : {0.0, 45.0, 80.0, 89.0}) {
            INFO("index " << ior << ", viewer " << angle << " degrees from the normal");
            const Vec3 v = towards(angle);
            const Real through = 1 - mirrored_by_angles(v.z, 1, ior);
            CHECK(near_color(furnace({Vec3(1), ior}, v, 64), Vec3(through), 5e-5));
            CHECK(furnace({Vec3(0.5), ior}, v, 64).x <= 0.5 * through + 5e-5);
        }
}

TEST_CASE("paint is the same with light and viewer exchanged", "[11.22]") {
    Random random(11171);
    for (int i = 0; i < cases(2000); ++i) {
        const Coated coated{{random.uniform(0, 1), 1, 0.5}, random.uniform(1, 4)};
        const Vec3 l = upper(random), v = upper(random);
        INFO("index " << coated.ior << ", one direction " << l << ", the other " << v);
        const Vec3 f = evaluate(coated, l, v);
        CHECK(near(f, evaluate(coated, v, l), 128 * unit_roundoff * (1 + f.y)));
    }
}

TEST_CASE("paint by a sum over all that happens under the coat", "[11.22]") {
    Random random(11172);
    for (int i = 0; i < cases(500); ++i) {
        const Real color = random.uniform(0, 0.95), ior = random.uniform(1.05, 3);
        const Vec3 l = upper(random), v = upper(random);
        INFO("colour " << color << ", index " << ior << ", to the light " << l << ", to the viewer " << v);
        // What the inside mirrors in the mean, by 4096 midpoints of the cosine's square.
        Real inside = 0;
        for (int k = 0; k < 4096; ++k) {
            const Real square = (k + 0.5) / 4096, sine = std::sqrt(1 - square) * ior;
            inside += (sine >= 1 ? 1 : mirrored_by_angles(std::sqrt((1 - sine) * (1 + sine)), 1, ior)) / 4096;
        }
        Real left_over = 1, out = 0;
        for (int bounce = 0; bounce < 1000; ++bounce) {
            left_over *= color;
            out += left_over;
            left_over *= inside;
        }
        const Real ways = (1 - mirrored_by_angles(l.z, 1, ior)) * (1 - mirrored_by_angles(v.z, 1, ior));
        // The midpoints miss 6e-6 of the mean near the critical angle, which the bounces make 6 times more
        // of.
        CHECK(near(evaluate({Vec3(color), ior}, l, v).x, ways * out / (pi * ior * ior), 5e-5));
    }
}

TEST_CASE("directions from paint are as dense as they claim", "[11.22]") {
    for (const Real angle : {0.0, 60.0, 85.0}) {
        const Coated coated{Vec3(0.5), 1.5};
        const Vec3 v = towards(angle, 25);
        INFO("index 1.5, the viewer " << angle << " degrees from the normal");
        const auto draw = [&](const Vec3& numbers) { return sample(coated, v, numbers); };
        const auto density = [&](const Vec3& l) { return pdf(coated, l, v); };
        test::check_report(test::compare_samples({test::dome()}, draw, density, cases(20000), 11173,
                                                 mirrored_by_angles(v.z, 1, 1.5)));
    }
}
