// How far apart two images are.
#pragma once

#include "common/image/image.hpp"

#include <array>
#include <string>

namespace rt {

/// What a display shows of two images: their light in this encoding, and where one of them has only 8 bits a
/// channel, both rounded to these, as they would be in files of the same kind.
struct Display {
    Encoding encoding = Encoding::Srgb;
    bool eight_bits = false;
};

/// Differences between two images of one size. `max`, `mean` and `rmse` are over all channels, linear,
/// of values clamped to [0, 1]; `within[n]` is the fraction of pixels whose greatest channel difference,
/// as the display shows it, is at most n/255; `within16[n]` the same in linear steps of 1/65535.
/// A NaN on one side counts as a difference of 1, on both sides as none.
struct Comparison {
    int width = 0;
    int height = 0;
    Real max = 0;
    Real mean = 0;
    Real rmse = 0;
    Real psnr = infinity;  ///< -20 log10(rmse); infinite for equal images
    Real shown_max = 0;    ///< the greatest difference as the display shows it, 1 from black to white
    std::array<Real, 256> within{};
    std::array<Real, 256> within16{};
    int worst_x = 0;  ///< pixel of the greatest linear difference; the first from the top left of several
    int worst_y = 0;
};

/// Share of the pixels of two pictures that must be alike if the pictures are to be the same. At the rest, on
/// a silhouette or a shadow's edge, two right programs may see different things.
inline constexpr Real same_share = 0.999;

/// A share of the pixels as "99.98 %", rounded down: "100 %" is all of them.
std::string percent(Real share);

/// Throws InputError, naming both sizes, if the sizes differ.
void require_same_size(const Image& image, const Image& reference);

/// Compares two images of at least one pixel; throws InputError, naming both sizes, if the sizes differ.
Comparison compare(const Image& image, const Image& reference, const Display& display = {});

/// |image − reference| a pixel and channel, as `compare` measures it, times `gain`, for the eye.
/// Throws InputError if the sizes differ.
Image difference(const Image& image, const Image& reference, Real gain = 1);

/// A power of two that makes the difference of two images visible, at least 1.
Real visible_gain(const Comparison& comparison);

}  // namespace rt
