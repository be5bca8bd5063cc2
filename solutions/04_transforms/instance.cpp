// Shapes under a transform: ellipsoids, and meshes that stand in many places but in memory once.
#include "chapters/04_transforms/instance.hpp"

#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "common/math/error.hpp"
#include "common/world/query.hpp"

namespace rt {
namespace {

/// Whether nothing in the sphere is hit in the range; in doubt, no. A line that comes from far away is seen
/// shifted by rounding, here and where a triangle is asked: by less than 64u of the way's greatest
/// coordinate. A sphere that is so much wider contains all that was in it. No roots are needed for that.
bool misses(const Sphere& bound, const Ray& local, Interval range) {
    const Vec3& d = local.direction;
    const Vec3 f = local.origin - bound.center;
    const Real a = dot(d, d);
    const Real nearest = -dot(f, d) / a;  // the middle of the chord
    const Vec3 w = f + nearest * d;
    const Real radius = bound.radius + gamma(64) * size_of(f);
    const Real rest = radius * radius - dot(w, w);  // the square of half the chord's length
    const auto is_outside = [&](Real t) { return a * (t - nearest) * (t - nearest) > rest; };
    return rest < 0 || (range.min > nearest && is_outside(range.min)) ||
           (range.max < nearest && is_outside(range.max));
}

}  // namespace

std::optional<Hit> intersect(const Ellipsoid& ellipsoid, const Ray& ray, Interval range) {
    // [exercise 04.6] The hit in the ellipsoid's local space, where it is the unit sphere of chapter 2.
    return intersect(unit_sphere, to_local(ellipsoid.transform, ray), range);
    // [/exercise]
}

Surface surface_at(const Ellipsoid& ellipsoid, const Ray& ray, const Hit& hit) {
    // [exercise 04.6] The surface at the hit, taken to the world.
    const Ray local = to_local(ellipsoid.transform, ray);
    return to_world(ellipsoid.transform, surface_at(unit_sphere, local, hit));
    // [/exercise]
}

std::optional<Hit> intersect(const MeshUse& shown, const Ray& local, Interval range) {
    // [exercise 04.6] The closest hit with the mesh, unless the ray misses its bounding sphere (`misses`,
    // above, says so). Which triangle it was belongs into `element`.
    if (misses(shown.mesh->bound, local, range)) return std::nullopt;
    std::optional<Hit> hit = closest_hit(*shown.mesh, local, range);
    if (hit) hit->element = hit->primitive;
    return hit;
    // [/exercise]
}

bool is_hit(const MeshUse& shown, const Ray& local, Interval range) {
    return !misses(shown.mesh->bound, local, range) && occluded(*shown.mesh, local, range);
}

Surface surface_at(const MeshUse& shown, const Ray& local, const Hit& hit) {
    const Group<Triangle>& triangles = shown.mesh->triangles;
    Surface surface = surface_at(triangles.shapes[hit.element], local, hit);
    if (!triangles.normals.empty())
        surface.shading_normal = interpolate(triangles.normals[hit.element], hit.uv, surface.normal);
    if (!triangles.uvs.empty()) surface.uv = interpolate(triangles.uvs[hit.element], hit.uv);
    return surface;
}

}  // namespace rt
