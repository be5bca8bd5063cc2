// What is seen in a direction: skies of one colour, of three, and of pictures of all directions.
// ε is the unit roundoff of `Real`. y is up.
#pragma once

#include "common/scene/sky.hpp"

#include <optional>

namespace rt {

/// [11.4] Where a picture of this layout shows the direction (x, y, z): u from 0 at the left to 1 at the
/// right, v from 0 at the bottom to 1 at the top. The direction may have any length but 0.
///
/// LatitudeLongitude: u is the longitude, which grows from x towards z, as a share of the full turn, and v is
/// ½ + latitude/π; as POV-Ray's map_type 1. Straight up and down any u in [0, 1] will do. Elsewhere u = 0 and
/// u = 1 are the same, and either will do.
///
/// The two others are discs that touch the picture's edges. If the disc has radius 1, the place is r away
/// from its middle, towards (x, y), which are right and up. The one direction that is shown all around the
/// rim has the place (1, ½).
///
/// MirrorBall: a ball seen from far away on +z (Debevec 1998). The middle shows +z, and r is the sine of half
/// the angle from there.
///
/// Angular: the middle shows −z, and r is the angle from there in half turns (Debevec 1998).
///
/// Within 16ε of the exact place, whatever the angle; at the six axis directions within ε. Never NaN.
Vec2 sky_uv(SkyMap map, const Vec3& direction);

/// [11.5] The unit direction that a picture of this layout shows at uv, which is in [0, 1]²; nothing outside
/// of the disc of a MirrorBall or Angular map. Its rim belongs to it; within 4ε of the rim either answer will
/// do. Each coordinate is within 8ε of the direction of a place at most 16ε away from uv, and the length is 1
/// within 8ε. Never NaN.
std::optional<Vec3> sky_direction(SkyMap map, const Vec2& uv);

/// [11.4] The colour of the gradient in a direction of any length but 0. With y for the direction's height at
/// length 1, it is horizon + (zenith − horizon)·y above the horizon, and horizon + (nadir − horizon)·(−y)
/// below. Within 8ε of the greatest of the colours' sizes.
Vec3 gradient_color(const GradientSky& sky, const Vec3& direction);

/// The direction in which to look into a sky's picture that was turned about y, counterclockwise as seen from
/// above: so the direction is turned clockwise. A quarter turn moves what was seen at x to −z. Neither x nor
/// z is −0. Given.
Vec3 turned(const Vec3& direction, const Turn& turn);

/// The picture's light at uv, as `bilinear` has it. Beyond the middles of the top and bottom rows it stays
/// the same; beyond those of the outer columns it goes on at the other side if `around`, and else stays the
/// same. A uv outside of [0, 1]² or NaN is brought inside. Given.
Vec3 sky_texel(const Image& image, const Vec2& uv, bool around);

/// The light of the sky from a direction of any length but 0. Pictures go around from the right edge to the
/// left if they are LatitudeLongitude. Given.
Vec3 sky_radiance(const Sky& sky, const Vec3& direction);

}  // namespace rt
