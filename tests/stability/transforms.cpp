// Families of extreme cases for chapter 4, and their judges.
#include "tests/stability/transforms.hpp"

#include "common/math/error.hpp"
#include "tests/oracle/matrix.hpp"
#include "tests/oracle/sphere.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt::stability {
namespace {

using test::many;
using test::Random;

constexpr Real band = 8 * unit_roundoff;

// --------------------------------------------------------------------------------------------- families

// Written out here, so that the families are the same whatever implementation is judged.

Mat4 moved_by(const Vec3& offset) {
    Mat4 m(1);
    m[3] = Vec4(offset, 1);
    return m;
}

Mat4 scaled_by(const Vec3& by) {
    Mat4 m(1);
    for (int i = 0; i < 3; ++i) m[i][i] = by[i];
    return m;
}

/// By any angle about any axis or, half of the time, by a multiple of 15° about an axis of coordinates, which
/// leaves elements that are zero or nearly so.
Mat4 turned(Random& random) {
    const bool plain = random.index(2) == 0;
    Vec3 k = random.direction();
    if (plain) {
        k = Vec3(0);
        k[static_cast<int>(random.index(3))] = 1;
    }
    const Real angle = plain ? radians(15 * static_cast<Real>(random.index(24))) : random.uniform(-pi, pi);
    const Real c = std::cos(angle);
    const Real s = std::sin(angle);
    Mat4 m(1);
    for (int i = 0; i < 3; ++i) {
        Vec3 e(0);
        e[i] = 1;
        m[i] = Vec4(c * e + (1 - c) * k[i] * k + s * cross(k, e), 0);
    }
    return m;
}

Vec3 factors(Random& random, Real exponent) {
    Vec3 by;
    for (int i = 0; i < 3; ++i) by[i] = random.sign() * random.magnitude(-exponent, exponent);
    return by;
}

Mat4 sheared(Random& random, Real most) {
    Mat4 m(1);
    const int from = static_cast<int>(random.index(3)),
              to = (from + 1 + static_cast<int>(random.index(2))) % 3;
    m[from][to] = random.sign() * random.magnitude(0, std::log10(most));
    return m;
}

/// With a translation that may be as long as anything in the matrix.
Mat4 somewhere(const Mat4& m, Random& random, Real exponent) {
    Mat4 result = m;
    result[3] = Vec4(factors(random, exponent), 1);
    return result;
}

/// The exact inverse, rounded: the best that any method can find.
Mat4 exact_inverse(const Mat4& m) {
    const Mat3 linear = oracle::judge_inverse(m, Mat4(1)).inverse;
    Mat4 result(1);
    for (int c = 0; c < 3; ++c) result[c] = Vec4(linear[c], 0);
    result[3] = Vec4(-(linear * Vec3(m[3])), 1);
    return result;
}

std::vector<Mat4> scale_then_turn(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Mat4 turn = turned(random);
        return somewhere(turn * scaled_by(factors(random, 15)), random, 15);
    });
}

std::vector<Mat4> turn_then_scale(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Mat4 turn = turned(random);
        return somewhere(scaled_by(factors(random, 15)) * turn, random, 15);
    });
}

std::vector<Mat4> shears(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Mat4 first = turned(random), shear = sheared(random, 1e6);
        return somewhere(turned(random) * shear * first, random, 6);
    });
}

std::vector<Mat4> reflections(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Mat4 first = turned(random);
        Vec3 by = random.magnitude(-6, 6) * abs(factors(random, 1));
        by[static_cast<int>(random.index(3))] *= -1;
        return somewhere(turned(random) * scaled_by(by) * first, random, 6);
    });
}

std::vector<Mat4> any_elements(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        Mat4 m(1);
        for (int c = 0; c < 3; ++c) m[c] = Vec4(factors(random, 8), 0);
        return somewhere(m, random, 8);
    });
}

std::vector<Mat4> chains(std::size_t count, std::uint64_t seed) {
    // One chain of 1000 steps after the other; every link of a chain is a case. A chain that shrinks, one
    // that grows.
    Random random(seed);
    std::vector<Mat4> cases;
    cases.reserve(count);
    Mat4 chain(1);
    Real growth = 1;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % 1000 == 0) {
            chain = Mat4(1);
            growth = i % 2000 == 0 ? 0.8 : 1.25;
        }
        switch (random.index(4)) {
            case 0:
                chain = chain * moved_by(10.0 * random.in_cube());
                break;
            case 1:
                chain = chain * scaled_by(growth * factors(random, 0.01));
                break;
            default:
                chain = chain * turned(random);
        }
        cases.push_back(chain);
    }
    return cases;
}

