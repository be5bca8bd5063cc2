// The integrators `analyticdirect` and `direct` of the successor course: nothing but the light of area
// lights, in physical units.
#pragma once

#include "common/world/query.hpp"

namespace rt {

/// Emission, and diffuse/π times the irradiance of each polygon light by Lambert's formula (12.14): without
/// shadows, and without a horizon. As its users have it, a light behind the surface counts negatively.
Vec3 analytic_direct(const World& world, const Ray& ray, Stream& stream);

/// Emission, and what comes from random points of the area lights (12.18): by diffuse/π and a Phong lobe, or
/// by GGX (12.23).
Vec3 direct(const World& world, const Ray& ray, Stream& stream);

}  // namespace rt
