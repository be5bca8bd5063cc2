// What all lobes share. A lobe says how much of the light from one direction a surface sends into another.
// Directions are unit vectors that point away from the surface, in a frame whose z axis is the normal: so
// `to_light.z` and `to_viewer.z` are cosines, positive above the surface.
#pragma once

#include "common/math/vec.hpp"

#include <algorithm>

namespace rt {

/// A direction from which light is to be fetched, and what that light counts.
struct LobeSample {
    Vec3 to_light{0, 0, 1};
    Vec3 weight{0};  ///< f·|cos|/pdf a channel, where f is the lobe and cos is to_light.z
    Real pdf = 0;    ///< per steradian; infinite if this direction is the only one, as in a mirror
};

/// Roughness of the smoothest lobe that is not a mirror. Less counts as this much.
inline constexpr Real least_roughness = 1e-4;

}  // namespace rt
