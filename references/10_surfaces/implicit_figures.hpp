// Figures of chapter 10 about implicit surfaces: pieces of a line, spheres along one, and error against time.
#pragma once

#include "chapters/10_surfaces/implicit.hpp"
#include "chapters/10_surfaces/sphere_tracing.hpp"
#include "common/scene/evaluate.hpp"
#include "references/figures.hpp"
#include "references/panels.hpp"
#include "tests/stability/implicits.hpp"
#include "tests/support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rt::figures {

/// The worked example: f on a chord, and what is certain of it on each piece that is looked at.
inline Svg pieces() {
    Svg svg{.width = 720, .height = 440, .body = {}};
    const Implicit example = stability::surface_of("x^2-x+2/9", 2);
    const ImplicitLine line_of_it{example.f, {Vec3(0), Vec3(1, 0, 0), 0, 1}};
    const auto f = [&](Real x) { return value_at(*example.f, Vec3(x, 0, 0)); };
    const Plot plot{{80, 30}, {600, 280}, {0, 1}, {-0.55, 0.5}};
    const auto show_piece = [&](Piece piece, const char* color, int row) {
        const Certain certain = enclose(line_of_it, piece);
        const Vec2 a = plot.place(piece.low, certain.value.high),
                   b = plot.place(piece.high, certain.value.low);
        rectangle(svg, a, b - a, {.stroke = color, .width = 1.5, .dash = row < 0 ? "4 4" : ""});
    };
    for (const Piece divided : {Piece{0, 1}, Piece{0, 0.5}, Piece{0.25, 0.5}}) show_piece(divided, grey, -1);
    show_piece({0, 0.25}, green, 0);
    show_piece({0.25, 0.375}, orange, 0);
    line(svg, plot.place(0, 0), plot.place(1, 0), {.stroke = ink, .width = 1.2});
    std::vector<Vec2> curve;
    for (int i = 0; i <= 100; ++i) curve.push_back(plot.place(i / 100.0, f(i / 100.0)));
    polyline(svg, curve, {.stroke = blue, .width = 2.5});
    for (const auto& [x, words] : Ticks{{0, "0"}, {0.25, "¼"}, {0.375, "⅜"}, {0.5, "½"}, {1, "1"}}) {
        line(svg, plot.place(x, -0.55), plot.place(x, -0.55) + Vec2(0, 6), {.width = 1});
        text(svg, plot.place(x, -0.55) + Vec2(0, 24), words, middle(small));
    }
    line(svg, plot.place(0, -0.55), plot.place(1, -0.55), {.stroke = grey, .width = 1.2});
    dot_at(svg, plot.place(1.0 / 3, 0), ink, 5);
    text(svg, plot.place(1, 0) + Vec2(4, 5), "f = 0", colored(small, ink));
    text(svg, plot.place(0.9, f(0.9)) + Vec2(-14, -4), "f",
         {.size = 17, .color = blue, .anchor = "end", .italic = true});
    text(svg, {90, 385}, "dashed: nothing is certain, so the piece is divided", colored(small, grey));
    text(svg, {90, 405}, "green: the slope has a sign, and f is positive at both ends",
         colored(small, green));
    text(svg, {90, 425}, "orange: here f goes below 0", colored(small, orange));
    return svg;
}

/// Steps of sphere tracing in the plane, past one disc and onto another.
inline Svg sphere_steps() {
    Svg svg{.width = 720, .height = 330, .body = {}};
    const Vec2 centers[] = {{3.1, 1.05}, {6.1, -0.25}};
    const Real radii[] = {0.9, 0.85};
    const auto at = [](Vec2 p) { return Vec2(30 + 92 * p.x, 190 - 92 * p.y); };
    const auto distance = [&](Vec2 p) {
        return std::min(glm::length(p - centers[0]) - radii[0], glm::length(p - centers[1]) - radii[1]);
    };
    for (int i = 0; i < 2; ++i)
        circle(svg, at(centers[i]), 92 * radii[i], {.stroke = ink, .width = 2, .fill = "#eef3f7"});
    const Vec2 start(1.1, 0), end(7.2, 0);
    arrow(svg, at(start), at(end), {.stroke = grey, .width = 1.5});
    Vec2 p = start;
    for (int i = 0; i < 40 && distance(p) > 0.004; ++i) {
        circle(svg, at(p), 92 * distance(p), {.stroke = blue, .width = 1.2});
        dot_at(svg, at(p), blue, 3);
        p.x += distance(p);
    }
    dot_at(svg, at(p), orange, 5);
    text(svg, at(start) + Vec2(-4, -8), "o", {.size = 17, .italic = true});
    return svg;
}

