// PFM: a header of text, then rows of floats, the bottom row first.
#include "common/image/format.hpp"

#include <bit>
#include <cctype>
#include <cmath>
#include <sstream>

namespace rt::format {
namespace {

namespace fs = std::filesystem;

/// Four bytes from position `i`.
std::uint32_t word(std::string_view content, std::size_t i, std::endian order) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k)
        value =
            value << 8 | static_cast<std::uint8_t>(content[order == std::endian::big ? i + k : i + 3 - k]);
    return value;
}

}  // namespace

Image read_pfm(const fs::path& path, std::string_view content) {
    std::istringstream header(std::string(content.substr(0, 256)));
    std::string magic;
    std::int64_t width = 0, height = 0;
    Real scale = 0;
    header >> magic;
    if (magic != "PF" && magic != "Pf") fail(path, "not a PFM file");
    header >> width >> height >> scale;
    if (!header || !std::isspace(header.get()) || scale == 0)
        fail(path, "a PFM file starts with 'PF' or 'Pf', width, height and a scale that is not 0");
    check_size(path, width, height);

    const std::size_t start = static_cast<std::size_t>(header.tellg());
    const std::size_t channels = magic == "PF" ? 3 : 1;
    const std::size_t expected = static_cast<std::size_t>(width * height) * channels * 4;
    if (content.size() - start != expected)
        fail(path, "the PFM file has " + std::to_string(content.size() - start) +
                       " bytes of pixels; expected " + std::to_string(expected));

    const std::endian order = scale < 0 ? std::endian::little : std::endian::big;
    Image image = make_image(static_cast<int>(width), static_cast<int>(height));
    std::size_t at = start;
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x, at += 4 * channels)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t bits = word(content, at + (channels == 3 ? 4 * i : 0), order);
                pixel(image, x, y)[static_cast<int>(i)] =
                    static_cast<Real>(std::bit_cast<float>(bits)) * std::abs(scale);
            }
    return image;
}

std::string pfm(const Image& image) {
    std::string content =
        "PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
    content.reserve(content.size() + 12 * image.pixels.size());
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x)
            for (int i = 0; i < 3; ++i) {
                const auto bits = std::bit_cast<std::uint32_t>(to_float(pixel(image, x, y)[i]));
                for (int shift = 0; shift < 32; shift += 8)
                    content += static_cast<char>(bits >> shift & 0xFF);
            }
    return content;
}

}  // namespace rt::format
