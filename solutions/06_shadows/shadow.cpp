// Shadows: one more question to the scene, asked from a point that is surely outside the surface.
#include "chapters/06_shadows/shadow.hpp"

#include "common/math/error.hpp"

#include <cmath>

namespace rt {

Vec3 offset_origin(const Surface& surface, const Vec3& direction) {
    // [exercise 06.1] The error box around the point reaches d = Σ |nᵢ|·errorᵢ along the normal n. Move the
    // point by d·n, or by −d·n where the direction points to the other side. Then move each coordinate on
    // to the next floating-point number in the direction of the offset (std::nextafter), because the
    // addition was rounded.
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
    // [exercise 06.2] Start at the offset origin, go in the light's direction, and let hits count in
    // (0, distance·(1 − gamma(8))]: what holds the light itself must not shade it.
    return {{offset_origin(surface, light.direction), light.direction}, {0, light.distance * (1 - gamma(8))}};
    // [/exercise]
}

Vec3 visibility(const World& world, const ShadowRay& shadow) {
    // [exercise 06.3] Nothing arrives where the scene says that the shadow ray is occluded, else all.
    return Vec3(occluded(world, shadow.ray, shadow.range) ? 0 : 1);
    // [/exercise]
}

Vec3 colored_visibility(const World& world, const ShadowRay& shadow) {
    // [exercise 06.4] Start with white. Find the closest hit in the range; multiply by the transmission of
    // its material; go on behind it by raising range.min to its t. Stop at black, or where nothing is hit.
    Vec3 part(1);
    Interval range = shadow.range;
    while (const std::optional<Hit> hit = closest_hit(world, shadow.ray, range)) {
        const Surface surface = surface_at(world, shadow.ray, *hit);
        part *= material_at(world, *hit, surface).transmission;
        if (part == Vec3(0)) break;
        range.min = hit->t;
    }
    return part;
    // [/exercise]
}

}  // namespace rt
