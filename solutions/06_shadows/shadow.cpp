// Shadows: one more question to the scene, asked from a point that is surely outside the surface.
// The lesson uses the same letters: n for the normal, e for the error bound, d for the offset along n.
#include "chapters/06_shadows/shadow.hpp"

#include "common/math/error.hpp"

#include <cmath>

namespace rt {

Vec3 offset_origin(const Surface& surface, const Vec3& direction) {
    // [exercise 06.1] The box of the error bound e around the point reaches d = Σ |nᵢ|·eᵢ far along the
    // normal n (the geometric one). Move the point by d·n, or by −d·n where the direction points to the other
    // side. The addition was rounded: move each coordinate on to the next number away from the surface
    // (std::nextafter, up where that coordinate of the offset is positive, down where it is negative).
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
    // [exercise 06.2] Start at the offset origin. To a light infinitely far away go in the light's direction,
    // without end. Else aim anew, because the origin has moved: the vector to the light is distance ·
    // direction less the offset, and its length is the new distance d. Hits count in (0, d·(1 − gamma(16))]:
    // that much may be rounding, and what holds the light must not hide it. Where d is 0, nothing counts.
    const Vec3 origin = offset_origin(surface, light.direction);
    if (light.distance == infinity) return {{origin, light.direction}, {0, infinity}};
    const Vec3 to_light = light.distance * light.direction - (origin - surface.point);
    const Real d = length(to_light);
    if (!(d > 0)) return {{origin, light.direction}, {0, 0}};
    return {{origin, to_light / d}, {0, d * (1 - gamma(16))}};
    // [/exercise]
}

Vec3 visibility(const World& world, const ShadowRay& shadow) {
    // [exercise 06.3] Ask `occluded`, which stops at the first thing it finds: a shadow ray wants to know
    // whether, not what. Nothing arrives if it is, else everything.
    return Vec3(occluded(world, shadow.ray, shadow.range) ? 0 : 1);
    // [/exercise]
}

Vec3 colored_visibility(const World& world, const ShadowRay& shadow) {
    // [exercise 06.4] Start with white, and with the closest hit in the range. As long as there is a hit:
    // multiply by the transmission of its material (surface_at, then material_at), and go on to the
    // next_hit. Stop where nothing is hit any more, or when the product is black.
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
