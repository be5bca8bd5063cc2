// Words in pictures: a band below each, with letters of 5 by 7 dots that are two pixels wide.
#pragma once

#include "common/image/image.hpp"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace rt::figures {

/// A letter by its five columns; the lowest bit is the topmost dot.
struct Letter {
    char sign;
    std::array<std::uint8_t, 5> columns;
};
inline constexpr Letter letters[] = {
    {'0', {0x3E, 0x51, 0x49, 0x45, 0x3E}}, {'1', {0x00, 0x42, 0x7F, 0x40, 0x00}},
    {'2', {0x42, 0x61, 0x51, 0x49, 0x46}}, {'3', {0x21, 0x41, 0x45, 0x4B, 0x31}},
    {'4', {0x18, 0x14, 0x12, 0x7F, 0x10}}, {'5', {0x27, 0x45, 0x45, 0x45, 0x39}},
    {'6', {0x3C, 0x4A, 0x49, 0x49, 0x30}}, {'7', {0x01, 0x71, 0x09, 0x05, 0x03}},
    {'8', {0x36, 0x49, 0x49, 0x49, 0x36}}, {'9', {0x06, 0x49, 0x49, 0x29, 0x1E}},
    {'.', {0x00, 0x60, 0x60, 0x00, 0x00}}, {',', {0x00, 0x50, 0x30, 0x00, 0x00}},
    {':', {0x00, 0x36, 0x36, 0x00, 0x00}}, {'F', {0x7F, 0x09, 0x09, 0x09, 0x01}},
    {'a', {0x20, 0x54, 0x54, 0x54, 0x78}}, {'b', {0x7F, 0x48, 0x44, 0x44, 0x38}},
    {'c', {0x38, 0x44, 0x44, 0x44, 0x20}}, {'d', {0x38, 0x44, 0x44, 0x48, 0x7F}},
    {'e', {0x38, 0x54, 0x54, 0x54, 0x18}}, {'f', {0x08, 0x7E, 0x09, 0x01, 0x02}},
    {'g', {0x0C, 0x52, 0x52, 0x52, 0x3E}}, {'h', {0x7F, 0x08, 0x04, 0x04, 0x78}},
    {'i', {0x00, 0x44, 0x7D, 0x40, 0x00}}, {'k', {0x7F, 0x10, 0x28, 0x44, 0x00}},
    {'l', {0x00, 0x41, 0x7F, 0x40, 0x00}}, {'m', {0x7C, 0x04, 0x18, 0x04, 0x78}},
    {'n', {0x7C, 0x08, 0x04, 0x04, 0x78}}, {'o', {0x38, 0x44, 0x44, 0x44, 0x38}},
    {'p', {0x7C, 0x14, 0x14, 0x14, 0x08}}, {'r', {0x7C, 0x08, 0x04, 0x04, 0x08}},
    {'s', {0x48, 0x54, 0x54, 0x54, 0x20}}, {'t', {0x04, 0x3F, 0x44, 0x40, 0x20}},
    {'u', {0x3C, 0x40, 0x40, 0x20, 0x7C}}, {'v', {0x1C, 0x20, 0x40, 0x20, 0x1C}},
    {'w', {0x3C, 0x40, 0x30, 0x40, 0x3C}}, {'x', {0x44, 0x28, 0x10, 0x28, 0x44}},
    {'y', {0x0C, 0x50, 0x50, 0x50, 0x3C}}, {'z', {0x44, 0x64, 0x54, 0x4C, 0x44}}};

/// Dark words on the picture, their middle at column `middle`, their top at row `top`. Signs that are not in
/// the table are blanks.
inline void write_words(Image& image, int middle, int top, std::string_view words) {
    const int left = middle - 6 * static_cast<int>(words.size()) + 1;
    const auto dot = [&](int x, int y) {
        for (const int i : {0, 1})
            for (const int j : {0, 1})
                if (x + i >= 0 && x + i < image.width && y + j < image.height)
                    pixel(image, x + i, y + j) = Vec3(0.02);
    };
    int place = left;
    for (const char sign : words) {
        for (const Letter& letter : letters)
            if (letter.sign == sign)
                for (int x = 0; x < 5; ++x)
                    for (int y = 0; y < 7; ++y)
                        if (letter.columns[static_cast<std::size_t>(x)] >> y & 1)
                            dot(place + 2 * x, top + 2 * y);
        place += 12;
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

/// The picture, and below it what it shows.
inline Image labelled(const Image& image, std::string_view words) {
    Image all = with_band(image);
    write_words(all, image.width / 2, image.height + 5, words);
    return all;
}

/// Pictures, each with its words.
inline std::vector<Image> labelled(const std::vector<Image>& images,
                                   const std::vector<std::string_view>& words) {
    std::vector<Image> all;
    for (std::size_t i = 0; i < images.size(); ++i) all.push_back(labelled(images[i], words[i]));
    return all;
}

}  // namespace rt::figures