// ------------------------------------------------------------------------------------ error against time

/// The method whose answers the others' are measured against.
constexpr const char* reference_method = "intervals";

struct ImplicitMethod {
    std::string name, surface, setting;
    std::function<std::optional<Hit>(const Ray&)> ask;
    Real microseconds = 0, error = 0;
    int wrong = 0;
};

/// Rays towards a surface, many of them towards the heart's cleft and its tip.
inline std::vector<Ray> rays_towards(const Implicit& surface, int count) {
    test::Random random(1090);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const Vec3 tip(0, 0, random.sign());
        const Vec3 target = i % 4 == 0 ? tip + random.magnitude(-3, -0.5) * random.in_cube()
                                       : surface.box.high * random.in_cube();
        const Vec3 origin = target + 6.0 * random.direction();
        rays.push_back({origin, normalize(target - origin)});
    }
    return rays;
}

/// The three methods with their settings.
inline std::vector<ImplicitMethod> methods_for(const std::string& name, const Implicit& s, Real lipschitz) {
    constexpr Interval range{0, infinity};
    std::vector<ImplicitMethod> methods;
    for (const int steps : {10, 30, 100, 300, 1000, 3000})
        methods.push_back({"equal steps", name, std::to_string(steps),
                           [=](const Ray& ray) { return naive::march(s, ray, range, steps); }});
    for (const int digits : {1, 2, 3, 4, 6, 8})
        methods.push_back({"sphere tracing", name, fmt::format("1e-{}", digits), [=](const Ray& ray) {
                               return sphere_trace(s, lipschitz, ray, range, std::pow(10.0, -digits));
                           }});
    methods.push_back({reference_method, name, "", [=](const Ray& ray) { return intersect(s, ray, range); }});
    return methods;
}

/// Fills in what each method takes, and how wrong it is: how far from what the intervals answer, or 1 where
/// that is farther away or only one of both is a miss.
inline void measure(std::vector<ImplicitMethod>& methods, const Implicit& surface) {
    const std::vector<Ray> rays = rays_towards(surface, 4000);
    std::vector<std::optional<Hit>> truth;
    for (const Ray& ray : rays) truth.push_back(intersect(surface, ray, {0, infinity}));
    for (ImplicitMethod& method : methods) {
        std::vector<std::optional<Hit>> answers(rays.size());
        const std::clock_t start = std::clock();
        for (std::size_t i = 0; i < rays.size(); ++i) answers[i] = method.ask(rays[i]);
        method.microseconds =
            1e6 * static_cast<Real>(std::clock() - start) / (CLOCKS_PER_SEC * static_cast<Real>(rays.size()));
        for (std::size_t i = 0; i < rays.size(); ++i) {
            Real error = answers[i].has_value() == truth[i].has_value() ? 0 : 1;
            if (answers[i] && truth[i]) error = std::min(Real(1), std::abs(answers[i]->t - truth[i]->t));
            method.wrong += error > 0.01;
            method.error += error / static_cast<Real>(rays.size());
        }
    }
}

