// What the tests of rectangles share: one view of a light, and whether its samples are as dense as they
// claim.
#pragma once

#include "chapters/12_distribution/rectangle_light.hpp"
#include "tests/12_distribution/light_checks.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rt::test {

/// In 4 × 4 equal parts, whose solid angles are known.
inline void check_density(const QuadLight& light, const Vec3& from, std::uint64_t seed, int full = 20000) {
    INFO(show(light) << " from " << from << ", in 4 by 4 equal parts");
    const LongVec a = LongVec(light.corner) - LongVec(from), ab(light.ab), ac(light.ac);
    std::vector<int> counts(16, 0);
    for (const LightDirection& one : directions_to(light, from, seed, full)) {
        const Vec2 at = 4.0 * place_in(beyond_corner(one, a), ab, ac);
        const auto i = static_cast<std::size_t>(std::clamp(at.x, 0.0, 3.5)),
                   j = static_cast<std::size_t>(std::clamp(at.y, 0.0, 3.5));
        ++counts[4 * i + j];
    }
    std::vector<Real> parts;
    const Long all = exact_angle(light, from);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const LongVec corner = a + Long(i) / 4 * ab + Long(j) / 4 * ac, s = ab / Long(4),
                          t = ac / Long(4);
            parts.push_back(static_cast<Real>(
                (exact_angle(spanned(corner, s + t, s)) + exact_angle(spanned(corner, t, s + t))) / all));
        }
    check_counts(counts, parts, cases(full));
}

/// What the contract says of one view. From the dark side, there is no direction.
inline void check_view(const QuadLight& light, const Vec3& from, const Vec2& numbers) {
    const auto both = long_triangles(light, from);
    const Long first = exact_angle(both[0]), second = exact_angle(both[1]);
    const Real expected = static_cast<Real>(first + second);
    const Real bound = gamma(64) * (angle_condition(both[0], true) + angle_condition(both[1], true));
    INFO(show(light) << " from " << from << ", random numbers " << numbers);
    const Real ours = solid_angle(light, from);
    CHECK(std::isfinite(ours));
    // The first order of the rounding's effect says nothing where it is not small.
    if (bound < 0.01) CHECK(near(ours, expected, bound));
    const auto found = toward(light, from, numbers);
    if (!found) {
        CHECK(!(expected > 2 * bound));
        return;
    }
    INFO(show(*found));
    CHECK(expected >= -2 * bound);
    CHECK(near(length(found->direction), 1, gamma(16)));
    if (bound < 0.01 * expected) CHECK(near(found->pdf * expected, 1, 2 * bound / expected));
    CHECK(found->distance > 0);
    const LongTriangle &t = both[0], &s = both[1];
    const Long far = std::max({glm::length(t.a), glm::length(t.b), glm::length(t.c), glm::length(s.b)});
    const LongVec point = Long(found->distance) * LongVec(found->direction);
    CHECK(outside(point - t.a, {LongVec(0), t.ac, t.ab, s.ab}) <= gamma(64) * static_cast<Real>(far));
}

}  // namespace rt::test
