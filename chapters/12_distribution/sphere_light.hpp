// Directions to a light that is a sphere, evenly by solid angle.
#pragma once

#include "chapters/12_distribution/light_direction.hpp"
#include "common/math/vec.hpp"
#include "common/scene/area_lights.hpp"

#include <optional>

namespace rt {

// From a point at the distance d of its centre, d > r, a sphere of radius r fills a cone: all directions that
// make an angle with the way to the centre whose sine is at most r/d. Lengths are from 1e-30 to 1e30.

/// [12.11] The solid angle that the sphere fills, as seen from `from`: 2π·(1 − cos), of the cone's angle; in
/// (0, 2π). 0 if `from` is not outside the sphere.
///
/// As a part of it right to gamma(24)·(1 + 1/cos), however small and far away the sphere is: close to its
/// surface, where the cosine goes to 0, it is d − r that rounding changes.
Real solid_angle(const SphereLight& light, const Vec3& from);

/// [12.11] A direction to the sphere for `random`, a point of [0, 1)²: uniform in the cone (Shirley, Wang &
/// Zimmerman, Monte Carlo Techniques for Direct Lighting Calculations, 1996), so that the pdf is
/// 1/solid_angle for all. Which numbers give which direction is left open. Nothing if `from` is not outside
/// the sphere.
///
/// The direction is a unit vector to gamma(16), and in the cone up to an angle of gamma(32)·(1 + 1/cos). The
/// distance is to where the ray enters the sphere; it is at least 0, and the point there is on the sphere up
/// to gamma(64)·d.
std::optional<LightDirection> toward(const SphereLight& light, const Vec3& from, const Vec2& random);

}  // namespace rt
