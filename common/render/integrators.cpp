// One colour a ray: the integrators that the course gives, and which function of one a world uses.
// To add one: its row in common/scene/integrators.hpp, and its functions and its row here.
#include "common/render/integrators.hpp"

#include "chapters/07_recursion/radiance.hpp"
#include "chapters/12_distribution/distributed.hpp"
#include "common/render/direct.hpp"
#include "common/render/filtered.hpp"
#include "common/render/groups.hpp"
#include "common/render/lights.hpp"
#include "common/render/rough.hpp"
#include "common/scene/integrators.hpp"

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

/// The function that `make` makes for the way in which this world is asked.
template <class Make>
RayColor for_shapes(const World& world, Make make) {
    if (world.groups.size() != 1 || world.needs.bumps) return make.template operator()<AllShapes>();
    return std::visit(
        [&]<class Shape>(const Group<Shape>& group) {
            // Next to a search by an accelerator, the choice of a shape is nothing.
            return has_accelerator(group) ? make.template operator()<AllShapes>()
                                          : make.template operator()<OnlyShape<Shape>>();
        },
        world.groups.front());
}

/// What `Show` says of the nearest hit, or the background of a world without a sky.
template <class Show, class Among>
Vec3 color_of_nearest(const World& world, const Ray& ray, Stream&) {
    const std::optional<Hit> hit = Among::closest(world, ray);
    return hit ? Show::template of<Among>(world, ray, *hit) : world.background;
}

/// The same, or the sky.
template <class Show>
Vec3 color_under_sky(const World& world, const Ray& ray, Stream&) {
    const std::optional<Hit> hit = AllShapes::closest(world, ray);
    return hit ? Show::template of<AllShapes>(world, ray, *hit) : sky_color(world, ray.direction);
}

/// What a function of chapter 11's averages says of the nearest hit, or the background.
template <HitColor show>
Vec3 filtered_color(const World& world, const Ray& ray, Stream&) {
    const std::optional<Hit> hit = closest_hit(world, ray, everything);
    return hit ? show(world, ray, *hit) : background(world, ray.direction);
}

template <class Show>
RayColor nearest(const World& world) {
    if (world.needs.sky) return color_under_sky<Show>;
    return for_shapes(world, []<class Among>() -> RayColor { return color_of_nearest<Show, Among>; });
}

/// The material at a hit where no material varies. Nobody needs to know the surface then, and what the
/// world keeps is not copied.
const Material& plain_material(const World& world, const Hit& hit) {
    return world.materials[world.primitives[hit.primitive].material];
}

// directions

/// The ray's direction as a colour, (d + 1)/2 for the unit direction d.
Vec3 direction_color(const World&, const Ray& ray, Stream&) {
    return 0.5 * (normalize(ray.direction) + Vec3(1));
}

RayColor directions(const World&) { return direction_color; }

// normals

/// The unit shading normal, turned to the viewer, as the colour (n + 1)/2.
struct Normal {
    template <class Among>
    static Vec3 of(const World& world, const Ray& ray, const Hit& hit) {
        const Vec3 n = Among::surface(world, ray, hit).shading_normal;
        return 0.5 * (turned_to_viewer(n, ray.direction) + Vec3(1));
    }
};

RayColor normals(const World& world) {
    return world.needs.footprints ? filtered_color<filtered_normal> : nearest<Normal>(world);
}

HitColor normal_of_hit(const World& world) {
    return world.needs.footprints ? filtered_normal : Normal::of<AllShapes>;
}

// uv

/// The texture coordinates as (u, v, 0).
struct TextureCoordinates {
    template <class Among>
    static Vec3 of(const World& world, const Ray& ray, const Hit& hit) {
        return Vec3(Among::surface(world, ray, hit).uv, 0);
    }
};

// flat

/// What a thing shows without any light, where no material varies.
struct PlainLight {
    template <class Among>
    static Vec3 of(const World& world, const Ray&, const Hit& hit) {
        const Material& material = plain_material(world, hit);
        return material.ambient + material.emission;
    }
};

/// The same, whether materials vary or not.
struct OwnLight {
    template <class Among>
    static Vec3 of(const World& world, const Ray& ray, const Hit& hit) {
        if (!varies(world.needs)) return PlainLight::of<Among>(world, ray, hit);
        const Material material = material_at(world, hit, Among::surface(world, ray, hit));
        return material.ambient + material.emission;
    }
};

