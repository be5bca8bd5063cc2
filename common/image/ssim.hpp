// How alike the structure of two pictures is (Wang et al. 2004).
#pragma once

#include "common/image/compare.hpp"

#include <optional>

namespace rt {

/// The mean structural similarity (SSIM) of the pictures' brightness as a display shows it: 1 for equal ones,
/// less for others (Wang, Bovik, Sheikh & Simoncelli 2004; Gaussian windows of 11 × 11 pixels with a standard
/// deviation of 1.5, K1 = 0.01, K2 = 0.03). Nothing where no window fits into the picture. Throws InputError,
/// naming both sizes, if the sizes differ.
std::optional<Real> ssim(const Image& image, const Image& reference, const Display& display = {});

}  // namespace rt
