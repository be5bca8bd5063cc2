// Shadows: one more question to the scene, asked from a point that is surely outside the surface.
// The lesson uses the same letters: n for the normal, e for the error bound, d for the offset along n.
#include "chapters/06_shadows/shadow.hpp"

#include "common/math/error.hpp"
#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Vec3 offset_origin(const Surface& surface, const Vec3& direction) {
    // 06.1  The box of the error bound e around the point reaches d = Σ |nᵢ|·eᵢ far along the
    // normal n (the geometric one). Move the point by d·n, or by −d·n where the direction points to the other
    // side. The addition was rounded: move each coordinate on to the next number away from the surface
    // (std::nextafter, up where that coordinate of the offset is positive, down where it is negative).
    return todo("06.1");
}

ShadowRay shadow_ray(const Surface& surface, const LightSample& light) {
    // 06.2  Start at the offset origin. To a light infinitely far away go in the light's direction,
    // without end. Else aim anew, because the origin has moved: the vector to the light is distance ·
    // direction less the offset, and its length is the new distance d. Hits count in (0, d·(1 − gamma(16))]:
    // that much may be rounding, and what holds the light must not hide it. Where d is 0, nothing counts.
    return todo("06.2");
}

Vec3 visibility(const World& world, const ShadowRay& shadow) {
    // 06.3  Ask `occluded`, which stops at the first thing it finds: a shadow ray wants to know
    // whether, not what. Nothing arrives if it is, else everything.
    return todo("06.3");
}

Vec3 colored_visibility(const World& world, const ShadowRay& shadow) {
    // 06.4  Start with white, and with the closest hit in the range. As long as there is a hit:
    // multiply by the transmission of its material (surface_at, then material_at), and go on to the
    // next_hit. Stop where nothing is hit any more, or when the product is black.
    return todo("06.4");
}

}  // namespace rt
