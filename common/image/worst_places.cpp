// Where two pictures differ most.
#include "common/image/worst_places.hpp"

#include "common/image/compare.hpp"

#include <algorithm>
#include <cstdlib>

namespace rt {

std::vector<DifferingPixel> differing_pixels(const Image& image, const Image& reference, std::size_t most) {
    const Image differences = difference(image, reference);
    std::vector<DifferingPixel> pixels;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (const Real greatest = max_component(pixel(differences, x, y)); greatest > 0)
                pixels.push_back({x, y, greatest});
    std::ranges::stable_sort(pixels, std::ranges::greater(), &DifferingPixel::difference);
    pixels.resize(std::min(pixels.size(), most));
    return pixels;
}

std::vector<DifferingPixel> worst_places(const std::vector<DifferingPixel>& pixels, std::size_t most,
                                         int apart) {
    std::vector<DifferingPixel> places;
    for (const DifferingPixel& pixel : pixels) {
        if (places.size() == most) break;
        const bool is_near = std::ranges::any_of(places, [&](const DifferingPixel& place) {
            return std::abs(place.x - pixel.x) < apart && std::abs(place.y - pixel.y) < apart;
        });
        if (!is_near) places.push_back(pixel);
    }
    return places;
}

}  // namespace rt
