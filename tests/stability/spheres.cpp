// Families of extreme cases for chapter 2, and their judge.
#include "tests/stability/spheres.hpp"

#include "common/math/error.hpp"
#include "tests/oracle/sphere.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt::stability {
namespace {

using test::many;
using test::Random;

// 4 ulp, as a relative error: an ulp is at most 2u.
constexpr Real band = 8 * unit_roundoff;

// --------------------------------------------------------------------------------------------- families

/// A ray from `distance` away towards a point beside the centre, `offset` away from it.
SphereCase aimed(Random& random, Real radius, Real distance, Real offset, Real length) {
    const Vec3 direction = random.direction();
    const Sphere sphere{distance * random.in_cube(), radius};
    const Vec3 origin = sphere.center - distance * direction;
    const Vec3 target = sphere.center + offset * random.perpendicular_to(direction);
    return {sphere, {origin, (target - origin) * (length / distance)}};
}

std::vector<SphereCase> far(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real radius = random.magnitude(-3, 3);
        const Real distance = radius * random.magnitude(0, 8);
        return aimed(random, radius, distance, radius * random.uniform(0, 1.2), random.uniform(0.5, 2));
    });
}

std::vector<SphereCase> tiny_and_huge(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real radius = random.uniform(1, 2) * (random.sign() > 0 ? 1e12 : 1e-12);
        const Real distance = radius * random.magnitude(0, 8);
        return aimed(random, radius, distance, radius * random.uniform(0, 1.2), random.uniform(0.5, 2));
    });
}

std::vector<SphereCase> inside(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Sphere sphere{random.in_cube() * random.magnitude(-3, 3), random.magnitude(-3, 3)};
        // From the middle to within 1e-8 radii of the surface.
        const Real depth = random.magnitude(-8, 0);
        const Vec3 origin = sphere.center + (1 - depth) * sphere.radius * random.direction();
        return SphereCase{sphere, {origin, random.uniform(0.5, 2) * random.direction()}};
    });
}

std::vector<SphereCase> on_the_surface(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Sphere sphere{random.in_cube() * random.magnitude(-3, 3), random.magnitude(-6, 3)};
        const Vec3 origin = sphere.center + sphere.radius * random.direction();
        return SphereCase{sphere, {origin, random.uniform(0.5, 2) * random.direction()}};
    });
}

std::vector<SphereCase> tangent(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real radius = random.magnitude(-3, 3);
        const Real ulps = std::floor(random.uniform(-80, 81));
        const Real offset = radius * (1 + ulps * 2 * unit_roundoff);
        const Real distance = radius * random.magnitude(0, 1);
        if (random.index(2) == 0) return aimed(random, radius, distance, offset, random.uniform(0.5, 2));
        // Along an axis the offset is exact.
        const int axis = static_cast<int>(random.index(3)), other = (axis + 1) % 3;
        Ray ray{Vec3(0), Vec3(0)};
        ray.origin[axis] = -random.sign() * distance;
        ray.origin[other] = random.sign() * offset;
        ray.direction[axis] = -std::copysign(random.uniform(0.5, 2), ray.origin[axis]);
        return SphereCase{{Vec3(0), radius}, ray};
    });
}

std::vector<SphereCase> long_and_short_directions(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real radius = random.magnitude(-1, 1);
        const Real distance = radius * random.magnitude(0, 8);
        const Real length = random.uniform(1, 2) * (random.sign() > 0 ? 1e20 : 1e-20);
        return aimed(random, radius, distance, radius * random.uniform(0, 1.2), length);
    });
}

std::vector<SphereCase> small_and_far(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Vec3 target(0, random.uniform(-0.12, 0.12), random.uniform(-0.12, 0.12));
        const Vec3 origin(-1e7, 0, 0);
        return SphereCase{{Vec3(0), 0.1}, {origin, (target - origin) * random.uniform(1e-7, 2e-7)}};
    });
}

constexpr std::array<SphereFamily, 7> families{{
    {"distance over radius from 1 to 1e8", "about 2/cos of the angle to the normal", far},
    {"radius 1e-12 and 1e12", "about 2/cos of the angle to the normal", tiny_and_huge},
    {"origin inside the sphere", "up to 1e8, radius over distance to the surface", inside},
    {"origin on the surface", "2 for the far root; without bound for the root near 0", on_the_surface},
    {"nearly tangent rays, at r(1 + k ulp)", "up to 1e8, near 1/sqrt(k ulp)", tangent},
    {"directions of length 1e-20 and 1e20", "about 2/cos of the angle to the normal",
     long_and_short_directions},
    {"radius 0.1 seen from x = -1e7", "about 2/cos of the angle to the normal", small_and_far},
}};

// ------------------------------------------------------------------------------------------------ judge

/// The exact truth about a case, and what follows from it for two proposed roots.
struct Judgement {
    oracle::SphereTruth truth;
    bool near_tangent = false;          ///< 4 ulp decide between hit and miss
    Real allowed0 = 0, allowed1 = 0;    ///< 8κu|t| for the exact roots
    bool fits0 = false, fits1 = false;  ///< whether the proposed roots are right
    Real error0 = 0, error1 = 0;        ///< in units of what is allowed
};

