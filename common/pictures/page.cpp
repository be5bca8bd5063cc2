// Pieces of the HTML pages that the program writes: one style, light and dark, and pictures side by side.
#include "common/pictures/page.hpp"

#include "common/terminal/project.hpp"
#include "common/image/file.hpp"
#include "common/math/printable.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>

namespace rt {
namespace {

constexpr std::string_view style = R"css(
:root {
  color-scheme: light dark;
  --ground: #fbfaf8; --card: #ffffff; --ink: #22262b; --quiet: #646b74; --line: #e2e0dc;
  --accent: #0b63a5; --good: #14713b; --good-ground: #e2f3e8; --bad: #b3261e; --bad-ground: #fbe6e4;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ground: #15171a; --card: #1d2024; --ink: #e6e7e9; --quiet: #9aa2ac; --line: #30353b;
    --accent: #79b8f0; --good: #7fd6a0; --good-ground: #173324; --bad: #ffaaa2; --bad-ground: #43201d;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; padding: 2.5rem 1.25rem 4rem; max-width: 84rem;
  background: var(--ground); color: var(--ink);
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", sans-serif;
}
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .4rem; letter-spacing: -.01em; }
h2 { font-size: 1.4rem; margin: 3rem 0 .25rem; padding-top: 1rem; border-top: 1px solid var(--line); }
h3 { font-size: 1.05rem; margin: 0; font-weight: 600; }
p { margin: .3rem 0 .9rem; max-width: 46rem; overflow-wrap: anywhere; }
a { color: var(--accent); text-underline-offset: .15em; }
.quiet { color: var(--quiet); }
nav ul { list-style: none; display: flex; flex-wrap: wrap; gap: .4rem 1.2rem; padding: 0; margin: 1rem 0; }
.card {
  background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 1rem; margin: 1rem 0;
}
.card > header { display: flex; flex-wrap: wrap; align-items: baseline; gap: .3rem .8rem; margin-bottom: .8rem; }
.figures { display: grid; gap: .9rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 17rem), 1fr)); }
.gallery { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 13rem), 1fr)); }
.gallery .card { margin: 0; }
figure { margin: 0; min-width: 0; }
figure img { display: block; width: 100%; height: auto; border-radius: 5px; background: #000; }
figcaption { overflow-wrap: anywhere; font-size: .875rem; color: var(--quiet); margin-top: .35rem; }
.plots {
  display: grid; gap: 0 1rem; align-items: start;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 34rem), 1fr));
}
.plots > * { min-width: 0; }
.plot img { background: none; min-width: 30rem; max-width: 64rem; }
.plot figcaption { max-width: 46rem; }
.made { display: block; margin-top: .2rem; }
code { font-size: .92em; overflow-wrap: anywhere; }
details { margin: -.3rem 0 1rem; }
summary { cursor: pointer; color: var(--accent); font-size: .92rem; }
.cases { display: block; }
.cases dt { margin-top: .6rem; }
.problem { overflow-wrap: anywhere; }
.notes { max-width: 46rem; padding-left: 1.2rem; }
dl { display: flex; flex-wrap: wrap; gap: .5rem 1.8rem; margin: .9rem 0 0; }
dl div { min-width: 5rem; }
dt { font-size: .8rem; color: var(--quiet); }
dd { margin: 0; font-variant-numeric: tabular-nums; }
.verdict { font-size: .8rem; font-weight: 600; padding: .1rem .6rem; border-radius: 1rem; white-space: nowrap; }
.good { color: var(--good); background: var(--good-ground); }
.bad { color: var(--bad); background: var(--bad-ground); }
.scroll { overflow-x: auto; }
.scroll:focus-visible, a:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
table { border-collapse: collapse; width: 100%; font-size: .92rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--quiet); padding: .3rem 0; }
th, td { text-align: right; padding: .35rem .7rem; border-bottom: 1px solid var(--line); white-space: nowrap; }
th { font-weight: 600; color: var(--quiet); font-size: .82rem; }
th:first-child, td:first-child, th:nth-child(2), td:nth-child(2) { text-align: left; }
tbody th { font-size: inherit; color: inherit; font-weight: 400; }
)css";

