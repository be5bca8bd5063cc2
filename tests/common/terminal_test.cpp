// Pictures in the terminal, character by character.

#include "common/image/in_terminal.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <string>

namespace rt {
namespace {

const std::string block = "\u2580";
const std::string end = "\x1b[0m\n";

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++count;
    return count;
}

TEST_CASE("two pixels, one above the other, are one character") {
    const Image image{2, 2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0.5}}};
    const std::string srgb = "\x1b[38;2;255;0;0;48;2;0;0;255m" + block +  //
                             "\x1b[38;2;0;255;0;48;2;188;188;188m" + block + end;
    CHECK(preview(image, Encoding::Srgb, 2, 1) == srgb);
    CHECK(preview(image, Encoding::Srgb, 80, 24) == srgb);
    const std::string linear = "\x1b[38;2;255;0;0;48;2;0;0;255m" + block +  //
                               "\x1b[38;2;0;255;0;48;2;128;128;128m" + block + end;
    CHECK(preview(image, Encoding::Linear, 2, 1) == linear);
}

TEST_CASE("a colour is said once for neighbours that share it, and anew on each line") {
    const std::string line = "\x1b[38;2;0;0;0;48;2;0;0;0m" + block + block + block + end;
    CHECK(preview(make_image(3, 4), Encoding::Srgb, 80, 24) == line + line);
}

TEST_CASE("below an odd last row the terminal shows its own background") {
    CHECK(preview({1, 1, {Vec3(1)}}, Encoding::Srgb, 80, 24) == "\x1b[38;2;255;255;255;49m" + block + end);
}

TEST_CASE("pixels are averaged as light, not as encoded numbers") {
    // Half of the light is byte 188; the mean of the bytes 0 and 255 would be 128.
    const Image stripes{4, 1, {Vec3(0), Vec3(1), Vec3(0), Vec3(1)}};
    CHECK(preview(stripes, Encoding::Srgb, 1, 1) == "\x1b[38;2;188;188;188;49m" + block + end);
}

TEST_CASE("a pixel that straddles two counts for each by its part") {
    // Three columns into two: the left one is the whole first and half of the second column.
    const Image image{3, 1, {Vec3(0), Vec3(0.75), Vec3(0)}};
    CHECK(preview(image, Encoding::Linear, 2, 1) ==
          "\x1b[38;2;64;64;64;49m" + block + block + end);  // 0.25 · 255
}

TEST_CASE("a highlight brightens its average only as far as the display could show it") {
    const Image image{2, 1, {Vec3(0), Vec3(1000)}};
    CHECK(preview(image, Encoding::Linear, 1, 1) == "\x1b[38;2;128;128;128;49m" + block + end);
}

TEST_CASE("a large picture is shrunk into the columns and rows, keeping its aspect") {
    struct Case {
        int width, height, columns, rows;
        std::size_t shown_columns, shown_lines;
    };
    for (const Case& c :
         {Case{320, 240, 80, 24, 64, 24}, Case{320, 240, 40, 24, 40, 15}, Case{640, 10, 80, 24, 80, 1},
          Case{10, 640, 80, 24, 1, 24}, Case{10, 8, 80, 24, 10, 4}, Case{320, 240, 0, -3, 1, 1},
          Case{1000, 1, 10, 10, 10, 1}}) {
        CAPTURE(c.width, c.height, c.columns, c.rows);
        const std::string text = preview(make_image(c.width, c.height), Encoding::Srgb, c.columns, c.rows);
        CHECK(occurrences(text, "\n") == c.shown_lines);
        CHECK(occurrences(text, block) == c.shown_columns * c.shown_lines);
    }
}

}  // namespace
}  // namespace rt
