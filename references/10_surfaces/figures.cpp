// Figures of chapter 10: spans, what a line has to do with a cone and with a torus, cancellation, and what
// mistakes look like. Usage: figures_10 DIRECTORY
#include "references/figures.hpp"
#include "chapters/10_surfaces/box.hpp"
#include "chapters/10_surfaces/combination.hpp"
#include "chapters/10_surfaces/cone.hpp"
#include "chapters/10_surfaces/torus.hpp"
#include "common/render/combinations.hpp"
#include "references/10_surfaces/implicit_figures.hpp"
#include "references/panels.hpp"
#include "tests/oracle/solid.hpp"
#include "tests/oracle/torus.hpp"
#include "tests/stability/tori.hpp"
#include "tests/support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>

using namespace rt;
using rt::figures::Path;

namespace {

using namespace figures;

const SvgStyle solid{.stroke = ink, .width = 2, .fill = "#eef3f7"};
const SvgStyle dashed{.stroke = grey, .width = 1.2, .dash = "5 4"};
const SvgFont letter{.size = 17, .italic = true};

// --------------------------------------------------------------------------------------------- spans

/// The worked example: a ray through a rectangle, and below it the two slabs and what they have in common.
Svg spans() {
    Svg svg{.width = 780, .height = 470, .body = {}};
    const auto at = [](Real x, Real y) { return Vec2(190 + 130 * x, 165 - 110 * y); };
    const Ray ray{{-1, -1, 0}, {2, 1, 0}};
    for (const Real x : {1.0, 3.0})
        line(svg, at(x, 1.1), at(x, -1.3), {.stroke = blue, .width = 1.2, .dash = "5 4"});
    for (const Real y : {-0.5, 0.5})
        line(svg, at(-1.1, y), at(3.9, y), {.stroke = orange, .width = 1.2, .dash = "5 4"});
    rectangle(svg, at(1, 0.5), {2 * 130, 110}, solid);
    arrow(svg, at(-1, -1), at(3.2, 1.1), {.stroke = grey, .width = 2});
    line(svg, at(1, 0), at(2, 0.5), {.stroke = green, .width = 4});
    dot_at(svg, at(-1, -1), ink, 4.5);
    text(svg, at(-1, -1) + Vec2(-6, 24), "o", letter);
    const std::pair<Real, const char*> marks[] = {{0.5, orange}, {1, blue}, {1.5, orange}, {2, blue}};
    for (const auto& [t, color] : marks) {
        const Vec3 p = point_at(ray, t);
        dot_at(svg, at(p.x, p.y), color, 5);
        text(svg, at(p.x, p.y) + Vec2(-4, -12), fmt::format("{}", t),
             {.size = 14, .color = color, .anchor = "end"});
    }
    text(svg, at(1, -1.3) + Vec2(6, 4), "x = 1", colored(small, blue));
    text(svg, at(3, -1.3) + Vec2(6, 4), "x = 3", colored(small, blue));
    text(svg, at(3.9, -0.5) + Vec2(6, 4), "y = −½", colored(small, orange));
    text(svg, at(3.9, 0.5) + Vec2(6, 4), "y = ½", colored(small, orange));

    const auto along = [](Real t) { return 200 + 220 * t; };
    const auto bar = [&](Real y, Real from, Real to, const char* color, const char* words) {
        line(svg, {along(from), y}, {along(to), y}, {.stroke = color, .width = 9});
        text(svg, {180, y + 5}, words, {.size = 14, .color = color, .anchor = "end"});
    };
    bar(345, 1, 2, blue, "between the planes of x");
    bar(375, 0.5, 1.5, orange, "of y");
    bar(405, 1, 1.5, green, "in common");
    line(svg, {along(0), 430}, {along(2.3), 430}, {.stroke = grey, .width = 1.5});
    for (const Real t : {0.0, 0.5, 1.0, 1.5, 2.0}) {
        line(svg, {along(t), 425}, {along(t), 435}, {.stroke = grey, .width = 1.5});
        text(svg, {along(t), 453}, fmt::format("{}", t), middle(small));
    }
    text(svg, {along(2.3) + 8, 435}, "t", letter);
    return svg;
}

// ---------------------------------------------------------------------------------------------- cones

/// A cone from the side: its axis, its radii, its mirror image, and a line.
Svg cone() {
    Svg svg{.width = 700, .height = 400, .body = {}};
    const Vec2 a{250, 350}, b{250, 150}, apex{250, 70};
    const Real wide = 140, narrow = wide * (b.y - apex.y) / (a.y - apex.y);
    const Vec2 corners[] = {{a.x - wide, a.y}, {a.x + wide, a.y}, {b.x + narrow, b.y}, {b.x - narrow, b.y}};
    polygon(svg, corners, solid);
    for (const Real side : {-1.0, 1.0}) {
        line(svg, {b.x + side * narrow, b.y}, apex, dashed);
        line(svg, apex, {apex.x + side * 30, 10}, dashed);
    }
    text(svg, {apex.x + 40, 30}, "the mirror image", note);
    text(svg, {apex.x + 14, apex.y + 6}, "apex", note);
    arrow(svg, a, b, {.stroke = blue, .width = 3});
    text(svg, {a.x - 22, 250}, "u", colored(letter, blue));
    dot_at(svg, a, blue, 4.5);
    dot_at(svg, b, blue, 4.5);
    text(svg, {a.x - 6, a.y + 26}, "a, s = 0", middle(small));
    text(svg, {b.x - 34, b.y - 10}, "b, s = 1", anchored(small, "end"));
    line(svg, a + Vec2(0, 8), a + Vec2(wide, 8), {.stroke = green, .width = 2});
    text(svg, {a.x + wide / 2, a.y + 26}, "radius_a", colored(middle(small), green));
    line(svg, b - Vec2(0, 8), b + Vec2(narrow, -8), {.stroke = green, .width = 2});
    text(svg, {b.x + narrow + 8, b.y - 6}, "radius_b", colored(small, green));

    const Vec2 o{560, 330}, end{90, 180};
    arrow(svg, o, end, {.stroke = grey, .width = 2});
    arrow(svg, o, o + Real(0.19) * (end - o), {.stroke = ink, .width = 3});
    dot_at(svg, o, ink, 4.5);
    text(svg, o + Vec2(8, 18), "o", letter);
    text(svg, {520, 300}, "d", letter);
    const Vec2 near = o + dot(b - o, end - o) / dot(end - o, end - o) * (end - o);
    arrow(svg, b, near, {.stroke = purple, .width = 1.5});
    text(svg, (b + near) / 2.0 + Vec2(-18, 0), "f", colored(letter, purple));
    const Vec2 p = o + Real(0.78) * (end - o);
    line(svg, p, {a.x, p.y}, {.stroke = red, .width = 2});
    dot_at(svg, p, red, 4.5);
    text(svg, {p.x - 44, p.y + 20}, "|e + τ·m| / |u|", colored(anchored(small, "end"), red));
    return svg;
}

/// Three lines and the double cone: across it, steeper than its side, parallel to its side.
Svg lines() {
    Svg svg{.width = 720, .height = 300, .body = {}};
    const Real half = 62;
    const auto panel = [&](int i, const char* title, const char* below) {
        const Vec2 apex{120.0 + 240 * i, 150};
        const Vec2 lower[] = {apex, {apex.x - half, apex.y + 95}, {apex.x + half, apex.y + 95}};
        polygon(svg, lower, solid);
        for (const Real side : {-1.0, 1.0}) line(svg, apex, {apex.x + side * half, apex.y - 95}, dashed);
        text(svg, {apex.x, 28}, title, {.size = 15, .anchor = "middle", .bold = true});
        text(svg, {apex.x, 282}, below, middle(small));
        return apex;
    };
    const SvgStyle ray{.stroke = blue, .width = 2};
    // The side's x is y·half/95, as seen from the apex.
    const auto side = [&](Real y) { return y * half / 95; };

    Vec2 apex = panel(0, "across", "inside between the roots");
    arrow(svg, apex + Vec2(-105, 60), apex + Vec2(105, 60), ray);
    for (const Real s : {-1.0, 1.0}) dot_at(svg, apex + Vec2(s * side(60), 60), red, 5);

    apex = panel(1, "steeper than the side", "inside from the greater root on");
    const Real x = -14;
    arrow(svg, apex + Vec2(x, -105), apex + Vec2(x, 118), ray);
    dot_at(svg, apex + Vec2(x, -x * 95 / half), red, 5);
    circle(svg, apex + Vec2(x, x * 95 / half), 5, {.stroke = red, .width = 2, .fill = "white"});

    apex = panel(2, "parallel to the side", "one root");
    const auto parallel = [&](Real y) { return apex + Vec2(side(y) - 34, y); };
    arrow(svg, parallel(-75), parallel(118), ray);
    const Real y = 17 * 95 / half;
    dot_at(svg, parallel(y), red, 5);
    return svg;
}

// ------------------------------------------------------------------------------------------ cancellation

using Method = std::function<Roots(const Cone&, const Ray&)>;

/// The line with τ counted from the ray's origin.
ConeLine from_the_eye(const Cone& cone, const Ray& ray) {
    const Vec3 u = cone.b - cone.a, f = ray.origin - cone.a;
    const Real u2 = dot(u, u), along = dot(f, u) / u2, step = dot(ray.direction, u) / u2;
    const Real widening = cone.radius_b - cone.radius_a;
    return {.e = cross(f, u),
            .m = cross(ray.direction, u),
            .alpha = std::sqrt(u2) * (cone.radius_a + along * widening),
            .beta = std::sqrt(u2) * step * widening,
            .along = along,
            .along_step = step};
}

Roots from_coefficients(const ConeLine& line) {
    const Real a = dot(line.m, line.m) - line.beta * line.beta;
    const Real h = dot(line.e, line.m) - line.alpha * line.beta;
    const Real c = dot(line.e, line.e) - line.alpha * line.alpha;
    return solve_quadratic(a, h, c, h * h - a * c);
}

/// The roots as parameters of the ray.
Roots moved(Roots roots, Real by) {
    roots.t0 += by;
    roots.t1 += by;
    return roots;
}

Roots textbook(const Cone& cone, const Ray& ray) { return from_coefficients(from_the_eye(cone, ray)); }
Roots near_with_coefficients(const Cone& cone, const Ray& ray) {
    const ConeLine line = cone_line(cone, ray);
    return moved(from_coefficients(line), line.from);
}
Roots stable(const Cone& cone, const Ray& ray) {
    const ConeLine line = cone_line(cone, ray);
    return moved(side_roots(line), line.from);
}

/// A pole of radius 1, and a line from far away towards a point beside its middle.
const Cone pole{{0, -4, 0}, 1, {0, 4, 0}, 1};

Ray towards_pole(Real distance, Real x, Real y) {
    const Vec3 w = normalize(Vec3(1, 0.3, 2)), u = normalize(cross(Vec3(0, 1, 0), w)), v = cross(w, u);
    const Vec3 from = distance * w;
    return {from, normalize(x * u + y * v - from)};
}

/// A rod of radius 1 that ends at the origin, and a line that passes it near there.
Cone rod(Real length) { return {{0, -length, 0}, 1, {0, 0, 0}, 1}; }

/// The pole from a distance, in radii, by a method: the normals at the smaller root.
Image far_pole(const Method& method, Real distance) {
    const int cell = 165;
    Image image = make_image(cell, cell);
    for (int y = 0; y < cell; ++y)
        for (int x = 0; x < cell; ++x) {
            const auto at = [&](int i) { return 3 * ((i + 0.5) / cell - 0.5); };
            const Ray ray = towards_pole(distance, at(x), -at(y));
            const Roots roots = method(pole, ray);
            pixel(image, x, y) = Vec3(0.02, 0.02, 0.03);
            if (roots.count == 0) continue;
            const Vec3 p = point_at(ray, roots.t0);
            pixel(image, x, y) = 0.5 * (normalize(Vec3(p.x, 0, p.z)) + 1.0);
        }
    return image;
}

/// A row for each power of ten: how many of many lines two methods judge wrongly, and how far from the side
/// the points are that their smaller roots lead to. Judged by exact arithmetic.
std::string errors(const std::string& head, int last, const std::vector<Method>& methods,
                   const std::function<std::pair<Cone, Ray>(Real, test::Random&)>& make) {
    const int count = 10000;
    std::string csv = head + '\n';
    for (int power = 1; power <= last; ++power) {
        int wrong[2] = {};
        Real off[2] = {};
        test::Random random(10400);
        for (int i = 0; i < count; ++i) {
            const auto [cone, ray] = make(std::pow(10.0, power), random);
            // The ends are far enough away.
            const bool truth =
                oracle::meets(cone, ray, {-infinity, infinity}, {0, 100 * length(cone.b - cone.a)});
            for (std::size_t m = 0; m < methods.size(); ++m) {
                const Roots roots = methods[m](cone, ray);
                wrong[m] += (roots.count > 0) != truth;
                if (roots.count == 0 || !truth) continue;
                const Vec3 p = point_at(ray, roots.t0);
                off[m] = std::max(off[m], std::abs(std::hypot(p.x, p.z) - 1));
            }
        }
        csv += fmt::format("1e{},{},{},{:.0e},{:.0e}\n", power, wrong[0], wrong[1], off[0], off[1]);
    }
    return csv;
}

std::string far_pole_errors() {
    return errors(
        "distance in radii,wrong of 10000 (textbook),wrong of 10000 (stable),"
        "farthest from the side in radii (textbook),farthest from the side in radii (stable)",
        8, {textbook, stable}, [](Real distance, test::Random& random) {
            const Real x = random.uniform(-1.5, 1.5);
            return std::pair(pole, towards_pole(distance, x, random.uniform(-1, 1)));
        });
}

std::string long_rod_errors() {
    return errors(
        "length in radii,wrong of 10000 (h² - ac),wrong of 10000 (stable),"
        "farthest from the side in radii (h² - ac),farthest from the side in radii (stable)",
        8, {near_with_coefficients, stable}, [](Real length, test::Random& random) {
            const Real x = random.uniform(-1.5, 1.5);
            Ray ray = towards_pole(10, x, random.uniform(-1, 1));
            ray.direction = normalize(ray.direction + Vec3(0, -1, 0));
            ray.origin = Vec3(x, -1, 0) - 10.0 * ray.direction;
            return std::pair(rod(length), ray);
        });
}

// --------------------------------------------------------------------------------------- roots and tori

/// The worked example, t³ − 3t + 1: between the roots of its derivative it only rises or only falls.
Svg derivative_figure() {
    Svg svg{.width = 640, .height = 360, .body = {}};
    const Polynomial p{{1, -3, 0, 1}};
    const Plot plot{{60, 20}, {540, 310}, {-2, 2}, {-2.2, 3.8}};
    line(svg, plot.place(-2, 0), plot.place(2, 0), {.stroke = grey, .width = 1.5});
    text(svg, plot.place(2, 0) + Vec2(10, 5), "t", letter);
    for (const Real turn : {-1.0, 1.0}) {
        line(svg, plot.place(turn, -2.2), plot.place(turn, 3.8),
             {.stroke = orange, .width = 1.2, .dash = "5 4"});
        text(svg, plot.place(turn, -2.2) + Vec2(6, -6), turn < 0 ? "t = −1" : "t = 1",
             colored(small, orange));
        dot_at(svg, plot.place(turn, evaluate(p, turn).value), orange, 5);
    }
    std::vector<Vec2> curve;
    for (int i = 0; i <= 200; ++i) {
        const Real t = -2 + 0.02 * i;
        curve.push_back(plot.place(t, evaluate(p, t).value));
    }
    polyline(svg, curve, {.stroke = blue, .width = 2.5});
    const SignChanges roots = sign_changes(p, -2, 2);
    for (std::size_t i = 0; i < static_cast<std::size_t>(roots.count); ++i) {
        dot_at(svg, plot.place(roots.t[i], 0), red, 5);
        text(svg, plot.place(roots.t[i], 0) + Vec2(i == 1 ? 10 : -10, -10),
             fmt::format("{}{:.3f}", roots.t[i] < 0 ? "−" : "", std::abs(roots.t[i])),
             colored(anchored(small, i == 1 ? "start" : "end"), red));
    }
    text(svg, plot.place(-1.45, 3.5), "rises", middle(note));
    text(svg, plot.place(0, 3.5), "falls", middle(note));
    text(svg, plot.place(1.45, 3.5), "rises", middle(note));
    return svg;
}

/// A line that is askew, seen along the axis of the ring and in the plane of Q/2R and z, where the torus is a
/// disc.
Svg parabola() {
    Svg svg{.width = 760, .height = 330, .body = {}};
    const Torus torus{{0, 0, 0}, {0, 1, 0}, 3, 1};
    const Ray ray{{0, 0.1, 1.4}, normalize(Vec3(1, 0.16, 0))};
    const auto above = [](const Vec3& p) { return Vec2(190 + 38 * p.x, 160 + 38 * p.z); };
    const Vec2 middle_of_ring = above(Vec3(0));
    circle(svg, middle_of_ring, 4 * 38, {.stroke = ink, .width = 2, .fill = "#eef3f7"});
    circle(svg, middle_of_ring, 2 * 38, {.stroke = ink, .width = 2, .fill = "white"});
    circle(svg, middle_of_ring, 3 * 38, dashed);
    const auto section = [&](Real t) {
        const Vec3 p = point_at(ray, t);
        return Vec2(560 + 95 * (dot(p, p) - 10) / 6, 160 - 95 * p.y);
    };
    line(svg, {430, 160}, {735, 160}, {.stroke = grey, .width = 1});
    line(svg, {560, 20}, {560, 300}, {.stroke = grey, .width = 1});
    circle(svg, {560, 160}, 95, {.stroke = ink, .width = 2, .fill = "#eef3f7"});
    text(svg, {722, 150}, "Q/2R", anchored(small, "end"));
    text(svg, {566, 24}, "z", letter);
    arrow(svg, above(point_at(ray, -4.6)), above(point_at(ray, 4.6)), {.stroke = blue, .width = 2});
    std::vector<Vec2> curve;
    for (int i = -100; i <= 100; ++i) curve.push_back(section(0.04 * i));
    polyline(svg, curve, {.stroke = blue, .width = 2});
    const TorusSpans spans = inside(torus, ray);
    for (std::size_t i = 0; i < static_cast<std::size_t>(spans.count); ++i)
        for (const Real t : {spans.spans[i].enter, spans.spans[i].leave}) {
            dot_at(svg, above(point_at(ray, t)), red, 5);
            dot_at(svg, section(t), red, 5);
        }
    text(svg, {190, 325}, "seen along the axis", middle(small));
    text(svg, {580, 325}, "what Q and z make of it", middle(small));
    return svg;
}

/// What three ways say is inside of a far torus, from an eye at the world's origin.
using Inside = TorusSpans (*)(const Torus&, const Ray&);

/// The quartic expanded at the eye, but solved with certainty.
TorusSpans solved_at_the_eye(const Torus& torus, const Ray& ray) {
    const SignChanges changes = naive::crossings_from_the_eye(torus, ray, sign_changes);
    TorusSpans spans;
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(changes.count); i += 2)
        spans.spans[static_cast<std::size_t>(spans.count++)] = {changes.t[i], changes.t[i + 1]};
    return spans;
}