Vec3 cast_ray_color(const World& world, const Ray& ray, Stream&) { return cast_ray(world, ray); }

RayColor flat(const World& world) {
    return world.needs.footprints ? filtered_color<filtered_own_light> : cast_ray_color;
}

HitColor own_light_of_hit(const World& world) {
    return world.needs.footprints ? filtered_own_light : OwnLight::of<AllShapes>;
}

// raytrace

/// The shading sum of chapter 5, without reflection. Whether materials vary is decided once a picture.
template <bool varied>
struct SumOfLights {
    template <class Among>
    static Vec3 of(const World& world, const Ray& ray, const Hit& hit) {
        const Surface surface = Among::surface(world, ray, hit);
        const Vec3 normal = turned_to_viewer(surface.shading_normal, ray.direction);
        const Material& material = material_of(world, hit, surface);
        return sum_of_lights(world, surface, material, normal, -ray.direction);
    }

private:
    static decltype(auto) material_of(const World& world, const Hit& hit, const Surface& surface) {
        if constexpr (varied)
            return material_at(world, hit, surface);
        else
            return plain_material(world, hit);
    }
};

/// The same with light from the sky, or on surfaces that have a finish.
struct AllLight {
    template <class Among>
    static Vec3 of(const World& world, const Ray& ray, const Hit& hit) {
        const Surface surface = Among::surface(world, ray, hit);
        const Vec3 normal = turned_to_viewer(surface.shading_normal, ray.direction);
        return local_light(world, surface, material_at(world, hit, surface), normal, -ray.direction);
    }
};

Vec3 radiance_color(const World& world, const Ray& ray, Stream&) { return radiance(world, ray); }

RayColor raytrace(const World& world) {
    const Needs& needs = world.needs;
    if (needs.rough) return rough_distributed;
    if (needs.distribution) return distributed;
    if (needs.footprints) return filtered_radiance;
    if (needs.reflection || needs.refraction) return radiance_color;
    if (needs.other_light) return nearest<AllLight>(world);
    if (needs.lights)
        return varies(needs) ? nearest<SumOfLights<true>>(world) : nearest<SumOfLights<false>>(world);
    return varies(needs) ? cast_ray_color : nearest<PlainLight>(world);
}

/// The rendering half of a row.
struct Renderer {
    Integrator integrator;
    RayColor (*color)(const World&);                ///< looks at the world, once a picture
    HitColor (*hit_color)(const World&) = nullptr;  ///< where its colour depends on the nearest hit alone
};

constexpr Renderer renderers[] = {
    {Integrator::Raytrace, raytrace},
    {Integrator::Flat, flat, own_light_of_hit},
    {Integrator::Directions, directions},
    {Integrator::Normals, normals, normal_of_hit},
    {Integrator::Uv, nearest<TextureCoordinates>,
     [](const World&) -> HitColor { return TextureCoordinates::of<AllShapes>; }},
    {Integrator::AnalyticDirect, [](const World&) -> RayColor { return analytic_direct; }},
    {Integrator::Direct, [](const World&) -> RayColor { return direct; }},
};

constexpr bool fits_the_scenes_table() {
    if (std::size(renderers) != std::size(integrators)) return false;
    for (std::size_t i = 0; i < std::size(integrators); ++i)
        if (renderers[i].integrator != integrators[i].value) return false;
    return true;
}
static_assert(fits_the_scenes_table());

const Renderer& renderer_of(const World& world) {
    return renderers[static_cast<std::size_t>(world.integrator)];
}

}  // namespace

RayColor color_function(const World& world) { return renderer_of(world).color(world); }

Vec3 color_along(const World& world, const Ray& ray) {
    Stream stream;
    return color_function(world)(world, ray, stream);
}

RayColor unaveraged_color_function(const World& world) {
    const RayColor averaged = color_function(world);
    if (averaged == filtered_radiance) return radiance_color;
    if (averaged == filtered_color<filtered_own_light>) return cast_ray_color;
    if (averaged == filtered_color<filtered_normal>) return nearest<Normal>(world);
    return nullptr;
}

HitColor hit_color_function(const World& world) {
    const Renderer& renderer = renderer_of(world);
    return renderer.hit_color ? renderer.hit_color(world) : nullptr;
}

}  // namespace rt
