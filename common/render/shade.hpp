// One colour a ray: the integrators that the course gives, and which one a world uses.
#pragma once

#include "chapters/01_ray_casting/raycast.hpp"

namespace rt {

/// The ray's direction as a colour, (d + 1)/2 for the unit direction d.
Vec3 direction_color(const World& world, const Ray& ray);

/// The unit shading normal at a hit, turned to the viewer, as the colour (n + 1)/2.
Vec3 normal_at(const World& world, const Ray& ray, const Hit& hit);

/// `normal_at` the nearest hit; background on a miss.
Vec3 normal_color(const World& world, const Ray& ray);

/// The texture coordinates at the nearest hit as (u, v, 0); background on a miss.
Vec3 uv_color(const World& world, const Ray& ray);

/// The shading sum of SCENE_FORMAT.md at the nearest hit, without reflection; background on a miss.
Vec3 lit_color(const World& world, const Ray& ray);

/// The cheapest function that is right for this world. For a picture by scan conversion it is that of the
/// same picture by rays.
RayColor color_function(const World& world);

/// `n` if it points against the ray's direction d, else −n.
inline Vec3 turned_to_viewer(const Vec3& n, const Vec3& d) { return dot(n, d) > 0 ? -n : n; }

}  // namespace rt
