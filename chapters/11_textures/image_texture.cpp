// The colour of an image at a point between its pixels, and beyond its edges.
#include "chapters/11_textures/image_texture.hpp"

#include "common/math/todo.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace rt {

int wrapped(std::int64_t i, int size, Wrap wrap) {
    // 11.2  Return the texel that stands at place i, as the three rows in image_texture.hpp show. i
    // may be negative.
    return todo("11.2");
}

Vec3 texel(const Image& image, std::int64_t column, std::int64_t row, Wrap wrap) {
    // 11.2  Return the pixel in this column and this row. `row` counts from the bottom.
    return todo("11.2");
}

Vec2 near_image(const Vec2& uv, Wrap wrap) {
    if (wrap == Wrap::Clamp) return clamp(uv, Vec2(-1), Vec2(2));
    if (std::abs(uv.x) < 2 && std::abs(uv.y) < 2) return uv;
    // Whether the image repeats or is mirrored, 2 is a period of it. fmod does not round.
    return {std::fmod(uv.x, 2), std::fmod(uv.y, 2)};
}

Vec3 nearest(const Image& image, const Vec2& uv, Wrap wrap) {
    [[maybe_unused]] const Vec2 near = near_image(uv, wrap);
    // 11.2  Return the texel in which `near` lies, on either side of 0.
    return todo("11.2");
}

Vec3 bilinear(const Image& image, const Vec2& uv, Wrap wrap) {
    [[maybe_unused]] const Vec2 near = near_image(uv, wrap);
    // 11.2  Return the mixture of the four texels whose centres are around `near`.
    return todo("11.2");
}

}  // namespace rt
