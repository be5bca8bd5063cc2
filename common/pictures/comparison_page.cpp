// What `course compare --page` writes: two pictures under a slider, where and how they differ, and on a click
// the rays of a pixel.
#include "common/pictures/comparison_page.hpp"

#include "common/image/color_map.hpp"
#include "common/image/encoding.hpp"
#include "common/image/file.hpp"
#include "common/image/flip.hpp"
#include "common/image/ssim.hpp"
#include "common/image/worst_places.hpp"
#include "common/terminal/base64.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/page.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace rt {
namespace {

constexpr std::size_t most_traced = 1000, most_worst = 10;
constexpr int traced_across = 16, traced_down = 12;  // also where nothing differs

/// The image as a data URL: an 8-bit PNG.
std::string data_url(const Image& image, Encoding encoding) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / fmt::format("course-page-{}.png", ::getpid());
    write_image(file, image, encoding);
    const std::string bytes = read_file(file);
    std::filesystem::remove(file);
    return "data:image/png;base64," + base64(bytes);
}

/// Numbers as colours; 1/scale is the brightest.
template <class NumberAt>
std::string mapped(const Image& image, Real scale, NumberAt number_at) {
    Image map = make_image(image.width, image.height);
    for (std::size_t i = 0; i < map.pixels.size(); ++i) map.pixels[i] = magma(scale * number_at(i));
    return data_url(map, Encoding::Srgb);
}

/// The map's colours from left to right, with what they stand for.
PageView scale_bar(std::string_view most) {
    Image bar = make_image(256, 1);
    for (int x = 0; x < bar.width; ++x) pixel(bar, x, 0) = magma(x / Real(255));
    return {{"source", data_url(bar, Encoding::Srgb)}, {"most", most}};
}

/// A pixel as the display gets it.
std::string bytes_of(const Vec3& p, const Display& display) {
    return fmt::format("{}, {}, {}", encode_byte(p.x, display.encoding), encode_byte(p.y, display.encoding),
                       encode_byte(p.z, display.encoding));
}

PageView worst_rows(const Image& image, const Image& reference, const Channel& perceived,
                    const Display& display) {
    // Of a silhouette that is off by a pixel, say, one place is enough to look at.
    const int apart = std::max(2, std::max(image.width, image.height) / 20);
    PageView rows = PageView::array();
    for (const DifferingPixel& place :
         worst_places(differing_pixels(image, reference, image.pixels.size()), most_worst, apart)) {
        const auto i = static_cast<std::size_t>(place.y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(place.x);
        rows.push_back({{"number", rows.size() + 1},
                        {"x", place.x},
                        {"y", place.y},
                        {"mine", bytes_of(image.pixels[i], display)},
                        {"theirs", bytes_of(reference.pixels[i], display)},
                        {"difference", fmt::format("{:.6f}", place.difference)},
                        {"flip", fmt::format("{:.3f}", perceived.values[i])}});
    }
    return rows;
}

/// How many pixels differ by how much, in steps of 1/255: none, 1, 2, 3 to 4, 5 to 8, ….
PageView histogram(const Comparison& comparison) {
    const Real pixels = Real(comparison.width) * comparison.height;
    PageView bars = PageView::array();
    std::vector<Real> counts;
    for (int last = 0, first = 0; first < 256;
         first = last + 1, last = last == 0 ? 1 : std::min(2 * last, 255)) {
        const Real before = first == 0 ? 0 : comparison.within[static_cast<std::size_t>(first) - 1];
        const Real count = std::round((comparison.within[static_cast<std::size_t>(last)] - before) * pixels);
        counts.push_back(count);
        bars.push_back(
            {{"from", first == last ? std::to_string(first) : fmt::format("{} to {}", first, last)},
             {"pixels", fmt::format("{:.0f}", count)}});
    }
    // By the logarithm: one wrong pixel among a hundred thousand is what somebody looks for.
    const Real most = std::log1p(*std::ranges::max_element(counts));
    for (std::size_t i = 0; i < counts.size(); ++i)
        bars[i]["length"] = fmt::format("{:.1f}", 100 * std::log1p(counts[i]) / most);
    return bars;
}

/// What the page's script works with. No text in it can end the element that it stands in.
std::string script_data(const Comparison& comparison, const PageExtras& extras) {
    PageView rays = PageView::array();
    for (const PixelRays& pixel : extras.rays) {
        PageView one = {
            {"x", pixel.x}, {"y", pixel.y}, {"mine", pixel.mine}, {"difference", pixel.difference}};
        if (pixel.theirs != pixel.mine) one["theirs"] = pixel.theirs;
        rays.push_back(one);
    }
    std::string text = json_text(PageView{{"width", comparison.width},
                                          {"height", comparison.height},
                                          {"x", comparison.worst_x},
                                          {"y", comparison.worst_y},
                                          {"scene", extras.scene},
                                          {"withoutMine", extras.without_mine},
                                          {"rays", rays}});
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; at += 6)
        text.replace(at, 1, "\\u003c");
    return text;
}

