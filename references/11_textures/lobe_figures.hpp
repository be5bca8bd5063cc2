// What the lobes of chapter 11 return of even light and whether their samples are as dense as they say, as
// tables; how they look cut open, and as balls in a white furnace.
#pragma once

#include "chapters/07_recursion/optics.hpp"
#include "chapters/11_textures/lobes.hpp"
#include "references/figures.hpp"
#include "references/panels.hpp"
#include "tests/stability/lobe_charts.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

namespace rt::figures {

/// A lobe and what a table says of it.
struct NamedLobe {
    const char* name;
    const char* letter;  ///< of the value: α, σ, or the colour of a coat's ground
    Real value;
    Lobe lobe;
};

inline NamedLobe matte(Real sigma) { return {"matte", "σ", sigma, Matte{Vec3(1), sigma}}; }
inline NamedLobe velvet(Real sigma) { return {"velvet", "σ", sigma, Velvet{Vec3(1), sigma}}; }
inline NamedLobe metal(Real alpha) { return {"metal", "α", alpha, RoughMetal{Vec3(1), std::sqrt(alpha)}}; }
inline NamedLobe glass(Real alpha) {
    return {"glass", "α", alpha, RoughGlass{Vec3(1), std::sqrt(alpha), 1.5}};
}
inline NamedLobe coated(Real color) { return {"coated", "color", color, Coated{Vec3(color), 1.5}}; }

/// Charts that hold all light of the lobe, on which it is nearly even.
inline std::vector<test::Chart> charts_of(const Lobe& lobe, const Vec3& v) {
    if (const auto* metal = std::get_if<RoughMetal>(&lobe))
        return {test::mirrored_by_facets(ggx_alpha(metal->roughness), v)};
    if (const auto* velvet = std::get_if<Velvet>(&lobe))
        return {test::mirrored_by_facets(1 / velvet_spread(*velvet), v)};
    if (const auto* glass = std::get_if<RoughGlass>(&lobe)) {
        const Real width = ggx_alpha(glass->roughness), n_v = v.z > 0 ? 1 : glass->ior;
        return {test::mirrored_by_facets(width, v),
                test::bent_by_facets(width, v, n_v, 1 + glass->ior - n_v)};
    }
    return {test::dome()};
}

/// What v gets of even light of radiance 1, without a coat's mirror: the midpoint rule on n × n cells a
/// chart.
inline Real returned(const Lobe& lobe, const Vec3& v, int n) {
    Real sum = 0;
    for (const test::Chart& chart : charts_of(lobe, v))
        sum +=
            test::sum_over(chart, n, [&](const Vec3& l) { return evaluate(lobe, l, v).x * std::abs(l.z); });
    return sum;
}

/// The furnace of every lobe against the viewer's cosine, which is negative in glass, and by how much a rule
/// of a quarter of the cells differs.
inline std::string furnaces() {
    std::vector<NamedLobe> lobes;
    for (const Real sigma : {0.0, 0.5, 1.0}) lobes.push_back(matte(sigma));
    for (const Real sigma : {0.1, 0.3, 0.5, 1.0}) lobes.push_back(velvet(sigma));
    for (const Real alpha : {1e-4, 1e-3, 0.01, 0.09, 0.25, 0.5, 1.0}) lobes.push_back(metal(alpha));
    for (const Real alpha : {1e-4, 0.01, 0.09, 0.25, 1.0}) lobes.push_back(glass(alpha));
    for (const Real color : {1.0, 0.5}) lobes.push_back(coated(color));
    std::string text = "lobe,value,cosine,returned,coarser_rule_differs_by\n";
    const auto add = [&](const NamedLobe& one, Real cosine) {
        const Real side = cosine > 0 ? 1 : -1;
        const Vec3 v = side * test::at_cosine(std::abs(cosine), 25);
        const Real sum = returned(one.lobe, v, 192);
        text += fmt::format("{},{},{},{:.4f},{:.1e}\n", one.name, one.value, cosine, sum,
                            std::abs(sum - returned(one.lobe, v, 96)));
    };
    for (const NamedLobe& one : lobes)
        for (const Real cosine : {1.0, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0.05}) {
            add(one, cosine);
            if (std::holds_alternative<RoughGlass>(one.lobe)) add(one, -cosine);
        }
    return text;
}

/// The same at three cosines, as the lesson shows it: a line a lobe.
inline std::string furnace_table() {
    std::string text = "lobe,cosine 1,cosine 0.5,cosine 0.1\n";
    const std::vector<NamedLobe> lobes{matte(1),  metal(1e-4), metal(0.09), metal(0.25),
                                       metal(1),  glass(0.25), glass(1),    velvet(0.5),
                                       velvet(1), coated(1),   coated(0.5)};
    for (const NamedLobe& one : lobes) {
        text += fmt::format("{} ({} = {})", one.name, one.letter, one.value);
        for (const Real cosine : {1.0, 0.5, 0.1})
            text += fmt::format(",{:.4f}", returned(one.lobe, test::at_cosine(cosine, 25), 192));
        text += '\n';
    }
    return text;
}

inline constexpr int lobe_samples = 20000;

/// Of samples of every lobe: calls `add(lobe, the viewer's degrees, report)`.
template <class Add>
void compare_all_samples(Add add_report) {
    const auto add = [&](const NamedLobe& one, Real degrees) {
        const Vec3 v = test::towards(degrees, 25);
        const auto* coated = std::get_if<Coated>(&one.lobe);
        add_report(
            one, degrees,
            test::compare_samples(
                charts_of(one.lobe, v), [&](const Vec3& numbers) { return sample(one.lobe, v, numbers); },
                [&](const Vec3& l) { return pdf(one.lobe, l, v); }, lobe_samples, 1118,
                coated ? fresnel(v.z, 1 / coated->ior) : 0));
    };
    std::vector<NamedLobe> lobes{matte(0), matte(1), velvet(0.2), velvet(0.5), velvet(1)};
    for (const Real alpha : {1e-4, 0.01, 0.25, 1.0}) lobes.push_back(metal(alpha));
    for (const Real alpha : {1e-4, 0.04, 0.36}) lobes.push_back(glass(alpha));
    lobes.push_back(coated(0.5));
    for (const NamedLobe& one : lobes) {
        for (const Real degrees : {0.0, 60.0, 85.0}) add(one, degrees);
        if (std::holds_alternative<RoughGlass>(one.lobe))
            for (const Real degrees : {105.0, 145.0, 180.0}) add(one, degrees);
    }
}

/// The greatest χ² of all, as a part of its limit.
inline Real worst_chi_square() {
    Real worst = 0;
    compare_all_samples([&](const NamedLobe&, Real, const test::SampleReport& report) {
        worst = std::max(worst, report.statistic / report.limit);
    });
    return worst;
}

/// Pearson's χ² of samples of every lobe, beside what right samples exceed once in ten million times.
inline std::string chi_squares() {
    std::string text = "lobe,value,viewer_degrees,samples,classes,chi_square,limit\n";
    compare_all_samples([&](const NamedLobe& one, Real degrees, const test::SampleReport& report) {
        text += fmt::format("{},{},{},{},{},{:.1f},{:.1f}\n", one.name, one.value, degrees, lobe_samples,
                            report.classes, report.statistic, report.limit);
    });
    return text;
}

/// Returned light against the viewer's cosine: facets on the left, the others on the right.
inline Svg furnace_curves() {
    Svg svg{720, 362};
    const auto panel = [&](Real left, const char* title,
                           const std::vector<std::pair<NamedLobe, SvgStyle>>& curves) {
        const Plot plot{{left, 40}, {270, 220}, {0, 1}, {0, 1.05}};
        draw_axes(svg, plot, {{0, "0"}, {0.5, "½"}, {1, "1"}}, {{0, "0"}, {0.5, "½"}, {1, "1"}});
        text(svg, {left + 135, 24}, title, heading);
        text(svg, {left + 135, 302}, "cosine of the viewer's angle", middle(note));
        for (const auto& [one, style] : curves) {
            std::vector<Vec2> points;
            for (int i = 1; i <= 40; ++i)
                points.push_back(
                    plot.place(i / 40.0, returned(one.lobe, test::at_cosine(i / 40.0, 25), 128)));
            polyline(svg, points, style);
        }
    };
    panel(50, "metal (lines) and glass (dashes)",
          {{metal(0.01), {.stroke = blue, .width = 2}},
           {metal(0.25), {.stroke = green, .width = 2}},
           {metal(0.5), {.stroke = orange, .width = 2}},
           {metal(1), {.stroke = red, .width = 2}},
           {glass(0.25), {.stroke = green, .width = 2, .dash = "6 4"}},
           {glass(1), {.stroke = red, .width = 2, .dash = "6 4"}}});
    panel(410, "matte, velvet, coated",
          {{matte(1), {.stroke = blue, .width = 2}},
           {coated(1), {.stroke = purple, .width = 2}},
           {coated(0.5), {.stroke = purple, .width = 2, .dash = "6 4"}},
           {velvet(1), {.stroke = orange, .width = 2}},
           {velvet(0.5), {.stroke = red, .width = 2}}});
    const auto word = [&](Real x, Real y, const char* words, const char* color) {
        text(svg, {x, y}, words, colored(SvgFont{.size = 17}, color));
    };
    word(60, 328, "α = 0.01", blue), word(150, 328, "0.25", green), word(210, 328, "0.5", orange);
    word(260, 328, "1", red);
    word(400, 328, "matte σ = 1", blue), word(520, 328, "velvet σ = 1", orange), word(640, 328, "½", red);
    word(400, 350, "paint of color 1, and ½ (dashes)", purple);
    return svg;
}

/// f·|cos| to a viewer at 45° against the light's direction, all in one plane, each as large as it fits.
inline Svg lobes_cut_open() {
    Svg svg{900, 300};
    const Vec3 v = test::towards(-45);
    const Real reach = 78;
    Real left = 0;
    const auto panel = [&](const char* title, const std::vector<std::pair<NamedLobe, const char*>>& lobes) {
        const Vec2 middle_point(left + 90, 140);
        text(svg, {left + 90, 24}, title, heading);
        line(svg, middle_point - Vec2(84, 0), middle_point + Vec2(84, 0), {.stroke = grey});
        arrow(svg, middle_point, middle_point + 84.0 * Vec2(v.x, -v.z), {.stroke = grey});
        Real below = 250;
        for (const auto& [one, color] : lobes) {
            std::vector<Vec2> way;
            Real most = 0;
            for (int i = -1440; i <= 1440; ++i) {
                const Vec3 l = test::towards(i / 8.0);
                const Real part = evaluate(one.lobe, l, v).x * std::abs(l.z);
                most = std::max(most, part);
                way.push_back(part * Vec2(l.x, -l.z));
            }
            std::vector<Vec2> points;  // a quarter of a pixel apart at least
            for (const Vec2& p : way) {
                const Vec2 at = middle_point + reach / most * p;
                if (points.empty() || length(at - points.back()) > 0.25) points.push_back(at);
            }
            polyline(svg, points, {.stroke = color, .width = 2});
            text(svg, {left + 90, below}, fmt::format("{} = {}: {:.3g}", one.letter, one.value, most),
                 colored(middle(SvgFont{.size = 17}), color));
            below += 22;
        }
        left += 180;
    };
    panel("matte", {{matte(0), blue}, {matte(1), red}});
    panel("metal", {{metal(0.04), blue}, {metal(0.25), red}});
    panel("glass", {{glass(0.04), blue}, {glass(0.25), red}});
    panel("velvet", {{velvet(1), blue}, {velvet(0.5), red}});
    panel("coated", {{coated(1), blue}});
    return svg;
}

/// Balls under an even sky that is as bright as what is behind them, seen from far away: what returns all
/// light is not seen. Metal of α = 0.01, 0.25 and 1, glass of α = 0.25; matte and velvet of σ = 1, white
/// paint without its coat's mirror, and with it.
inline Svg white_furnace() {
    const Vec3 sky(0.8);
    std::vector<Panel> panels;
    const auto add = [&](const NamedLobe& one, const std::string& words, bool with_mirror = false) {
        std::array<Real, 65> table{};  // between them it is linear
        for (std::size_t i = 0; i < table.size(); ++i) {
            const Real cosine = std::max(static_cast<Real>(i) / 64, 0.01);
            table[i] = returned(one.lobe, test::at_cosine(cosine, 25), 96);
            if (with_mirror) table[i] += fresnel(cosine, 1 / std::get<Coated>(one.lobe).ior);
        }
        Image image = make_image(120, 120);
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 120; ++x) {
                const Vec2 at((x - 59.5) / 54, (59.5 - y) / 54);
                pixel(image, x, y) = sky;
                if (dot(at, at) >= 1) continue;
                const Real place = 64 * std::sqrt(1 - dot(at, at));
                const auto i = std::min(static_cast<std::size_t>(place), table.size() - 2);
                const Real rest = place - static_cast<Real>(i);
                pixel(image, x, y) *= (1 - rest) * table[i] + rest * table[i + 1];
            }
        panels.push_back({image, words});
    };
    for (const Real alpha : {0.01, 0.25, 1.0}) add(metal(alpha), fmt::format("metal {}", alpha));
    add(glass(0.25), "glass 0.25");
    add(matte(1), "clay"), add(velvet(1), "velvet"), add(coated(1), "paint");
    add(coated(1), "varnished", true);
    return side_by_side(panels, 4);
}

}  // namespace rt::figures
