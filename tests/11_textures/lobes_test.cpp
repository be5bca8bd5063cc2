// Steps 11.15 to 11.22 under one name: a Lobe answers as what it is.
#include "chapters/11_textures/lobes.hpp"
#include "tests/11_textures/lobe_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

using namespace rt;
using test::cases;
using test::near;
using test::Random;

namespace {

template <class Kind>
void check_as(const Kind& kind, std::uint64_t seed) {
    const Lobe lobe = kind;
    Random random(seed);
    for (int i = 0; i < cases(200); ++i) {
        const Vec3 l = random.direction(), v = random.direction();
        const Vec3 numbers(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
        INFO("to the light " << l << ", to the viewer " << v << ", random numbers " << numbers);
        CHECK(test::near_color(evaluate(lobe, l, v), evaluate(kind, l, v), 0));
        CHECK(near(pdf(lobe, l, v), pdf(kind, l, v), 0));
        const auto one = sample(lobe, v, numbers), other = sample(kind, v, numbers);
        REQUIRE(one.has_value() == other.has_value());
        if (!one) continue;
        CHECK(near(one->to_light, other->to_light, 0));
        CHECK(test::near_color(one->weight, other->weight, 0));
        CHECK((one->pdf == other->pdf));
    }
}

}  // namespace

TEST_CASE("a lobe that is matte answers so", "[11.15]") { check_as(Matte{{0.2, 0.4, 0.6}, 0.5}, 11180); }

TEST_CASE("a lobe of rough metal answers so", "[11.17]") {
    check_as(RoughMetal{{0.2, 0.4, 0.6}, 0.5}, 11181);
}

TEST_CASE("a lobe of rough glass answers so", "[11.19]") {
    check_as(RoughGlass{{0.2, 0.4, 0.6}, 0.5, 1.5}, 11182);
}

TEST_CASE("a lobe of velvet answers so", "[11.21]") { check_as(Velvet{{0.2, 0.4, 0.6}, 0.5}, 11183); }

TEST_CASE("a lobe of coated paint answers so", "[11.22]") { check_as(Coated{{0.2, 0.4, 0.6}, 1.5}, 11184); }