PageView numbers_of(const Comparison& comparison, Real flip_mean, const std::optional<Real>& similarity) {
    return {{"width", comparison.width},
            {"height", comparison.height},
            {"greatest", fmt::format("{:.6f}", comparison.max)},
            {"shown_greatest", fmt::format("{:.3g}", 255 * comparison.shown_max)},
            {"x", comparison.worst_x},
            {"y", comparison.worst_y},
            {"mean", fmt::format("{:.3g}", comparison.mean)},
            {"rmse", fmt::format("{:.3g}", comparison.rmse)},
            {"psnr", comparison.max == 0 ? "∞" : fmt::format("{:.1f} dB", comparison.psnr)},
            {"ssim", similarity ? fmt::format("{:.6f}", *similarity) : "–"},
            {"flip", fmt::format("{:.6f}", flip_mean)},
            {"within_1", percent(comparison.within[1])},
            {"within_2", percent(comparison.within[2])},
            {"within_10", percent(comparison.within[10])},
            {"within16_2", percent(comparison.within16[2])}};
}

}  // namespace

std::vector<PixelRays> pixels_to_trace(const Image& image, const Image& reference) {
    std::vector<PixelRays> pixels;
    std::set<std::pair<int, int>> there;
    const auto add = [&](int x, int y) {
        if (there.insert({x, y}).second) pixels.push_back({x, y, {}, {}, {}});
    };
    for (const DifferingPixel& pixel : differing_pixels(image, reference, most_traced)) add(pixel.x, pixel.y);
    for (int row = 0; row < traced_down; ++row)
        for (int column = 0; column < traced_across; ++column)
            add((2 * column + 1) * image.width / (2 * traced_across),
                (2 * row + 1) * image.height / (2 * traced_down));
    return pixels;
}

std::string comparison_page(const Image& image, const Image& reference, const Comparison& comparison,
                            std::string_view image_name, std::string_view reference_name,
                            const PageExtras& extras) {
    const bool equal = comparison.max == 0, same = comparison.within[1] >= same_share;
    const Channel perceived = flip(image, reference, extras.display);
    const Image differences = difference(image, reference);
    const Real gain = visible_gain(comparison);
    PageView view = numbers_of(comparison, mean(perceived), ssim(image, reference, extras.display));
    view.update(
        PageView{{"title", fmt::format("{} against {}", image_name, reference_name)},
                 {"policy",
                  "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'"},
                 {"image", image_name},
                 {"reference", reference_name},
                 {"passed", same},
                 {"differs", !equal},
                 {"word", equal  ? "the same"
                          : same ? "looks the same"
                                 : "differs"},
                 {"image_source", data_url(image, extras.display.encoding)},
                 {"reference_source", data_url(reference, extras.display.encoding)},
                 {"difference_source",
                  mapped(image, gain, [&](std::size_t i) { return max_component(differences.pixels[i]); })},
                 {"difference_bar", scale_bar(gain == 1 ? "1" : fmt::format("1/{} or more", gain))},
                 {"flip_source", mapped(image, 1, [&](std::size_t i) { return perceived.values[i]; })},
                 {"flip_bar", scale_bar("1")},
                 {"worst", worst_rows(image, reference, perceived, extras.display)},
                 {"histogram", histogram(comparison)},
                 {"scene", extras.scene},
                 {"data", script_data(comparison, extras)}});
    return page_from("common/pictures/pages/comparison.mustache", view);
}

}  // namespace rt
