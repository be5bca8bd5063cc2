// Light on a surface: what arrives from a light, and what of it goes on to the viewer.
// The lesson uses the same letters: n for the normal, l to the light, v to the viewer, h halfway, r
// mirrored.
#include "chapters/05_lighting/lighting.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

LightSample sample_light(const PointLight& light, const Vec3& point) {
    // 05.1  In which direction and at what distance d the lamp is, seen from the point, and what
    // arrives of its light: color / (x + y·d + z·d²), where (x, y, z) is the attenuation. A lamp at
    // the very point sends nothing, and its distance is 0. Where the quotient is not a finite number, no
    // light arrives, from that direction and distance. Nothing computed from the answer may become NaN.
    return todo("05.1");
}

LightSample sample_light(const DirectionalLight& light, const Vec3&) {
    // 05.1  The same for a light infinitely far away: its own direction and colour, everywhere.
    return todo("05.1");
}

Real lambert(const Vec3& n, const Vec3& l) {
    // 05.2  The part of the light that the surface catches: the cosine of the angle between n and
    // l, and 0 where the light is behind the surface.
    return todo("05.2");
}

Real blinn(const Vec3& n, const Vec3& l, const Vec3& v, Real shininess) {
    // 05.3  (n·h)^shininess, where h is the unit vector halfway between l and v. 0 where n·h is
    // not greater than 0, and where l and v are opposite, so that h has no direction. Never more than 1,
    // although rounding can make n·h a little greater.
    return todo("05.3");
}

Real phong(const Vec3& n, const Vec3& l, const Vec3& v, Real shininess) {
    // 05.4  (r·v)^shininess, where r is l mirrored at n. 0 where r·v is not greater than 0; never
    // more than 1.
    return todo("05.4");
}

Vec3 reflected_light(const Material& material, const Vec3& n, const Vec3& v, const LightSample& light,
                     const Vec3& visibility) {
    // 05.5  What goes from one light to the viewer: black where n·l ≤ 0, else visibility · color ·
    // (diffuse · lambert + specular · highlight), with the highlight that material.highlight names. Where
    // specular is black, compute no highlight: most surfaces are matte, and a power costs more than the rest.
    return todo("05.5");
}

Vec3 emitted_light(const Material& material) {
    // 05.5  What the surface shows without any light.
    return todo("05.5");
}

}  // namespace rt
