// What `course compare --page` writes: two pictures under a slider, where and how they differ, and on a click
// the rays of a pixel.
#pragma once

#include "common/image/compare.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// The rays of one pixel: by the student's code and by the solutions, of which one may be missing.
struct PixelRays {
    int x = 0;
    int y = 0;
    std::string mine;    ///< as `tree_text`
    std::string theirs;  ///< the same
    std::string
        difference;  ///< the first quantity in which they differ, as a sentence; empty if there is none
};

/// What a page knows beyond its two pictures.
struct PageExtras {
    Display display = {};
    std::string scene = {};            ///< file of the pictures' scene; empty if it is not known
    std::vector<PixelRays> rays = {};  ///< of some pixels of that scene
    std::string without_mine = {};     ///< why there are no rays of the student's code
};

/// The pixels whose rays a page of these pictures tells: those that differ most, then some all over the
/// picture.
std::vector<PixelRays> pixels_to_trace(const Image& image, const Image& reference);

/// The page: nothing in it is loaded from elsewhere.
std::string comparison_page(const Image& image, const Image& reference, const Comparison& comparison,
                            std::string_view image_name, std::string_view reference_name,
                            const PageExtras& extras = {});

}  // namespace rt
