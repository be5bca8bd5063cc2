// Axes around a direction.
#pragma once

#include "common/math/vec.hpp"

#include <cmath>

namespace rt {

/// Columns that are perpendicular unit vectors, a right-handed frame whose last one is the unit vector
/// `axis`: so `axes_around(axis) * v` turns the z axis into `axis`, and `v * axes_around(axis)` is v as it is
/// seen in that frame. The others are any; they hardly turn with the axis, but where its z changes sign (Duff
/// and others, Building an Orthonormal Basis, Revisited, 2017).
inline Mat3 axes_around(const Vec3& axis) {
    const Real sign = std::copysign(Real(1), axis.z), a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
    return {Vec3(1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x),
            Vec3(b, sign + axis.y * axis.y * a, -axis.y), axis};
}

}  // namespace rt
