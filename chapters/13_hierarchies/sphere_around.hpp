// Spheres around points: one that is quickly found, the smallest one, and where a ray is inside.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/bounding_volumes.hpp"

#include <optional>
#include <span>
#include <vector>

namespace rt {

/// [13.13] A sphere around the points (Ritter 1990). It begins with the one that has its diameter from a to
/// b, where a is the point farthest from the first point, and b the one farthest from a; of points equally
/// far, the first counts. Then it grows for each point in their order that is outside, to the smallest sphere
/// around itself and that point.
///
/// Contains each point up to rounding: 16u of the greatest coordinate. The sphere of no points is empty.
BoundingSphere sphere_by_ritter(std::span<const Vec3> points);

/// [13.14] The smallest sphere through all of up to four points. A point adds nothing if it is hardly outside
/// of the point, line or plane through those before it: nearer than 2^-36 of its distance from the first. The
/// sphere through no point is empty.
BoundingSphere sphere_through(std::span<const Vec3> points);

/// The smallest sphere around points, and those of them that hold it.
struct SmallestSphere {
    BoundingSphere sphere;
    /// Up to four of the points. They are on the sphere, and its centre is between them: it is a mean of them
    /// with some weights that are not negative. That is why no other sphere around them is as small. (Where
    /// more points are so near the sphere that rounding decides which of them count, these need not be
    /// right.)
    std::vector<Vec3> support;
};

/// [13.15] The smallest sphere around the points (Welzl 1991; points found outside are asked earlier the
/// next time). Its radius is at most (1 + 2^-24) times the smallest, and it contains each point up to
/// rounding: 16u of the greatest coordinate. The sphere of no points is empty.
SmallestSphere smallest_sphere(std::span<const Vec3> points);

/// [13.16] The part of the ray inside the sphere, or nothing if that is empty.
///
/// It contains every t in [range.min, range.max] whose exact point is in the sphere, short of over- and
/// underflow; and it is the part in a sphere whose radius is greater by less than 2^-45 of the radius and of
/// the distance from the ray's origin to the centre. An empty sphere is always missed.
std::optional<Interval> clip(const BoundingSphere& sphere, const Ray& ray, Interval range);

}  // namespace rt