Judgement judge_one(const SphereCase& item, Real proposed0, Real proposed1) {
    Judgement result;
    result.truth = oracle::judge_sphere(item.sphere, item.ray, proposed0, proposed1);
    const oracle::SphereTruth& truth = result.truth;

    const Real from_centre = length(item.ray.origin - item.sphere.center);
    const Real speed = std::sqrt(truth.a);
    const Real radius = item.sphere.radius;
    // Moving the data by a relative `band` moves a point of the line, or the sphere, by at most this.
    const auto moved = [&](Real t) { return band * (from_centre + std::abs(t) * speed + radius); };
    const Real middle = (truth.t0 + truth.t1) / 2;
    result.near_tangent = truth.roots == 1 || std::abs(truth.depth) <= moved(middle);

    if (truth.roots == 2) {
        const Real cosine_times_speed = std::sqrt(truth.discriminant) / radius;
        result.allowed0 = moved(truth.t0) / cosine_times_speed;
        result.allowed1 = moved(truth.t1) / cosine_times_speed;
        result.error0 = std::abs(truth.error0) / result.allowed0;
        result.error1 = std::abs(truth.error1) / result.allowed1;
    } else {
        // No root to compare with: the point must lie on the sphere but for 4 ulp of the data.
        result.allowed0 = result.allowed1 = std::sqrt(2 * radius * moved(middle)) / speed;
        result.error0 = std::abs(truth.distance0) / moved(proposed0);
        result.error1 = std::abs(truth.distance1) / moved(proposed1);
    }
    result.fits0 = result.error0 <= 1;
    result.fits1 = result.error1 <= 1;
    return result;
}

std::string literal(const SphereCase& item) {
    return stability::literal(item.sphere) + ", " + stability::literal(item.ray);
}

std::string expected(const oracle::QuadraticTruth& truth) {
    if (truth.roots == 0) return "no root";
    return "roots " + stability::literal(truth.t0) + " and " + stability::literal(truth.t1);
}

std::string answered(const Roots& roots) {
    if (roots.count == 0) return "no root";
    return std::to_string(roots.count) + " roots, " + stability::literal(roots.t0) + " and " +
           stability::literal(roots.t1);
}

}  // namespace

std::span<const SphereFamily> sphere_families() { return families; }

Verdict judge(std::span<const SphereCase> cases, std::span<const Roots> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Roots& roots = answers[i];
        const Judgement exact = judge_one(cases[i], roots.t0, roots.t1);
        if (exact.near_tangent) ++verdict.undecided;
        const bool right = roots.count == 0 ? exact.truth.roots == 0 || exact.near_tangent
                                            : (exact.truth.roots == 2 || exact.near_tangent) && exact.fits0 &&
                                                  exact.fits1 && roots.t0 <= roots.t1;
        if (!right)
            count_mismatch(verdict, literal(cases[i]) + "\n  right: " + expected(exact.truth) +
                                        "\n  answered: " + answered(roots));
        else if (roots.count > 0)
            remember(verdict, std::max(exact.error0, exact.error1), [&] { return literal(cases[i]); });
    }
    return verdict;
}

Verdict judge(std::span<const SphereCase> cases, std::span<const std::optional<Hit>> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Real t = answers[i] ? answers[i]->t : 0;
        const Judgement exact = judge_one(cases[i], t, t);
        const bool meets = exact.truth.roots == 2 && !exact.near_tangent;
        // Roots whose sign 4 ulp can't change.
        const bool first_is_ahead = meets && exact.truth.t0 > exact.allowed0;
        const bool second_is_ahead = meets && exact.truth.t1 > exact.allowed1;
        const bool undecided = exact.near_tangent || (meets && (std::abs(exact.truth.t0) <= exact.allowed0 ||
                                                                std::abs(exact.truth.t1) <= exact.allowed1));
        if (undecided) ++verdict.undecided;
        const bool possible = exact.truth.roots == 2 || exact.near_tangent;
        const bool right = answers[i] ? t > 0 && possible && (exact.fits0 || (exact.fits1 && !first_is_ahead))
                                      : !first_is_ahead && !second_is_ahead;
        if (!right)
            count_mismatch(verdict, literal(cases[i]) + "\n  right: " + expected(exact.truth) +
                                        "\n  answered: " +
                                        (answers[i] ? "a hit at " + stability::literal(t) : "a miss"));
        else if (answers[i])
            remember(verdict, std::min(exact.error0, exact.error1), [&] { return literal(cases[i]); });
    }
    return verdict;
}

std::vector<QuadraticCase> quadratic_cases(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<QuadraticCase> cases;
    cases.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        QuadraticCase item;
        item.a = random.magnitude(-20, 20);
        item.h = item.a * random.sign() * random.magnitude(-20, 20);
        // From h²/a, where the roots meet, to 1e16 times less, where one is tiny.
        item.c = random.sign() * item.h * (item.h / item.a) * random.magnitude(-16, 1);
        item.discriminant = oracle::judge_quadratic(item.a, item.h, item.c, 0, 0).discriminant;
        cases.push_back(item);
    }
    return cases;
}

Verdict judge(std::span<const QuadraticCase> cases, std::span<const Roots> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const QuadraticCase& item = cases[i];
        const Roots& roots = answers[i];
        const oracle::QuadraticTruth truth =
            oracle::judge_quadratic(item.a, item.h, item.c, roots.t0, roots.t1);
        const Real allowed = 4 * unit_roundoff;
        const Real error = std::max(std::abs(truth.error0 / truth.t0), std::abs(truth.error1 / truth.t1));
        const bool right =
            roots.count == truth.roots && (roots.count == 0 || (error <= allowed && roots.t0 <= roots.t1));
        const auto text = [&] {
            return "a = " + stability::literal(item.a) + ", h = " + stability::literal(item.h) +
                   ", c = " + stability::literal(item.c) +
                   ", discriminant = " + stability::literal(item.discriminant);
        };
        if (!right)
            count_mismatch(verdict,
                           text() + "\n  right: " + expected(truth) + "\n  answered: " + answered(roots));
        else if (roots.count > 0)
            remember(verdict, error / allowed, text);
    }
    return verdict;
}

}  // namespace rt::stability