constexpr Inside ways_inside[] = {naive::inside, solved_at_the_eye, inside};

/// A ring of radius 1 that lies askew, with a tube of radius 0.3, and a line from far away to a place beside
/// it.
std::pair<Torus, Ray> far_ring(Real distance, Real x, Real y) {
    const Vec3 w = normalize(Vec3(1, 0.3, 2)), u = normalize(cross(Vec3(0, 1, 0), w)), v = cross(w, u);
    return {{-distance * w, {0.2, 0.8, 0.5}, 1, 0.3}, {Vec3(0), normalize(-distance * w + x * u + y * v)}};
}

/// The ring from a distance, in its radii, one way: the normals.
Image far_ring(Inside way, Real distance) {
    const int cell = 165;
    Image image = make_image(cell, cell);
    for (int y = 0; y < cell; ++y)
        for (int x = 0; x < cell; ++x) {
            const auto at = [&](int i) { return 3 * ((i + 0.5) / cell - 0.5); };
            const auto [torus, ray] = far_ring(distance, at(x), -at(y));
            const TorusSpans spans = way(torus, ray);
            pixel(image, x, y) = Vec3(0.02, 0.02, 0.03);
            if (spans.count == 0) continue;
            const Surface surface = surface_at(torus, ray, Hit{.t = spans.spans[0].enter});
            pixel(image, x, y) = 0.5 * (surface.normal + 1.0);
        }
    return image;
}

