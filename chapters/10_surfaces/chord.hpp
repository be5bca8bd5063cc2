// The part of a line that is in a box, counted from near: given, for surfaces that end there.
// ε is the unit roundoff of `Real`.
#pragma once

#include "chapters/10_surfaces/box.hpp"

#include <cstdint>
#include <optional>

namespace rt {

/// The faces of a solid in a box are those of the box, as `inside` numbers them, and its own surface.
inline constexpr std::uint32_t surface_face = 6;

/// The points start + λ·way, 0 ≤ λ ≤ 1, from end to end inside a box. The ray's t there is from + λ·length. λ
/// has no unit: in a scene that is scaled, all that is computed with it stays the same.
struct Chord {
    Vec3 start{0}, way{0};
    Real from = 0, length = 0;

    Vec3 at(Real lambda) const { return start + lambda * way; }
    Real t_at(Real lambda) const { return from + lambda * length; }
};

/// The chord of the ray's line in the box, as far as it is in the part of the line, both ends included;
/// nothing where it is only a point. It starts at the ray's origin to the bit if that is its first point.
///
/// It is the exact chord but for a move by 4ε·(|origin| + the box's greatest coordinate).
std::optional<Chord> chord(const Box& box, const Ray& ray, Interval part);

/// The same from what `inside` says of the box and the ray.
std::optional<Chord> chord(const Span& in_box, const Ray& ray, Interval part);

/// The point on a surface in the box where the ray hits it at t, before it is moved onto the surface.
Vec3 point_in(const Box& box, const Ray& ray, Real t);

}  // namespace rt
