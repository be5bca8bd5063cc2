// The image reader under libFuzzer: whatever the bytes, out comes a picture or an InputError of one line.
// README.md beside this file says how to run it.
#include "common/image/file.hpp"
#include "tests/fuzz/must.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

namespace {

using rt::fuzz::require;

/// The checksum of PNG's chunks (ISO 3309), bit by bit.
std::uint32_t checksum(std::string_view content) {
    std::uint32_t crc = ~std::uint32_t(0);
    for (const char c : content) {
        crc ^= static_cast<std::uint8_t>(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xEDB88320u : crc >> 1;
    }
    return ~crc;
}

/// The bytes with the right checksum at the end of each chunk, without which nothing behind it is looked at.
std::string with_checksums(std::string png) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(png[i]); };
    for (std::size_t at = 8; at + 12 <= png.size();) {
        const std::size_t length = std::size_t{byte(at)} << 24 | std::size_t{byte(at + 1)} << 16 |
                                   std::size_t{byte(at + 2)} << 8 | byte(at + 3);
        if (length > png.size() - at - 12) break;
        const std::uint32_t crc = checksum(std::string_view(png).substr(at + 4, 4 + length));
        for (std::size_t i = 0; i < 4; ++i) png[at + 8 + length + i] = static_cast<char>(crc >> (24 - 8 * i));
        at += 12 + length;
    }
    return png;
}

void check(const rt::Picture& picture) {
    const rt::Image& image = picture.image;
    require(image.width >= 1 && image.height >= 1);
    const std::int64_t pixels = std::int64_t{image.width} * image.height;
    require(pixels <= rt::most_pixels && image.pixels.size() == static_cast<std::size_t>(pixels));
    if (!picture.eight_bits) return;
    for (const rt::Vec3& p : image.pixels)
        for (int i = 0; i < 3; ++i) require(p[i] >= 0 && p[i] <= 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string content(reinterpret_cast<const char*>(data), size);
    const std::string repaired = content.starts_with("\x89PNG") ? with_checksums(content) : content;
    for (const char* name : {"fuzz.png", "fuzz.pfm", "fuzz.hdr"})
        rt::fuzz::must_read_or_refuse([&] { check(rt::decode_picture(name, repaired)); },
                                      std::string(name) + ": ");
    return 0;
}
