// The sun of a sky's picture as a lamp: a challenge, which nothing else needs.
// ε is the unit roundoff of `Real`.
#pragma once

#include "common/image/image.hpp"
#include "common/math/vec.hpp"

namespace rt {

/// A sky without its sun, and the sun as a `directional` lamp.
struct SkyAndSun {
    Image sky;
    Vec3 to_sun{0, 1, 0};  ///< unit
    Vec3 light{0};         ///< as a scene says it: what a white surface that faces the lamp shows
};

/// [11.23] Takes out of a picture in SkyMap::LatitudeLongitude what its pixels have above `most`, channel by
/// channel; the sky that is left has no more than that anywhere, up to rounding. What is taken, summed up
/// over the pixels times their solid angles (as in 11.6) and divided by π, is the lamp's light. The direction
/// to it is the mean of the directions in the middles of the pixels, each weighed by what is taken there, the
/// channels together, times the pixel's solid angle; made unit. Where nothing is above `most`, the light is 0
/// and the direction (0, 1, 0).
///
/// `most` is not negative. For n pixels the light is within (n + 32)u of what it would be without rounding;
/// the direction is, where the weighed directions' sum is at least half as long as the sum of the weights.
SkyAndSun without_sun(const Image& picture, Real most);

}  // namespace rt
