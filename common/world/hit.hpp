// What a ray meets: the hit, and the surface around it.
#pragma once

#include "common/math/ray.hpp"

#include <cstdint>

namespace rt {

/// Where along a ray something is met. Small, because many hits are found and few are shaded.
struct Hit {
    Real t = infinity;            ///< in units of |ray.direction|
    Vec2 uv{0};                   ///< triangles: weights of the corners b and c; else unused
    std::uint32_t primitive = 0;  ///< in a chapter: index into the span asked; in a World: order in the file
    std::uint32_t element = 0;    ///< which triangle of an instanced mesh, or face of a solid; else 0
};

/// The surface at a hit, in world space.
struct Surface {
    Vec3 point{0};
    Vec3 error{0};  ///< per coordinate: a point of the exact surface is at most this far away, and a ray
                    ///< that starts farther out on either side meets the surface no more
    Vec3 normal{0, 0, 1};          ///< unit, of the geometry: outward on a sphere; not turned to the viewer
    Vec3 shading_normal{0, 0, 1};  ///< unit, interpolated where the surface is smooth, else `normal`
    Vec2 uv{0};                    ///< texture coordinates
};

}  // namespace rt
