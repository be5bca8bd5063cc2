// Axis-aligned boxes: around shapes, and where a ray runs through one.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/bounds.hpp"
#include "common/world/shapes.hpp"

#include <optional>

namespace rt {

/// [09.1] The smallest box around the shape, up to rounding; the grid's margin covers that.
Bounds bounds_of(const Sphere& sphere);
/// [09.1] The same.
Bounds bounds_of(const Triangle& triangle);
/// The box around the vertices, where all hits are. Given.
Bounds bounds_of(const Polygon& polygon);
/// [09.1] The same: along each axis the unit sphere's image reaches as far from its centre as the matching
/// row of the matrix is long.
Bounds bounds_of(const Ellipsoid& ellipsoid);
/// A box around the instance: around the image of its mesh's bounding sphere. Given.
Bounds bounds_of(const Instance& instance);

/// The box around the image of a box under an affine map: around its eight corners. Given.
Bounds bounds_of_image(const Transform& transform, const Bounds& box);
/// A box around any other shape under a transform.
template <class Shape>
requires requires(const Shape& shape) { bounds_of(shape); }
Bounds bounds_of(const Placed<Shape>& placed) {
    return bounds_of_image(placed.transform, bounds_of(placed.shape));
}

/// How much more rounding moves a point that goes to local space and back than one that stays: the greatest
/// sum along a row of |M|·|M⁻¹|. 1 for a map that only moves and stretches along the axes, at most 3 with a
/// rotation of the result, and large where a rotated shape is stretched. Given.
Real distortion_of(const Transform& transform);

/// The smallest box around both. Given.
Bounds merge(const Bounds& a, const Bounds& b);

/// The box with every face moved out by `by`. Given.
Bounds grown(const Bounds& box, Real by);

/// Whether no point is in the box. Given.
bool is_empty(const Bounds& box);

/// [09.2] The part of the ray inside the box, or nothing if that is empty (Kay & Kajiya 1986).
///
/// The box is closed: a ray along a face, an edge, or through a corner is inside there. A direction of ±0
/// along some axis is right too: such a ray is inside that pair of planes everywhere or nowhere. The result
/// contains every t in [range.min, range.max] whose exact point lies in the box, short of over- and
/// underflow: each computed distance is widened by gamma(3), its two roundings and one more for the widening
/// (Ize 2013). An empty box is always missed.
std::optional<Interval> clip(const Bounds& box, const Ray& ray, Interval range);

/// What an accelerator allows for rounding, so that it finds what asking every shape finds, to the bit.
struct Allowance {
    Real margin = 0;  ///< by how much its boxes are larger than what is in them, on each side
    Real reach = 0;   ///< how far from the middle of all, along each axis, a ray may start and still be exact
};

/// The allowance for shapes in this box: a margin of 2^-30 of its longest edge, and 2^-44 of its greatest
/// coordinate, times `distortion`, the greatest of the shapes' transforms; a reach of 2^16 longest edges.
/// Given.
Allowance allowance_for(const Bounds& around, Real distortion);

/// Whether a ray's rounding errors stay below the margin of an accelerator whose outermost box and reach
/// these are, and its numbers in the range of Real. Given.
bool is_within_reach(const Ray& ray, const Bounds& box, Real reach);

}  // namespace rt
