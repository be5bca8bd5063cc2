// One colour a ray: which function makes it for a world.
#pragma once

#include "chapters/01_ray_casting/raycast.hpp"

namespace rt {

/// The cheapest function that is right for this world: what a picture needs is looked at here, once, and not
/// ray by ray. For a picture by scan conversion it is that of the same picture by rays.
RayColor color_function(const World& world);

/// `n` if it points against the ray's direction d, else −n.
inline Vec3 turned_to_viewer(const Vec3& n, const Vec3& d) { return dot(n, d) > 0 ? -n : n; }

}  // namespace rt
