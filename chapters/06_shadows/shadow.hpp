// Shadows: one more question to the scene, asked from a point that is surely outside the surface.
#pragma once

#include "chapters/05_lighting/lighting.hpp"
#include "common/world/query.hpp"

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

/// [06.2] The shadow ray from the surface to a light: from the offset origin, aimed at the light anew, up to
/// it but not onto it. Its direction is a unit vector; the end is the distance from the offset origin,
/// shortened by gamma(16) of itself for rounding, so that what holds the light (a ceiling, say) does not hide
/// it. For a directional light the direction is the light's and the end infinite. A light on the very origin
/// has an empty range: nothing hides it.
ShadowRay shadow_ray(const Surface& surface, const LightSample& light);

/// [06.3] Which part of the light arrives where everything is opaque: 0 or 1, the same in all channels.
Vec3 visibility(const World& world, const ShadowRay& shadow);

/// [06.4] Which part of the light arrives where some things are transparent: the product of the
/// transmission of every surface crossed, without refraction (POV-Ray's convention); 0 behind anything
/// opaque. Of objects that are crossed at exactly the same distance each counts.
Vec3 colored_visibility(const World& world, const ShadowRay& shadow);

}  // namespace rt
