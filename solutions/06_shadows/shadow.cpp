// Shadows: one more question to the scene, asked from a point that is surely outside the surface.
// The lesson uses the same letters: n for the normal, e for the error bound, d for the offset along n.
#include "chapters/06_shadows/shadow.hpp"

#include "common/math/error.hpp"

#include <cmath>

namespace rt {

Vec3 offset_origin(const Surface& surface, const Vec3& direction) {
    // [exercise 06.1] The point, moved along the geometric normal n to the side that `direction` points to,
    // until all of the box of its error bound e is behind it; then each coordinate that was moved goes on to
    // the next number in the same direction, because the addition was rounded.
    const Vec3& n = surface.normal;
    const Real d = dot(glm::abs(n), surface.error);
    const Vec3 offset = dot(direction, n) < 0 ? -d * n : d * n;
    Vec3 origin = surface.point + offset;
    for (int i = 0; i < 3; ++i) {
        if (offset[i] > 0) origin[i] = std::nextafter(origin[i], infinity);
        if (offset[i] < 0) origin[i] = std::nextafter(origin[i], -infinity);
    }
    return origin;
    // [/exercise]
}

ShadowRay shadow_ray(const Surface& surface, const LightSample& light) {
    // [exercise 06.2] The ray from the offset origin (06.1) to the light, with a unit direction, and the
    // range in which hits count. To a light infinitely far away it goes in the light's direction, without
    // end. Else it is aimed at the light anew, because the origin has moved, and ends at the new distance
    // times 1 − gamma(16): what holds the light must not hide it. Where that distance is 0 the range is
    // empty.
    const Vec3 origin = offset_origin(surface, light.direction);
    if (light.distance == infinity) return {{origin, light.direction}, {0, infinity}};
    const Vec3 to_light = light.distance * light.direction - (origin - surface.point);
    const Real distance = length(to_light);
    if (!(distance > 0)) return {{origin, light.direction}, {0, 0}};
    return {{origin, to_light / distance}, {0, distance * (1 - gamma(16))}};
    // [/exercise]
}

Vec3 visibility(const World& world, const ShadowRay& shadow) {
    // [exercise 06.3] White where nothing at all stands between surface and light, else black. It does not
    // matter what it is, nor where.
    return Vec3(occluded(world, shadow.ray, shadow.range) ? 0 : 1);
    // [/exercise]
}

Vec3 colored_visibility(const World& world, const ShadowRay& shadow) {
    // [exercise 06.4] The product of the transmissions of all surfaces that the ray meets in its range, white
    // if there are none. Of surfaces in the same place each counts. Once the product is black, stop.
    Vec3 part(1);
    std::optional<Hit> hit = closest_hit(world, shadow.ray, shadow.range);
    while (hit) {
        const Surface surface = surface_at(world, shadow.ray, *hit);
        part *= material_at(world, *hit, surface).transmission;
        if (part == Vec3(0)) break;
        hit = next_hit(world, shadow.ray, *hit, shadow.range);
    }
    return part;
    // [/exercise]
}

}  // namespace rt
