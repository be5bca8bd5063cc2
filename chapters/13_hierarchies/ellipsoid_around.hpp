// Ellipsoids around points: the smallest one, and where a ray is inside.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/bounding_volumes.hpp"

#include <optional>
#include <span>
#include <vector>

namespace rt {

/// Points with weights, which are not negative and have the sum 1: their mean, and how they are spread.
struct WeightedSpread {
    Vec3 mean{0};
    Mat3 covariance{0};  ///< the sum of w (p − mean)(p − mean)ᵀ
};

/// The spread of the points with these weights, one for each. Given.
WeightedSpread spread_of(std::span<const Vec3> points, std::span<const Real> weights);

/// [13.22] Weights of points, not all of which are in a plane, from which follows the smallest ellipsoid
/// around them (Khachiyan 1996). With c and S, the mean and the covariance of the points with the weights,
/// the ellipsoid (p − c)ᵀ S⁻¹ (p − c) <= 3 is no larger than the smallest; and no point has more there than
/// 3 (1 + tolerance), so that the ellipsoid up to that contains them all; tolerance is greater than 0. All
/// weights are equal at first. Then that of the point with the most, m, is raised: all weights are
/// multiplied by 1 − s, and s is added to its own, with s = (m − 3)/(4 m).
std::vector<Real> ellipsoid_weights(std::span<const Vec3> points, Real tolerance);

/// [13.23] The ellipsoid with the centre c and the shape S of the points with these weights that just
/// contains them all, up to rounding. The points with weights are not all in a plane.
BoundingEllipsoid ellipsoid_of(std::span<const Vec3> points, std::span<const Real> weights);

/// Its volume. Given.
Real volume_of(const BoundingEllipsoid& ellipsoid);

/// [13.24] The part of the ray inside the ellipsoid, or nothing if that is empty.
///
/// It contains every t in [range.min, range.max] whose exact point is in the ellipsoid, short of over- and
/// underflow. With N the root of the sum of the squares of to_unit's elements, it is the part in an ellipsoid
/// that is larger by a factor less than 1 + 2^-44 N (longest + the distance from the ray's origin to the
/// centre).
std::optional<Interval> clip(const BoundingEllipsoid& ellipsoid, const Ray& ray, Interval range);

}  // namespace rt
