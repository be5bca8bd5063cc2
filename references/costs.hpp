// What searches cost, as curves and as colours: what the figures about accelerators share.
#pragma once

#include "common/world/search.hpp"
#include "references/figures.hpp"

#include <array>
#include <ctime>
#include <functional>

namespace rt::figures {

/// Words that can be read when the figure is shown at half its size.
inline const SvgFont label{.size = 15};
inline const SvgFont remark{.size = 15, .color = "#666666"};

// Curves ------------------------------------------------------------------------------------------------

/// Lines and words at the powers of ten, and what the axes show.
inline void draw_axes(Svg& svg, const Plot& plot, const std::string& x_words, const std::string& y_words) {
    const auto ticks = [](const Axis& axis) {
        return decades(static_cast<int>(std::ceil(std::log10(axis.low))),
                       static_cast<int>(std::floor(std::log10(axis.high))));
    };
    draw_axes(svg, plot, ticks(plot.x), ticks(plot.y));
    text(svg, plot.corner + Vec2(plot.size.x / 2, plot.size.y + 42), x_words, middle(SvgFont{.size = 16}));
    text(svg, plot.corner + Vec2(0, -12), y_words, {.size = 16});
}

inline void draw_curve(Svg& svg, const Plot& plot, const std::vector<Vec2>& curve, const char* color,
                       const std::string& dash = "") {
    std::vector<Vec2> places;
    for (const Vec2& p : curve) places.push_back(plot.place(p.x, p.y));
    polyline(svg, places, {.stroke = color, .width = 2.2, .dash = dash});
    for (const Vec2& p : places) dot_at(svg, p, color, 3.2);
}

/// Slope of the straight line through log y over log x, by least squares.
inline Real exponent(const std::vector<Vec2>& curve) {
    Real mx = 0, my = 0, xx = 0, xy = 0;
    for (const Vec2& p : curve) mx += std::log(p.x), my += std::log(p.y);
    mx /= static_cast<Real>(curve.size()), my /= static_cast<Real>(curve.size());
    for (const Vec2& p : curve) {
        const Real dx = std::log(p.x) - mx;
        xx += dx * dx, xy += dx * (std::log(p.y) - my);
    }
    return xy / xx;
}

// Colours of counts -----------------------------------------------------------------------------------------

/// Colours for counts: 1, 2, 5, 10, 20, 50, ... and what is below.
inline constexpr std::array<const char*, 16> heat_colors{
    "#ffffff", "#f4f1d6", "#fbe6a2", "#fdd379", "#fdb75f", "#f9934e", "#ee6a45", "#d94a4a",
    "#bd3356", "#9a2a63", "#77256a", "#572069", "#3b1a60", "#24144f", "#130e38", "#050414"};

inline std::size_t heat_class(Real count) {
    constexpr std::array<Real, 15> bounds{1,   2,    5,    10,   20,     50,     100,   200,
                                          500, 1000, 2000, 5000, 10'000, 20'000, 50'000};
    std::size_t i = 0;
    while (i < bounds.size() && count >= bounds[i]) ++i;
    return i;
}

inline Vec3 heat(Real count) {
    const std::string hex = heat_colors[heat_class(count)];
    Vec3 color;
    for (int i = 0; i < 3; ++i)
        color[i] = decode(std::stoi(hex.substr(1 + 2 * static_cast<std::size_t>(i), 2), nullptr, 16) / 255.0,
                          Encoding::Srgb);
    return color;
}

inline void draw_heat_scale(const Path& directory) {
    Svg svg{.width = 700, .height = 52};
    const std::array<const char*, 16> words{"0",   "1",   "2",  "5",  "10", "20",  "50",  "100",
                                            "200", "500", "1k", "2k", "5k", "10k", "20k", "50k"};
    for (std::size_t i = 0; i < 16; ++i) {
        const Vec2 corner(14 + 42 * static_cast<Real>(i), 6);
        rectangle(svg, corner, {42, 20}, {.stroke = grey, .width = 0.5, .fill = heat_colors[i]});
        text(svg, corner + Vec2(i == 0 ? 21 : 0, 38), words[i], middle(SvgFont{.size = 16}));
    }
    write_svg(directory / "heat_scale.svg", svg);
}

// What there is to count ------------------------------------------------------------------------------------

/// The shapes of one kind in the world, without those of its meshes.
template <class Shape>
std::vector<Shape> shapes_of(const World& world) {
    for (const AnyGroup& group : world.groups)
        if (const auto* found = std::get_if<Group<Shape>>(&group)) return found->shapes;
    return {};
}

/// What one ray costs.
template <class OneAccelerator, class Shape>
SearchCounts cost(const OneAccelerator& accelerator, const std::vector<Shape>& shapes, const Ray& ray,
                  Mailbox& mailbox) {
    const SearchCounts before = search_counts();
    closest_hit(accelerator, shapes, ray, {0, infinity}, mailbox);
    const SearchCounts after = search_counts();
    return {after.cells - before.cells, after.shapes - before.shapes};
}

/// Seconds of the processor that the work takes, the least of three times: other programs can only make it
/// longer.
inline double seconds_of(const std::function<void()>& work) {
    double least = infinity;
    for (int i = 0; i < 3; ++i) {
        const std::clock_t start = std::clock();
        work();
        least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return least;
}

}  // namespace rt::figures