/// How many of many lines a way judges wrongly, by exact arithmetic, and how far from the surface, in the
/// median, the points are at which it says that lines enter.
struct FarErrors {
    int wrong = 0;
    Real off = 0;
};
FarErrors far_errors(Inside way, Real distance) {
    test::Random random(10800);
    FarErrors errors;
    std::vector<Real> off;
    for (int i = 0; i < 10000; ++i) {
        const Real x = random.uniform(-1.5, 1.5);
        const auto [torus, ray] = far_ring(distance, x, random.uniform(-1.5, 1.5));
        const TorusSpans spans = way(torus, ray);
        const bool truth = oracle::LineAndTorus(torus, ray).meets({-infinity, infinity});
        errors.wrong += (spans.count > 0) != truth;
        if (spans.count == 0 || !truth) continue;
        const Vec3 p = point_at(ray, spans.spans[0].enter) - torus.center, n = normalize(torus.axis);
        off.push_back(std::abs(std::hypot(length(cross(p, n)) - torus.ring, dot(p, n)) - torus.tube));
    }
    if (off.empty()) return errors;
    std::ranges::nth_element(off, off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2));
    errors.off = off[off.size() / 2];
    return errors;
}

/// The table and the plot of it.
std::pair<std::string, Svg> far_ring_errors() {
    std::string csv = "distance in radii";
    const char* names[] = {"closed formulas from the eye", "solved at the eye", "solved near"};
    for (const char* name : names) csv += fmt::format(",wrong of 10000 ({0}),off the surface ({0})", name);
    Svg svg{.width = 640, .height = 400, .body = {}};
    const Plot plot{{80, 40}, {440, 300}, {1, 1e8, true}, {1e-17, 1e2, true}};
    draw_axes(svg, plot, decades(0, 8),
              {{1e-16, "10⁻¹⁶"}, {1e-12, "10⁻¹²"}, {1e-8, "10⁻⁸"}, {1e-4, "10⁻⁴"}, {1, "1"}});
    text(svg, {300, 385}, "distance, in radii of the ring", middle(small));
    text(svg, {80, 26}, "distance from the surface, in radii of the ring", small);
    const char* colors[] = {red, orange, green};
    std::vector<Vec2> curves[3];
    for (int power = 1; power <= 8; ++power) {
        const Real distance = std::pow(10.0, power);
        csv += fmt::format("\n1e{}", power);
        for (std::size_t m = 0; m < 3; ++m) {
            const FarErrors errors = far_errors(ways_inside[m], distance);
            csv +=
                fmt::format(",{},{}", errors.wrong, errors.off > 0 ? fmt::format("{:.0e}", errors.off) : "");
            if (0 < errors.off && errors.off < 20) curves[m].push_back(plot.place(distance, errors.off));
        }
    }
    for (std::size_t m = 0; m < 3; ++m) {
        polyline(svg, curves[m], {.stroke = colors[m], .width = 2.5});
        for (const Vec2& point : curves[m]) dot_at(svg, point, colors[m], 4);
    }
    text(svg, plot.place(1.3e5, 5), "closed formulas from the eye", colored(small, red));
    text(svg, plot.place(1.5e4, 6e-3), "the same quartic, by 10.8", colored(small, orange));
    text(svg, plot.place(2e5, 1e-13), "expanded near the torus", colored(small, green));
    return {csv + '\n', svg};
}

