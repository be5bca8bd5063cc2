// A picture in a true-colour terminal, two pixels a character.

#include "common/image/in_terminal.hpp"

#include "common/image/file.hpp"

#include <algorithm>
#include <cstdint>

namespace rt {
namespace {

/// Size that fits into width × height, with the image's aspect; never larger than the image.
Image fitting_canvas(const Image& image, std::int64_t width, std::int64_t height) {
    const std::int64_t w = image.width, h = image.height;
    const auto rounded = [](std::int64_t a, std::int64_t b) {
        return std::max<std::int64_t>(1, (2 * a + b) / (2 * b));
    };
    if (w <= width && h <= height) {
        width = w;
        height = h;
    } else if (w * height >= h * width) {
        height = rounded(h * width, w);
    } else {
        width = rounded(w * height, h);
    }
    return make_image(static_cast<int>(width), static_cast<int>(height));
}

/// Length shared by pixel i of n and pixel s of m that cover the same interval, in units of 1/(n·m) of it.
/// Whole numbers keep the weights exact; over s they add up to m.
std::int64_t overlap(std::int64_t i, std::int64_t n, std::int64_t s, std::int64_t m) {
    return std::min((i + 1) * m, (s + 1) * n) - std::max(i * m, s * n);
}

/// Each pixel becomes the mean of the part of the image that it covers.
Image shrink(const Image& image, Image canvas) {
    const std::int64_t w = canvas.width, h = canvas.height, W = image.width, H = image.height;
    for (std::int64_t y = 0; y < h; ++y)
        for (std::int64_t x = 0; x < w; ++x) {
            Vec3 sum(0);
            for (std::int64_t t = y * H / h; t * h < (y + 1) * H; ++t)
                for (std::int64_t s = x * W / w; s * w < (x + 1) * W; ++s) {
                    const Vec3& p = pixel(image, static_cast<int>(s), static_cast<int>(t));
                    sum += static_cast<Real>(overlap(x, w, s, W) * overlap(y, h, t, H)) *
                           Vec3(displayable(p.x), displayable(p.y), displayable(p.z));
                }
            pixel(canvas, static_cast<int>(x), static_cast<int>(y)) = sum / static_cast<Real>(W * H);
        }
    return canvas;
}

std::string colour(const Vec3& linear, Encoding encoding) {
    return "2;" + std::to_string(encode_byte(linear.x, encoding)) + ";" +
           std::to_string(encode_byte(linear.y, encoding)) + ";" +
           std::to_string(encode_byte(linear.z, encoding));
}

}  // namespace

std::string preview(const Image& image, Encoding encoding, int columns, int rows) {
    const Image small =
        shrink(image, fitting_canvas(image, std::max(columns, 1), 2 * std::max<std::int64_t>(rows, 1)));
    std::string text;
    for (int y = 0; y < small.height; y += 2) {
        std::string current;
        for (int x = 0; x < small.width; ++x) {
            const std::string lower =
                y + 1 < small.height ? "48;" + colour(pixel(small, x, y + 1), encoding) : "49";
            const std::string wanted = "\x1b[38;" + colour(pixel(small, x, y), encoding) + ";" + lower + "m";
            if (wanted != current) text += current = wanted;
            text += "\u2580";
        }
        text += "\x1b[0m\n";
    }
    return text;
}

}  // namespace rt
