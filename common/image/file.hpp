// Images from and to files, by the file's ending. A file appears whole or not at all.
#pragma once

#include "common/image/image.hpp"

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace rt {

/// Light in [0, 1] to the number that a display wants, in [0, 1]; values outside are clamped,
/// NaN becomes 0.
Real encode(Real linear, Encoding encoding);

/// Inverse of `encode` on [0, 1].
Real decode(Real encoded, Encoding encoding);

/// The byte round(255 · encode(linear)).
std::uint8_t encode_byte(Real linear, Encoding encoding);

/// Reads `.png` (8-bit as `encoding` says, 16-bit as linear), `.pfm` (linear, colour or grey, either
/// byte order, times the scale in its header) or `.hdr` (linear, RGBE). Grey becomes three equal
/// channels; an alpha channel is ignored. Throws InputError with the path and what is wrong, also for
/// a file that is damaged, cut off or larger than 2^26 pixels.
Image read_image(const std::filesystem::path& path, Encoding encoding = Encoding::Srgb);

/// Writes `.png` (8-bit in `encoding`), `.pfm` (32-bit float, linear) or `.hdr` (RGBE, linear; negative
/// and NaN become 0) as `write_file` does. Throws InputError, also for an unknown ending.
void write_image(const std::filesystem::path& path, const Image& image, Encoding encoding = Encoding::Srgb);

/// Writes a PNG of 16 bits a channel, linear: what references are kept in. Values outside [0, 1] are clamped.
void write_png16(const std::filesystem::path& path, const Image& image);

/// Writes `content` to `path` whole, through a temporary file beside it and a rename; a link or the
/// permissions of an existing file are kept, a device or pipe is written directly. Throws InputError with
/// the path and what is wrong; then nothing is left behind and an existing file is as it was.
void write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace rt
