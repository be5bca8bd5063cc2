// What `course compare --page` writes: two pictures and their difference, side by side.
#pragma once

#include "common/image/compare.hpp"

#include <string>
#include <string_view>

namespace rt {

/// Share of the pixels of two pictures that must be alike if the pictures are to be the same. At the rest, on
/// a silhouette or a shadow's edge, two right programs may see different things.
inline constexpr Real same_share = 0.999;

/// A power of two that makes the difference of two images visible, at least 1.
Real visible_gain(const Comparison& comparison);

/// Both pictures and their difference, embedded in the page, and the figures of `comparison`.
std::string comparison_page(const Image& image, const Image& reference, const Comparison& comparison,
                            std::string_view image_name, std::string_view reference_name);

}  // namespace rt
