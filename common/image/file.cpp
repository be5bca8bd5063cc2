// Pictures from and to files: the file's ending chooses the format.
// Formats are decoded from and encoded to memory; whole_file.hpp reads and writes the files.
#include "common/image/file.hpp"

#include "common/image/format.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"

#include <cctype>
#include <cmath>
#include <limits>

namespace rt {

namespace fs = std::filesystem;

namespace {

std::string ending(const fs::path& path) {
    std::string text = path.extension().string();
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

[[noreturn]] void fail_ending(const fs::path& path) {
    const std::string found = path.extension().string();
    format::fail(path, (found.empty() ? "no file ending" : "unknown image format '" + found + "'") +
                           "; expected .png, .pfm or .hdr");
}

}  // namespace

namespace format {

void fail(const fs::path& path, const std::string& what) { throw InputError(path.string() + ": " + what); }

void check_size(const fs::path& path, std::int64_t width, std::int64_t height) {
    if (width < 1 || height < 1 || width > most_pixels || height > most_pixels / width)
        fail(path, "an image of " + std::to_string(width) + " x " + std::to_string(height) +
                       " pixels; expected at least 1 x 1 and at most " + std::to_string(most_pixels) +
                       " pixels");
}

float to_float(Real value) {
    constexpr float greatest = std::numeric_limits<float>::max();
    if (std::abs(value) > static_cast<Real>(greatest))
        return std::copysign(std::numeric_limits<float>::infinity(), value > 0 ? 1.0f : -1.0f);
    return static_cast<float>(value);
}

}  // namespace format

Picture decode_picture(const fs::path& path, std::string_view content, Encoding encoding) {
    const std::string kind = ending(path);
    if (kind == ".png") return format::read_png(path, content, encoding);
    if (kind == ".pfm") return {format::read_pfm(path, content), false};
    if (kind == ".hdr") return {format::read_hdr(path, content), false};
    fail_ending(path);
}

Picture read_picture(const fs::path& path, Encoding encoding) {
    require_picture_ending(path);
    return decode_picture(path, read_file(path), encoding);
}

Image read_image(const fs::path& path, Encoding encoding) { return read_picture(path, encoding).image; }

void require_picture_ending(const fs::path& path) {
    const std::string kind = ending(path);
    if (kind != ".png" && kind != ".pfm" && kind != ".hdr") fail_ending(path);
}

void write_image(const fs::path& path, const Image& image, Encoding encoding) {
    require_picture_ending(path);
    const std::string kind = ending(path);
    format::check_size(path, image.width, image.height);
    write_file(path, kind == ".png"   ? format::png(image, encoding)
                     : kind == ".pfm" ? format::pfm(image)
                                      : format::hdr(image));
}

void write_png16(const fs::path& path, const Image& image) { write_file(path, format::png16(image)); }

}  // namespace rt
