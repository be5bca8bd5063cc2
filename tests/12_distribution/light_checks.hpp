// What the tests of lights with an extent share: solid angles in long double, and whether samples are as
// dense as they claim.
#pragma once

#include "chapters/12_distribution/light_direction.hpp"
#include "common/scene/area_lights.hpp"
#include "tests/catch.hpp"
#include "tests/chi_square.hpp"
#include "tests/support.hpp"
#include "tests/together.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace rt::test {

using Long = long double;
using LongVec = glm::vec<3, Long, glm::defaultp>;
inline const Long long_pi = std::acos(Long(-1));

inline std::string show(const LightDirection& found) {
    return "direction " + show(found.direction) + ", distance " + show(found.distance) + ", pdf " +
           show(found.pdf);
}
inline std::string show(const QuadLight& light) {
    return "parallelogram at " + show(light.corner) + " with sides " + show(light.ab) + " and " +
           show(light.ac);
}
inline std::string show(const TriangleLight& light) {
    return "triangle " + show(light.a) + ", " + show(light.b) + ", " + show(light.c);
}
inline std::string show(const SphereLight& light) {
    return "sphere around " + show(light.center) + " of radius " + show(light.radius);
}
inline std::string show(const DiscLight& light) {
    return "disc around " + show(light.center) + " with normal " + show(light.normal) + " and radius " +
           show(light.radius);
}

inline Vec2 square_point(Random& random) {
    const Real x = random.uniform(0, 1);
    return {x, random.uniform(0, 1)};
}

/// Directions to the light, each of which must exist.
template <class Light>
std::vector<LightDirection> directions_to(const Light& light, const Vec3& from, std::uint64_t seed,
                                          int full = 20000) {
    const std::vector<Vec2> pairs = many(static_cast<std::size_t>(cases(full)), seed, square_point);
    const auto found = answers(pairs, [&](const Vec2& numbers) { return toward(light, from, numbers); });
    std::vector<LightDirection> all;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!found[i]) FAIL("nothing for random numbers " << pairs[i]);
        all.push_back(*found[i]);
    }
    return all;
}

/// The two ends of [0, 1), and what is between them.
inline const std::array<Real, 7> ends_and_between{0, 1e-300, 1e-9, 0.3, 0.5, 1 - 1e-9, 1 - 0x1p-53};

/// A triangle seen from 0: its corners and its two sides at a.
struct LongTriangle {
    LongVec a, b, c, ab, ac;
};

inline LongTriangle spanned(const LongVec& a, const LongVec& ab, const LongVec& ac) {
    return {a, a + ab, a + ac, ab, ac};
}

inline LongTriangle long_triangle(const TriangleLight& light, const Vec3& from) {
    const LongVec a(light.a), b(light.b), c(light.c), viewer(from);
    return {a - viewer, b - viewer, c - viewer, b - a, c - a};
}

/// The two triangles into which ad divides a parallelogram, both bright on its bright side.
inline std::array<LongTriangle, 2> long_triangles(const QuadLight& light, const Vec3& from) {
    const LongVec a = LongVec(light.corner) - LongVec(from), ab(light.ab), ac(light.ac);
    return {spanned(a, ab + ac, ab), spanned(a, ac, ab + ac)};
}

/// ∫ cos θ/r² over a triangle by Gauss's rule of 12 × 12 points. cos θ·dA is a twelfth of a pyramid's edge
/// that all points share, so what is integrated is 1/r³: smooth, where the triangle is small.
inline Long angle_of_far_triangle(const LongTriangle& t, Long pyramid) {
    static const std::array<Long, 6> places = {0.1252334085114689154724L, 0.3678314989981801937527L,
                                               0.5873179542866174472967L, 0.7699026741943046870369L,
                                               0.9041172563704748566785L, 0.9815606342467192506906L};
    static const std::array<Long, 6> weights = {0.2491470458134027850006L, 0.2334925365383548087608L,
                                                0.2031674267230659217491L, 0.1600783285433462263347L,
                                                0.1069393259953184309603L, 0.0471753363865118271946L};
    Long sum = 0;
    for (std::size_t i = 0; i < 12; ++i)
        for (std::size_t j = 0; j < 12; ++j) {
            const Long p = (1 + (i % 2 == 0 ? places[i / 2] : -places[i / 2])) / 2;
            const Long q = (1 + (j % 2 == 0 ? places[j / 2] : -places[j / 2])) / 2;
            const Long r = glm::length(t.a + p * ((1 - q) * t.ab + q * t.ac));
            sum += weights[i / 2] * weights[j / 2] / 4 * p / (r * r * r);
        }
    return sum * pyramid;
}