/// Closed formulas, and roots by sign changes, of the same quartics, expanded near the torus: how many lines
/// of 10000 they judge wrongly, and how far from the surface the farthest first root is.
std::string closed_formulas() {
    using Solve = SignChanges (*)(const Polynomial&, Real, Real);
    const Solve ways[] = {naive::sign_changes, sign_changes};
    std::string csv =
        "lines,wrong of 10000 (closed formulas),farthest off the surface (closed formulas),"
        "wrong of 10000 (sign changes),farthest off the surface (sign changes)\n";
    for (const Real beside : {0.0, 1e-2, 1e-4, 1e-6, 1e-8}) {
        csv += beside == 0 ? "anywhere" : fmt::format("touching but for {:.0e}", beside);
        for (const Solve& solve : ways) {
            test::Random random(10801);
            int wrong = 0;
            Real off = 0;
            for (int i = 0; i < 10000; ++i) {
                const Real x = random.uniform(-1.5, 1.5);
                auto [torus, ray] = far_ring(10, x, random.uniform(-1.5, 1.5));
                if (beside > 0) {  // in the plane that touches the tube, that much inside or outside of it
                    const Vec3 n = normalize(torus.axis), radial = random.perpendicular_to(n);
                    const Real angle = random.uniform(0, 2 * pi), turn = random.uniform(0, pi);
                    const Vec3 out = std::cos(angle) * radial + std::sin(angle) * n;
                    const Vec3 point = radial + torus.tube * (1 + random.sign() * beside) * out;
                    const Vec3 along = std::cos(angle) * n - std::sin(angle) * radial;
                    const Vec3 d = std::cos(turn) * cross(n, radial) + std::sin(turn) * along;
                    ray = {torus.center + point - 10.0 * d, d};
                }
                const std::optional<TorusLine> near = torus_line(torus, ray);
                const bool truth = oracle::LineAndTorus(torus, ray).meets({-infinity, infinity});
                const SignChanges roots = near ? solve(torus_quartic(torus, *near, 0), -2, 2) : SignChanges{};
                wrong += (roots.count > 0) != truth;
                if (roots.count == 0 || !truth) continue;
                const Vec3 p = near->q + roots.t[0] * near->e;
                off = std::max(
                    off, std::abs(std::hypot(length(cross(p, near->n)) - 1, dot(p, near->n)) - torus.tube));
            }
            csv += fmt::format(",{},{:.0e}", wrong, off);
        }
        csv += '\n';
    }
    return csv;
}

