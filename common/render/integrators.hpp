// From rays to colours: the rendering half of the table of integrators.
#pragma once

#include "chapters/01_ray_casting/raycast.hpp"

namespace rt {

/// The cheapest function that is right for this world: what a picture needs is looked at here, once, and not
/// ray by ray. For a picture by scan conversion it is that of the same picture by rays.
RayColor color_function(const World& world);

/// The colour along one ray, which belongs to no pixel: by random numbers that are the same each time.
Vec3 color_along(const World& world, const Ray& ray);

/// The same function but for textures, which it looks up between four texels and does not average over what
/// a pixel sees. Null where nothing is averaged.
RayColor unaveraged_color_function(const World& world);

/// What the nearest hit of a ray shows: linear RGB.
using HitColor = Vec3 (*)(const World&, const Ray&, const Hit&);

/// The same for a hit that something else than a ray has found; only for integrators whose colour depends on
/// nothing but the nearest hit (`hit_alone` in common/scene/integrators.hpp).
HitColor hit_color_function(const World& world);

/// `n` if it points against the ray's direction d, else −n. Always part of its caller, however many kinds of
/// shapes there are, each of which has a copy.
[[gnu::always_inline]] inline Vec3 turned_to_viewer(const Vec3& n, const Vec3& d) {
    return dot(n, d) > 0 ? -n : n;
}

}  // namespace rt
