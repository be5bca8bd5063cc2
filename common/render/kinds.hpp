// The questions of common/world/query.hpp, asked of one group: its kind is known, so nothing is dispatched.
#pragma once

#include "chapters/01_ray_casting/plane.hpp"
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/polygon.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/04_transforms/instance.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "chapters/09_grids/walk.hpp"
#include "common/world/query.hpp"

#include <type_traits>
#include <vector>

namespace rt {

/// The group's shapes. Their number comes from the indices, which are as many: to divide by the size of four
/// bytes is a shift.
template <class Shape>
std::span<const Shape> shapes_of(const Group<Shape>& group) {
    return {group.shapes.data(), group.primitive.size()};
}

/// Nearest hit with the group's shapes; `Hit::primitive` is the index into the group.
template <class Shape>
std::optional<Hit> closest_in(const World&, const Group<Shape>& group, const Ray& ray, Interval range) {
    return closest_hit(shapes_of(group), ray, range);
}
inline std::optional<Hit> closest_in(const World& world, const Instances& group, const Ray& ray,
                                     Interval range) {
    return closest_hit(shapes_of(group), world.meshes, ray, range);
}

/// The calling thread's mailbox of a grid; it stays where it is.
Mailbox& mailbox_of(const Grid& grid);

// What is asked of a grid is kept out of the functions that ask, which else would save registers for it
// always.
template <class Kind>
[[gnu::noinline]] std::optional<Hit> closest_in(const World&, const Gridded<Kind>& group, const Ray& ray,
                                                Interval range) {
    return closest_hit(group.grid, shapes_of(group), ray, range, mailbox_of(group.grid));
}
[[gnu::noinline]] inline std::optional<Hit> closest_in(const World& world, const Gridded<Instances>& group,
                                                       const Ray& ray, Interval range) {
    return closest_hit(group.grid, shapes_of(group), world.meshes, ray, range, mailbox_of(group.grid));
}

/// Whether any of the group's shapes is hit.
template <class Shape>
bool any_in(const World&, const Group<Shape>& group, const Ray& ray, Interval range) {
    return any_hit(shapes_of(group), ray, range);
}
inline bool any_in(const World& world, const Instances& group, const Ray& ray, Interval range) {
    return any_hit(shapes_of(group), world.meshes, ray, range);
}
template <class Kind>
[[gnu::noinline]] bool any_in(const World&, const Gridded<Kind>& group, const Ray& ray, Interval range) {
    return any_hit(group.grid, shapes_of(group), ray, range, mailbox_of(group.grid));
}
[[gnu::noinline]] inline bool any_in(const World& world, const Gridded<Instances>& group, const Ray& ray,
                                     Interval range) {
    return any_hit(group.grid, shapes_of(group), world.meshes, ray, range, mailbox_of(group.grid));
}

/// Appends a hit for each of the group's shapes that is hit, its nearest in the range, which should be short;
/// `Hit::primitive` is the index into the group.
template <class Shape>
void append_in(const World& world, const Group<Shape>& group, const Ray& ray, Interval range,
               std::vector<Hit>& hits) {
    for (std::uint32_t i = 0; i < group.primitive.size(); ++i) {
        std::optional<Hit> hit;
        if constexpr (std::is_same_v<Shape, Instance>)
            hit = closest_hit(shapes_of(group).subspan(i, 1), world.meshes, ray, range);
        else
            hit = intersect(group.shapes[i], ray, range);
        if (!hit) continue;
        hit->primitive = i;
        hits.push_back(*hit);
    }
}
template <class Kind>
void append_in(const World&, const Gridded<Kind>& group, const Ray& ray, Interval range,
               std::vector<Hit>& hits) {
    append_hits(group.grid, shapes_of(group), ray, range, mailbox_of(group.grid), hits);
}
inline void append_in(const World& world, const Gridded<Instances>& group, const Ray& ray, Interval range,
                      std::vector<Hit>& hits) {
    append_hits(group.grid, shapes_of(group), world.meshes, ray, range, mailbox_of(group.grid), hits);
}

/// The surface at a hit with the group's shape `index`.
template <class Shape>
Surface surface_in(const World&, const Group<Shape>& group, std::uint32_t index, const Ray& ray,
                   const Hit& hit) {
    return surface_at(group.shapes[index], ray, hit);
}
inline Surface surface_in(const World& world, const Spheres& group, std::uint32_t index, const Ray& ray,
                          const Hit& hit) {
    Surface surface = surface_at(group.shapes[index], ray, hit);
    if (world.needs.uvs) surface.uv = sphere_uv(surface.normal);
    return surface;
}
inline Surface surface_in(const World& world, const Ellipsoids& group, std::uint32_t index, const Ray& ray,
                          const Hit& hit) {
    const Ellipsoid& ellipsoid = group.shapes[index];
    Surface surface = surface_at(ellipsoid, ray, hit);
    // On the unit sphere that the ellipsoid is in its own space, the point is the normal.
    if (world.needs.uvs)
        surface.uv = sphere_uv(normalize(transform_point(ellipsoid.transform.to_local, surface.point)));
    return surface;
}
inline Surface surface_in(const World&, const Triangles& group, std::uint32_t index, const Ray& ray,
                          const Hit& hit) {
    Surface surface = surface_at(group.shapes[index], ray, hit);
    if (!group.normals.empty())
        surface.shading_normal = interpolate(group.normals[index], hit.uv, surface.normal);
    if (!group.uvs.empty()) surface.uv = interpolate(group.uvs[index], hit.uv);
    return surface;
}
inline Surface surface_in(const World& world, const Instances& group, std::uint32_t index, const Ray& ray,
                          const Hit& hit) {
    const Instance& instance = group.shapes[index];
    return surface_at(instance, world.meshes[instance.mesh], ray, hit);
}

/// A grid changes nothing about the surface.
template <class Kind>
Surface surface_in(const World& world, const Gridded<Kind>& group, std::uint32_t index, const Ray& ray,
                   const Hit& hit) {
    return surface_in(world, static_cast<const Kind&>(group), index, ray, hit);
}

/// The group of a world that has no other; it must be of this kind. It holds all the primitives in the order
/// of the file, so that an index into the group is one into world.primitives.
template <class Kind>
const Kind& only_group(const World& world) {
    const Kind* group = std::get_if<Kind>(&world.groups.front());
    // Whoever calls this for Kind has looked, once a picture, so that no ray has to.
    if (!group) __builtin_unreachable();
    return *group;
}

}  // namespace rt