// ------------------------------------------------------------------------------------------ combinations

/// The worked example: the pieces of two solids on the t axis, and of what is made of them.
Svg two_solids() {
    Svg svg{.width = 720, .height = 250, .body = {}};
    const auto along = [](Real t) { return 170 + 75 * t; };
    const auto bar = [&](Real y, std::span<const Hit> hits, const char* color, const char* words) {
        for (std::size_t i = 0; i + 1 < hits.size(); i += 2)
            line(svg, {along(hits[i].t), y}, {along(hits[i + 1].t), y}, {.stroke = color, .width = 11});
        text(svg, {150, y + 5}, words, {.size = 14, .color = color, .anchor = "end"});
    };
    const Hit a[] = {{.t = 1}, {.t = 4}}, b[] = {{.t = 2}, {.t = 6}};
    for (const Real t : {1.0, 2.0, 4.0, 6.0})
        line(svg, {along(t), 20}, {along(t), 205}, {.stroke = grey, .width = 1, .dash = "3 5"});
    bar(35, a, blue, "in A");
    bar(65, b, orange, "in B");
    bar(115, combine(SetOperation::Union, a, b), green, "union");
    bar(145, combine(SetOperation::Intersection, a, b), green, "intersection");
    bar(175, combine(SetOperation::Difference, a, b), green, "difference A − B");
    line(svg, {along(0), 205}, {along(7), 205}, {.stroke = grey, .width = 1.5});
    for (int t = 0; t <= 7; ++t) {
        line(svg, {along(t), 200}, {along(t), 210}, {.stroke = grey, .width = 1.5});
        text(svg, {along(t), 230}, fmt::format("{}", t), middle(small));
    }
    text(svg, {along(7) + 12, 211}, "t", letter);
    return svg;
}

