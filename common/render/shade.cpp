// One colour a ray: the integrators that the course gives, and which one a world uses.
#include "common/render/shade.hpp"

#include "chapters/07_recursion/radiance.hpp"
#include "common/render/groups.hpp"
#include "common/render/lights.hpp"

namespace rt {
namespace {

constexpr Interval everything{0, infinity};

// How a ray asks the world. The functions below are made for each way, so that none of them has a choice
// left.

/// A world of several shapes, or none: each is asked.
struct AllShapes {
    static std::optional<Hit> closest(const World& world, const Ray& ray) {
        return closest_hit(world, ray, everything);
    }
    static Surface surface(const World& world, const Ray& ray, const Hit& hit) {
        return surface_at(world, ray, hit);
    }
};

/// A world whose primitives are all of this shape, without an accelerator: they alone are asked.
template <class Shape>
struct OnlyShape {
    static std::optional<Hit> closest(const World& world, const Ray& ray) {
        return closest_hit(shapes_of(only_group<Shape>(world)), ray, everything);
    }
    static Surface surface(const World& world, const Ray& ray, const Hit& hit) {
        return surface_in(world, only_group<Shape>(world), hit.primitive, ray, hit);
    }
};

/// The material at a hit where no material has a pattern: then nobody needs to know the surface.
const Material& plain_material(const World& world, const Hit& hit) {
    return world.materials[world.primitives[hit.primitive].material];
}

/// The ray's direction as a colour, (d + 1)/2 for the unit direction d.
Vec3 direction_color(const World&, const Ray& ray) { return 0.5 * (normalize(ray.direction) + Vec3(1)); }

/// The unit shading normal at the nearest hit, turned to the viewer, as the colour (n + 1)/2.
template <class Among>
Vec3 normal_color(const World& world, const Ray& ray) {
    const std::optional<Hit> hit = Among::closest(world, ray);
    if (!hit) return world.background;
    const Vec3 n = turned_to_viewer(Among::surface(world, ray, *hit).shading_normal, ray.direction);
    return 0.5 * (n + Vec3(1));
}

/// The texture coordinates at the nearest hit as (u, v, 0).
template <class Among>
Vec3 uv_color(const World& world, const Ray& ray) {
    const std::optional<Hit> hit = Among::closest(world, ray);
    return hit ? Vec3(Among::surface(world, ray, *hit).uv, 0) : world.background;
}

/// What the nearest thing shows where there are no lights and no patterns.
template <class Among>
Vec3 plain_color(const World& world, const Ray& ray) {
    const std::optional<Hit> hit = Among::closest(world, ray);
    if (!hit) return world.background;
    const Material& material = plain_material(world, *hit);
    return material.ambient + material.emission;
}

/// The shading sum of SCENE_FORMAT.md at the nearest hit, without reflection.
template <class Among>
Vec3 lit_color(const World& world, const Ray& ray) {
    const std::optional<Hit> hit = Among::closest(world, ray);
    if (!hit) return world.background;
    const Surface surface = Among::surface(world, ray, *hit);
    const Vec3 normal = turned_to_viewer(surface.shading_normal, ray.direction);
    const Material& material =
        world.needs.patterns ? material_at(world, *hit, surface) : plain_material(world, *hit);
    return sum_of_lights(world, surface, material, normal, -ray.direction);
}

template <class Among>
RayColor color_function_for(const World& world) {
    switch (world.integrator) {
        case Integrator::Directions:
            return direction_color;
        case Integrator::Normals:
        case Integrator::Rasterize:
            return normal_color<Among>;
        case Integrator::Uv:
            return uv_color<Among>;
        case Integrator::Flat:
            return cast_ray;
        case Integrator::Raytrace:
            break;
    }
    const Needs& needs = world.needs;
    if (needs.reflection || needs.refraction) return radiance;
    if (needs.lights) return lit_color<Among>;
    return needs.patterns ? cast_ray : plain_color<Among>;
}

}  // namespace

RayColor color_function(const World& world) {
    if (world.groups.size() != 1) return color_function_for<AllShapes>(world);
    return std::visit(
        [&]<class Shape>(const Group<Shape>& group) {
            // Next to a search by an accelerator, the choice of a shape is nothing.
            return has_accelerator(group) ? color_function_for<AllShapes>(world)
                                          : color_function_for<OnlyShape<Shape>>(world);
        },
        world.groups.front());
}

}  // namespace rt
