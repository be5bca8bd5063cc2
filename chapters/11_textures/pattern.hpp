// Patterns in space: a value between 0 and 1 at every point, and two colours mixed by it.
// ε is the unit roundoff of `Real`.
#pragma once

#include "common/math/vec.hpp"
#include "common/scene/solid_pattern.hpp"

namespace rt {

// In all of them q is the point in units of the pattern's size, finite, and the value is in [0, 1].

/// [11.8] Slices across x, one unit thick: 0 where floor(x) is even, 1 where it is odd. So x = 1 belongs to
/// the second slice, and x = -0.5 to one of the second colour. From 2^53 on every whole x is even.
Real stripe_value(const Vec3& q);

/// [11.8] Shells around the y axis, one unit thick: 0 where floor(r) is even, 1 where it is odd, with r the
/// distance from the axis. A distance that rounding brings to a whole number belongs to the outer shell.
Real ring_value(const Vec3& q);

/// [11.8] From 0 to 1 along y, and again from 0 after each whole number: y - floor(y). To 2ε: it may be 1
/// just below a whole number.
Real gradient_value(const Vec3& q);

/// [11.8] Soft slices across x, disturbed by turbulence (Perlin 1985): (1 + sin(pi * s))/2 with
/// s = x + 4 * turbulence(q/4, 6). To 40000ε for every q: from a large x, whole waves must be taken before
/// anything else is computed.
Real marble_value(const Vec3& q);

/// [11.8] The rings of a tree around the y axis: r + 2 * noise(q/8), less the greatest whole number in it,
/// with r the distance from the axis. To 4ε * (2500 + r), but for 1 in place of 0 and 0 in place of 1 where a
/// ring ends.
Real wood_value(const Vec3& q);

/// The value of the pattern of that kind; of Cellular it is twice second - first of cell_distances, but at
/// most 1: 0 on the walls between the cells. Given.
Real pattern_value(PatternKind kind, const Vec3& q);

/// [11.8] The colour at a point of the world: `first` where the value is 0, `second` where it is 1, and
/// between them linearly; both to the bit. The pattern's space is the world's, divided by its size, so that
/// both times the same power of two give the same bits. point/size is finite. Where the value jumps, a point
/// on the boundary has the upper value; who asks for a point of a surface adds the surface's error first, so
/// that a plane exactly between two stripes has one colour.
Vec3 pattern_color(const SolidPattern& pattern, const Vec3& point);

}  // namespace rt
