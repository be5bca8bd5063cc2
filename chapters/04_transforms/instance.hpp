// Shapes under a transform: ellipsoids, and meshes that stand in many places but in memory once.
#pragma once

#include "chapters/04_transforms/transform.hpp"
#include "common/world/search.hpp"
#include "common/world/world.hpp"

#include <optional>

namespace rt {

/// What every ellipsoid is in its local space.
inline constexpr Sphere unit_sphere{Vec3(0), 1};

/// [04.6] Nearest hit with the ellipsoid in (range.min, range.max], or nothing: that of the local ray with
/// the unit sphere. `t` is the world ray's.
std::optional<Hit> intersect(const Ellipsoid& ellipsoid, const Ray& ray, Interval range);

/// [04.6] The surface at a hit, in world space.
Surface surface_at(const Ellipsoid& ellipsoid, const Ray& ray, const Hit& hit);

/// [04.6] Nearest hit with the mesh in (range.min, range.max], or nothing, for a ray in the mesh's own space.
/// `Hit::element` is the triangle's index. A ray that misses the mesh's bounding sphere asks none of its
/// triangles.
std::optional<Hit> intersect(const MeshUse& shown, const Ray& local, Interval range);

/// Whether any of the mesh's triangles is hit in the range. Given.
bool is_hit(const MeshUse& shown, const Ray& local, Interval range);

/// The surface at a hit, in the mesh's own space; shading normals interpolated where the mesh has normals.
/// Given.
Surface surface_at(const MeshUse& shown, const Ray& local, const Hit& hit);

// Every other shape under a transform, instances among them, does what an ellipsoid does.

/// Nearest hit in (range.min, range.max], or nothing. `t` is the world ray's.
template <class Shape>
std::optional<Hit> intersect(const Placed<Shape>& placed, const Ray& ray, Interval range) {
    return intersect(placed.shape, to_local(placed.transform, ray), range);
}

/// Whether there is a hit in the range.
template <class Shape>
bool is_hit(const Placed<Shape>& placed, const Ray& ray, Interval range) {
    return is_hit(placed.shape, to_local(placed.transform, ray), range);
}

/// The surface at a hit, in world space.
template <class Shape>
Surface surface_at(const Placed<Shape>& placed, const Ray& ray, const Hit& hit) {
    return to_world(placed.transform, surface_at(placed.shape, to_local(placed.transform, ray), hit));
}

}  // namespace rt
