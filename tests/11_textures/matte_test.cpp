// Step 11.15: matte surfaces.
#include "chapters/11_textures/matte.hpp"
#include "common/math/error.hpp"
#include "tests/11_textures/lobe_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::at_cosine;
using test::cases;
using test::left;
using test::near;
using test::Random;
using test::right;
using test::towards;
using test::up;
using test::upper;

namespace {

void check_lobe(const Matte& matte, const Vec3& l, const Vec3& v, Real factor) {
    INFO("matte of colour " << matte.color << " and roughness " << matte.roughness);
    INFO("to the light " << l << ", to the viewer " << v);
    const Vec3 f = evaluate(matte, l, v);
    CHECK(near(f, matte.color * factor, gamma(20) * factor));
}

/// The whole returned to v of light that comes evenly from everywhere.
Vec3 furnace(const Matte& matte, const Vec3& v, int n) {
    return test::sum_over(test::dome(), n, [&](const Vec3& l) { return evaluate(matte, l, v) * l.z; });
}

}  // namespace

TEST_CASE("without roughness it is Lambert's: colour over pi from everywhere", "[11.15]") {
    const Matte matte{{0.2, 0.4, 0.6}, 0};
    for (const Vec3& l : {up, right, left, towards(85, 70)})
        for (const Vec3& v : {up, right, left, towards(20, -30)}) check_lobe(matte, l, v, 1 / pi);
}

TEST_CASE("a rough matte surface seen from straight above", "[11.15]") {
    // s = 0. With σ = 1 what is left is 1/(π + (3π − 4)/6) = 6/(9π − 4).
    check_lobe({Vec3(1), 1}, right, up, 6 / (9 * pi - 4));
    check_lobe({{0.1, 0.5, 0.9}, 1}, up, up, 6 / (9 * pi - 4));
    // Across the viewer's plane, too: s = 0 again.
    check_lobe({Vec3(1), 1}, right, {0, std::sqrt(3.0) / 2, 0.5}, 6 / (9 * pi - 4));
}

TEST_CASE("a rough matte surface is bright where the light is behind the viewer", "[11.15]") {
    // 60° and 60° on the same side: s = 3/4, t = (3/4)/(1/2) = 3/2, with σ = 1 the factor 1 + 3/2.
    check_lobe({Vec3(1), 1}, right, right, 2.5 * 6 / (9 * pi - 4));
    // With σ = 1/2: (1 + 3/4)/(π + (3π − 4)/12) = 21/(15π − 4).
    check_lobe({Vec3(1), 0.5}, right, right, 21 / (15 * pi - 4));
}

TEST_CASE("a rough matte surface is dark where the light comes towards the viewer", "[11.15]") {
    // s = −3/4, and is not divided: with σ = 1 the factor is 1 − 3/4.
    check_lobe({Vec3(1), 1}, left, right, 0.25 * 6 / (9 * pi - 4));
}

TEST_CASE("the greater of the cosines divides", "[11.15]") {
    // 60° and 30°: cosines 1/2 and √3/2; s = √3/4, t = 1/2.
    const Vec3 high{0.5, 0, std::sqrt(3.0) / 2};
    check_lobe({Vec3(1), 1}, right, high, 1.5 * 6 / (9 * pi - 4));
    check_lobe({Vec3(1), 1}, high, right, 1.5 * 6 / (9 * pi - 4));
}

TEST_CASE("below the surface a matte lobe is 0", "[11.15]") {
    test::check_below(Matte{Vec3(1), 0.7});
    test::check_nothing_drawn_below(Matte{Vec3(1), 0.7});
    for (const Vec3& below : {Vec3(0, 0, -1), Vec3(right.x, 0, -0.5), Vec3(1, 0, 0)}) {
        INFO("one direction is " << below << ", the other " << right);
        CHECK(near(oren_nayar_1994(0.7, below, right), 0, 0));
        CHECK(near(oren_nayar_1994(0.7, right, below), 0, 0));
    }
}

TEST_CASE("Oren and Nayar's model of 1994 at angles by hand", "[11.15]") {
    // σ² = 0.09: A = 1 − 0.045/0.42 = 25/28 and B = 0.225.
    const Real a = 25.0 / 28;
    INFO("sigma = 0.3");
    CHECK(near(oren_nayar_1994(0.3, up, up), a / pi, gamma(20)));
    CHECK(near(oren_nayar_1994(0.3, left, right), a / pi, gamma(20)));
    // Both 60° on one side: sin α tan β = (√3/2)·√3 = 3/2.
    CHECK(near(oren_nayar_1994(0.3, right, right), (a + 0.225 * 1.5) / pi, gamma(20)));
    // 60° and 30°: sin α tan β = (√3/2)/√3 = 1/2.
    CHECK(near(oren_nayar_1994(0.3, right, {0.5, 0, std::sqrt(3.0) / 2}), (a + 0.225 * 0.5) / pi, gamma(20)));
    CHECK(near(oren_nayar_1994(0, right, right), 1 / pi, gamma(8)));
}

TEST_CASE("Oren and Nayar's model of 1994 is their formula in angles", "[11.15]") {
    Random random(11130);
    for (int i = 0; i < cases(2000); ++i) {
        const Real sigma = random.uniform(0, 1.5);
        const Real one = random.uniform(0, 85), two = random.uniform(0, 85), turn = random.uniform(0, 360);
        const Real greater = radians(std::max(one, two)), less = radians(std::min(one, two));
        const Real bright = std::max(0.0, std::cos(radians(turn))) * std::sin(greater) * std::tan(less);
        const Real square = sigma * sigma;
        const Real expected =
            (1 - 0.5 * square / (square + 0.33) + 0.45 * square / (square + 0.09) * bright) / pi;
        INFO("sigma " << sigma << ", angles " << one << " and " << two << " degrees, " << turn << " apart");
        // The angles in degrees are rounded: the tangent of 85° passes 130 times of that on.
        const Real bound = gamma(16) * 130;
        CHECK(near(oren_nayar_1994(sigma, towards(one, 10), towards(two, 10 + turn)), expected, bound));
    }
}

