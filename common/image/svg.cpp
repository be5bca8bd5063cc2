// A small writer of SVG pictures.
// Numbers go through to_chars, so that no locale changes the files.
#include "common/image/svg.hpp"

#include "common/image/file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace rt {

namespace {

std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}

std::string attribute(std::string_view name, Real value) { return attribute(name, decimal(value)); }

std::string attributes(const SvgStyle& style) {
    std::string result = attribute("stroke", style.stroke) + attribute("fill", style.fill);
    if (style.stroke != "none") result += attribute("stroke-width", style.width);
    if (!style.dash.empty()) result += attribute("stroke-dasharray", style.dash);
    if (style.opacity < 1) result += attribute("opacity", style.opacity);
    return result;
}

std::string attributes(std::span<const Vec2> points, const SvgStyle& style) {
    std::string list;
    for (const Vec2& point : points) {
        if (!list.empty()) list += ' ';
        list += decimal(point.x) + "," + decimal(point.y);
    }
    return attribute("points", list) + attributes(style);
}

void element(Svg& svg, std::string_view name, std::string_view attributes) {
    svg.body += "<" + std::string(name) + std::string(attributes) + "/>\n";
}

std::string escaped(std::string_view words) {
    std::string result;
    for (const char c : words) {
        if (c == '&') {
            result += "&amp;";
        } else if (c == '<') {
            result += "&lt;";
        } else if (c == '>') {
            result += "&gt;";
        } else {
            result += c;
        }
    }
    return result;
}

}  // namespace

std::string decimal(Real value, int decimals) {
    std::array<char, 400> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                            std::chars_format::fixed, decimals);
    std::string result(digits.data(), end);
    if (result.find('.') != std::string::npos) {
        result.erase(result.find_last_not_of('0') + 1);
        if (result.back() == '.') result.pop_back();
    }
    return result == "-0" ? "0" : result;
}

void line(Svg& svg, Vec2 from, Vec2 to, const SvgStyle& style) {
    element(svg, "line",
            attribute("x1", from.x) + attribute("y1", from.y) + attribute("x2", to.x) +
                attribute("y2", to.y) + attributes(style));
}

void arrow(Svg& svg, Vec2 from, Vec2 to, const SvgStyle& style, Real head) {
    const Vec2 along = to - from;
    const Real length = glm::length(along);
    if (length == 0) return;
    const Vec2 unit = along / length;
    const Vec2 side(-unit.y, unit.x);
    const Real size = std::min(head, length);
    const Vec2 neck = to - size * unit;
    // The line stops inside the head, so that its blunt end does not stick out of the point.
    line(svg, from, neck + 0.2 * size * unit, style);
    const std::array<Vec2, 3> tip{to, neck + 0.38 * size * side, neck - 0.38 * size * side};
    polygon(svg, tip, {.stroke = "none", .fill = style.stroke, .opacity = style.opacity});
}

void circle(Svg& svg, Vec2 center, Real radius, const SvgStyle& style) {
    element(
        svg, "circle",
        attribute("cx", center.x) + attribute("cy", center.y) + attribute("r", radius) + attributes(style));
}

void rectangle(Svg& svg, Vec2 corner, Vec2 size, const SvgStyle& style) {
    element(svg, "rect",
            attribute("x", corner.x) + attribute("y", corner.y) + attribute("width", size.x) +
                attribute("height", size.y) + attributes(style));
}

void polygon(Svg& svg, std::span<const Vec2> points, const SvgStyle& style) {
    element(svg, "polygon", attributes(points, style) + attribute("fill-rule", "evenodd"));
}

void polyline(Svg& svg, std::span<const Vec2> points, const SvgStyle& style) {
    element(svg, "polyline", attributes(points, style) + attribute("stroke-linejoin", "round"));
}

void arc(Svg& svg, Vec2 center, Real radius, Real from, Real to, const SvgStyle& style) {
    const Vec2 start = center + radius * Vec2(std::cos(from), -std::sin(from));
    const Vec2 end = center + radius * Vec2(std::cos(to), -std::sin(to));
    const bool large = to - from > pi;
    element(svg, "path",
            attribute("d", "M" + decimal(start.x) + " " + decimal(start.y) + "A" + decimal(radius) + " " +
                               decimal(radius) + " 0 " + (large ? "1" : "0") + " 0 " + decimal(end.x) + " " +
                               decimal(end.y)) +
                attributes(style));
}

void text(Svg& svg, Vec2 at, std::string_view words, const SvgFont& font) {
    std::string result = attribute("x", at.x) + attribute("y", at.y) + attribute("font-size", font.size) +
                         attribute("fill", font.color);
    if (font.anchor != "start") result += attribute("text-anchor", font.anchor);
    if (font.italic) result += attribute("font-style", "italic");
    if (font.bold) result += attribute("font-weight", "bold");
    if (font.turn != 0) {
        result += attribute("transform",
                            "rotate(" + decimal(font.turn) + " " + decimal(at.x) + " " + decimal(at.y) + ")");
    }
    svg.body += "<text" + result + ">" + escaped(words) + "</text>\n";
}

std::string to_string(const Svg& svg) {
    const std::string width = std::to_string(svg.width), height = std::to_string(svg.height);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height +
           "\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n" + "<rect width=\"" + width +
           "\" height=\"" + height + "\" fill=\"#ffffff\"/>\n" + svg.body + "</svg>\n";
}

void write_svg(const std::filesystem::path& path, const Svg& svg) { write_file(path, to_string(svg)); }

}  // namespace rt
