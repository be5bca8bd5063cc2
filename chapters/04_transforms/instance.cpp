// Shapes under a transform: ellipsoids, and meshes that stand in many places but in memory once.
#include "chapters/04_transforms/instance.hpp"

#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "common/math/todo.hpp"
#include "common/world/query.hpp"

namespace rt {
namespace {

bool misses(const Sphere& bound, const Ray& local, Interval range) {
    const Roots roots = intersections(bound, local);
    return roots.count == 0 || roots.t1 <= range.min || roots.t0 > range.max;
}

}  // namespace

std::optional<Hit> intersect(const Ellipsoid& ellipsoid, const Ray& ray, Interval range) {
    // 04.6  Take the ray to the ellipsoid's local space; there it is the unit sphere around the
    // origin, which chapter 2 knows how to hit. The t of that hit needs no change.
    return todo("04.6");
}

Surface surface_at(const Ellipsoid& ellipsoid, const Ray& ray, const Hit& hit) {
    // 04.6  Ask chapter 2 for the surface of the unit sphere at the hit of the local ray, and
    // take it to the world with to_world.
    return todo("04.6");
}

std::optional<Hit> closest_hit(std::span<const Ellipsoid> ellipsoids, const Ray& ray, Interval range) {
    std::optional<Hit> best;
    for (std::size_t i = 0; i < ellipsoids.size(); ++i) {
        std::optional<Hit> hit = intersect(ellipsoids[i], ray, range);
        if (!hit || (best && hit->t >= best->t)) continue;
        hit->primitive = static_cast<std::uint32_t>(i);
        best = hit;
        range.max = hit->t;
    }
    return best;
}

bool any_hit(std::span<const Ellipsoid> ellipsoids, const Ray& ray, Interval range) {
    for (const Ellipsoid& ellipsoid : ellipsoids)
        if (intersect(ellipsoid, ray, range)) return true;
    return false;
}

std::optional<Hit> closest_hit(std::span<const Instance> instances, std::span<const SharedMesh> meshes,
                               const Ray& ray, Interval range) {
    // 04.6  For each instance: take the ray to its local space. If it misses the mesh's bounding
    // sphere (the function `misses` above says so), go on to the next. Else ask for the closest hit with
    // the mesh, closest_hit(mesh, local, range): its `primitive` is the triangle, which belongs into
    // `element`; `primitive` becomes the instance's index. Keep the nearest, the first of equal ones.
    return todo("04.6");
}

bool any_hit(std::span<const Instance> instances, std::span<const SharedMesh> meshes, const Ray& ray,
             Interval range) {
    for (const Instance& instance : instances) {
        const SharedMesh& mesh = meshes[instance.mesh];
        const Ray local = to_local(instance.transform, ray);
        if (!misses(mesh.bound, local, range) && occluded(mesh, local, range)) return true;
    }
    return false;
}

Surface surface_at(const Instance& instance, const SharedMesh& mesh, const Ray& ray, const Hit& hit) {
    const Triangles& triangles = mesh.triangles;
    Surface local = surface_at(triangles.shapes[hit.element], to_local(instance.transform, ray), hit);
    if (!triangles.normals.empty())
        local.shading_normal = interpolate(triangles.normals[hit.element], hit.uv, local.normal);
    if (!triangles.uvs.empty()) local.uv = interpolate(triangles.uvs[hit.element], hit.uv);
    return to_world(instance.transform, local);
}

}  // namespace rt
