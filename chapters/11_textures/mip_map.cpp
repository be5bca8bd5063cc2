// An image in all sizes, so that one lookup is the mean of many texels (Williams, Pyramidal Parametrics,
// 1983).
#include "chapters/11_textures/mip_map.hpp"

#include "chapters/11_textures/image_texture.hpp"

#include "common/math/todo.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rt {

std::array<Real, 3> halving_weights(int i, int size) {
    // 11.3  Return the three weights; for a size of 1, for an even one, and for an odd one.
    return todo("11.3");
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
    // 11.3  Add to map.levels, which has the image itself, the smaller ones, down to a single
    // texel.
    return todo("11.3");
    return map;
}

Vec3 trilinear(const MipMap& map, const Vec2& uv, Real width, Wrap wrap) {
    // 11.3  Return the mean colour of the part of the image around uv that is `width` wide, as the
    // pyramid knows it.
    return todo("11.3");
}

}  // namespace rt