std::vector<Mat4> nearly_singular(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Mat4 first = turned(random);
        Vec3 by(1);
        by[static_cast<int>(random.index(3))] = random.magnitude(-25, -5);
        return somewhere(turned(random) * scaled_by(by) * first, random, 3);
    });
}

std::vector<Mat4> singular(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const auto whole = [&] {
            return static_cast<Real>(static_cast<int>(random.index(2'000'001)) - 1'000'000);
        };
        const auto small = [&] { return static_cast<Real>(static_cast<int>(random.index(2001)) - 1000); };
        // One vector, two or none, and whole multiples of them: rank 2, 1 or 0 without rounding. Then rows or
        // columns in other units.
        Vec3 p(whole(), whole(), whole()), q(whole(), whole(), whole());
        if (random.index(4) == 0) q = Vec3(0);
        if (random.index(16) == 0) p = Vec3(0);
        std::array<Vec3, 3> lines{p, q, small() * p + small() * q};
        std::swap(lines[2], lines[random.index(3)]);
        Mat4 m(1);
        const bool rows = random.index(2) == 0;
        for (int i = 0; i < 3; ++i) {
            const Real unit = std::ldexp(Real(1), static_cast<int>(random.index(101)) - 50);
            for (int k = 0; k < 3; ++k) {
                const Real element = unit * lines[static_cast<std::size_t>(i)][k];
                (rows ? m[k][i] : m[i][k]) = element;
            }
        }
        return somewhere(m, random, 6);
    });
}

constexpr std::array<MatrixFamily, 8> families{{
    {"scaled by 1e-15 to 1e15, then turned", "3 at most on the diagonal", scale_then_turn},
    {"turned, then scaled by 1e-15 to 1e15", "3 at most on the diagonal", turn_then_scale},
    {"shears by up to 1e6", "up to 1e12", shears},
    {"reflections", "up to 1e2", reflections},
    {"elements from 1e-8 to 1e8", "1 mostly, without bound", any_elements},
    {"chains of 1000 steps", "up to 1e3", chains},
    {"nearly singular", "from 1e5 to 1e25", nearly_singular},
    {"singular", "infinite", singular},
}};

// ------------------------------------------------------------------------------------------- ellipsoids

Mat3 absolute(const Mat3& m) { return {abs(m[0]), abs(m[1]), abs(m[2])}; }

/// A ray from `distance` away, in the ellipsoid's own units, towards a point of or beside it.
EllipsoidCase aimed(Random& random, const Mat4& to_world, Real distance, Real offset) {
    const Vec3 side = random.direction();
    const Vec3 from = distance * random.direction();
    const Vec3 target = offset * normalize(cross(from, side));
    const Vec3 o(to_world * Vec4(from, 1)), p(to_world * Vec4(target, 1));
    EllipsoidCase item;
    item.ellipsoid.transform.to_world = to_world;
    item.ellipsoid.transform.to_local = exact_inverse(to_world);
    item.ray = {o, random.uniform(0.5, 2) * (p - o)};
    return item;
}

std::vector<EllipsoidCase> needles_and_discs(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Mat4 turn = turned(random);
        const Mat4 m = somewhere(turn * scaled_by(factors(random, 4)), random, 2);
        return aimed(random, m, random.magnitude(0, 4), random.uniform(0, 1.3));
    });
}

std::vector<EllipsoidCase> sheared_balls(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Mat4 first = turned(random);
        const Mat4 m = somewhere(turned(random) * sheared(random, 1e6) * first, random, 2);
        return aimed(random, m, random.magnitude(0, 4), random.uniform(0, 1.3));
    });
}

std::vector<EllipsoidCase> far_balls(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Mat4 m = somewhere(turned(random) * scaled_by(factors(random, 1)), random, 3);
        return aimed(random, m, random.magnitude(4, 8), random.uniform(0, 1.3));
    });
}

std::vector<EllipsoidCase> huge_and_tiny(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real unit = random.index(2) == 0 ? 1e15 : 1e-15;
        Mat4 m = scaled_by(unit * factors(random, 1)) * turned(random);
        m[3] = Vec4(unit * factors(random, 1), 1);
        return aimed(random, m, random.magnitude(0, 2), random.uniform(0, 1.3));
    });
}

