// What all ways of choosing a direction towards a light answer.
#pragma once

#include "common/math/vec.hpp"

#include <optional>

namespace rt {

/// A direction that leads to a light.
struct LightDirection {
    Vec3 direction{0, 0, 1};  ///< unit
    Real distance = 0;        ///< to the light's point that was chosen
    Real pdf = 0;             ///< density per steradian, with which this direction was chosen
};

/// The direction to what is `away` from the viewer, chosen with the density `pdf`. Nothing if that is where
/// the viewer is. Given.
inline std::optional<LightDirection> aimed(const Vec3& away, Real pdf) {
    if (!(size_of(away) > 0)) return std::nullopt;
    return LightDirection{unit(away), glm::length(away), pdf};
}

}  // namespace rt
