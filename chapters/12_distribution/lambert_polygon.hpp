// The light that an even polygon sends to a point, exactly and without a single sample: Lambert's formula.
// The lesson uses the same letters: dₖ from the point to corner k, uₖ its direction, θₖ the angle between uₖ
// and uₖ₊₁, Γₖ the unit normal of the plane through the point and edge k.
#pragma once

#include "common/math/vec.hpp"

#include <span>
#include <vector>

namespace rt {

/// [12.14] Lambert's vector of a closed polygon as seen from `point` (Lambert 1760),
///   Φ = ½ Σ θₖ·Γₖ,  Γₖ along dₖ × dₖ₊₁, θₖ in [0, π],
/// where the last edge goes back to the first corner. Its dot product with a normal is the irradiance there
/// of a polygon of radiance 1 that is wholly above the horizon: positive if the corners run clockwise as seen
/// from the point. That is where a QuadLight with the corners a, a + ab, a + ab + ac, a + ac is bright.
///
/// An edge whose line goes through the point counts 0, and so do equal corners: never NaN. Fewer than three
/// corners give 0, up to rounding. With n corners it is right to gamma(16 + n)·Σ θₖ·(1 + rₖ/pₖ), where rₖ is
/// the distance of the farther end of edge k and pₖ that of its line: also for a polygon that is small and
/// far away. Edges are 0, or from 1e-60 to 1e60 long, and corners no farther away than 1e60.
Vec3 lambert_vector(std::span<const Vec3> corners, const Vec3& point);

/// [12.14] The part of the polygon that is above the horizon: where (x − point)·normal ≥ 0 (Sutherland &
/// Hodgman 1974, one plane). The corners above stay as they are and in their order; where an edge crosses the
/// horizon there is a new one. It may begin with any corner, and a corner may be there twice. Empty, or
/// without an area, if nothing of the polygon is above. A concave one may fall into parts, which are then
/// joined by edges along the horizon. normal: unit.
///
/// A new corner on the edge from p to q is right to gamma(16)·(|p| + |q| + |point|)·(1 + |q − p|/|h|), where
/// h is what of q − p is along the normal.
std::vector<Vec3> above_horizon(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal);

/// [12.14] Irradiance at `point`, on a surface with the unit `normal`, of a polygon that sends radiance 1
/// everywhere and that nothing hides: ∫ cos θ dω over its part above the horizon, θ from the normal. In [0,
/// π] up to rounding, and the same for both orders of the corners. The polygon is flat up to rounding and
/// does not cross itself; the point is not on it.
///
/// As right as lambert_vector where all of it is above. Where the horizon cuts it, the same bound holds of
/// the part above, if rₖ counts the greatest size of a coordinate, too: new corners round as coordinates do.
Real polygon_irradiance(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal);

}  // namespace rt