inline void error_against_time(const Path& directory) {
    const Implicit heart = stability::tight_heart();
    const Implicit ring = stability::surface_of("sqrt((sqrt(x^2+y^2)-1)^2+z^2)-1/4", 1.3);
    std::vector<ImplicitMethod> methods = methods_for("heart", heart, lipschitz_bound(heart));
    std::vector<ImplicitMethod> of_ring = methods_for("torus by its distance", ring, 1);
    measure(methods, heart);
    measure(of_ring, ring);
    methods.insert(methods.end(), of_ring.begin(), of_ring.end());
    std::string csv =
        "surface,method,steps or tolerance,microseconds a ray,of 4000 rays wrong by more than 0.01,mean "
        "error of t\n";
    for (const ImplicitMethod& m : methods) {
        csv += fmt::format("{},{},{},{:.1f},", m.surface, m.name, m.setting, m.microseconds);
        csv += m.name == reference_method ? ",\n" : fmt::format("{},{:.1e}\n", m.wrong, m.error);
    }
    write_file(directory / "measured_implicit.csv", csv);

    Svg svg{.width = 720, .height = 440, .body = {}};
    const Plot plot{{85, 40}, {600, 320}, {0.1, 1e4, true}, {1e-8, 1, true}};
    draw_axes(svg, plot,
              {{0.1, "0.1 µs"}, {1, "1 µs"}, {10, "10 µs"}, {100, "100 µs"}, {1000, "1 ms"}, {1e4, "10 ms"}},
              decades(-8, 0));
    const auto curve = [&](const char* name, const char* surface, const char* color, Vec2 beside,
                           const char* words) {
        std::vector<Vec2> points;
        for (const ImplicitMethod& m : methods)
            if (m.name == name && m.surface == surface) {
                points.push_back(plot.place(m.microseconds, std::max(m.error, 1e-8)));
                dot_at(svg, points.back(), color, 4);
            }
        polyline(svg, points,
                 {.stroke = color, .width = 2, .dash = surface == std::string("heart") ? "" : "5 4"});
        text(svg, points.back() + beside, words, colored(small, color));
    };
    curve("equal steps", "heart", red, {10, 5}, "equal steps, heart");
    curve("equal steps", "torus by its distance", red, {-160, -150}, "equal steps, torus");
    curve("sphere tracing", "heart", blue, {-170, 30}, "sphere tracing, heart");
    curve("sphere tracing", "torus by its distance", blue, {-52, -70}, "torus");
    curve("intervals", "heart", green, {10, -8}, "intervals, taken for the truth");
    curve("intervals", "torus by its distance", green, {10, -8}, "");
    text(svg, {385, 424}, "CPU time a ray", middle(small));
    text(svg, {24, 200}, "mean error of t; a miss counts as 1",
         {.size = 13, .anchor = "middle", .turn = -90});
    write_svg(directory / "measured_implicit.svg", svg);
}

/// How many pixels of the heart there are, and how many equal steps lose.
struct LostByStepping {
    int hits = 0, by_6 = 0, by_12 = 0;
};

/// The heart as a program sees it that takes six steps, or twelve, and by intervals: normals as colours.
inline LostByStepping draw_missed(const Path& out) {
    const Implicit heart = stability::surface_named("the heart");
    const auto look = [&](int& hits, const std::function<std::optional<Hit>(const Ray&)>& ask) {
        const int width = 220, height = 200;
        Image image = make_image(width, height);
        const Vec3 eye(2.2, -5.2, 1.6), w = normalize(eye), u = normalize(cross(Vec3(0, 0, 1), w)),
                                        v = cross(w, u);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Vec3 d =
                    (x + 0.5 - width / 2) / width * u + (height / 2 - y - 0.5) / width * v - 2.0 * w;
                const Ray ray{eye, normalize(d)};
                const std::optional<Hit> hit = ask(ray);
                hits += hit.has_value();
                pixel(image, x, y) =
                    hit ? 0.5 * (surface_at(heart, ray, *hit).normal + 1.0) : Vec3(0.02, 0.02, 0.03);
            }
        return image;
    };
    const Interval range{0, infinity};
    int all = 0, with_6 = 0, with_12 = 0;
    const Image six = look(with_6, [&](const Ray& ray) { return naive::march(heart, ray, range, 6); });
    const Image twelve = look(with_12, [&](const Ray& ray) { return naive::march(heart, ray, range, 12); });
    const Image right = look(all, [&](const Ray& ray) { return intersect(heart, ray, range); });
    write_svg(out / "missed.svg",
              side_by_side({{six, "6 steps"}, {twelve, "12 steps"}, {right, "by intervals"}}, 3));
    return {all, all - with_6, all - with_12};
}

inline LostByStepping draw_implicit(const Path& out) {
    write_svg(out / "pieces.svg", pieces());
    write_svg(out / "sphere_steps.svg", sphere_steps());
    error_against_time(out);
    return draw_missed(out);
}

}  // namespace rt::figures
