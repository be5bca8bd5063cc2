// The colour of an image at a point between its pixels, and beyond its edges.
#include "chapters/11_textures/image_texture.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace rt {

int wrapped(std::int64_t i, int size, Wrap wrap) {
    // [exercise 11.2] Return the texel that stands at place i, as the three rows in image_texture.hpp show. i
    // may be negative.
    if (0 <= i && i < size) return static_cast<int>(i);  // as a rule; the remainders take long
    if (wrap == Wrap::Clamp) return static_cast<int>(std::clamp<std::int64_t>(i, 0, size - 1));
    // The mirrored row is a row of twice as many that repeats.
    const std::int64_t period = wrap == Wrap::Mirror ? 2 * std::int64_t{size} : size;
    const std::int64_t left = (i % period + period) % period;
    return static_cast<int>(left < size ? left : period - 1 - left);
    // [/exercise]
}

Vec3 texel(const Image& image, std::int64_t column, std::int64_t row, Wrap wrap) {
    // [exercise 11.2] Return the pixel in this column and this row. `row` counts from the bottom.
    const int x = wrapped(column, image.width, wrap), y = wrapped(row, image.height, wrap);
    return pixel(image, x, image.height - 1 - y);
    // [/exercise]
}

Vec2 near_image(const Vec2& uv, Wrap wrap) {
    if (wrap == Wrap::Clamp) return clamp(uv, Vec2(-1), Vec2(2));
    if (std::abs(uv.x) < 2 && std::abs(uv.y) < 2) return uv;
    // Whether the image repeats or is mirrored, 2 is a period of it. fmod does not round.
    return {std::fmod(uv.x, 2), std::fmod(uv.y, 2)};
}

Vec3 nearest(const Image& image, const Vec2& uv, Wrap wrap) {
    [[maybe_unused]] const Vec2 near = near_image(uv, wrap);
    // [exercise 11.2] Return the texel in which `near` lies, on either side of 0.
    const Real column = std::floor(near.x * image.width), row = std::floor(near.y * image.height);
    return texel(image, static_cast<std::int64_t>(column), static_cast<std::int64_t>(row), wrap);
    // [/exercise]
}

Vec3 bilinear(const Image& image, const Vec2& uv, Wrap wrap) {
    [[maybe_unused]] const Vec2 near = near_image(uv, wrap);
    // [exercise 11.2] Return the mixture of the four texels whose centres are around `near`.
    const Vec2 at = near * Vec2(image.width, image.height) - 0.5, whole = floor(at), rest = at - whole;
    const auto i = static_cast<std::int64_t>(whole.x), j = static_cast<std::int64_t>(whole.y);
    const Vec3 low = glm::mix(texel(image, i, j, wrap), texel(image, i + 1, j, wrap), rest.x);
    const Vec3 high = glm::mix(texel(image, i, j + 1, wrap), texel(image, i + 1, j + 1, wrap), rest.x);
    return glm::mix(low, high, rest.y);
    // [/exercise]
}

}  // namespace rt
