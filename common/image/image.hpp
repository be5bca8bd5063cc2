// A picture in memory: linear RGB, row 0 at the top.
#pragma once

#include "common/math/vec.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace rt {

/// width × height pixels of linear RGB, row by row from the top left.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<Vec3> pixels;
};

/// A black image of width × height pixels; both at least 1.
inline Image make_image(int width, int height) {
    return {width, height,
            std::vector<Vec3>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Vec3(0))};
}

/// The pixel in column x and row y; both must be inside.
inline Vec3& pixel(Image& image, int x, int y) {
    return image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(x)];
}
inline const Vec3& pixel(const Image& image, int x, int y) {
    return image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(x)];
}

/// `linear` limited to what a display can show, [0, 1]; NaN becomes 0.
inline Real displayable(Real linear) { return linear > 0 ? std::min(linear, Real(1)) : Real(0); }

/// How numbers in an 8-bit file stand for light: as they are, or by the sRGB transfer curve
/// (IEC 61966-2-1).
enum class Encoding { Linear, Srgb };

}  // namespace rt
