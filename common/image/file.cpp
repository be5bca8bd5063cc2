// Images from and to files: PNG through stb, PFM and the reading of RGBE by hand.
// Formats are decoded from and encoded to memory; whole_file.hpp reads and writes the files.

#include "common/image/file.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

// stb_image_write defines it for its own use, without a declaration.
extern "C" unsigned char* stbi_zlib_compress(unsigned char* data, int size, int* packed_size, int quality);

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

namespace rt {
namespace {

namespace fs = std::filesystem;
using Bytes = std::string_view;

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
    throw InputError(path.string() + ": " + what);
}

void check_size(const fs::path& path, std::int64_t width, std::int64_t height) {
    if (width < 1 || height < 1 || width > most_pixels || height > most_pixels / width)
        fail(path, "an image of " + std::to_string(width) + " x " + std::to_string(height) +
                       " pixels; expected at least 1 x 1 and at most " + std::to_string(most_pixels) +
                       " pixels");
}

std::string ending(const fs::path& path) {
    std::string text = path.extension().string();
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

[[noreturn]] void fail_ending(const fs::path& path) {
    const std::string found = path.extension().string();
    fail(path, (found.empty() ? "no file ending" : "unknown image format '" + found + "'") +
                   "; expected .png, .pfm or .hdr");
}

std::uint8_t byte(Bytes content, std::size_t i) { return static_cast<std::uint8_t>(content[i]); }

/// Four bytes from position `i`.
std::uint32_t word(Bytes content, std::size_t i, std::endian order) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k)
        value = value << 8 | byte(content, order == std::endian::big ? i + k : i + 3 - k);
    return value;
}

// ---- PNG ----

/// The checksum of PNG's chunks (ISO 3309).
std::uint32_t crc32(Bytes content) {
    static const std::array<std::uint32_t, 256> table = [] {
        std::array<std::uint32_t, 256> t{};
        for (std::uint32_t n = 0; n < 256; ++n) {
            t[n] = n;
            for (int bit = 0; bit < 8; ++bit) t[n] = t[n] >> 1 ^ (t[n] & 1 ? 0xEDB88320u : 0u);
        }
        return t;
    }();
    std::uint32_t crc = 0xFFFFFFFFu;
    for (std::size_t i = 0; i < content.size(); ++i) crc = table[(crc ^ byte(content, i)) & 0xFF] ^ crc >> 8;
    return ~crc;
}

/// Walks the chunks, because stb_image checks no checksum: a damaged file would pass for a picture.
void check_png(const fs::path& path, Bytes content) {
    constexpr Bytes signature = "\x89PNG\r\n\x1a\n";
    if (!content.starts_with(signature)) fail(path, "not a PNG file");
    if (content.size() > 16 && content.substr(12, 4) != "IHDR")
        fail(path, "the PNG file is damaged (it does not begin with IHDR)");
    content.remove_prefix(signature.size());
    for (Bytes type; type != "IEND";) {
        // A chunk: length of its data, type, data, checksum over type and data.
        if (content.size() < 12 || content.size() - 12 < word(content, 0, std::endian::big))
            fail(path, "the PNG file is cut off");
        const std::size_t length = word(content, 0, std::endian::big);
        if (crc32(content.substr(4, 4 + length)) != word(content, 8 + length, std::endian::big))
            fail(path, "the PNG file is damaged (a checksum is wrong)");
        type = content.substr(4, 4);
        content.remove_prefix(12 + length);
    }
}

[[noreturn]] void fail_png(const fs::path& path) {
    // It may have the name of a chunk in it, which may be any four bytes.
    fail(path, "the PNG file is damaged (" + printable(stbi_failure_reason()) + ")");
}

/// Bytes of the rows of `width` × `height` pixels before packing, each with the number of its filter in
/// front.
std::int64_t bytes_of_rows(std::int64_t width, std::int64_t height, std::int64_t bits_per_pixel) {
    return width == 0 ? 0 : height * (1 + (width * bits_per_pixel + 7) / 8);
}

