// Shadows: one more question to the scene, asked from a point that is surely outside the surface.
#pragma once

#include "chapters/05_lighting/lighting.hpp"
#include "common/scene/query.hpp"

namespace rt {

/// [06.1] Where a ray that leaves the surface in `direction` may start: the surface's point moved along the
/// normal, to the side that `direction` points to, until it is outside the box of its error bound, each
/// coordinate then rounded away from the surface (Pharr, Jakob & Humphreys, §6.8.6). No absolute epsilon:
/// scaling the scene by a power of two scales the result, to the bit.
Vec3 offset_origin(const Surface& surface, const Vec3& direction);

/// The part of a ray between a surface and a light.
struct ShadowRay {
    Ray ray;
    Interval range;
};

/// [06.2] The shadow ray from the surface to a light: from the offset origin, in the light's direction (a
/// unit vector), up to the light but not onto it: the end is shortened by the rounding error of the distance.
ShadowRay shadow_ray(const Surface& surface, const LightSample& light);

/// [06.3] Which part of the light arrives where everything is opaque: 0 or 1 in each channel.
Vec3 visibility(const World& world, const ShadowRay& shadow);

/// [06.4] Which part of the light arrives where some things are transparent: the product of the
/// transmission of every surface crossed, without refraction (POV-Ray's convention); 0 behind anything
/// opaque.
Vec3 colored_visibility(const World& world, const ShadowRay& shadow);

}  // namespace rt
