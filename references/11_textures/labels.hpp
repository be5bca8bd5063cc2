// Words in pictures: a white band below each, with what it shows.
#pragma once

#include "common/image/image.hpp"

#include <stb/stb_easy_font.h>

#include <cstring>
#include <string>
#include <vector>

namespace rt::figures {

/// Dark words on the picture, with their middle at column `middle` and their top at row `top`. Plain ASCII;
/// letters are two pixels wide where they are one dot.
inline void write_words(Image& image, int middle, int top, std::string words) {
    struct Corner {
        float x, y, z;
        unsigned char color[4];
    };
    std::vector<char> buffer(words.size() * 512 + 512);
    const int quads =
        stb_easy_font_print(0, 0, words.data(), nullptr, buffer.data(), static_cast<int>(buffer.size()));
    const int left = middle - stb_easy_font_width(words.data());
    for (int i = 0; i < quads; ++i) {
        Corner low, high;
        const char* quad = buffer.data() + static_cast<std::size_t>(i) * 4 * sizeof(Corner);
        std::memcpy(&low, quad, sizeof low);
        std::memcpy(&high, quad + 2 * sizeof high, sizeof high);
        for (int y = top + 2 * static_cast<int>(low.y); y < top + 2 * static_cast<int>(high.y); ++y)
            for (int x = left + 2 * static_cast<int>(low.x); x < left + 2 * static_cast<int>(high.x); ++x)
                if (x >= 0 && x < image.width && y >= 0 && y < image.height) pixel(image, x, y) = Vec3(0.02);
    }
}

/// The picture with a white band below it, for words.
inline Image with_band(const Image& image) {
    Image all = make_image(image.width, image.height + 24);
    for (Vec3& p : all.pixels) p = Vec3(1);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) pixel(all, x, y) = pixel(image, x, y);
    return all;
}

/// Pictures, and below each what it shows.
inline std::vector<Image> with_words(const std::vector<Image>& images,
                                     const std::vector<std::string>& words) {
    std::vector<Image> all;
    for (std::size_t i = 0; i < images.size(); ++i) {
        all.push_back(with_band(images[i]));
        write_words(all.back(), images[i].width / 2, images[i].height + 4, words[i]);
    }
    return all;
}

}  // namespace rt::figures
