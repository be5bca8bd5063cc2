// A turn while the shutter is open, as plain data.
#pragma once

#include "common/math/vec.hpp"

namespace rt {

/// A turn at an even pace about the line through `center` along `axis`: by 0 at time 0, by `angle` at time 1.
struct Spin {
    Vec3 center{0};
    Vec3 axis{0, 0, 1};  ///< a unit vector, up to rounding
    Real angle = 0;      ///< radians, counterclockwise as seen from the axis's tip; may be more than one turn
};

}  // namespace rt
