// Convex solids as what their faces have in common, along one line.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/hit.hpp"

#include <cstdint>
#include <optional>

namespace rt {

/// The part of a line that is inside a convex solid, and the faces of the solid by which the line comes in
/// and goes out. What a face's number means, the solid says. The default is the whole line.
struct Span {
    Real enter = -infinity;
    Real leave = infinity;  ///< not before `enter`; both in units of the line's direction
    std::uint32_t enter_face = 0;
    std::uint32_t leave_face = 0;
};

/// [10.1] The part of a line between two parallel planes, or nothing: where low ≤ x + t·v ≤ high. x is the
/// line's coordinate across the planes at t = 0, and v what it gains with each t; finite, low ≤ high.
///
/// The plane at `low` is face 0, the one at `high` face 1. A line that runs along the planes (v = ±0) is
/// between them everywhere, also in one of them, or nowhere. Each end is rounded twice; so slabs that share a
/// plane, to the bit, have that end in common, to the bit, and no line slips through between them.
std::optional<Span> slab(Real x, Real v, Real low, Real high);

/// [10.1] What two spans of one line have in common, or nothing. They are closed: two that touch have that
/// point in common. The later entry and the earlier exit stay, with their faces; of equal ones the first
/// span's.
std::optional<Span> common_part(const Span& a, const Span& b);

/// [10.1] Where a ray first crosses the surface of the solid, in (range.min, range.max]: where the line
/// enters, or if that is not in the range, where it leaves; or nothing. `Hit::element` is the face.
std::optional<Hit> first_hit(const Span& span, Interval range);

}  // namespace rt
