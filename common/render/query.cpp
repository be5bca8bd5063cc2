// The questions of common/scene/query.hpp, answered by dispatch over the kinds that occur.
#include "common/scene/query.hpp"

#include "chapters/01_ray_casting/plane.hpp"
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/polygon.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/04_transforms/instance.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "common/render/lights.hpp"

#include <cmath>

namespace rt {
namespace {

template <class Shape>
std::optional<Hit> closest_in(const World&, const Group<Shape>& group, const Ray& ray, Interval range) {
    return closest_hit(std::span<const Shape>(group.shapes), ray, range);
}
std::optional<Hit> closest_in(const World& world, const Instances& group, const Ray& ray, Interval range) {
    return closest_hit(group.shapes, world.meshes, ray, range);
}

template <class Shape>
bool any_in(const World&, const Group<Shape>& group, const Ray& ray, Interval range) {
    return any_hit(std::span<const Shape>(group.shapes), ray, range);
}
bool any_in(const World& world, const Instances& group, const Ray& ray, Interval range) {
    return any_hit(group.shapes, world.meshes, ray, range);
}

template <class Shape>
Surface surface_in(const World&, const Group<Shape>& group, std::uint32_t index, const Ray& ray,
                   const Hit& hit) {
    return surface_at(group.shapes[index], ray, hit);
}
Surface surface_in(const World& world, const Spheres& group, std::uint32_t index, const Ray& ray,
                   const Hit& hit) {
    Surface surface = surface_at(group.shapes[index], ray, hit);
    if (world.needs.uvs) surface.uv = sphere_uv(surface.normal);
    return surface;
}
Surface surface_in(const World& world, const Ellipsoids& group, std::uint32_t index, const Ray& ray,
                   const Hit& hit) {
    const Ellipsoid& ellipsoid = group.shapes[index];
    Surface surface = surface_at(ellipsoid, ray, hit);
    // On the unit sphere that the ellipsoid is in its own space, the point is the normal.
    if (world.needs.uvs)
        surface.uv = sphere_uv(normalize(transform_point(ellipsoid.transform.to_local, surface.point)));
    return surface;
}
Surface surface_in(const World&, const Triangles& group, std::uint32_t index, const Ray& ray,
                   const Hit& hit) {
    Surface surface = surface_at(group.shapes[index], ray, hit);
    if (!group.normals.empty())
        surface.shading_normal = interpolate(group.normals[index], hit.uv, surface.normal);
    if (!group.uvs.empty()) surface.uv = interpolate(group.uvs[index], hit.uv);
    return surface;
}
Surface surface_in(const World& world, const Instances& group, std::uint32_t index, const Ray& ray,
                   const Hit& hit) {
    const Instance& instance = group.shapes[index];
    return surface_at(instance, world.meshes[instance.mesh], ray, hit);
}

}  // namespace

std::optional<Hit> closest_hit(const World& world, const Ray& ray, Interval range) {
    std::optional<Hit> best;
    for (const AnyGroup& any : world.groups) {
        std::visit(
            [&](const auto& group) {
                std::optional<Hit> hit = closest_in(world, group, ray, range);
                if (!hit) return;
                hit->primitive = group.primitive[hit->primitive];
                // Hits at exactly range.max are reported too, so here the file's order decides.
                if (!best || hit->t < best->t || hit->primitive < best->primitive) best = hit;
                range.max = best->t;
            },
            any);
    }
    return best;
}

bool occluded(const World& world, const Ray& ray, Interval range) {
    for (const AnyGroup& any : world.groups)
        if (std::visit([&](const auto& group) { return any_in(world, group, ray, range); }, any)) return true;
    return false;
}

Surface surface_at(const World& world, const Ray& ray, const Hit& hit) {
    const Primitive& primitive = world.primitives[hit.primitive];
    return std::visit([&](const auto& group) { return surface_in(world, group, primitive.index, ray, hit); },
                      world.groups[primitive.group]);
}

std::uint32_t material_index(const World& world, const Hit& hit, const Surface& surface) {
    const std::uint32_t material = world.primitives[hit.primitive].material;
    if (!world.needs.patterns) return material;
    const Pattern& pattern = world.patterns[material];
    if (pattern.size == 0) return material;
    // A surface that lies exactly between two cubes belongs to the upper one, whatever its rounding.
    const Vec3 cell = glm::floor((surface.point + surface.error) / pattern.size);
    const Real parity = std::fmod(cell.x + cell.y + cell.z, Real(2));
    return parity == 0 ? material : pattern.odd;
}

const Material& material_at(const World& world, const Hit& hit, const Surface& surface) {
    return world.materials[material_index(world, hit, surface)];
}

Vec3 local_light(const World& world, const Surface& surface, const Material& material, const Vec3& normal,
                 const Vec3& to_viewer) {
    Vec3 sum = emitted_light(material);
    visit_lights(world, surface, normal, [&](const LightSample& light, const Vec3& visible) {
        sum += reflected_light(material, normal, to_viewer, light, visible);
    });
    return sum;
}

RayCounts& ray_counts() {
    thread_local RayCounts counts;
    return counts;
}

}  // namespace rt
