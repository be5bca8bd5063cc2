// Light on a surface: what arrives from a light, and what of it goes on to the viewer.
// The lesson uses the same letters: n for the normal, l to the light, v to the viewer, h halfway, r
// mirrored.
#include "chapters/05_lighting/lighting.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

LightSample sample_light(const PointLight& light, const Vec3& point) {
    // [exercise 05.1] In which direction and at what distance d the lamp is, seen from the point, and what
    // arrives of its light: color / (x + y·d + z·d²), where (x, y, z) is the attenuation. A lamp at
    // the very point sends nothing, and its distance is 0. Where the quotient is not a finite number, no
    // light arrives, from that direction and distance. Nothing computed from the answer may become NaN.
    const Vec3 to_light = light.position - point;
    const Real d = length(to_light);
    if (!(d > 0)) return {.distance = 0};
    const Vec3 l = to_light / d;
    const Vec3& attenuation = light.attenuation;
    const Real divisor = attenuation.x + attenuation.y * d + attenuation.z * d * d;
    const Vec3 color = light.color / divisor;
    if (!(divisor > 0) || !std::isfinite(color.x + color.y + color.z)) return {.direction = l, .distance = d};
    return {l, d, color};
    // [/exercise]
}

LightSample sample_light(const DirectionalLight& light, const Vec3&) {
    // [exercise 05.1] The same for a light infinitely far away: its own direction and colour, everywhere.
    return {light.direction, infinity, light.color};
    // [/exercise]
}

Real lambert(const Vec3& n, const Vec3& l) {
    // [exercise 05.2] The part of the light that the surface catches: the cosine of the angle between n and
    // l, and 0 where the light is behind the surface.
    return std::max(dot(n, l), Real(0));
    // [/exercise]
}

Real blinn(const Vec3& n, const Vec3& l, const Vec3& v, Real shininess) {
    // [exercise 05.3] (n·h)^shininess, where h is the unit vector halfway between l and v. 0 where n·h is
    // not greater than 0, and where l and v are opposite, so that h has no direction. Never more than 1,
    // although rounding can make n·h a little greater.
    const Vec3 h = l + v;
    const Real size = length(h);
    if (!(size > 0)) return 0;
    const Real cosine = dot(n, h) / size;
    return cosine > 0 ? std::pow(std::min(cosine, Real(1)), shininess) : 0;
    // [/exercise]
}

Real phong(const Vec3& n, const Vec3& l, const Vec3& v, Real shininess) {
    // [exercise 05.4] (r·v)^shininess, where r is l mirrored at n. 0 where r·v is not greater than 0; never
    // more than 1.
    const Vec3 r = 2 * dot(n, l) * n - l;
    const Real cosine = dot(r, v);
    return cosine > 0 ? std::pow(std::min(cosine, Real(1)), shininess) : 0;
    // [/exercise]
}

Vec3 reflected_light(const Material& material, const Vec3& n, const Vec3& v, const LightSample& light,
                     const Vec3& visibility) {
    // [exercise 05.5] What goes from one light to the viewer: black where n·l ≤ 0, else visibility · color ·
    // (diffuse · lambert + specular · highlight), with the highlight that material.highlight names. Where
    // specular is black, compute no highlight: most surfaces are matte, and a power costs more than the rest.
    const Vec3& l = light.direction;
    const Real cosine = lambert(n, l);
    if (!(cosine > 0)) return Vec3(0);
    Vec3 sum = material.diffuse * cosine;
    if (material.specular != Vec3(0)) {
        const auto highlight = material.highlight == Highlight::Blinn ? blinn : phong;
        sum += material.specular * highlight(n, l, v, material.shininess);
    }
    return visibility * light.color * sum;
    // [/exercise]
}

Vec3 emitted_light(const Material& material) {
    // [exercise 05.5] What the surface shows without any light.
    return material.ambient + material.emission;
    // [/exercise]
}

}  // namespace rt