/// What the header says that IDAT holds, unpacked. The header is whole: stb has read it.
std::int64_t unpacked_size(Bytes header) {
    constexpr std::array<int, 7> channels{1, 0, 3, 1,
                                          2, 0, 4};  // of colour types 0 to 6; a palette's index is one
    const std::int64_t width = word(header, 0, std::endian::big), height = word(header, 4, std::endian::big);
    const std::int64_t bits = byte(header, 8) * channels.at(byte(header, 9));
    if (byte(header, 12) == 0) return bytes_of_rows(width, height, bits);
    // Adam7: of each 8 × 8 pixels first one, then twice as many again and again.
    constexpr std::array<std::array<int, 4>, 7> passes{
        {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};
    std::int64_t sum = 0;
    for (const auto& [x, y, dx, dy] : passes)
        sum += bytes_of_rows((width - x + dx - 1) / dx, (height - y + dy - 1) / dy, bits);
    return sum;
}

/// The data of all IDAT chunks of a file that `check_png` has passed.
std::string packed_rows(Bytes content) {
    std::string packed;
    for (std::size_t at = 8; at < content.size();) {
        const std::size_t length = word(content, at, std::endian::big);
        const Bytes type = content.substr(at + 4, 4);
        if (type == "IDAT") packed += content.substr(at + 8, length);
        if (type == "IEND") break;
        at += 12 + length;
    }
    return packed;
}

/// Unpacks the rows once into no more memory than the header's size needs: stb would go on for as long as
/// there is something to unpack, which in 3 MB of file may be 3 GB.
void check_png_data(const fs::path& path, Bytes content) {
    constexpr std::int64_t surplus = 1 << 20;   // some programs write more than the pixels
    constexpr std::int64_t most_packed = 1032;  // deflate's greatest ratio: 258 bytes from 2 bits
    const std::string packed = packed_rows(content);
    const std::int64_t expected = unpacked_size(content.substr(16));
    if (expected / most_packed > static_cast<std::int64_t>(packed.size()))
        fail(path, "the PNG file is damaged (not enough pixels)");
    const auto room = static_cast<std::size_t>(expected + surplus);
    const auto unpacked = std::make_unique_for_overwrite<char[]>(room);
    if (stbi_zlib_decode_buffer(unpacked.get(), static_cast<int>(room), packed.data(),
                                static_cast<int>(packed.size())) < 0) {
        const Bytes why = stbi_failure_reason();
        fail(path, why == "output buffer limit" ? "the PNG file unpacks to more than its " +
                                                      std::to_string(expected) + " bytes of pixels"
                                                : "the PNG file is damaged (" + printable(why) + ")");
    }
}

struct FreeStb {
    void operator()(void* samples) const { stbi_image_free(samples); }
};

/// The image of stb's samples, three a pixel, each turned into light by `decoded`.
template <typename Sample, typename Decode>
Image from_samples(const fs::path& path, Sample* samples, int width, int height, Decode decoded) {
    const std::unique_ptr<Sample[], FreeStb> owner(samples);
    if (!samples) fail_png(path);
    Image image = make_image(width, height);
    for (Vec3& p : image.pixels)
        for (int i = 0; i < 3; ++i) p[i] = decoded(*samples++);
    return image;
}

Picture read_png(const fs::path& path, Bytes content, Encoding encoding) {
    check_png(path, content);
    if (content.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        fail(path, "the PNG file is larger than 2 GB");
    const auto* bytes = reinterpret_cast<const stbi_uc*>(content.data());
    const int size = static_cast<int>(content.size());
    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(bytes, size, &width, &height, &channels)) fail_png(path);
    check_size(path, width, height);
    check_png_data(path, content);
    if (stbi_is_16_bit_from_memory(bytes, size))
        return {from_samples(path, stbi_load_16_from_memory(bytes, size, &width, &height, &channels, 3),
                             width, height, [](stbi_us sample) { return sample / Real(65535); }),
                false};
    std::array<Real, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i) light[i] = decode(static_cast<Real>(i) / 255, encoding);
    return {from_samples(path, stbi_load_from_memory(bytes, size, &width, &height, &channels, 3), width,
                         height, [&light](stbi_uc sample) { return light[sample]; }),
            true};
}

