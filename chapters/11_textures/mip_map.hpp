// An image in all sizes, so that one lookup is the mean of many texels (Williams, Pyramidal Parametrics,
// 1983).
#pragma once

#include "common/image/image.hpp"
#include "common/scene/textures.hpp"

#include <array>

namespace rt {

// Such a pyramid is a `MipMap` (common/scene/textures.hpp): each of its levels is the one before it,
// `halved`, and the last one is a single texel.

/// [11.3] The weights of texels 2i, 2i + 1 and 2i + 2 of a row of `size` in texel i of the halved row, which
/// has m = ⌊size/2⌋ texels, or 1 if `size` is 1. They add up to 1.
///
/// Texel i of the halved row covers what its m-th part of the row covers: where the size is even that is two
/// whole texels, and the weights are ½, ½ and 0. Where it is odd, size = 2m + 1, it is two and an m-th, and
/// the weights are (m − i)/size, m/size and (i + 1)/size. So each texel counts for as much as every other one
/// in all (Guthe & Heckbert, Non-Power-of-Two Mipmapping, 2005). A single texel stays: 1, 0, 0.
std::array<Real, 3> halving_weights(int i, int size);

/// The image at half its width and half its height, rounded down, but at least 1: each texel is the mean of
/// what it covers. The mean of all texels is the image's. Given.
Image halved(const Image& image);

/// [11.3] The image, its half, the half of that, and so on down to a single texel: 1 + ⌊log₂ max(width,
/// height)⌋ levels.
MipMap mip_map(Image image);

/// [11.3] The mean colour, as well as a pyramid of halves knows it, of the part of the image around uv that
/// is `width` wide, in units of uv: the whole image is 1 wide. `width` is not negative; 0 asks for a point,
/// infinity for the mean of all.
///
/// That is at level log₂(width·max(width, height) of the image), kept between the first level and the last:
/// `bilinear` of the two levels around it, mixed by what is between. So a width of one texel or less is
/// `bilinear` of the image; one of two texels is that of level 1; one of three, 0.585 of the way to level 2.
/// The answer is continuous in uv and in the width; between two levels it goes straight from the one to the
/// other.
///
/// It is right where the image has one colour. Where the colour grows evenly it is right, too, if the image's
/// sides are powers of two, and the texels around uv of the coarser level are not beyond its edges; for other
/// sides it is off by no more than what the colour grows in 1/16 of a texel of the coarser level, along
/// either side. Rounding adds gamma(16·(width + height of the image)) of the greatest texel.
Vec3 trilinear(const MipMap& map, const Vec2& uv, Real width, Wrap wrap);

}  // namespace rt
