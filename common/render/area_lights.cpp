// Lights with an extent: what compile works out once, and what their surfaces show.
#include "common/render/area_lights.hpp"

#include "chapters/12_distribution/area_light.hpp"
#include "common/render/finish.hpp"

namespace rt {
namespace {

/// On which side of the light's surface the ray is: positive where it shines.
struct BrightSide {
    const Vec3& to_viewer;
    const Vec3& point;

    Real operator()(const QuadLight& quad) const { return -dot(cross(quad.ab, quad.ac), to_viewer); }
    Real operator()(const DiscLight& disc) const { return dot(disc.normal, to_viewer); }
    Real operator()(const SphereLight& sphere) const { return dot(point - sphere.center, to_viewer); }
    Real operator()(const TriangleLight& triangle) const {
        return dot(cross(triangle.b - triangle.a, triangle.c - triangle.a), to_viewer);
    }
};

}  // namespace

std::optional<Vec3> light_at(const World& world, const Ray& ray, const Hit& hit) {
    if (hit.primitive < world.area_lights.first_primitive || world.area_lights.of.empty())
        return std::nullopt;
    const AreaLight& light =
        world.area_lights.lights[world.area_lights.of[hit.primitive - world.area_lights.first_primitive]];
    const Vec3 point = point_at(ray, hit.t);
    return std::visit(BrightSide{-ray.direction, point}, light.shape) > 0 ? light.radiance : Vec3(0);
}

Real gloss_of(const World& world, const Material& material, bool refracted) {
    if (!world.needs.gloss || material.finish < 0) return 0;
    const Finish finish = finish_at(world, material);
    return refracted ? finish.translucency : finish.gloss;
}

std::vector<Real> chances_of(std::span<const AreaLight> lights) {
    std::vector<Real> powers;
    for (const AreaLight& light : lights)
        powers.push_back(std::visit([](const auto& shape) { return area(shape); }, light.shape) *
                         (light.radiance.x + light.radiance.y + light.radiance.z));
    return cumulative(powers);
}

}  // namespace rt
