// Spheres around points: one that is quickly found, the smallest one, and where a ray is inside.
#include "chapters/13_hierarchies/sphere_around.hpp"

#include "common/math/error.hpp"
#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// The point that is farthest from this place; of points equally far the first. There is at least one.
Vec3 farthest_from(const Vec3& place, std::span<const Vec3> points) {
    return *std::ranges::max_element(points, {}, [&](const Vec3& p) { return dot(p - place, p - place); });
}

/// Whether a point is outside of the sphere, by more than rounding.
[[maybe_unused]] bool is_outside(const BoundingSphere& sphere, const Vec3& point) {
    return !(length(point - sphere.center) <= sphere.radius * (1 + 0x1p-44));
}

/// The smallest sphere around the points, which may be put into another order, that has all of `boundary` on
/// it. There is one.
SmallestSphere smallest_with(std::span<Vec3> points, std::vector<Vec3> boundary) {
    SmallestSphere smallest{sphere_through(boundary), boundary};
    // 13.15  Make `smallest` the sphere around all of the points. Move a point that was outside of
    // the sphere around those before it to the front, because it is likely to be needed again.
    return todo("13.15");
}

}  // namespace

BoundingSphere sphere_by_ritter(std::span<const Vec3> points) {
    if (points.empty()) return {};
    // 13.13  Return Ritter's sphere. `farthest_from` finds a and b.
    return todo("13.13");
}

BoundingSphere sphere_through(std::span<const Vec3> points) {
    if (points.empty()) return {};
    // 13.14  Return the sphere. Seen from the first point, all numbers are small.
    return todo("13.14");
}

SmallestSphere smallest_sphere(std::span<const Vec3> points) {
    if (points.empty()) return {};
    // Seen from one of the points: far from the origin, spheres would be rounded away.
    const Vec3 origin = points[0];
    std::vector<Vec3> shifted;
    shifted.reserve(points.size());
    for (const Vec3& point : points) shifted.push_back(point - origin);
    SmallestSphere smallest = smallest_with(shifted, {});
    smallest.sphere.center += origin;
    for (Vec3& point : smallest.support) point += origin;
    // What rounding has left outside.
    const Vec3& center = smallest.sphere.center;
    smallest.sphere.radius = std::max(smallest.sphere.radius, length(farthest_from(center, points) - center));
    return smallest;
}

std::optional<Interval> clip(const BoundingSphere& sphere, const Ray& ray, Interval range) {
    if (sphere.radius < 0) return std::nullopt;
    // 13.16  Return the part of the range in which the ray is inside. Take a radius that is greater
    // by gamma(40) of the radius and of the distance from the origin to the centre: no rounding here moves a
    // point by so much.
    return todo("13.16");
}

}  // namespace rt
