// The spheres of chapter 2 against exact arithmetic, on cases made to break them.
// Demands and condition numbers: tests/stability/spheres.hpp.
#include "chapters/02_spheres/sphere.hpp"
#include "tests/oracle/sphere.hpp"
#include "tests/stability/check.hpp"
#include "tests/stability/naive.hpp"
#include "tests/stability/spheres.hpp"

#include <string>

using namespace rt;
using namespace rt::stability;
using rt::test::cases;

namespace {

constexpr std::uint64_t seed = 2;

Tally tally("02 spheres");

}  // namespace

TEST_CASE("the roots of a quadratic are right to 4 roundings, however far apart", "[02.1][stability]") {
    const auto questions = quadratic_cases(how_many(tally, 100'000), seed);
    const auto stable = [](const QuadraticCase& q) { return solve_quadratic(q.a, q.h, q.c, q.discriminant); };
    const auto naive = [](const QuadraticCase& q) { return naive::solve_quadratic(q.a, q.h, q.c); };
    check(tally, "coefficients of all sizes", judge(questions, ask<Roots>(questions, stable)),
          judge(some(questions), ask<Roots>(some(questions), naive)));
}

TEST_CASE("both roots of a line and a sphere are right on extreme cases", "[02.2][stability]") {
    const auto both_roots = [](const SphereCase& question) {
        return intersections(question.sphere, question.ray);
    };
    for (const SphereFamily& family : sphere_families()) {
        const auto questions = family.make(how_many(tally, 100'000), seed);
        const Verdict verdict = judge(questions, ask<Roots>(questions, both_roots));
        add(tally.stable, verdict);
        check_right(family.name, verdict);
    }
}

TEST_CASE("the nearest hit with a sphere is right on extreme cases", "[02.3][stability]") {
    const auto stable = [](const SphereCase& q) { return intersect(q.sphere, q.ray, Interval{}); };
    const auto naive = [](const SphereCase& q) { return naive::intersect(q.sphere, q.ray, Interval{}); };
    for (const SphereFamily& family : sphere_families()) {
        const auto questions = family.make(how_many(tally, 100'000), seed + 1);
        check(tally, family.name, judge(questions, ask<std::optional<Hit>>(questions, stable)),
              judge(some(questions), ask<std::optional<Hit>>(some(questions), naive)));
    }
}

TEST_CASE("the judge of spheres agrees with CGAL's own predicate and algebraic numbers", "[stability]") {
    for (const SphereFamily& family : sphere_families()) {
        for (const SphereCase& item : family.make(static_cast<std::size_t>(cases(500)), seed + 2)) {
            const oracle::SphereTruth truth = oracle::judge_sphere(item.sphere, item.ray, 0, 0);
            INFO(family.name << ": " << literal(item.sphere) << ", " << literal(item.ray));
            // Proposing 0 makes the error −root, exactly signed.
            const bool hit = truth.roots > 0 && truth.error1 <= 0;
            CHECK(hit == (oracle::cgal_ray_meets_ball(item.sphere, item.ray)));
            if (truth.roots == 0) continue;
            const Real slack = 16 * std::numeric_limits<Real>::epsilon();
            const auto low = [&](Real t) { return t - slack * std::abs(t); };
            const auto high = [&](Real t) { return t + slack * std::abs(t); };
            CHECK(oracle::cgal_root_is_between(item.sphere, item.ray, false, low(truth.t0), high(truth.t0)));
            CHECK(oracle::cgal_root_is_between(item.sphere, item.ray, true, low(truth.t1), high(truth.t1)));
        }
    }
}
