// What the programs that draw the lessons' figures have in common: fonts, axes, rows of pictures, numbers,
// their main.
#pragma once

#include "common/image/file.hpp"
#include "common/image/svg.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace rt::figures {

using namespace svg_color;
using Path = std::filesystem::path;

// Words and dots ----------------------------------------------------------------------------------------

inline const SvgFont note{.size = 14, .color = grey};
inline const SvgFont small{.size = 13};
inline const SvgFont heading{.size = 17, .anchor = "middle", .bold = true};

inline SvgFont colored(SvgFont font, const char* color) {
    font.color = color;
    return font;
}
inline SvgFont anchored(SvgFont font, const char* anchor) {
    font.anchor = anchor;
    return font;
}
inline SvgFont middle(SvgFont font) { return anchored(std::move(font), "middle"); }

inline void dot_at(Svg& svg, Vec2 at, const char* color = ink, Real radius = 3.5) {
    circle(svg, at, radius, {.stroke = "none", .fill = color});
}

// Plots -------------------------------------------------------------------------------------------------

/// An axis on which equal factors, or equal differences, are equally long.
struct Axis {
    Real low, high;
    bool logarithmic = false;
    Real share(Real value) const {
        return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    }
};

struct Plot {
    Vec2 corner, size;  ///< top left, pixels
    Axis x, y;
    Vec2 place(Real a, Real b) const { return corner + Vec2(x.share(a) * size.x, (1 - y.share(b)) * size.y); }
};

/// Values along an axis, and the words beside them.
using Ticks = std::vector<std::pair<Real, std::string>>;

/// The powers of ten from 10^first to 10^last.
inline Ticks decades(int first, int last) {
    const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    Ticks ticks;
    for (int k = first; k <= last; ++k) {
        std::string power = k < 0 ? "10⁻" : "10";
        for (const char digit : std::to_string(std::abs(k))) power += digits[digit - '0'];
        ticks.emplace_back(std::pow(10.0, k), k == 0 ? "1" : k == 1 ? "10" : power);
    }
    return ticks;
}

inline void draw_axes(Svg& svg, const Plot& plot, const Ticks& xs, const Ticks& ys) {
    for (const auto& [value, words] : ys) {
        line(svg, plot.place(plot.x.low, value), plot.place(plot.x.high, value),
             {.stroke = light, .width = 1});
        text(svg, plot.place(plot.x.low, value) + Vec2(-8, 5), words, anchored(small, "end"));
    }
    for (const auto& [value, words] : xs) {
        line(svg, plot.place(value, plot.y.low), plot.place(value, plot.y.low) + Vec2(0, 5), {.width = 1});
        text(svg, plot.place(value, plot.y.low) + Vec2(0, 20), words, middle(small));
    }
    line(svg, plot.corner, plot.corner + Vec2(0, plot.size.y));
    line(svg, plot.corner + Vec2(0, plot.size.y), plot.corner + plot.size);
}

// Pictures ----------------------------------------------------------------------------------------------

/// Pictures of one size beside each other, in rows, with white between them.
inline Image in_rows(const std::vector<Image>& images, int columns, int gap = 6) {
    const int width = images[0].width, height = images[0].height;
    const int rows = (static_cast<int>(images.size()) + columns - 1) / columns;
    Image all = make_image(columns * (width + gap) - gap, rows * (height + gap) - gap);
    for (Vec3& p : all.pixels) p = Vec3(1);
    for (int i = 0; i < static_cast<int>(images.size()); ++i)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                pixel(all, i % columns * (width + gap) + x, i / columns * (height + gap) + y) =
                    pixel(images[static_cast<std::size_t>(i)], x, y);
    return all;
}

/// The scene NAME.scene beside the program `source`, its __FILE__; in its own size if none is given.
inline Scene scene_beside(const char* source, const std::string& name, int width = 0, int height = 0) {
    Scene scene = parse_scene(Path(source).parent_path() / (name + ".scene"));
    if (width > 0) scene.width = width, scene.height = height;
    return scene;
}

/// The scenes beside `source` as a display shows them.
inline void draw_scenes(const Path& directory, const char* source, std::initializer_list<const char*> names,
                        int width = 0, int height = 0) {
    for (const char* name : names) {
        const Scene scene = scene_beside(source, name, width, height);
        write_image(directory / (std::string(name) + ".png"), render(compile(scene)).image, scene.encoding);
    }
}

// Numbers -----------------------------------------------------------------------------------------------

/// The numbers of a lesson that stand in no other table: numbers.csv, a name and a value a line.
struct Numbers {
    std::string csv = "name,value\n";

    /// A value that needs rounding comes as text. A name with a comma is put into quotes.
    template <class Value>
    void add(const std::string& name, const Value& value) {
        const char* quote = name.find(',') == std::string::npos ? "" : "\"";
        csv += fmt::format("{0}{1}{0},{2}\n", quote, name, value);
    }

    void write(const Path& directory) const { write_file(directory / "numbers.csv", csv); }
};

/// What main does: draws into the directory that is the only argument. Returns the exit status, 2 for a wrong
/// command line or scene.
inline int draw_figures(int argc, char** argv, void (*draw)(const Path&)) {
    if (argc != 2) {
        std::cerr << "usage: " << Path(argv[0]).filename().string() << " DIRECTORY\n";
        return 2;
    }
    try {
        draw(argv[1]);
    } catch (const InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
    return 0;
}

}  // namespace rt::figures
