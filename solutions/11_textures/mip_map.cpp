// An image in all sizes, so that one lookup is the mean of many texels (Williams, Pyramidal Parametrics,
// 1983).
#include "chapters/11_textures/mip_map.hpp"

#include "chapters/11_textures/image_texture.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rt {

std::array<Real, 3> halving_weights(int i, int size) {
    // [exercise 11.3] Return the three weights; for a size of 1, for an even one, and for an odd one.
    if (size == 1) return {1, 0, 0};
    if (size % 2 == 0) return {0.5, 0.5, 0};
    // Texel i of m begins at i·(2 + 1/m), which is i/m beyond the beginning of texel 2i.
    const Real m = size / 2, n = size;
    return {(m - i) / n, m / n, (i + 1) / n};
    // [/exercise]
}

Image halved(const Image& image) {
    const auto half = [](int size) { return std::max(1, size / 2); };
    Image small = make_image(half(image.width), half(image.height));
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            const std::array<Real, 3> across = halving_weights(x, image.width);
            const std::array<Real, 3> down = halving_weights(y, image.height);
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i) {
                    const Real weight =
                        across[static_cast<std::size_t>(i)] * down[static_cast<std::size_t>(j)];
                    // What has no weight may not be there.
                    if (weight > 0) pixel(small, x, y) += weight * pixel(image, 2 * x + i, 2 * y + j);
                }
        }
    return small;
}

MipMap mip_map(Image image) {
    MipMap map{{std::move(image)}};
    // [exercise 11.3] Add to map.levels, which has the image itself, the smaller ones, down to a single
    // texel.
    while (map.levels.back().width > 1 || map.levels.back().height > 1)
        map.levels.push_back(halved(map.levels.back()));
    // [/exercise]
    return map;
}

Vec3 trilinear(const MipMap& map, const Vec2& uv, Real width, Wrap wrap) {
    // [exercise 11.3] Return the mean colour of the part of the image around uv that is `width` wide, as the
    // pyramid knows it.
    const Image& image = map.levels.front();
    const Real last = static_cast<Real>(map.levels.size() - 1);
    const Real level = std::clamp(std::log2(width * std::max(image.width, image.height)), Real(0), last);
    const auto finer = static_cast<std::size_t>(level);
    const Vec3 fine = bilinear(map.levels[finer], uv, wrap);
    const Real rest = level - std::floor(level);
    // Of a whole level the next one is not asked: the last has none.
    return rest == 0 ? fine : glm::mix(fine, bilinear(map.levels[finer + 1], uv, wrap), rest);
    // [/exercise]
}

}  // namespace rt