/// A slab with a hole that ends in its upper face, as a pixel sees it: each part's crossings by its own
/// formula, and one hit after the other.
std::optional<Vec3> normal_with_skin(const Box& slab, const Cone& hole, const Ray& ray) {
    const std::optional<Span> in_slab = inside(slab, ray), in_hole = inside(hole, ray);
    if (!in_slab) return std::nullopt;
    const auto of_slab = [&](Real t, std::uint32_t face) {
        return surface_at(slab, ray, Hit{.t = t, .element = face}).normal;
    };
    if (!in_hole || in_slab->enter < in_hole->enter) return of_slab(in_slab->enter, in_slab->enter_face);
    if (in_hole->leave >= in_slab->leave) return std::nullopt;
    if (in_hole->leave < in_slab->enter) return of_slab(in_slab->enter, in_slab->enter_face);
    return -surface_at(hole, ray, Hit{.t = in_hole->leave, .element = in_hole->leave_face}).normal;
}

/// The same by step 10.15, with both planes crossed at one t.
std::optional<Vec3> normal_without_skin(const Combination& pot, const Ray& ray) {
    const std::optional<Hit> hit = intersect(pot, ray, Interval{});
    if (!hit) return std::nullopt;
    return surface_at(pot, ray, *hit).normal;
}

