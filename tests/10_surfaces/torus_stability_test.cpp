// Chapter 10's quartics and tori against exact arithmetic, on cases made to break them.
// Demands: tests/stability/tori.hpp and leaving.hpp.
#include "tests/10_surfaces/check_families.hpp"
#include "tests/oracle/polynomial.hpp"
#include "tests/oracle/torus.hpp"

using namespace rt;
using namespace rt::stability;

namespace {

constexpr std::uint64_t seed = 10;

/// Fewer than of other shapes, because the judge takes some tenths of a millisecond a case.
constexpr int cases_a_family = 2'000;

Tally tally("10 tori");

}  // namespace

TEST_CASE("the roots of extreme quartics are all found", "[10.8][stability]") {
    for (const PolynomialFamily& family : polynomial_families()) {
        const auto questions = family.make(how_many(tally, cases_a_family), seed);
        const auto tenth = a_tenth(questions, cases_a_family);
        const auto stable = [](const PolynomialCase& q) { return sign_changes(q.polynomial, q.low, q.high); };
        const auto naive = [](const PolynomialCase& q) {
            return naive::sign_changes(q.polynomial, q.low, q.high);
        };
        check_family(tally, family.name, judge(questions, ask<SignChanges>(questions, stable)),
                     judge(tenth, ask<SignChanges>(tenth, naive)));
    }
}

TEST_CASE("what is inside a torus is right on extreme cases", "[10.10][stability]") {
    for (const TorusFamily& family : torus_families()) {
        const auto questions = family.make(how_many(tally, cases_a_family), seed);
        const auto tenth = a_tenth(questions, cases_a_family);
        const auto stable = [](const TorusCase& q) { return inside(q.torus, q.ray); };
        const auto naive = [](const TorusCase& q) { return naive::inside(q.torus, q.ray); };
        check_family(tally, family.name, judge(questions, ask<TorusSpans>(questions, stable)),
                     judge(tenth, ask<TorusSpans>(tenth, naive)));
    }
}

TEST_CASE("rays that leave a torus start outside of it, or inside, and then meet what is there",
          "[10.10][stability]") {
    check_leaving(tally, torus_families(), cases_a_family, seed);
}

TEST_CASE("the judge of quartics, by hand", "[stability]") {
    const oracle::Coefficients one_to_four{24, -50, 35, -10, 1}, touching{1, -2, 1, 0, 0},
        nothing{1, 0, 0, 0, 1};
    CHECK(oracle::count_roots(one_to_four, {0, 5}) == 4);
    CHECK(oracle::count_roots(one_to_four, {1, 3}) == 2);
    CHECK(oracle::count_roots(one_to_four, {-5, 1}) == 1);
    CHECK(oracle::count_roots(touching, {-5, 5}) == 1);
    CHECK(oracle::count_roots(touching, {-5, 5}, 1e-300) == 0);
    CHECK(oracle::count_roots(touching, {-5, 5}, -1e-300) == 2);
    CHECK(oracle::count_roots(nothing, {-5, 5}) == 0);
    CHECK(oracle::can_be_positive(one_to_four, {2, 3}, 0));
    CHECK_FALSE(oracle::can_be_positive(one_to_four, {2, std::nextafter(3.0, 4.0)}, 0));
    CHECK(oracle::can_be_not_positive(one_to_four, {1, 2}, 0));
    CHECK_FALSE(oracle::can_be_not_positive(one_to_four, {1.5, 3.5}, 0));
    CHECK(oracle::residual(one_to_four, 2) == 0);
    CHECK(oracle::residual({-1, 0, 1, 0, 0}, 2) == 0.6);
}

TEST_CASE("the judge of tori, by hand", "[stability]") {
    const Torus ring{{0, 0, 0}, {0, 2, 0}, 3, 1}, spindle{{0, 0, 0}, {0, 1, 0}, 3, 5};
    const Ray across{{10, 0, 0}, {-1, 0, 0}}, axis{{0, 10, 0}, {0, -1, 0}}, top{{10, 1, 0}, {-1, 0, 0}};
    const oracle::LineAndTorus both(ring, across);
    CHECK(both.meets({0, 6}));
    CHECK_FALSE(both.meets({0, std::nextafter(6.0, 0.0)}));
    CHECK(both.covers({6, 8}));
    CHECK_FALSE(both.covers({6, std::nextafter(8.0, 9.0)}));
    CHECK_FALSE(both.covers({7, 13}));
    CHECK_FALSE(both.meets({9, 11}));
    CHECK(both.meets({-infinity, infinity}));
    CHECK_FALSE(oracle::LineAndTorus(ring, axis).meets({-infinity, infinity}));
    CHECK(oracle::LineAndTorus(ring, top).meets({-infinity, infinity}));
    CHECK_FALSE(oracle::LineAndTorus(ring, top, -1e-300).meets({-infinity, infinity}));
    CHECK_FALSE(oracle::LineAndTorus(ring, across, -2).meets({-infinity, infinity}));
    const oracle::LineAndTorus through(spindle, axis), wide(spindle, across);
    CHECK(through.covers({6.5, 13.5}));
    CHECK_FALSE(through.meets({0, 5.5}));
    CHECK_FALSE(through.covers({5.5, 10}));
    CHECK(wide.covers({2, 18}));
    CHECK_FALSE(wide.meets({0, 1.5}));
}
