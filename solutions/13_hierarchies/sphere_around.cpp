// Spheres around points: one that is quickly found, the smallest one, and where a ray is inside.
#include "chapters/13_hierarchies/sphere_around.hpp"

#include "common/math/error.hpp"

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
    // [exercise 13.15] Make `smallest` the sphere around all of the points. Move a point that was outside of
    // the sphere around those before it to the front, because it is likely to be needed again.
    if (boundary.size() == 4) return smallest;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!is_outside(smallest.sphere, points[i])) continue;
        boundary.push_back(points[i]);
        smallest = smallest_with(points.first(i), boundary);
        boundary.pop_back();
        std::rotate(points.data(), points.data() + i, points.data() + i + 1);
    }
    return smallest;
    // [/exercise]
}

}  // namespace

BoundingSphere sphere_by_ritter(std::span<const Vec3> points) {
    if (points.empty()) return {};
    // [exercise 13.13] Return Ritter's sphere. `farthest_from` finds a and b.
    const Vec3 a = farthest_from(points[0], points), b = farthest_from(a, points);
    BoundingSphere sphere{a + (b - a) * Real(0.5), length(b - a) * Real(0.5)};
    for (const Vec3& point : points) {
        const Real distance = length(point - sphere.center);
        if (distance <= sphere.radius) continue;
        const Real radius = (sphere.radius + distance) * Real(0.5);
        sphere.center += (distance - radius) / distance * (point - sphere.center);
        sphere.radius = radius;
    }
    return sphere;
    // [/exercise]
}

BoundingSphere sphere_through(std::span<const Vec3> points) {
    if (points.empty()) return {};
    // [exercise 13.14] Return the sphere. Seen from the first point, all numbers are small.
    Vec3 center(0);
    std::vector<Vec3> directions;
    for (const Vec3& point : points.subspan(1)) {
        const Vec3 q = point - points[0];
        Vec3 across = q;
        // Once more, because what rounding left over would count where q is nearly in the plane.
        for (int pass = 0; pass < 2; ++pass)
            for (const Vec3& direction : directions) across -= dot(across, direction) * direction;
        const Real out = length(across);
        if (!(out > 0x1p-36 * length(q))) continue;
        directions.push_back(across / out);
        center += dot(q, q - Real(2) * center) / (2 * out) * directions.back();
    }
    return {points[0] + center, length(center)};
    // [/exercise]
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
    // [exercise 13.16] Return the part of the range in which the ray is inside. Take a radius that is greater
    // by gamma(40) of the radius and of the distance from the origin to the centre: no rounding here moves a
    // point by so much.
    const Vec3 from = ray.origin - sphere.center, &d = ray.direction;
    const Real radius = sphere.radius + gamma(40) * (sphere.radius + length(from));
    const Real middle = -dot(from, d) / dot(d, d);
    const Vec3 nearest = from + middle * d;
    const Real left = radius * radius - dot(nearest, nearest);
    if (!(left >= 0)) return std::nullopt;
    const Real half = std::sqrt(left / dot(d, d));
    range.min = std::max(range.min, middle - half);
    range.max = std::min(range.max, middle + half);
    if (range.min > range.max) return std::nullopt;
    return range;
    // [/exercise]
}

}  // namespace rt
