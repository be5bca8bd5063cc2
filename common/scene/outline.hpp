// The outline of a polygon in the plane: does it cross itself, which way does it go around?
#pragma once

#include "common/math/vec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// A corner of an outline that lies inside one of its sides.
struct Touch {
    std::uint32_t side = 0;    ///< from corner `side` to the next one
    std::uint32_t corner = 0;  ///< one of those at the place
};

/// What a walk around an outline finds.
struct OutlineCheck {
    /// How often the outline goes around every point inside: 1 counterclockwise, −1 clockwise, 0 where there
    /// is no inside.
    int turns = 0;
    bool crosses = false;        ///< it goes around some points otherwise; then the rest means nothing
    std::vector<Touch> touches;  ///< by sides, and along each side in its direction
};

/// Checks a closed outline by exact signs, in O(n log n): a line sweeps over the plane and keeps the sides
/// that it cuts in order; before two could change places they were neighbours (Shamos & Hoey 1976). Between
/// neighbours the number of turns is known, and must be 0 or always the same. Corners may share a place,
/// sides may lie on one another, and corners on sides.
OutlineCheck check_outline(std::span<const Vec2> corners);

}  // namespace rt
