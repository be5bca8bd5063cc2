// Lights with an extent: points of them that are chosen at random, evenly by area.
// The lesson uses the same letters: A for a light's area, d for the distance to a point of it, θ for the
// angle between the light's normal there and the way to the viewer.
#pragma once

#include "chapters/12_distribution/light_direction.hpp"
#include "common/math/vec.hpp"
#include "common/scene/area_lights.hpp"

#include <optional>

namespace rt {

// The lights are plain data: QuadLight, DiscLight, SphereLight, TriangleLight (common/scene/area_lights.hpp).
// Here they have an area; a light without one sends no light, and a renderer leaves it out. Lengths that are
// not 0 are from 1e-30 to 1e30.

/// A point of a light.
struct LightPoint {
    Vec3 point{0};
    Vec3 normal{0, 0, 1};  ///< unit, on the bright side
    Real pdf = 0;          ///< density with which this point was chosen, per unit of area
};

/// The light's area, right to gamma(16)·κ as a part of it, where κ is 1 for discs and spheres. For a triangle
/// or parallelogram it is the product of the two sides at its first corner divided by twice the triangle's
/// area, or by the parallelogram's: 1 where they are perpendicular, large for slivers. Given.
Real area(const QuadLight& light);
Real area(const DiscLight& light);
Real area(const SphereLight& light);
Real area(const TriangleLight& light);

/// [12.10] A point of the light for `random`, a point of the unit square [0, 1)²; where that is uniform, the
/// light's point is, too, by area: the pdf is 1/A for all. Which numbers give which point is left open.
///
/// The point is on the light up to gamma(32) of the greatest coordinate that the light has. The normal is
/// that of the bright side: −(ab × ac) for a parallelogram, outwards for a sphere, and for a triangle that
/// side from which a, b, c run counterclockwise. Its length is 1 to gamma(16); its direction and the pdf are
/// as right as `area`. For the disc use 12.6's disc_point: strata of the square stay in one piece.
LightPoint point_on(const QuadLight& light, const Vec2& random);
LightPoint point_on(const DiscLight& light, const Vec2& random);
LightPoint point_on(const SphereLight& light, const Vec2& random);
LightPoint point_on(const TriangleLight& light, const Vec2& random);

/// [12.10] The density per steradian, as seen from `from`, with which a direction to this point of a light is
/// chosen, where the point is with its own pdf by area:
///   pdf·d²/cos θ.
/// 0 where the light shows `from` its dark side or its edge (cos θ ≤ 0), and at the point itself. Never NaN.
/// As a part of it right to gamma(32)/cos θ: near the light's plane rounding turns the angle.
Real per_steradian(const LightPoint& point, const Vec3& from);

/// The direction to a point of a light that was chosen by area. Nothing where the light shows `from` its dark
/// side. Given.
std::optional<LightDirection> seen_from(const LightPoint& point, const Vec3& from);

/// A direction to the disc, chosen by area: uniform directions to a disc have no formula as short as those
/// of the next steps. Nothing where the disc shows `from` its dark side. Given.
std::optional<LightDirection> toward(const DiscLight& light, const Vec3& from, const Vec2& random);

}  // namespace rt
