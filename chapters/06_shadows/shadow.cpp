// Shadows: one more question to the scene, asked from a point that is surely outside the surface.
// The lesson uses the same letters: n for the normal, e for the error bound, d for the offset along n.
#include "chapters/06_shadows/shadow.hpp"

#include "common/math/error.hpp"
#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Vec3 offset_origin(const Surface& surface, const Vec3& direction) {
    // 06.1  The point, moved along the geometric normal n to the side that `direction` points to,
    // until all of the box of its error bound e is behind it; then each coordinate that was moved goes on to
    // the next number in the same direction, because the addition was rounded.
    return todo("06.1");
}

ShadowRay shadow_ray(const Surface& surface, const LightSample& light) {
    // 06.2  The ray from the offset origin (06.1) to the light, with a unit direction, and the
    // range in which hits count. To a light infinitely far away it goes in the light's direction, without
    // end. Else it is aimed at the light anew, because the origin has moved, and ends at the new distance
    // times 1 − gamma(16): what holds the light must not hide it. Where that distance is 0 the range is
    // empty.
    return todo("06.2");
}

Vec3 visibility(const World& world, const ShadowRay& shadow) {
    // 06.3  White where nothing at all stands between surface and light, else black. It does not
    // matter what it is, nor where.
    return todo("06.3");
}

Vec3 colored_visibility(const World& world, const ShadowRay& shadow) {
    // 06.4  The product of the transmissions of all surfaces that the ray meets in its range, white
    // if there are none. Of surfaces in the same place each counts. Once the product is black, stop.
    return todo("06.4");
}

}  // namespace rt
