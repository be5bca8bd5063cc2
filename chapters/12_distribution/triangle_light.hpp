// Directions to a light that is a triangle, evenly by solid angle.
#pragma once

#include "chapters/12_distribution/light_direction.hpp"
#include "common/math/vec.hpp"
#include "common/scene/area_lights.hpp"

#include <optional>

namespace rt {

/// A triangle as it is seen: its corners as they are from the viewer, who is at 0. The sides are kept beside
/// them, because in b − a a small triangle that is far away would have lost its digits.
struct SeenTriangle {
    Vec3 a{0};
    Vec3 b{0};
    Vec3 c{0};
    Vec3 ab{0};
    Vec3 ac{0};
};

/// The light as it is seen from `from`. Given.
inline SeenTriangle seen(const TriangleLight& light, const Vec3& from) {
    return {light.a - from, light.b - from, light.c - from, light.b - light.a, light.c - light.a};
}

/// [12.12] The solid angle that the triangle fills (Van Oosterom & Strackee, The Solid Angle of a Plane
/// Triangle, 1983): from 0 to 2π if its corners run counterclockwise as the viewer sees them, which is its
/// bright side, and from −2π to 0 if they run clockwise. 0 from its plane beside it.
///
/// Right to gamma(64)·(n·|x| + p·|y|)/(x² + y²), where y/x is the formula's fraction, the tangent of half the
/// answer, p is |a|·|b|·|c|, and n the distance of the nearest corner times the two longest sides. As a part
/// of the answer that is some u for a small triangle far away, if it is seen from the front. It is more for
/// slivers, next to an edge, and where the viewer is almost in the triangle's plane: by the quotient of his
/// distances from the nearest corner and from the plane. Where rounding may change x or y by half of what
/// they are, on an edge or on the triangle itself, any answer from −2π to 2π is right. Never NaN.
Real solid_angle(const SeenTriangle& triangle);
/// The same of a light. Given.
Real solid_angle(const TriangleLight& light, const Vec3& from);

/// [12.12] A direction to the triangle for `random`, a point of [0, 1)²: uniform in the solid angle (Arvo,
/// Stratified Sampling of Spherical Triangles, 1995), so that the pdf is 1/solid_angle for all. Which numbers
/// give which direction is left open. Nothing where solid_angle is not positive, or if rounding lets the
/// chosen point be where the viewer is, who is then at a corner or on the triangle.
///
/// The direction is unit to gamma(16), the distance that to the triangle's plane; the point there is in the
/// triangle up to gamma(64) of the greatest distance of a corner. Where solid_angle is right to a part k of
/// itself, the directions are as dense as the pdf says to some k. Never NaN.
std::optional<LightDirection> toward(const SeenTriangle& triangle, const Vec2& random);
/// The same of a light. Given.
std::optional<LightDirection> toward(const TriangleLight& light, const Vec3& from, const Vec2& random);

}  // namespace rt
