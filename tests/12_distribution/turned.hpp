// Turns in long double: what tests of steps 12.21 and 12.22 expect.
#pragma once

#include "common/world/spin.hpp"
#include "tests/support.hpp"

#include <array>
#include <cmath>

namespace rt::test {

using Long = long double;
using Long3 = std::array<Long, 3>;

inline Long3 long_cross(const Long3& a, const Long3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The vector turned by `angle` about the axis, by a quaternion; an axis that is a unit vector up to rounding
/// only is made one.
inline Long3 long_turned(const Vec3& axis, Long angle, const Long3& v) {
    const Long x = axis.x, y = axis.y, z = axis.z, size = std::sqrt(x * x + y * y + z * z);
    const Long w = std::cos(angle / 2), s = std::sin(angle / 2) / size;
    const Long3 q{s * x, s * y, s * z}, once = long_cross(q, v), twice = long_cross(q, once);
    return {v[0] + 2 * (w * once[0] + twice[0]), v[1] + 2 * (w * once[1] + twice[1]),
            v[2] + 2 * (w * once[2] + twice[2])};
}

/// The same of a point, about the spin's line.
inline Long3 long_turned(const Spin& spin, Long angle, const Vec3& point) {
    Long3 from;
    for (int i = 0; i < 3; ++i) from[static_cast<std::size_t>(i)] = Long(point[i]) - Long(spin.center[i]);
    Long3 there = long_turned(spin.axis, angle, from);
    for (int i = 0; i < 3; ++i) there[static_cast<std::size_t>(i)] += Long(spin.center[i]);
    return there;
}

/// What lies as far from the expected number as `allowed`, or nearer.
inline bool long_near(Real x, Long expected, Long allowed) { return std::abs(Long(x) - expected) <= allowed; }

}  // namespace rt::test
