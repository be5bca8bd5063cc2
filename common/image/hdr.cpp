// HDR: RGBE, three mantissas with one exponent (Ward, Real Pixels, Graphics Gems II, 1991).
// Written by stb_image_write; read here, because stb_image takes missing bytes for zeros, and in a run-length
// encoded row waits for ever for one that is not.
#include "common/image/format.hpp"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace rt::format {
namespace {

namespace fs = std::filesystem;

std::uint8_t byte(std::string_view content, std::size_t i) { return static_cast<std::uint8_t>(content[i]); }

/// The bytes of an .hdr file that are still to be read.
struct RgbeReader {
    const fs::path& path;
    std::string_view rest;

    static bool may_have_runs(std::size_t width) { return width >= 8 && width < 32768; }

    std::uint8_t next() {
        if (rest.empty()) fail(path, "the HDR file is cut off");
        const std::uint8_t first = byte(rest, 0);
        rest.remove_prefix(1);
        return first;
    }

    /// The header's next line, without its newline.
    std::string line() {
        std::string text;
        for (char c; (c = static_cast<char>(next())) != '\n';) text += c;
        return text;
    }

    /// One row, each channel for itself: a count up to 128 and that many bytes, or 128 + a count and the byte
    /// to repeat. Rows of other widths, and of older files, hold plain pixels.
    void row(std::vector<std::array<std::uint8_t, 4>>& pixels) {
        const std::size_t width = pixels.size();
        const bool runs = may_have_runs(width) && rest.size() >= 4 && byte(rest, 0) == 2 &&
                          byte(rest, 1) == 2 && byte(rest, 2) < 128;
        if (!runs) {
            for (auto& p : pixels)
                for (std::uint8_t& channel : p) channel = next();
            return;
        }
        if (byte(rest, 2) * 256u + byte(rest, 3) != width) damaged();
        rest.remove_prefix(4);
        for (std::size_t channel = 0; channel < 4; ++channel)
            for (std::size_t x = 0; x < width;) {
                const std::size_t code = next();
                const bool repeat = code > 128;
                const std::size_t count = repeat ? code - 128 : code;
                if (count == 0 || count > width - x) damaged();
                const std::uint8_t repeated = repeat ? next() : std::uint8_t(0);
                for (const std::size_t end = x + count; x < end; ++x)
                    pixels[x][channel] = repeat ? repeated : next();
            }
    }

    [[noreturn]] void damaged() const { fail(path, "the HDR file is damaged (a row has the wrong length)"); }
};

/// The fewest bytes that a row can have: runs of up to 127 equal values a channel, or plain pixels.
std::size_t least_row(std::size_t width) {
    return RgbeReader::may_have_runs(width) ? 4 + 4 * 2 * ((width + 126) / 127) : 4 * width;
}

void append(void* text, void* data, int size) {
    static_cast<std::string*>(text)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

Image read_hdr(const fs::path& path, std::string_view content) {
    RgbeReader reader{path, content};
    if (!content.starts_with("#?RADIANCE\n") && !content.starts_with("#?RGBE\n"))
        fail(path, "not an HDR file");
    bool rgbe = false;
    for (std::string line; !(line = reader.line()).empty();) rgbe |= line == "FORMAT=32-bit_rle_rgbe";
    if (!rgbe) fail(path, "an HDR file of another kind; expected FORMAT=32-bit_rle_rgbe");

    std::istringstream size(reader.line());
    std::string minus_y, plus_x;
    std::int64_t width = 0, height = 0;
    size >> minus_y >> height >> plus_x >> width;
    if (!size || minus_y != "-Y" || plus_x != "+X")
        fail(path, "an HDR file with an unknown order of pixels; expected -Y height +X width");
    check_size(path, width, height);
    // Known before memory is taken, so that a tiny file cannot ask for a huge image.
    if (reader.rest.size() / least_row(static_cast<std::size_t>(width)) < static_cast<std::size_t>(height))
        fail(path, "the HDR file is cut off");

    Image image = make_image(static_cast<int>(width), static_cast<int>(height));
    std::vector<std::array<std::uint8_t, 4>> row(static_cast<std::size_t>(width));
    for (int y = 0; y < image.height; ++y) {
        reader.row(row);
        for (int x = 0; x < image.width; ++x) {
            const auto& [r, g, b, e] = row[static_cast<std::size_t>(x)];
            if (e != 0) pixel(image, x, y) = Vec3(r, g, b) * std::ldexp(Real(1), e - 136);
        }
    }
    if (!reader.rest.empty()) fail(path, "the HDR file goes on after its last pixel");
    return image;
}

std::string hdr(const Image& image) {
    // The greatest number of the format; the exponent's byte would wrap around above it.
    constexpr Real greatest = Real(255) / 256 * 0x1p127;
    std::vector<float> samples;
    samples.reserve(image.pixels.size() * 3);
    for (const Vec3& p : image.pixels)
        for (int i = 0; i < 3; ++i) samples.push_back(p[i] > 0 ? to_float(std::min(p[i], greatest)) : 0.0f);
    std::string content;
    stbi_write_hdr_to_func(append, &content, image.width, image.height, 3, samples.data());
    return content;
}

}  // namespace rt::format