/// The solid angle of a triangle, positive on its bright side: by Gauss's rule where it is far away, else as
/// what its three angles on the unit sphere have more than half a turn (Girard 1629).
inline Long exact_angle(const LongTriangle& t) {
    const std::array<LongVec, 3> corners{t.a, t.b, t.c};
    const LongVec& top = *std::min_element(corners.begin(), corners.end(), [](const auto& p, const auto& q) {
        return glm::length(p) < glm::length(q);
    });
    const Long pyramid = -glm::dot(top, glm::cross(t.ab, t.ac));
    const Long size = std::max({glm::length(t.ab), glm::length(t.ac), glm::length(t.ac - t.ab)});
    if (std::min({glm::length(t.a), glm::length(t.b), glm::length(t.c)}) > 4 * size)
        return angle_of_far_triangle(t, pyramid);
    const auto corner = [&](const LongVec& p, const LongVec& q, const LongVec& r) {
        return std::atan2(glm::length(p) * std::abs(pyramid), glm::dot(glm::cross(p, q), glm::cross(p, r)));
    };
    const Long excess = corner(t.a, t.b, t.c) + corner(t.b, t.c, t.a) + corner(t.c, t.a, t.b) - long_pi;
    return pyramid < 0 ? -excess : excess;
}

inline Long exact_angle(const TriangleLight& light, const Vec3& from) {
    return exact_angle(long_triangle(light, from));
}

inline Long exact_angle(const QuadLight& light, const Vec3& from) {
    const auto both = long_triangles(light, from);
    return exact_angle(both[0]) + exact_angle(both[1]);
}

/// What the contract lets rounding do to the solid angle of a triangle: (n·|x| + p·|y|)/(x² + y²), in units
/// of gamma(64); so large that it says nothing where rounding may change x and y by more than half of what
/// they are. `spoilt` says that the corners themselves were rounded like the farthest of them.
inline Real angle_condition(const LongTriangle& t, bool spoilt) {
    const std::array<LongVec, 3> corners{t.a, t.b, t.c};
    std::array<Long, 3> far{}, sides{glm::length(t.ab), glm::length(t.ac), glm::length(t.ac - t.ab)};
    // Of x/p and y/p the squares together are 2·Π(1 + cos), with the cosines between the corners.
    Long square = 2;
    for (std::size_t i = 0; i < 3; ++i) {
        far[i] = glm::length(corners[i]);
        const LongVec sum = glm::normalize(corners[i]) + glm::normalize(corners[(i + 1) % 3]);
        square *= glm::dot(sum, sum) / 2;
    }
    std::sort(far.begin(), far.end());
    std::sort(sides.begin(), sides.end());
    const Long worse = spoilt ? far[2] / far[0] : 1, p = far[0] * far[1] * far[2];
    const Long n = worse * far[0] * sides[1] * sides[2], modulus = p * std::sqrt(square);
    const Long half = exact_angle(t) / 2, x = std::abs(std::cos(half)), y = std::abs(std::sin(half));
    if (gamma(64) * n > y * modulus / 2 || gamma(64) * (n + worse * p) > modulus / 2) return infinity;
    return static_cast<Real>((n * x + worse * p * y) / modulus);
}

/// Lambert's vector of a polygon seen from 0, ∫ ω dω over its solid angle: a term for each side, its angle
/// times the unit normal of the plane through it and the viewer (Lambert 1760). The corners run
/// counterclockwise as they are seen.
inline LongVec exact_flow(const std::vector<LongVec>& corners) {
    LongVec sum(0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const LongVec p = glm::normalize(corners[i]), q = glm::normalize(corners[(i + 1) % corners.size()]);
        const Long chord = glm::length(q - p) / 2;
        sum += std::asin(std::min(chord, Long(1))) * glm::normalize(glm::cross(q, p));
    }
    return sum;
}

/// The mean of directions, against what it should be, with a bound that right samples exceed three times in a
/// thousand million.
inline void check_mean_direction(const std::vector<Vec3>& directions, const Vec3& expected) {
    const Real count = static_cast<Real>(directions.size());
    Vec3 sum(0), squares(0);
    for (const Vec3& w : directions) sum += w;
    const Vec3 mean = sum / count;
    for (const Vec3& w : directions) squares += (w - mean) * (w - mean);
    const Vec3 bound = 6.0 * glm::sqrt(squares / count / count) + 16 * unit_roundoff;
    INFO("the mean of " << directions.size() << " directions; the bound is six times what chance does");
    CHECK(near(mean.x, expected.x, bound.x));
    CHECK(near(mean.y, expected.y, bound.y));
    CHECK(near(mean.z, expected.z, bound.z));
}

