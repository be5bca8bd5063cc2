// A small writer of SVG pictures, for the figures of the lessons and the plots of the reports.
// Coordinates are pixels, y down; numbers are rounded to 1/100 pixel, so that files are small and repeatable.
#pragma once

#include "common/math/vec.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace rt {

/// A drawing: opaque white, width × height pixels; each call adds a shape on top.
struct Svg {
    int width = 700;
    int height = 400;
    std::string body = {};  ///< the shapes so far
};

/// How a shape is drawn. Colours as SVG writes them (`#rrggbb`, `none`, a name).
struct SvgStyle {
    std::string stroke = "#333333";
    Real width = 1.5;  ///< of the stroke, pixels
    std::string fill = "none";
    std::string dash = "";  ///< lengths of dashes and gaps, such as "4 3"; empty is solid
    Real opacity = 1;       ///< of stroke and fill
};

/// How words are drawn. `at` of `text` is on the base line of the first letter.
struct SvgFont {
    Real size = 15;  ///< pixels
    std::string color = "#222222";
    std::string anchor = "start";  ///< which end is at the point: start, middle or end
    bool italic = false;
    bool bold = false;
    Real turn = 0;  ///< degrees, clockwise around the point
};

/// Colours that read on white and are told apart by most eyes (Okabe & Ito 2008).
namespace svg_color {
inline constexpr const char* ink = "#222222";
inline constexpr const char* grey = "#8a8a8a";
inline constexpr const char* light = "#e4e4e4";
inline constexpr const char* blue = "#0072b2";
inline constexpr const char* sky = "#56b4e9";
inline constexpr const char* green = "#009e73";
inline constexpr const char* orange = "#e69f00";
inline constexpr const char* red = "#d55e00";
inline constexpr const char* purple = "#cc79a7";
}  // namespace svg_color

void line(Svg& svg, Vec2 from, Vec2 to, const SvgStyle& style = {});

/// A line with a filled head at `to`, `head` pixels long and never longer than the line.
void arrow(Svg& svg, Vec2 from, Vec2 to, const SvgStyle& style = {}, Real head = 9);

void circle(Svg& svg, Vec2 center, Real radius, const SvgStyle& style = {});

/// Upright rectangle with its top left corner at `corner`.
void rectangle(Svg& svg, Vec2 corner, Vec2 size, const SvgStyle& style = {});

/// Closed, and filled by the even-odd rule.
void polygon(Svg& svg, std::span<const Vec2> points, const SvgStyle& style = {});

/// Open; its corners are round.
void polyline(Svg& svg, std::span<const Vec2> points, const SvgStyle& style = {});

/// Arc of a circle from the angle `from` to `to`, radians, counterclockwise as seen; less than a full turn.
void arc(Svg& svg, Vec2 center, Real radius, Real from, Real to, const SvgStyle& style = {});

/// One line of words; `words` is plain UTF-8, escaped here.
void text(Svg& svg, Vec2 at, std::string_view words, const SvgFont& font = {});

/// The whole file.
std::string to_string(const Svg& svg);

/// Writes the file whole (see write_file).
void write_svg(const std::filesystem::path& path, const Svg& svg);

/// `value` rounded to `decimals` digits after the point, without trailing zeros; never "-0".
std::string decimal(Real value, int decimals = 2);

}  // namespace rt
