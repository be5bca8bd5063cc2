// Shapes under a transform: ellipsoids, and meshes that stand in many places but in memory once.
#pragma once

#include "common/scene/shapes.hpp"
#include "common/world/world.hpp"

#include <optional>
#include <span>

namespace rt {

/// What every ellipsoid is in its local space.
inline constexpr Sphere unit_sphere{Vec3(0), 1};

/// [04.6] Nearest hit with the ellipsoid in (range.min, range.max], or nothing: that of the local ray with
/// the unit sphere. `t` is the world ray's.
std::optional<Hit> intersect(const Ellipsoid& ellipsoid, const Ray& ray, Interval range);

/// [04.6] The surface at a hit, in world space.
Surface surface_at(const Ellipsoid& ellipsoid, const Ray& ray, const Hit& hit);

/// Nearest of the hits with all the ellipsoids, as for spheres. Given.
std::optional<Hit> closest_hit(std::span<const Ellipsoid> ellipsoids, const Ray& ray, Interval range);

/// Whether any ellipsoid is hit in the range. Given.
bool any_hit(std::span<const Ellipsoid> ellipsoids, const Ray& ray, Interval range);

/// [04.6] Nearest of the hits with all the instances: `Hit::primitive` is the instance's index and
/// `Hit::element` the triangle of its mesh. A ray that misses the mesh's bounding sphere, in local space,
/// tests none of its triangles. Of equal distances the lowest index wins.
std::optional<Hit> closest_hit(std::span<const Instance> instances, std::span<const SharedMesh> meshes,
                               const Ray& ray, Interval range);

/// Whether any instance is hit in the range. Given.
bool any_hit(std::span<const Instance> instances, std::span<const SharedMesh> meshes, const Ray& ray,
             Interval range);

/// The surface at a hit with an instance, in world space; shading normals interpolated where the mesh has
/// normals. Given.
Surface surface_at(const Instance& instance, const SharedMesh& mesh, const Ray& ray, const Hit& hit);

}  // namespace rt
