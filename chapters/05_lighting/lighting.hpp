// Light on a surface: what arrives from a light, and what of it goes on to the viewer.
#pragma once

#include "common/scene/scene.hpp"

namespace rt {

/// What a light sends to one point, before anything in between is asked about.
struct LightSample {
    Vec3 direction{0, 1, 0};   ///< unit, from the point towards the light
    Real distance = infinity;  ///< to the light, world units; infinite for a directional light
    Vec3 color{0};             ///< arriving, after attenuation
};

/// [05.1] Light of a point light at `point`: color / (c + l·d + q·d²) at distance d, in world units. Where
/// the light stands on the point itself: black, with distance 0. Black, too, where the quotient is not a
/// finite number, because the light stands so near or the divisor is 0. No part of the attenuation is
/// negative. Never NaN.
LightSample sample_light(const PointLight& light, const Vec3& point);

/// [05.1] Light of a directional light: the same everywhere. `light.direction` is a unit vector.
LightSample sample_light(const DirectionalLight& light, const Vec3& point);

/// [05.2] Lambert's cosine max(n·l, 0) (Lambert 1760). n, l: unit vectors.
Real lambert(const Vec3& n, const Vec3& l);

/// [05.3] Highlight max(n·h, 0)^shininess with the half vector h = (l + v)/|l + v| (Blinn 1977), in [0, 1].
/// n, l, v: unit vectors, l to the light, v to the viewer. 0 where l = −v; 1 for shininess 0 where n·h > 0.
Real blinn(const Vec3& n, const Vec3& l, const Vec3& v, Real shininess);

/// [05.4] Highlight max(r·v, 0)^shininess with the mirror direction r = 2(n·l)n − l (Phong 1975), in [0, 1].
/// n, l, v as in `blinn`; 1 for shininess 0 where r·v > 0.
Real phong(const Vec3& n, const Vec3& l, const Vec3& v, Real shininess);

/// [05.5] Radiance towards the viewer from one light: visibility · light.color · (diffuse · lambert +
/// specular · highlight), black where n·l ≤ 0, because then the surface itself is in the way.
/// `n` is the unit normal turned to the viewer. Where specular is black, no highlight is computed, and
/// shininess is not looked at.
Vec3 reflected_light(const Material& material, const Vec3& n, const Vec3& v, const LightSample& light,
                     const Vec3& visibility);

/// [05.5] Radiance that needs no light: ambient + emission.
Vec3 emitted_light(const Material& material);

}  // namespace rt