TEST_CASE("a point of the disc is lifted onto the hemisphere", "[11.15]") {
    const auto check_direction = [](Real a, Real b, const Vec3& expected, Real bound) {
        INFO("the direction from the random numbers a = " << a << ", b = " << b);
        CHECK(test::near_direction(cosine_direction(a, b), expected, bound));
    };
    check_direction(0, 0.3, up, gamma(4));
    check_direction(0.75, 0, right, gamma(8));
    check_direction(0.75, 0.5, left, gamma(8));
    check_direction(0.25, 0.25, {0, 0.5, std::sqrt(3.0) / 2}, gamma(8));
}

TEST_CASE("the density of directions from a matte surface is cos over pi", "[11.15]") {
    INFO("pdf of a direction to the light, seen from 60 degrees: straight up 1/pi");
    CHECK(near(pdf(Matte{}, up, right), 1 / pi, gamma(4)));
    INFO("and 60 degrees from the normal, seen from above, half of that");
    CHECK(near(pdf(Matte{}, right, up), 0.5 / pi, gamma(4)));
}

TEST_CASE("the weight of a sample is f cos/pdf", "[11.15]") {
    // Lambert's: the weight is the colour, wherever the sample goes.
    const auto drawn = sample(Matte{{0.2, 0.4, 0.6}, 0}, right, {0.75, 0.5, 0});
    {
        INFO("matte of colour (0.2, 0.4, 0.6) and roughness 0, random numbers (0.75, 0.5): to the light");
        REQUIRE(drawn.has_value());
        CHECK(test::near_direction(drawn->to_light, left, gamma(8)));
        INFO("which is 60 degrees from the normal; the weight is the colour");
        CHECK(test::near_color(drawn->weight, {0.2, 0.4, 0.6}, gamma(12)));
        INFO("and the pdf cos/pi");
        CHECK(near(drawn->pdf, 0.5 / pi, gamma(12)));
    }
    Random random(11131);
    for (int i = 0; i < cases(2000); ++i) {
        const Matte matte{Vec3(random.uniform(0, 1), 1, 0.5), random.uniform(0, 1)};
        const Vec3 v = upper(random),
                   numbers(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
        INFO("roughness " << matte.roughness << ", to the viewer " << v << ", random numbers " << numbers);
        const auto one = sample(matte, v, numbers);
        REQUIRE(one.has_value());
        const Vec3 expected = evaluate(matte, one->to_light, v) * one->to_light.z;
        CHECK(near(one->pdf, pdf(matte, one->to_light, v), gamma(16)));
        CHECK(test::near_color(one->weight * one->pdf, expected, gamma(20)));
        CHECK(near(length(one->to_light), 1, gamma(8)));
    }
}

TEST_CASE("a matte lobe is the same with light and viewer exchanged", "[11.15]") {
    Random random(11132);
    for (int i = 0; i < cases(2000); ++i) {
        const Matte matte{Vec3(1), random.uniform(0, 1)};
        const Vec3 l = upper(random), v = upper(random);
        INFO("roughness " << matte.roughness << ", one direction " << l << ", the other " << v);
        const Real bound = gamma(24) * (1 + 1 / std::max(l.z, v.z));
        CHECK(test::near_color(evaluate(matte, l, v), evaluate(matte, v, l), bound));
        CHECK(near(oren_nayar_1994(0.4, l, v), oren_nayar_1994(0.4, v, l), bound));
    }
}

TEST_CASE("a matte surface returns no more light than it gets", "[11.15]") {
    // From straight above σ = 1 returns π·6/(9π − 4), from the horizon all. The midpoint rule has 64² cells,
    // and errs by 9e-5 at most, for σ = 1 at the horizon.
    {
        INFO("what a white surface of roughness 1 returns of an even light, seen from straight above");
        CHECK(test::near_color(furnace({Vec3(1), 1}, up, 64), Vec3(6 * pi / (9 * pi - 4)), 1e-12));
        INFO("and seen from the horizon");
        CHECK(test::near_color(furnace({Vec3(1), 1}, at_cosine(1e-8), 64), Vec3(1), 2e-4));
    }
    for (const Real roughness : {0.0, 0.3, 1.0})
        for (const Real angle : {0.0, 30.0, 60.0, 80.0, 89.0}) {
            INFO("roughness " << roughness << ", viewer " << angle << " degrees from the normal");
            const Vec3 sum = furnace({{1, 0.5, 0}, roughness}, towards(angle), 64);
            CHECK(sum.x <= 1 + 2e-4);
            CHECK(near(sum.y, sum.x / 2, 1e-12));
            CHECK(near(sum.z, 0, 0));
        }
}

TEST_CASE("directions from a matte surface are as dense as they claim", "[11.15]") {
    const Matte matte{Vec3(1), 0.5};
    const auto draw = [&](const Vec3& numbers) { return sample(matte, right, numbers); };
    const auto density = [&](const Vec3& l) { return pdf(matte, l, right); };
    test::check_report(test::compare_samples({test::dome()}, draw, density, 20000, 11133));
}
