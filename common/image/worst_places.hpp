// Where two pictures differ most.
#pragma once

#include "common/image/image.hpp"

#include <cstddef>
#include <vector>

namespace rt {

/// A pixel and the greatest difference of its channels, as `compare` measures it.
struct DifferingPixel {
    int x = 0;
    int y = 0;
    Real difference = 0;
};

/// The pixels that differ most, at most so many: the greatest difference first, of equal ones the first from
/// the top left. Throws InputError if the sizes differ.
std::vector<DifferingPixel> differing_pixels(const Image& image, const Image& reference, std::size_t most);

/// Of such pixels those that no earlier one is near, at most so many; near is less than `apart` pixels off
/// across and down.
std::vector<DifferingPixel> worst_places(const std::vector<DifferingPixel>& pixels, std::size_t most,
                                         int apart);

}  // namespace rt
