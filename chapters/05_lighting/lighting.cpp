// Light on a surface: what arrives from a light, and what of it goes on to the viewer.
// The lesson uses the same letters: n for the normal, l to the light, v to the viewer, h half way, r
// mirrored.
#include "chapters/05_lighting/lighting.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

LightSample sample_light(const PointLight& light, const Vec3& point) {
    // 05.1  The vector from the point to the light has the direction l and the length d. With the
    // attenuation (c, l, q) = (x, y, z) the light arrives as color / (c + l·d + q·d²). Where d is 0 return a
    // LightSample with .distance = 0, and where the quotient is not a finite number one with the colour
    // black: nothing that is computed from it may become NaN.
    return todo("05.1");
}

LightSample sample_light(const DirectionalLight& light, const Vec3&) {
    // 05.1  The light's own direction and colour, from infinitely far away.
    return todo("05.1");
}

Real lambert(const Vec3& n, const Vec3& l) {
    // 05.2  The cosine of the angle between n and l, and 0 where it is negative.
    return todo("05.2");
}

Real blinn(const Vec3& n, const Vec3& l, const Vec3& v, Real shininess) {
    // 05.3  Make h = l + v a unit vector and raise n·h to the power `shininess`. Return 0 where n·h
    // is not greater than 0, and where l and v are opposite, so that h has no direction. Rounding can make
    // n·h a little greater than 1, and a power of that a lot: let it be 1 at most.
    return todo("05.3");
}

Real phong(const Vec3& n, const Vec3& l, const Vec3& v, Real shininess) {
    // 05.4  Mirror l at n: r = 2(n·l)n − l. Raise r·v, at most 1, to the power `shininess`; return
    // 0 where it is not greater than 0.
    return todo("05.4");
}

Vec3 reflected_light(const Material& material, const Vec3& n, const Vec3& v, const LightSample& light,
                     const Vec3& visibility) {
    // 05.5  Black where n·l ≤ 0. Else visibility · color · (diffuse · lambert + specular ·
    // highlight), the highlight by blinn or phong as material.highlight says. Where specular is black,
    // compute none: most surfaces are matt, and a power is the most expensive thing here.
    return todo("05.5");
}

Vec3 emitted_light(const Material& material) {
    // 05.5  What the surface shows without any light.
    return todo("05.5");
}

}  // namespace rt
