// Light on a surface: what arrives from a light, and what of it goes on to the viewer.
#include "chapters/05_lighting/lighting.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

LightSample sample_light(const PointLight& light, const Vec3& point) {
    // [exercise 05.1] The vector from the point to the light gives direction and distance d. With the
    // attenuation (c, l, q) the light arrives as color / (c + l·d + q·d²). Where d is 0, or the
    // denominator is not greater than 0, return a LightSample with the colour black.
    const Vec3 to_light = light.position - point;
    const Vec3 size = glm::abs(to_light);
    const Real greatest = std::max({size.x, size.y, size.z});
    if (!(greatest > 0)) return {.distance = 0};
    const Real d = greatest * length(to_light / greatest);
    const Real c = light.attenuation.x, l = light.attenuation.y, q = light.attenuation.z;
    const Real denominator = c + l * d + q * d * d;
    if (!(denominator > 0)) return {.direction = to_light / d, .distance = d};
    return {to_light / d, d, light.color / denominator};
    // [/exercise]
}

LightSample sample_light(const DirectionalLight& light, const Vec3&) {
    // [exercise 05.1] The light's own direction and colour, from infinitely far away.
    return {light.direction, infinity, light.color};
    // [/exercise]
}

Real lambert(const Vec3& n, const Vec3& l) {
    // [exercise 05.2] The cosine of the angle between n and l, and 0 where it is negative.
    return std::max(dot(n, l), Real(0));
    // [/exercise]
}

Real blinn(const Vec3& n, const Vec3& l, const Vec3& v, Real shininess) {
    // [exercise 05.3] Make h = l + v a unit vector and raise max(n·h, 0) to the power `shininess`. Return 0
    // where h has no direction, and where n·h is not greater than 0.
    const Vec3 h = l + v;
    const Real size = length(h);
    if (!(size > 0)) return 0;
    const Real cosine = dot(n, h) / size;
    return cosine > 0 ? std::pow(std::min(cosine, Real(1)), shininess) : 0;
    // [/exercise]
}

Real phong(const Vec3& n, const Vec3& l, const Vec3& v, Real shininess) {
    // [exercise 05.4] Mirror l at n: r = 2(n·l)n − l; raise max(r·v, 0) to the power `shininess`, and return
    // 0 where r·v is not greater than 0.
    const Vec3 r = 2 * dot(n, l) * n - l;
    const Real cosine = dot(r, v);
    return cosine > 0 ? std::pow(std::min(cosine, Real(1)), shininess) : 0;
    // [/exercise]
}

Vec3 reflected_light(const Material& material, const Vec3& n, const Vec3& v, const LightSample& light,
                     const Vec3& visibility) {
    // [exercise 05.5] Black where n·l ≤ 0. Else visibility · color · (diffuse · lambert + specular · highlight)
    // with blinn or phong as material.highlight says. Where specular is black compute no highlight.
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
