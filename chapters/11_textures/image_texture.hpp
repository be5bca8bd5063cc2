// The colour of an image at a point between its pixels, and beyond its edges.
// A pixel of an image that is used as a texture is called a texel. u runs from the left edge to the right, v
// from the bottom edge to the top; but row 0 of an `Image` is its top row.
// ε is the unit roundoff of `Real`.
#pragma once

#include "common/image/image.hpp"
#include "common/scene/textures.hpp"

#include <cstdint>

namespace rt {

// What is beyond the edges of an image says `Wrap` (common/scene/textures.hpp): the image again, as tiles are
// laid; its mirror image, so that no edge is seen; or the texels at its edge, for ever.
// Images have at least one texel, and finite ones. Coordinates are finite, and may be as large as 1e300.

/// [11.2] Which of the texels 0 … size − 1 of a row or column stands at place i, which may be beyond either
/// end. With three texels a, b, c, the places from −4 to 6 are
///   Repeat  c a b c |a b c| a b c a
///   Mirror  c c b a |a b c| c b a a
///   Clamp   a a a a |a b c| c c c c
/// `size` is at least 1.
int wrapped(std::int64_t i, int size, Wrap wrap);

/// [11.2] The texel in this column, counted from the left, and in this row, counted from the *bottom*; both
/// from 0, and wrapped.
Vec3 texel(const Image& image, std::int64_t column, std::int64_t row, Wrap wrap);

/// A point with the same colour as uv, neither of whose coordinates is greater than 2 in size: nothing that
/// is computed from it overflows a whole number. Without any rounding. Given.
Vec2 near_image(const Vec2& uv, Wrap wrap);

/// [11.2] The colour of the texel in which uv lies. The texel in column i of w lies from u = i/w, included,
/// to (i + 1)/w. Within 4ε(|u| + |v|) of an edge, after `near_image`, rounding decides.
Vec3 nearest(const Image& image, const Vec2& uv, Wrap wrap);

/// [11.2] The colour at uv, bilinear between the centres of the four texels around it: the texel in column i
/// of w has its centre at u = (i + ½)/w. Equal to POV-Ray's `interpolate 2` where the image repeats. Within
/// 16ε(w + h) of the greatest texel's size; never outside of the range of the four texels by more than 8ε of
/// it.
Vec3 bilinear(const Image& image, const Vec2& uv, Wrap wrap);

}  // namespace rt
