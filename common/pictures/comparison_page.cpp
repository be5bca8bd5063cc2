// What `course compare --page` writes: two pictures and their difference, side by side.
#include "common/pictures/comparison_page.hpp"

#include "common/image/file.hpp"
#include "common/terminal/base64.hpp"
#include "common/terminal/page.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace rt {
namespace {

/// The image as a data URL: an 8-bit sRGB PNG.
std::string data_url(const Image& image) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / fmt::format("course-page-{}.png", ::getpid());
    write_image(file, image, Encoding::Srgb);
    const std::string bytes = read_file(file);
    std::filesystem::remove(file);
    return "data:image/png;base64," + base64(bytes);
}

PageView embedded(const Image& image, const std::string& alt, std::string_view caption) {
    return {{"source", data_url(image)}, {"embedded", true},     {"alt", alt},
            {"caption", caption},        {"width", image.width}, {"height", image.height}};
}

/// A fraction of pixels; 100 % only if it is all of them.
std::string percent(Real fraction) {
    return fraction >= 1 ? "100 %" : fmt::format("{:.2f} %", std::floor(fraction * 1e4) / 1e2);
}

}  // namespace

std::string comparison_page(const Image& image, const Image& reference, const Comparison& comparison,
                            std::string_view image_name, std::string_view reference_name) {
    const Real gain = visible_gain(comparison);
    const bool equal = comparison.max == 0, same = comparison.within[1] >= same_share;
    return page_from("common/pictures/pages/comparison.mustache",
                     {{"title", fmt::format("{} against {}", image_name, reference_name)},
                      {"image", image_name},
                      {"reference", reference_name},
                      {"passed", same},
                      {"word", equal  ? "the same"
                               : same ? "looks the same"
                                      : "differs"},
                      {"figures",
                       {embedded(image, fmt::format("The picture {}.", image_name), image_name),
                        embedded(reference, fmt::format("The reference {}.", reference_name), reference_name),
                        embedded(difference(image, reference, gain),
                                 "The absolute difference of the two pictures, amplified.",
                                 fmt::format("difference × {}", gain))}},
                      {"width", comparison.width},
                      {"height", comparison.height},
                      {"greatest", fmt::format("{:.6f}", comparison.max)},
                      {"x", comparison.worst_x},
                      {"y", comparison.worst_y},
                      {"mean", fmt::format("{:.3g}", comparison.mean)},
                      {"rmse", fmt::format("{:.3g}", comparison.rmse)},
                      {"psnr", equal ? "∞" : fmt::format("{:.1f} dB", comparison.psnr)},
                      {"within_1", percent(comparison.within[1])},
                      {"within_2", percent(comparison.within[2])},
                      {"within_10", percent(comparison.within[10])},
                      {"within16_2", percent(comparison.within16[2])}});
}

}  // namespace rt