/// With a skin of no thickness, and without.
std::vector<Panel> skin() {
    const Box slab{{-1, -0.3, -1}, {1, 0.3, 1}};
    const Cone hole{{0, -0.1, 0}, 0.7, {0, 0.3, 0}, 0.7};
    Combination pot;
    const std::int32_t parts[] = {add_part(pot, slab, false), add_part(pot, hole, true)};
    join(pot, SetOperation::Difference, parts);
    find_common_planes(pot);
    const int width = 240, height = 180;
    const Vec3 eye(0.7, 2.2, 2.6), w = normalize(eye), u = normalize(cross(Vec3(0, 1, 0), w)),
                                   v = cross(w, u);
    const auto look = [&](const auto& normal_at) {
        Image image = make_image(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Vec3 d =
                    (x + 0.5 - width / 2) / width * u + (height / 2 - y - 0.5) / width * v - 1.3 * w;
                const std::optional<Vec3> normal = normal_at(Ray{eye, normalize(d)});
                pixel(image, x, y) = normal ? 0.5 * (*normal + 1.0) : Vec3(0.02, 0.02, 0.03);
            }
        return image;
    };
    return {{look([&](const Ray& ray) { return normal_with_skin(slab, hole, ray); }), "one by one"},
            {look([&](const Ray& ray) { return normal_without_skin(pot, ray); }), "all at one t at once"}};
}

// ---------------------------------------------------------------------------------------------- mistakes

/// A stump, a can and a hat, as one pixel sees them by a way of intersecting and of finding the normal.
using Way = std::function<std::optional<Hit>(const Cone&, const Ray&)>;

std::optional<Hit> right_way(const Cone& cone, const Ray& ray) { return intersect(cone, ray, Interval{}); }

std::optional<Hit> without_caps(const Cone& cone, const Ray& ray) {
    return intersect(OpenCone{cone}, ray, Interval{});
}

/// Both halves of the double cone, without ends.
std::optional<Hit> without_end(const Cone& cone, const Ray& ray) {
    const Roots roots = stable(cone, ray);
    for (const Real t : {roots.t0, roots.t1})
        if (roots.count > 0 && t > 0) return Hit{.t = t};
    return std::nullopt;
}