/// Pearson's χ² of counts in classes of these probabilities. Classes of few samples are counted together. A
/// right sampler fails once in ten million times.
inline void check_counts(const std::vector<int>& counts, const std::vector<Real>& probabilities, int drawn) {
    Real sum = 0, rest = 0, worst = 0;
    int rest_count = 0, classes = 0;
    std::string worst_class = "none";
    const auto add = [&](int count, Real expected, const std::string& name) {
        const Real one = (count - expected) * (count - expected) / expected;
        sum += one;
        ++classes;
        if (one <= worst) return;
        worst = one;
        worst_class = name + " has " + show(count) + " samples instead of about " + show(expected);
    };
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const Real expected = probabilities[i] * drawn;
        if (expected >= 8)
            add(counts[i], expected, "part " + show(i) + " of " + show(counts.size()));
        else {
            rest += expected;
            rest_count += counts[i];
        }
    }
    if (rest >= 8) add(rest_count, rest, "what is seen small");
    INFO("of " << drawn << " samples: " << worst_class);
    if (rest < 8) CHECK(rest_count <= 48);
    if (classes > 1) CHECK(sum <= chi_square_limit(static_cast<std::size_t>(classes)));
}

/// A triangle is divided into 16 of half its height, and these are numbered.
inline std::size_t part_of_triangle(Real s, Real t) {
    const Real p = std::clamp(4 * s, Real(0), Real(3.999999)), q = std::clamp(4 * t, Real(0), Real(3.999999));
    const Real r = std::min(std::floor(p), 3 - std::floor(q));
    const bool upper = p - r + q - std::floor(q) >= 1 && r + std::floor(q) < 3;
    return static_cast<std::size_t>(8 * r + 2 * std::floor(q) + (upper ? 1 : 0));
}

/// The probabilities of those parts, where all of the triangle's solid angle is equally likely: 0 for numbers
/// without a part.
inline std::vector<Real> parts_of_triangle(const LongTriangle& t) {
    std::vector<Real> parts(32, 0);
    const Long all = exact_angle(t);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; i + j < 4; ++j) {
            const LongVec corner = t.a + Long(i) / 4 * t.ab + Long(j) / 4 * t.ac;
            const auto index = static_cast<std::size_t>(8 * i + 2 * j);
            parts[index] =
                static_cast<Real>(exact_angle(spanned(corner, t.ab / Long(4), t.ac / Long(4))) / all);
            if (i + j < 3)
                parts[index + 1] = static_cast<Real>(
                    exact_angle(spanned(corner + (t.ab + t.ac) / Long(4), -t.ab / Long(4), -t.ac / Long(4))) /
                    all);
        }
    return parts;
}

/// Where a point p of the plane of a and its two sides is: p = a + s·ab + t·ac.
inline Vec2 place_in(const LongVec& p, const LongVec& ab, const LongVec& ac) {
    const LongVec n = glm::cross(ab, ac);
    const Long square = glm::dot(n, n);
    return {static_cast<Real>(glm::dot(glm::cross(p, ac), n) / square),
            static_cast<Real>(glm::dot(glm::cross(ab, p), n) / square)};
}

/// The point that a direction and a distance lead to, from a, the corner of something seen from 0.
inline LongVec beyond_corner(const LightDirection& found, const LongVec& a) {
    return Long(found.distance) * LongVec(found.direction) - a;
}

/// How far a point is beside a convex polygon's plane or beyond one of its sides, at most; at most 0 in it.
/// The polygon is measured from its longest side, so that slivers keep their digits.
inline Real outside(const LongVec& point, const std::vector<LongVec>& corners) {
    const std::size_t count = corners.size();
    const auto side = [&](std::size_t i) { return corners[(i + 1) % count] - corners[i]; };
    std::size_t base = 0;
    for (std::size_t i = 1; i < count; ++i)
        if (glm::length(side(i)) > glm::length(side(base))) base = i;
    const LongVec origin = corners[base], along = glm::normalize(side(base));
    const auto rest = [&](const LongVec& p) { return p - glm::dot(p, along) * along; };
    const LongVec up = glm::normalize(rest(corners[(base + 2) % count] - origin));
    const auto flat = [&](const LongVec& p) {
        return glm::vec<2, Long, glm::defaultp>(glm::dot(p, along), glm::dot(rest(p), up));
    };
    const auto at = flat(point - origin);
    Long most = std::abs(glm::dot(rest(point - origin), glm::cross(along, up)));
    for (std::size_t i = 0; i < count; ++i) {
        const auto p = flat(corners[i] - origin), step = flat(side(i)), way = at - p;
        most = std::max(most, (step.y * way.x - step.x * way.y) / glm::length(step));
    }
    return static_cast<Real>(most);
}

inline Real outside(const LightDirection& found, const LongTriangle& t) {
    const LongVec point = Long(found.distance) * LongVec(found.direction);
    return outside(point - t.a, {LongVec(0), t.ab, t.ac});
}

}  // namespace rt::test
