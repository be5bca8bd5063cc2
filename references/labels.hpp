// Words within pictures made of pixels, so that a picture says what it shows wherever it is looked at.
#pragma once

#include "references/figures.hpp"

#include <stb/stb_easy_font.h>

#include <cstring>

namespace rt::figures {

/// The picture with words in its upper left corner, white on a dark strip. `words` is plain ASCII; its
/// letters are seven pixels high, times `size`.
inline Image labelled(Image image, std::string words, int size = 2) {
    struct Corner {
        float x, y, z;
        unsigned char color[4];
    };
    std::vector<char> buffer(words.size() * 512 + 512);
    const int quads =
        stb_easy_font_print(0, 0, words.data(), nullptr, buffer.data(), static_cast<int>(buffer.size()));
    const int margin = 3 * size, width = size * stb_easy_font_width(words.data()) + 2 * margin;
    const auto at = [&](int x, int y) -> Vec3* {
        return x < image.width && y < image.height ? &pixel(image, x, y) : nullptr;
    };
    for (int y = 0; y < 9 * size + margin; ++y)
        for (int x = 0; x < width; ++x)
            if (Vec3* p = at(x, y)) *p = Vec3(0.015);
    for (int i = 0; i < quads; ++i) {
        Corner low, high;
        const char* quad = buffer.data() + static_cast<std::size_t>(i) * 4 * sizeof(Corner);
        std::memcpy(&low, quad, sizeof low);
        std::memcpy(&high, quad + 2 * sizeof high, sizeof high);
        for (int y = size * static_cast<int>(low.y); y < size * static_cast<int>(high.y); ++y)
            for (int x = size * static_cast<int>(low.x); x < size * static_cast<int>(high.x); ++x)
                if (Vec3* p = at(margin + x, margin + y)) *p = Vec3(1);
    }
    return image;
}

/// Pictures as a file has them, encoded already: where pictures of different encodings stand side by side.
inline Image as_displayed(Image image, Encoding encoding) {
    for (Vec3& p : image.pixels)
        for (int i = 0; i < 3; ++i) p[i] = encode(p[i], encoding);
    return image;
}

}  // namespace rt::figures
