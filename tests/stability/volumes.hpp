// Families of extreme clouds of points for chapter 13, rays at volumes around them, and judges of what is
// fitted: by definition, with bounds that no volume can be smaller than.
#pragma once

#include "chapters/13_hierarchies/volumes.hpp"
#include "tests/support.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rt::stability {

struct CloudFamily {
    const char* name;
    const char* extremes;  ///< what is extreme in it
    std::vector<Vec3> (*make)(test::Random& random);
};

/// All the families.
std::span<const CloudFamily> cloud_families();

/// The greatest size of a coordinate.
Real greatest_coordinate(std::span<const Vec3> points);

/// The points of the cloud's box turned at random: some matrix whose columns are perpendicular unit vectors.
Mat3 some_axes(test::Random& random);

/// No sphere around the points has a smaller radius than this: with any weights whose sum is 1, the mean of
/// squares less the square of the mean is at most the radius' square (Frank & Wolfe's method, with steps
/// away, raises it until it is within 2^-34 of the greatest, or for 20000 steps).
Real least_radius(std::span<const Vec3> points);

/// How far the place is from the nearest mean of these at most four points with weights that are not
/// negative.
Real distance_from_hull(const Vec3& place, std::span<const Vec3> points);

/// A ray to a point in or near the volume with this centre and size, or one that touches it, nearly; from
/// near and far, also from inside, along axes and in any direction.
Ray some_ray_at(test::Random& random, const Vec3& center, Real size);

}  // namespace rt::stability

namespace rt::naive {

/// The part of the ray inside by the quadratic formula as it is often written, and nothing for rounding.
std::optional<Interval> clip(const BoundingSphere& sphere, const Ray& ray, Interval range);

/// The ray seen along the axes, and no thought of rounding.
std::optional<Interval> clip(const OrientedBox& box, const Ray& ray, Interval range);

/// The naive sphere under `to_unit`.
std::optional<Interval> clip(const BoundingEllipsoid& ellipsoid, const Ray& ray, Interval range);

/// The mean of products less the product of means.
Mat3 covariance(std::span<const Vec3> points);

}  // namespace rt::naive
