// Boxes with axes of their own: how points are spread, the axes that fit them, and where a ray is inside.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/bounding_volumes.hpp"

#include <optional>
#include <span>

namespace rt {

/// [13.17] How the points are spread: the mean over the points of (p − m)(p − m)ᵀ, where m is their mean.
/// Element [i][j] is the mean of the products of coordinates i and j, seen from m. Its error is at most 2^-40
/// of the greatest element, and the square of by how much rounding moves the mean: far from the origin points
/// are spread as they are near it. 0 of no points.
Mat3 covariance(std::span<const Vec3> points);

/// [13.18] Axes along which a symmetric matrix only stretches: unit vectors across one another, the columns
/// of a matrix A for which Aᵀ·m·A has nothing beside its diagonal but rounding, 2^-44 of the greatest element
/// of m. In any order, and either way along each (Jacobi 1846). Only m[i][j] with i <= j is looked at.
Mat3 principal_axes(const Mat3& m);

/// [13.19] The smallest box with these axes around the points, up to rounding: 16u of the greatest
/// coordinate. The box of no points is empty.
OrientedBox box_along(const Mat3& axes, std::span<const Vec3> points);

/// Half the area of the box's surface; 0 of an empty box, one of whose halves is negative. Given.
Real half_area(const OrientedBox& box);

/// [13.20] Axes along which the box around the points has little surface: those given, turned. First by an
/// eighth of a half circle about one of the three axes, this way or that, wherever that lessens the area;
/// when none of the six turns does, by half that angle, down to 1/128 of a half circle, by which at last no
/// turn lessens it any more, but for rounding. The axes are still unit vectors across one another, up to
/// 2^-40.
Mat3 refined_axes(const Mat3& axes, std::span<const Vec3> points);

/// [13.21] The part of the ray inside the box, or nothing if that is empty.
///
/// It contains every t in [range.min, range.max] whose exact point is in the box, short of over- and
/// underflow; and it is the part in a box whose halves are greater by less than 2^-45 of `length(half)` and
/// of the distance from the ray's origin to the centre, but for what 09.2 (`clip`) widens. An empty box,
/// whose halves are −1, is missed from any place less than 2^48 away.
std::optional<Interval> clip(const OrientedBox& box, const Ray& ray, Interval range);

}  // namespace rt
