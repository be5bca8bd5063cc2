// Directions to a light that is a rectangle, evenly by solid angle.
#pragma once

#include "chapters/12_distribution/light_direction.hpp"
#include "chapters/12_distribution/triangle_light.hpp"
#include "common/math/vec.hpp"
#include "common/scene/area_lights.hpp"

#include <array>
#include <optional>

namespace rt {

/// The two triangles into which the diagonal from `corner` divides the light, as they are seen from `from`,
/// so that they are bright where the light is. Given.
std::array<SeenTriangle, 2> halves(const QuadLight& light, const Vec3& from);

/// [12.13] The solid angle that the light fills: positive, up to 2π, from its bright side, and negative from
/// its dark side. As right as 12.12 promises of its two halves, of which no digits are lost in the sum, with
/// one reserve: three of the corners are sums, rounded in proportion to the greatest distance D of a corner.
/// So D takes the place of the nearest corner's distance in n, and p grows by the quotient of the two.
Real solid_angle(const QuadLight& light, const Vec3& from);

/// A direction to one of the light's halves, which is chosen by its part of the solid angle with the help of
/// random.x: what this number says besides is used again. Uniform in the solid angle. Nothing where that is
/// not positive. Given.
std::optional<LightDirection> toward_a_half(const QuadLight& light, const Vec3& from, const Vec2& random);

/// [12.13] A direction to the light for `random`, a point of [0, 1)²: uniform in the solid angle, so that the
/// pdf is 1/solid_angle for all. Which numbers give which direction is left open. Nothing where solid_angle
/// is not positive, or where rounding lets the chosen point be where the viewer is.
///
/// For a rectangle (Ureña, Fajardo & King, An Area-Preserving Parametrization for Spherical Rectangles, 2013)
/// strata of the square stay in one piece. A parallelogram whose sides are perpendicular to no better than
/// 2^-40, and a rectangle that fills less than 2^-20 steradians, are looked at as two halves: in the closed
/// formula so small a difference of large angles would have lost too many of its digits.
///
/// The direction is unit to gamma(16), the distance that to the light's plane; the point there is on the
/// light up to gamma(64) of the greatest distance of a corner. Never NaN.
std::optional<LightDirection> toward(const QuadLight& light, const Vec3& from, const Vec2& random);

}  // namespace rt
