// What `course compare --page` writes: two pictures and their difference, side by side.
#pragma once

#include "common/image/compare.hpp"

#include <string>
#include <string_view>

namespace rt {

/// Both pictures and their difference, embedded in the page, and the figures of `comparison`.
std::string comparison_page(const Image& image, const Image& reference, const Comparison& comparison,
                            std::string_view image_name, std::string_view reference_name);

}  // namespace rt
