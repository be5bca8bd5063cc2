// How different two pictures look to somebody who flips between them (Andersson et al. 2020).
#pragma once

#include "common/image/compare.hpp"
#include "common/image/convolution.hpp"

namespace rt {

/// How many pixels a degree of the field of view has for who sits 0.7 m before a monitor that is 0.7 m and
/// 3840 pixels wide: about 67.
inline constexpr Real usual_pixels_per_degree = 3840 * pi / 180;

/// The difference that is seen at each pixel, from 0 to 1: LDR-FLIP, a difference evaluator for alternating
/// images (Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström & Fairchild 2020). It compares colours after
/// a filter for what the eye resolves at this distance, and raises their difference where one picture has an
/// edge or a point that the other has not. Zero where nothing differs near; symmetric. Values are clamped to
/// what a display shows, NaN to 0. Throws InputError, naming both sizes, if the sizes differ.
Channel flip(const Image& image, const Image& reference, const Display& display = {},
             Real pixels_per_degree = usual_pixels_per_degree);

/// The mean of all values: by which the authors of FLIP sum it up.
Real mean(const Channel& channel);

}  // namespace rt
