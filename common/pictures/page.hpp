// Pieces of the HTML pages that the program writes: one style, light and dark, and pictures side by side.
#pragma once

#include "common/image/compare.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// Text as HTML shows it: &, <, > and quotes written as entities.
std::string html(std::string_view text);

/// A whole page: one file, nothing loaded from elsewhere, readable on a narrow screen and a wide one, in
/// light and in dark. `title` is plain text, `body` is HTML.
std::string html_page(std::string_view title, std::string_view body);

/// A picture with words below it. `source` is a link or a data URL, `alt` says what is to be seen.
struct PageFigure {
    std::string source;
    std::string alt;
    std::string caption;
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels
};

/// Figures in a row, each a link to its file (none for data URLs); below each other where it is narrow.
std::string html_figures(const std::vector<PageFigure>& figures);

/// Names and values as a description list.
std::string html_facts(const std::vector<std::pair<std::string, std::string>>& facts);

/// A verdict: a word that does not depend on colour to be understood, and a colour.
std::string html_verdict(bool passed, std::string_view word);

/// The image as a data URL: an 8-bit sRGB PNG.
std::string data_url(const Image& image);

/// A power of two that makes the difference of two images visible, at least 1.
Real visible_gain(const Comparison& comparison);

/// What `course compare --page` writes: both pictures and their difference, embedded, and the figures.
std::string comparison_page(const Image& image, const Image& reference, const Comparison& comparison,
                            std::string_view image_name, std::string_view reference_name);

}  // namespace rt