std::vector<EllipsoidCase> from_inside(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Mat4 turn = turned(random);
        const Mat4 m = somewhere(turn * scaled_by(factors(random, 3)), random, 0);
        return aimed(random, m, random.uniform(0.01, 0.99), random.uniform(0, 1));
    });
}

constexpr std::array<EllipsoidFamily, 5> families_of_ellipsoids{{
    {"needles and discs, 1e-4 to 1e4", "up to 1e8", needles_and_discs},
    {"balls sheared by up to 1e6", "up to 1e14", sheared_balls},
    {"seen from up to 1e8 radii", "about 2/cos of the angle to the normal", far_balls},
    {"of size 1e-15 and 1e15", "about 2/cos of the angle to the normal", huge_and_tiny},
    {"from inside", "about 1 to 1e3", from_inside},
}};

// ------------------------------------------------------------------------------------------------ judge

std::string literal(const Mat4& m) {
    std::string text = "Mat4{";
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) text += (c + r == 0 ? "" : ", ") + stability::literal(m[c][r]);
    return text + "}";
}

bool is_finite(const Mat4& m) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r])) return false;
    return true;
}

/// 8u times κ, to first order and a little more; elements that κ says are exactly zero may be off by u as
/// much as the others.
Mat3 allowed(const Mat3& kappa) {
    Real greatest = 0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) greatest = std::max(greatest, kappa[c][r]);
    Mat3 result = band * kappa + band * unit_roundoff * (kappa * kappa);
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            if (result[c][r] == 0) result[c][r] = band * unit_roundoff * greatest;
    return result;
}

/// The greatest of |error| / allowed, with 0/0 = 0.
Real worst_of(const Mat3& error, const Mat3& allow) {
    Real worst = 0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            if (error[c][r] != 0) worst = std::max(worst, std::abs(error[c][r]) / allow[c][r]);
    return worst;
}

}  // namespace

std::span<const MatrixFamily> matrix_families() { return families; }

Verdict judge(std::span<const Mat4> cases, std::span<const std::optional<Mat4>> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Mat4& m = cases[i];
        const std::optional<Mat4>& x = answers[i];
        if (x && !is_finite(*x)) {
            count_mismatch(verdict, literal(m) + "\n  answered with numbers that are not finite");
            continue;
        }
        const oracle::InverseTruth truth = oracle::judge_inverse(m, x.value_or(Mat4(1)));
        if (truth.singular) {
            if (x) count_mismatch(verdict, literal(m) + "\n  is singular, but got an inverse");
            continue;
        }
        const Mat3 linear(m), absolute_m = absolute(linear), absolute_x = absolute(truth.inverse);
        const Mat3 kappa = absolute_m * absolute_x, left_kappa = absolute_x * absolute_m;
        // Each row in units of its greatest element.
        Vec3 unit;
        for (int r = 0; r < 3; ++r)
            unit[r] = std::max({absolute_m[0][r], absolute_m[1][r], absolute_m[2][r]});
        Real norm = 0;
        for (int r = 0; r < 3; ++r) {
            Real sum = 0;
            for (int c = 0; c < 3; ++c) sum += kappa[c][r] / unit[r] * unit[c];
            norm = std::max(norm, sum);
        }
        const bool near = norm * 2 * band >= 1;
        if (near) ++verdict.undecided;
        if (!x) {
            if (!near) count_mismatch(verdict, literal(m) + "\n  has an inverse, but got none");
            continue;
        }
        const Vec3 t(m[3]);
        Real error =
            std::max(worst_of(truth.right, allowed(kappa)), worst_of(truth.left, allowed(left_kappa)));
        const Vec3 allow_t = allowed(kappa) * abs(t);
        for (int r = 0; r < 3; ++r)
            if (truth.translation[r] != 0)
                error = std::max(error, std::abs(truth.translation[r]) / allow_t[r]);
        if (error > 1)
            count_mismatch(verdict, literal(m) + "\n  M times its inverse is off by " +
                                        std::to_string(error) + " of what is allowed");
        else
            remember(verdict, error, [&] { return literal(m); });
    }
    return verdict;
}

