// Boxes with axes of their own: how points are spread, the axes that fit them, and where a ray is inside.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/bounding_volumes.hpp"

#include <optional>
#include <span>

namespace rt {

/// [13.17] How the points are spread: the mean over the points of (p − m)(p − m)ᵀ, where m is the mean of all
/// points. Element [i][j] is the mean of the products of coordinates i and j, seen from m. Its error is at
/// most 2^-40 of the greatest element, as long as the points are at most 2^10 times farther from the origin
/// than from one another; farther away it may be 4u² of the square of the greatest coordinate. 0 of no
/// points.
Mat3 covariance(std::span<const Vec3> points);

/// [13.18] Axes along which a symmetric matrix only stretches: unit vectors across one another, the columns
/// of a matrix A for which Aᵀ·m·A has nothing beside its diagonal but rounding, 2^-44 of the greatest element
/// of m. In any order, and either way along each (Jacobi 1846). Only m[i][j] with i <= j is looked at.
Mat3 principal_axes(const Mat3& m);

/// [13.19] The smallest box with these axes around the points, up to rounding: 16u of the greatest
/// coordinate. The box of no points is empty.
OrientedBox box_along(const Mat3& axes, std::span<const Vec3> points);

/// Half the area of the box's surface; 0 of an empty box. Given.
Real half_area(const OrientedBox& box);

/// [13.20] Axes that are turned until the box along them around the points has little surface: never more
/// than along those given, and no turn about one of the three axes by 1/64 of a right angle or more of the
/// angles that were tried makes it less. Begins with turns of an eighth of a circle, and halves the angle
/// whenever none of the six (about each axis, either way) lessens the area.
Mat3 refined_axes(const Mat3& axes, std::span<const Vec3> points);

/// [13.21] The part of the ray inside the box, or nothing if that is empty.
///
/// It contains every t in [range.min, range.max] whose exact point is in the box, short of over- and
/// underflow; and it is the part in a box whose halves are greater by less than 2^-45 of `length(half)` and
/// of the distance from the ray's origin to the centre, but for what 09.2 (`clip`) widens. An empty box is
/// always missed.
std::optional<Interval> clip(const OrientedBox& box, const Ray& ray, Interval range);

}  // namespace rt
