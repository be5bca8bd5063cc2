// Lights with an extent under the sum of chapter 5: one random point at a time.
#pragma once

#include "chapters/05_lighting/lighting.hpp"
#include "common/scene/scene.hpp"

#include <optional>

namespace rt {

/// [12.18] What a random point of the light sends to `point`: its direction and distance, and the colour
/// radiance/(π·pdf), where pdf is the density per steradian with which that direction was chosen. So the mean
/// of colour · max(n·l, 0) over all random numbers is 1/π times the irradiance at a surface with the normal
/// n, if nothing is in between; and a white surface that sees nothing but the light, in all directions, is as
/// bright as the light.
///
/// By LightSampling::Area the point is uniform on the light (12.10); by LightSampling::Angle its direction is
/// uniform in what is seen of the light (12.11 to 12.13), of which discs know nothing: theirs is by area,
/// too. Nothing where the point of the light shows its dark side, or where the light is not seen at all.
/// `random`: of the unit square [0, 1)². Which numbers give which point is left open.
///
/// As right as the directions and densities of those steps; the colour to gamma(4) more. Never NaN.
std::optional<LightSample> sample_light(const AreaLight& light, const Vec3& point, LightSampling how,
                                        const Vec2& random);

}  // namespace rt