void append(void* text, void* data, int size) {
    static_cast<std::string*>(text)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

std::string png(const Image& image, Encoding encoding) {
    std::vector<std::uint8_t> samples;
    samples.reserve(image.pixels.size() * 3);
    for (const Vec3& p : image.pixels)
        for (int i = 0; i < 3; ++i) samples.push_back(encode_byte(p[i], encoding));
    std::string content;
    stbi_write_png_to_func(append, &content, image.width, image.height, 3, samples.data(), 3 * image.width);
    return content;
}

/// The four bytes of a number, the most significant first, as PNG has them.
std::string big_endian(std::uint32_t n) {
    return {static_cast<char>(n >> 24), static_cast<char>(n >> 16), static_cast<char>(n >> 8),
            static_cast<char>(n)};
}

std::string png_chunk(const std::string& content) {
    return big_endian(static_cast<std::uint32_t>(content.size()) - 4) + content + big_endian(crc32(content));
}

/// Three linear samples of 16 bits a pixel. stb writes 8 bits only, but it can pack.
std::string png16(const Image& image) {
    std::string rows;
    rows.reserve(image.pixels.size() * 6 + static_cast<std::size_t>(image.height));
    for (int y = 0; y < image.height; ++y) {
        rows += '\0';  // the row is stored as it is
        for (int x = 0; x < image.width; ++x)
            for (int i = 0; i < 3; ++i) {
                const Real light = encode(pixel(image, x, y)[i], Encoding::Linear);
                const auto sample = static_cast<std::uint32_t>(std::lround(65535 * light));
                rows += {static_cast<char>(sample >> 8), static_cast<char>(sample)};
            }
    }
    int size = 0;
    const std::unique_ptr<unsigned char, decltype(&std::free)> packed(
        stbi_zlib_compress(reinterpret_cast<unsigned char*>(rows.data()), static_cast<int>(rows.size()),
                           &size, 8),
        &std::free);
    const std::string data(reinterpret_cast<const char*>(packed.get()), static_cast<std::size_t>(size));
    const std::string header = big_endian(static_cast<std::uint32_t>(image.width)) +
                               big_endian(static_cast<std::uint32_t>(image.height)) +
                               std::string("\x10\x02\0\0\0", 5);  // 16 bits, RGB, nothing special
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR" + header) + png_chunk("IDAT" + data) + png_chunk("IEND");
}

// ---- PFM: a header of text, then rows of floats, the bottom row first ----

Image read_pfm(const fs::path& path, Bytes content) {
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

/// The nearest float; infinite beyond the greatest, where a bare conversion is undefined.
float to_float(Real value) {
    constexpr float greatest = std::numeric_limits<float>::max();
    if (std::abs(value) > static_cast<Real>(greatest))
        return std::copysign(std::numeric_limits<float>::infinity(), value > 0 ? 1.0f : -1.0f);
    return static_cast<float>(value);
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

// ---- HDR: RGBE, three mantissas with one exponent (Ward, Real Pixels, Graphics Gems II, 1991) ----

/// The bytes of an .hdr file after its header. stb_image takes missing bytes for zeros, and in a run-length
/// encoded row waits for ever for one that is not; hence our own reader.
struct RgbeReader {
    const fs::path& path;
    Bytes rest;

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

Image read_hdr(const fs::path& path, Bytes content) {
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

}  // namespace

Real encode(Real linear, Encoding encoding) {
    linear = displayable(linear);
    if (encoding == Encoding::Linear) return linear;
    if (linear <= 0.0031308) return 12.92 * linear;
    return displayable(1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

Real decode(Real encoded, Encoding encoding) {
    encoded = displayable(encoded);
    if (encoding == Encoding::Linear) return encoded;
    if (encoded <= 0.04045) return encoded / 12.92;
    return displayable(std::pow((encoded + 0.055) / 1.055, 2.4));
}

std::uint8_t encode_byte(Real linear, Encoding encoding) {
    return static_cast<std::uint8_t>(std::lround(255 * encode(linear, encoding)));
}

Picture decode_picture(const fs::path& path, std::string_view content, Encoding encoding) {
    const std::string format = ending(path);
    if (format == ".png") return read_png(path, content, encoding);
    if (format == ".pfm") return {read_pfm(path, content), false};
    if (format == ".hdr") return {read_hdr(path, content), false};
    fail_ending(path);
}

Picture read_picture(const fs::path& path, Encoding encoding) {
    require_picture_ending(path);
    return decode_picture(path, read_file(path), encoding);
}

Image read_image(const fs::path& path, Encoding encoding) { return read_picture(path, encoding).image; }

void require_picture_ending(const fs::path& path) {
    const std::string format = ending(path);
    if (format != ".png" && format != ".pfm" && format != ".hdr") fail_ending(path);
}

void write_image(const fs::path& path, const Image& image, Encoding encoding) {
    require_picture_ending(path);
    const std::string format = ending(path);
    check_size(path, image.width, image.height);
    write_file(path, format == ".png" ? png(image, encoding) : format == ".pfm" ? pfm(image) : hdr(image));
}

void write_png16(const std::filesystem::path& path, const Image& image) { write_file(path, png16(image)); }

}  // namespace rt