Image look(const Way& way, bool normal_of_a_cylinder) {
    const Cone things[] = {{{-1.35, -0.7, -0.6}, 0.75, {-1.2, 0.7, -0.5}, 0.3},
                           {{1.3, -0.7, -0.5}, 0.5, {1.2, 0.6, -0.4}, 0.5},
                           {{0, -0.7, 0.6}, 0.65, {0.1, 0.8, 0.6}, 0}};
    const int width = 200, height = 130;
    const Vec3 eye(0, 2, 5.5), w = normalize(eye), u = normalize(cross(Vec3(0, 1, 0), w)), v = cross(w, u);
    Image image = make_image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec3 d = (x + 0.5 - width / 2) / width * u + (height / 2 - y - 0.5) / width * v - 1.25 * w;
            const Ray ray{eye, normalize(d)};
            Real nearest = infinity;
            pixel(image, x, y) = Vec3(0.02, 0.02, 0.03);
            for (const Cone& thing : things) {
                const std::optional<Hit> hit = way(thing, ray);
                if (!hit || hit->t >= nearest) continue;
                nearest = hit->t;
                Surface surface = surface_at(thing, ray, *hit);
                const Vec3 axis = normalize(thing.b - thing.a);
                if (normal_of_a_cylinder && hit->element == 0)
                    surface.normal = normalize(surface.normal - dot(surface.normal, axis) * axis);
                pixel(image, x, y) = 0.5 * (surface.normal + 1.0);
            }
        }
    return image;
}

std::vector<Panel> mistakes() {
    return {{look(right_way, false), "right"},
            {look(right_way, true), "normals of cylinders"},
            {look(without_caps, false), "no caps"},
            {look(without_end, false), "no ends"}};
}

/// How many of a scene's shapes have one of these commands.
long count_of(const std::string& name, const std::vector<std::string>& commands) {
    std::ifstream file(Path(__FILE__).parent_path() / (name + ".scene"));
    long count = 0;
    for (std::string line; std::getline(file, line);)
        count += std::ranges::count(commands, line.substr(0, line.find(' ')));
    return count;
}

/// The numbers of the lesson that stand in no other table.
Numbers lesson_numbers(const LostByStepping& lost) {
    Numbers numbers;
    numbers.add("cones and cylinders in columns.scene", count_of("columns", {"cone", "cylinder"}));
    numbers.add("boxes in columns.scene", count_of("columns", {"box"}));
    numbers.add("polygons and triangles in columns.scene", count_of("columns", {"polygon", "tri"}));
    numbers.add("pixels of the heart", lost.hits);
    numbers.add("pixels of the heart that 6 steps lose", lost.by_6);
    numbers.add("pixels of the heart that 12 steps lose", lost.by_12);
    return numbers;
}

void draw_all(const Path& out) {
    write_svg(out / "spans.svg", spans());
    write_svg(out / "cone.svg", cone());
    write_svg(out / "lines.svg", lines());
    std::vector<Panel> poles;
    for (const auto& [method, name] : {std::pair(Method(textbook), "textbook"), {Method(stable), "10.4"}})
        for (const auto& [distance, words] : Ticks{{1e6, "10⁶"}, {1e7, "10⁷"}, {3e7, "3·10⁷"}, {1e8, "10⁸"}})
            poles.push_back({far_pole(method, distance), fmt::format("{}, {}", name, words)});
    write_svg(out / "far_pole.svg", side_by_side(poles, 4));
    write_file(out / "far_pole.csv", far_pole_errors());
    write_file(out / "long_rod.csv", long_rod_errors());
    write_svg(out / "derivative.svg", derivative_figure());
    write_svg(out / "parabola.svg", parabola());
    std::vector<Panel> rings;
    const char* names[] = {"closed", "10.8", "10.10"};
    for (std::size_t m = 0; m < 3; ++m)
        for (const auto& [distance, words] : Ticks{{1e2, "100"}, {1e3, "1000"}, {3e3, "3000"}, {1e4, "10⁴"}})
            rings.push_back({far_ring(ways_inside[m], distance), fmt::format("{}, {}", names[m], words)});
    write_svg(out / "far_ring.svg", side_by_side(rings, 4));
    const auto [table, plot] = far_ring_errors();
    write_file(out / "far_ring.csv", table);
    write_file(out / "closed_formulas.csv", closed_formulas());
    write_svg(out / "far_ring_errors.svg", plot);
    write_svg(out / "mistakes.svg", side_by_side(mistakes(), 2, 1.5));
    write_svg(out / "two_solids.svg", two_solids());
    write_svg(out / "skin.svg", side_by_side(skin(), 2, 1.5));
    lesson_numbers(draw_implicit(out)).write(out);
    draw_scenes(out, __FILE__,
                {"still_life", "tubes", "glass", "lathe", "tori", "surfaces", "heart", "lenses"}, 320, 240);
    draw_scenes(out, __FILE__, {"columns", "carved"});
}

}  // namespace

int main(int argc, char** argv) { return figures::draw_figures(argc, argv, draw_all); }
