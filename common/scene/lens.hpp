// What a camera does beside looking: its lens and its shutter.
#pragma once

#include "common/math/vec.hpp"

namespace rt {

/// A thin lens: all rays through one point of the picture meet in one point of the plane in focus.
struct Lens {
    Real radius = 0;    ///< world units; 0 is a pinhole
    Real distance = 1;  ///< of the plane in focus along the view direction, from the eye; positive
    int sides = 0;      ///< of the aperture, a regular polygon in the circle of the radius; 0 is the circle
    Real turn = 0;      ///< of the polygon, radians, counterclockwise as the camera's right and up have it
};

/// When light comes in. The shutter opens at time 0 and is closed at time 1. Meanwhile it is open in
/// proportion to a trapezoid: rising during the first part, falling during the last one.
struct Shutter {
    Real opening = 0;  ///< how long the shutter takes to open, as a part of the whole; 0 is at once
    Real closing = 0;  ///< likewise to close; opening + closing ≤ 1
};

}  // namespace rt
