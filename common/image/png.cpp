// PNG through libspng.
#include "common/image/format.hpp"

#include <spng.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

namespace rt::format {
namespace {

namespace fs = std::filesystem;

/// Texts and colour profiles are packed, too; no file may have more of them.
constexpr std::size_t most_extra = std::size_t{1} << 24;

struct FreeContext {
    void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};
using Context = std::unique_ptr<spng_ctx, FreeContext>;

Context new_context(int flags) {
    Context context(spng_ctx_new(flags));
    if (!context) throw std::bad_alloc();
    return context;
}

// ---- Reading ----

/// libspng's words, where ours are not plainer.
std::string what_is_damaged(int error) {
    switch (error) {
        case SPNG_ENOIHDR:
        case SPNG_EIHDR_SIZE:
            return "it does not begin with IHDR";
        case SPNG_ECHUNK_CRC:
            return "a checksum is wrong";
        case SPNG_EIDAT_TOO_SHORT:
            return "not enough pixels";
        default:
            return spng_strerror(error);
    }
}

/// Throws unless the answer of libspng is that all is well.
void check(const fs::path& path, int error) {
    if (error == SPNG_OK) return;
    if (error == SPNG_EMEM) throw std::bad_alloc();
    if (error == SPNG_IO_EOF) fail(path, "the PNG file is cut off");
    if (error == SPNG_ECHUNK_LIMITS)
        fail(path, "the PNG file has more than 16 MiB of texts and colour profiles");
    fail(path, "the PNG file is damaged (" + what_is_damaged(error) + ")");
}

/// All pixels in one of libspng's formats, `Sample` its channels. It unpacks row by row, so that what is
/// packed behind the last row takes no memory.
template <class Sample>
std::vector<Sample> decode(const fs::path& path, spng_ctx* context, spng_format kind) {
    std::size_t size = 0;
    check(path, spng_decoded_image_size(context, kind, &size));
    std::vector<Sample> samples(size / sizeof(Sample));
    check(path, spng_decode_image(context, samples.data(), size, kind, 0));
    check(path, spng_decode_chunks(context));  // up to the end of the file
    return samples;
}

/// The first three of each pixel's `channels` samples, each turned into light by `light`.
template <class Sample, class Light>
Image image_of(const spng_ihdr& header, const std::vector<Sample>& samples, std::size_t channels,
               Light light) {
    Image image = make_image(static_cast<int>(header.width), static_cast<int>(header.height));
    for (std::size_t p = 0; p < image.pixels.size(); ++p)
        for (std::size_t i = 0; i < 3; ++i)
            image.pixels[p][static_cast<int>(i)] = light(samples[p * channels + i]);
    return image;
}

/// The header, if a file of this length can have so many pixels: deflate packs at most 258 bytes into 2 bits.
spng_ihdr checked_header(const fs::path& path, std::string_view content, spng_ctx* context) {
    constexpr std::size_t most_packed = 1032;
    spng_ihdr header{};
    check(path, spng_get_ihdr(context, &header));
    check_size(path, header.width, header.height);
    std::size_t unpacked = 0;
    check(path, spng_decoded_image_size(context, SPNG_FMT_PNG, &unpacked));
    if (unpacked / most_packed > content.size()) check(path, SPNG_EIDAT_TOO_SHORT);
    return header;
}

/// libspng is content with the end's name.
void check_end(const fs::path& path, std::string_view content) {
    constexpr std::string_view end("\0\0\0\0IEND\xAE\x42\x60\x82", 12);
    if (content.rfind(end) == std::string_view::npos) fail(path, "the PNG file is cut off");
}

}  // namespace

Picture read_png(const fs::path& path, std::string_view content, Encoding encoding) {
    if (!content.starts_with("\x89PNG\r\n\x1a\n")) fail(path, "not a PNG file");
    // The checksum of each chunk tells of damage; some programs write a wrong one of the data inside.
    const Context context = new_context(SPNG_CTX_IGNORE_ADLER32);
    check(path, spng_set_chunk_limits(context.get(), most_extra, most_extra));
    check(path, spng_set_crc_action(context.get(), SPNG_CRC_ERROR, SPNG_CRC_ERROR));
    check(path, spng_set_png_buffer(context.get(), content.data(), content.size()));
    const spng_ihdr header = checked_header(path, content, context.get());
    check_end(path, content);
    if (header.bit_depth == 16)
        return {image_of(header, decode<std::uint16_t>(path, context.get(), SPNG_FMT_RGBA16), 4,
                         [](std::uint16_t sample) { return sample / Real(65535); }),
                false};
    std::array<Real, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = rt::decode(static_cast<Real>(i) / 255, encoding);
    return {image_of(header, decode<std::uint8_t>(path, context.get(), SPNG_FMT_RGB8), 3,
                     [&](std::uint8_t sample) { return light[sample]; }),
            true};
}

// ---- Writing ----

namespace {

/// A file of three samples a pixel, of 8 or 16 bits as `Sample` has.
template <class Sample>
std::string encode(const Image& image, const std::vector<Sample>& samples) {
    const Context context = new_context(SPNG_CTX_ENCODER);
    spng_ihdr header{.width = static_cast<std::uint32_t>(image.width),
                     .height = static_cast<std::uint32_t>(image.height),
                     .bit_depth = 8 * sizeof(Sample),
                     .color_type = SPNG_COLOR_TYPE_TRUECOLOR,
                     .compression_method = 0,
                     .filter_method = 0,
                     .interlace_method = SPNG_INTERLACE_NONE};
    spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
    // Level 6, zlib's own choice, takes half as long again for files that are 4 % smaller.
    spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, 5);
    spng_set_ihdr(context.get(), &header);
    int error = spng_encode_image(context.get(), samples.data(), samples.size() * sizeof(Sample),
                                  SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
    std::size_t size = 0;
    const std::unique_ptr<void, decltype(&std::free)> content(
        error == SPNG_OK ? spng_get_png_buffer(context.get(), &size, &error) : nullptr, &std::free);
    if (!content) throw std::bad_alloc();  // nothing else can go wrong
    return {static_cast<const char*>(content.get()), size};
}

}  // namespace

std::string png(const Image& image, Encoding encoding) {
    std::vector<std::uint8_t> samples;
    samples.reserve(image.pixels.size() * 3);
    for (const Vec3& p : image.pixels)
        for (int i = 0; i < 3; ++i) samples.push_back(encode_byte(p[i], encoding));
    return encode(image, samples);
}

std::string png16(const Image& image) {
    std::vector<std::uint16_t> samples;
    samples.reserve(image.pixels.size() * 3);
    for (const Vec3& p : image.pixels)
        for (int i = 0; i < 3; ++i)
            samples.push_back(static_cast<std::uint16_t>(std::lround(65535 * displayable(p[i]))));
    return encode(image, samples);
}

}  // namespace rt::format
