// Chapter 10's surfaces against exact arithmetic, on cases made to break them.
// Demands: tests/stability/solids.hpp, implicits.hpp and leaving.hpp.
#include "chapters/10_surfaces/box.hpp"
#include "chapters/10_surfaces/cone.hpp"
#include "chapters/10_surfaces/disc.hpp"
#include "chapters/10_surfaces/implicit.hpp"
#include "chapters/10_surfaces/quadric.hpp"
#include "tests/10_surfaces/check_families.hpp"
#include "tests/oracle/implicit.hpp"
#include "tests/oracle/solid.hpp"

using namespace rt;
using namespace rt::stability;

namespace {

constexpr std::uint64_t seed = 10;

Tally tally("10 surfaces");

template <class Shape>
void check_families(std::span<const SolidFamily<Shape>> families, int full) {
    const auto stable = [](const SolidCase<Shape>& q) { return intersect(q.shape, q.ray, Interval{}); };
    const auto naive = [](const SolidCase<Shape>& q) { return naive::intersect(q.shape, q.ray, Interval{}); };
    for (const SolidFamily<Shape>& family : families) {
        const auto questions = family.make(how_many(tally, full), seed), tenth = a_tenth(questions, full);
        const Verdict right = judge(questions, ask<std::optional<Hit>>(questions, stable));
        const Verdict textbook = judge(tenth, ask<std::optional<Hit>>(tenth, naive));
        check_family(tally, family.name, right, textbook, family.breaks_textbook);
    }
}

}  // namespace

TEST_CASE("hits with a box are right on extreme cases", "[10.2][stability]") {
    check_families(box_families(), 20'000);
}

TEST_CASE("hits with a disc are right on extreme cases", "[10.3][stability]") {
    check_families(disc_families(), 5'000);
}

TEST_CASE("hits with a cone or cylinder are right on extreme cases", "[10.5][stability]") {
    check_families(cone_families(), 1'500);
}

TEST_CASE("rays that leave a box meet it no more, or at its far side", "[10.2][stability]") {
    check_leaving(tally, box_families(), 20'000, seed);
}

TEST_CASE("rays that leave a cone or cylinder meet it no more, or at its far side", "[10.6][stability]") {
    check_leaving(tally, cone_families(), 2'000, seed);
}

TEST_CASE("no crossing with an implicit surface is missed on extreme cases", "[10.13][stability]") {
    check_families(implicit_families(), 3'000);
}

TEST_CASE("rays that leave an implicit surface begin where they should", "[10.13][stability]") {
    check_leaving(tally, implicit_families(), 2'000, seed);
}

TEST_CASE("hits with a quadric are right on extreme cases", "[quadric][stability]") {
    check_families(quadric_families(), 10'000);
}

TEST_CASE("rays that leave a quadric begin where they should", "[quadric][stability]") {
    check_leaving(tally, quadric_families(), 10'000, seed);
}

TEST_CASE("the judge of implicit surfaces, by hand", "[stability]") {
    const auto judge = [](const char* f, std::optional<Real> proposed) {
        return oracle::judge_line(parse_formula(f), Vec3(0), Vec3(1, 0, 0), gamma(64), proposed, gamma(4));
    };
    CHECK(judge("(x-1/4)*(x-1/2)", std::nullopt).roots == 2);
    CHECK(judge("(x-1/4)*(x-1/2)", std::nullopt).is_overlooked);
    CHECK(judge("(x-1/4)*(x-1/2)", 0.5).is_overlooked);
    CHECK_FALSE(judge("(x-1/4)*(x-1/2)", 0.25).is_overlooked);
    CHECK(judge("(x-1/4)*(x-1/2)", 0.25).is_on);
    CHECK_FALSE(judge("(x-1/4)*(x-1/2)", 0.2501).is_on);
    CHECK_FALSE(judge("(x-1/4)^2", std::nullopt).is_overlooked);
    CHECK(judge("(x-1/4)^2", std::nullopt).roots == 1);
    CHECK(judge("(x-1/4)^2-10^-40", std::nullopt).has_hidden);
    CHECK(judge("x/3-1/9", 1.0 / 3).is_on);
    CHECK(judge("x^2+1", std::nullopt).roots == 0);
}

TEST_CASE("the judge of solids, by hand", "[stability]") {
    const Cone hat{{0, 0, 0}, 1, {0, 2, 0}, 0};
    const Ray across{{3, 1, 0}, {-1, 0, 0}}, above{{3, 3, 0}, {-1, 0, 0}}, tip{{3, 2, 0}, {-1, 0, 0}};
    CHECK(oracle::meets(hat, across, {2.5, 2.5}));
    CHECK_FALSE(oracle::meets(hat, across, {0, std::nextafter(2.5, 0.0)}));
    CHECK(oracle::meets(hat, across, {3.5, infinity}));
    CHECK_FALSE(oracle::meets(hat, across, {std::nextafter(3.5, 4.0), infinity}));
    CHECK_FALSE(oracle::meets(hat, above, {-infinity, infinity}));
    CHECK(oracle::meets(hat, tip, {-infinity, infinity}));
    CHECK_FALSE(oracle::meets(hat, tip, {-infinity, infinity}, {-1e-300, 0}));
}
