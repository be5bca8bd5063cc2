// What the readers and writers of picture formats share. Each format has a file of its own: its reader takes
// a file's content and the path for messages, its writer returns the content.
#pragma once

#include "common/image/file.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace rt::format {

/// Throws InputError with the path and what is wrong.
[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what);

/// Throws InputError for an image that is empty or larger than `most_pixels`: before any memory is taken.
void check_size(const std::filesystem::path& path, std::int64_t width, std::int64_t height);

/// The nearest float; infinite beyond the greatest, where a bare conversion is undefined.
float to_float(Real value);

Picture read_png(const std::filesystem::path& path, std::string_view content, Encoding encoding);
Image read_pfm(const std::filesystem::path& path, std::string_view content);
Image read_hdr(const std::filesystem::path& path, std::string_view content);

std::string png(const Image& image, Encoding encoding);  ///< 8 bits a channel
std::string png16(const Image& image);                   ///< 16 bits a channel, linear
std::string pfm(const Image& image);
std::string hdr(const Image& image);

}  // namespace rt::format