std::vector<NormalCase> normal_cases(const MatrixFamily& family, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<NormalCase> cases;
    for (const Mat4& m : family.make(count, seed)) {
        const auto whole = [&] { return static_cast<Real>(static_cast<int>(random.index(2001)) - 1000); };
        const Vec3 p(whole(), whole(), whole()), tangent(whole(), whole(), whole());
        // Whole numbers below 2^53: nothing is rounded.
        const Vec3 normal = cross(p, tangent);
        if (normal == Vec3(0)) continue;
        cases.push_back({{m, exact_inverse(m)}, normal, tangent});
    }
    return cases;
}

Verdict judge(std::span<const NormalCase> cases, std::span<const Vec3> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Vec3 &normal = cases[i].normal, &tangent = cases[i].tangent;
        const Mat4& m = cases[i].transform.to_world;
        const oracle::InverseTruth truth = oracle::judge_inverse(m, Mat4(1));
        const Vec3 image = Mat3(m) * tangent;
        const Vec3 right = glm::transpose(truth.inverse) * normal;
        const Vec3 spread = absolute(truth.inverse) * (absolute(Mat3(m)) * abs(tangent));
        const Real kappa = dot(abs(normal), spread) / (length(right) * length(image));
        const Real cosine = std::abs(oracle::judge_normal(m, answers[i], tangent)) / length(image);
        const Real error = std::max(cosine / (band * (kappa + 1)), std::abs(length(answers[i]) - 1) / band);
        const auto text = [&] {
            return literal(m) + ", normal " + stability::literal(normal) + ", tangent " +
                   stability::literal(tangent);
        };
        if (!(error <= 1))
            count_mismatch(verdict, text() + "\n  the normal of the image is " +
                                        stability::literal(answers[i]) + ", " + std::to_string(error) +
                                        " of what is allowed off a right angle");
        else
            remember(verdict, error, text);
    }
    return verdict;
}

std::span<const EllipsoidFamily> ellipsoid_families() { return families_of_ellipsoids; }

Verdict judge(std::span<const EllipsoidCase> cases, std::span<const std::optional<Hit>> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Ray& ray = cases[i].ray;
        const Mat4& m = cases[i].ellipsoid.transform.to_world;
        const Mat4& x = cases[i].ellipsoid.transform.to_local;
        const Real t = answers[i] ? answers[i]->t : 0;
        const oracle::SphereTruth truth = oracle::judge_ellipsoid(m, ray, t, t);
        const Vec3 local_o(x * Vec4(ray.origin, 1)), local_d(x * Vec4(ray.direction, 0));
        const auto moved = [&](Real at) {
            const Vec3 sum = abs(ray.origin) + std::abs(at) * abs(ray.direction) + abs(Vec3(m[3]));
            return band * (length(absolute(Mat3(x)) * sum) + 1);
        };
        const auto off = [&](Real at) {
            const Vec3 n = normalize(local_o + at * local_d);
            return moved(at) / std::abs(dot(n, local_d));
        };
        const Real middle = (truth.t0 + truth.t1) / 2;
        const bool near_tangent = truth.roots == 1 || std::abs(truth.depth) <= moved(middle);
        const bool meets = truth.roots == 2 && !near_tangent;
        const Real allow0 = meets ? off(truth.t0) : 0, allow1 = meets ? off(truth.t1) : 0;
        const bool first_ahead = meets && truth.t0 > allow0, second_ahead = meets && truth.t1 > allow1;
        const bool undecided =
            near_tangent || (meets && (std::abs(truth.t0) <= allow0 || std::abs(truth.t1) <= allow1));
        if (undecided) ++verdict.undecided;

        Real error = 0;
        bool right = false;
        if (!answers[i]) {
            right = !first_ahead && !second_ahead;
        } else if (near_tangent) {
            error = std::abs(truth.distance0) / moved(t);
            right = t > 0 && error <= 1;
        } else if (meets) {
            const Real error0 = std::abs(truth.error0) / allow0, error1 = std::abs(truth.error1) / allow1;
            error = first_ahead ? error0 : std::min(error0, error1);
            right = t > 0 && error <= 1;
        }
        const auto text = [&] { return literal(m) + ", " + stability::literal(ray); };
        if (!right)
            count_mismatch(verdict, text() + "\n  right: " + std::to_string(truth.roots) + " roots, " +
                                        stability::literal(truth.t0) + " and " +
                                        stability::literal(truth.t1) + "\n  answered: " +
                                        (answers[i] ? "a hit at " + stability::literal(t) : "a miss"));
        else
            remember(verdict, error, text);
    }
    return verdict;
}

}  // namespace rt::stability
