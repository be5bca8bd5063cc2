// Images from and to files, by the file's ending. A file appears whole or not at all.
#pragma once

#include "common/image/encoding.hpp"
#include "common/image/image.hpp"
#include "common/image/whole_file.hpp"

#include <filesystem>
#include <string_view>

namespace rt {

/// No picture has more pixels (1.6 GB of them in memory): more are a damaged header or a slip of the hand.
inline constexpr long long most_pixels = 1LL << 26;

/// A picture as a file has it.
struct Picture {
    Image image;
    bool eight_bits = false;  ///< 8 bits (or fewer) a channel; else 16, or floats
};

/// Reads `.png` (8-bit as `encoding` says, 16-bit as linear), `.pfm` (linear, colour or grey, either
/// byte order, times the scale in its header) or `.hdr` (linear, RGBE). Grey becomes three equal
/// channels; an alpha channel is ignored. Throws InputError with the path and what is wrong, also for
/// a file that is damaged, cut off, larger than 2^26 pixels, or that would unpack to more than its pixels.
Picture read_picture(const std::filesystem::path& path, Encoding encoding = Encoding::Srgb);

/// The same of a file's content; `path` has the ending and is named in messages.
Picture decode_picture(const std::filesystem::path& path, std::string_view content,
                       Encoding encoding = Encoding::Srgb);

/// The image of `read_picture`.
Image read_image(const std::filesystem::path& path, Encoding encoding = Encoding::Srgb);

/// Throws InputError unless the path ends in .png, .pfm or .hdr, in small or capital letters.
void require_picture_ending(const std::filesystem::path& path);

/// Writes `.png` (8-bit in `encoding`), `.pfm` (32-bit float, linear) or `.hdr` (RGBE, linear; negative
/// and NaN become 0) as `write_file` does. Throws InputError, also for an unknown ending.
void write_image(const std::filesystem::path& path, const Image& image, Encoding encoding = Encoding::Srgb);

/// Writes a PNG of 16 bits a channel, linear: what references are kept in. Values outside [0, 1] are clamped.
void write_png16(const std::filesystem::path& path, const Image& image);

}  // namespace rt
