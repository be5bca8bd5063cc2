// One colour a ray: the integrators that the course gives, and which one a world uses.
#include "common/render/shade.hpp"

#include "chapters/07_recursion/radiance.hpp"

namespace rt {
namespace {

constexpr Interval everything{0, infinity};

}  // namespace

Vec3 direction_color(const World&, const Ray& ray) { return 0.5 * (normalize(ray.direction) + Vec3(1)); }

Vec3 normal_at(const World& world, const Ray& ray, const Hit& hit) {
    const Vec3 n = turned_to_viewer(surface_at(world, ray, hit).shading_normal, ray.direction);
    return 0.5 * (n + Vec3(1));
}

Vec3 normal_color(const World& world, const Ray& ray) {
    const std::optional<Hit> hit = closest_hit(world, ray, everything);
    return hit ? normal_at(world, ray, *hit) : world.background;
}

Vec3 uv_color(const World& world, const Ray& ray) {
    const std::optional<Hit> hit = closest_hit(world, ray, everything);
    return hit ? Vec3(surface_at(world, ray, *hit).uv, 0) : world.background;
}

Vec3 lit_color(const World& world, const Ray& ray) {
    const std::optional<Hit> hit = closest_hit(world, ray, everything);
    if (!hit) return world.background;
    const Surface surface = surface_at(world, ray, *hit);
    const Vec3 normal = turned_to_viewer(surface.shading_normal, ray.direction);
    return local_light(world, surface, material_at(world, *hit, surface), normal, -ray.direction);
}

RayColor color_function(const World& world) {
    switch (world.integrator) {
        case Integrator::Directions:
            return direction_color;
        case Integrator::Normals:
        case Integrator::Rasterize:
            return normal_color;
        case Integrator::Uv:
            return uv_color;
        case Integrator::Flat:
            return cast_ray;
        case Integrator::Raytrace:
            break;
    }
    if (world.needs.reflection || world.needs.refraction) return radiance;
    return world.needs.lights ? lit_color : cast_ray;
}

}  // namespace rt