std::string base64(std::string_view bytes) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? letters[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

/// A fraction of pixels; 100 % only if it is all of them.
std::string percent(Real fraction) {
    return fraction >= 1 ? "100 %" : fmt::format("{:.2f} %", std::floor(fraction * 1e4) / 1e2);
}

}  // namespace

std::string html(std::string_view text) {
    std::string escaped;
    for (const char c : printable(text, Keep::Lines)) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

std::string html_page(std::string_view title, std::string_view body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
        html(title), style, body);
}

std::string html_figures(const std::vector<PageFigure>& figures) {
    std::string text = "<div class=\"figures\">\n";
    for (const PageFigure& figure : figures) {
        const std::string image =
            fmt::format("<img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\" loading=\"lazy\">",
                        html(figure.source), html(figure.alt), figure.width, figure.height);
        const bool embedded = figure.source.starts_with("data:");
        text +=
            fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                        embedded ? image : fmt::format("<a href=\"{}\">{}</a>", html(figure.source), image),
                        html(figure.caption));
    }
    return text + "</div>\n";
}

std::string html_facts(const std::vector<std::pair<std::string, std::string>>& facts) {
    std::string text = "<dl>\n";
    for (const auto& [name, value] : facts)
        text += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", html(name), html(value));
    return text + "</dl>\n";
}

std::string html_verdict(bool passed, std::string_view word) {
    return fmt::format("<span class=\"verdict {}\">{}</span>", passed ? "good" : "bad", html(word));
}

std::string data_url(const Image& image) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / fmt::format("course-page-{}.png", ::getpid());
    write_image(file, image, Encoding::Srgb);
    const std::string bytes = read_file(file);
    std::filesystem::remove(file);
    return "data:image/png;base64," + base64(bytes);
}

Real visible_gain(const Comparison& comparison) {
    // A typical difference then becomes a middle grey, and a few large ones do not hide it.
    if (comparison.rmse <= 0) return 1;
    return std::clamp(std::exp2(std::floor(std::log2(0.25 / comparison.rmse))), Real(1), Real(4096));
}

std::string comparison_page(const Image& image, const Image& reference, const Comparison& comparison,
                            std::string_view image_name, std::string_view reference_name) {
    const Real gain = visible_gain(comparison);
    const bool same = comparison.max == 0;
    const auto figure = [&](const Image& picture, std::string alt, std::string caption) {
        return PageFigure{data_url(picture), std::move(alt), std::move(caption), picture.width,
                          picture.height};
    };
    const std::string body = fmt::format(
        "<h1>Two pictures compared</h1>\n<p class=\"quiet\">{} against {}</p>\n"
        "<article class=\"card\">\n<header><h2 hidden>Pictures</h2>{}</header>\n{}{}</article>\n",
        html(image_name), html(reference_name),
        html_verdict(comparison.within[1] >= 0.999, same                            ? "the same"
                                                    : comparison.within[1] >= 0.999 ? "looks the same"
                                                                                    : "differs"),
        html_figures(
            {figure(image, fmt::format("The picture {}.", image_name), std::string(image_name)),
             figure(reference, fmt::format("The reference {}.", reference_name), std::string(reference_name)),
             figure(difference(image, reference, gain),
                    "The absolute difference of the two pictures, amplified.",
                    fmt::format("difference × {}", gain))}),
        html_facts({{"size", fmt::format("{} × {}", comparison.width, comparison.height)},
                    {"greatest difference", fmt::format("{:.6f}", comparison.max)},
                    {"at pixel", fmt::format("{}, {}", comparison.worst_x, comparison.worst_y)},
                    {"mean", fmt::format("{:.3g}", comparison.mean)},
                    {"RMSE", fmt::format("{:.3g}", comparison.rmse)},
                    {"PSNR", same ? "∞" : fmt::format("{:.1f} dB", comparison.psnr)},
                    {"pixels within 1/255", percent(comparison.within[1])},
                    {"within 2/255", percent(comparison.within[2])},
                    {"within 10/255", percent(comparison.within[10])},
                    {"within 2/65535", percent(comparison.within16[2])}}));
    return html_page(fmt::format("{} against {}", image_name, reference_name), body);
}

}  // namespace rt
