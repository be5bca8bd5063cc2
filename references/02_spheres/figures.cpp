// Figures of chapter 2: the geometry, what cancellation does to a far sphere, what mistakes look like.
// Usage: figures_02 DIRECTORY
#include "references/figures.hpp"
#include "chapters/02_spheres/sphere.hpp"
#include "common/render/integrators.hpp"
#include "references/panels.hpp"
#include "tests/oracle/sphere.hpp"
#include "tests/stability/naive.hpp"
#include "tests/support.hpp"

#include <fmt/format.h>

#include <functional>

using namespace rt;
using rt::figures::Path;

namespace {

// ------------------------------------------------------------------------------------------- geometry

const SvgStyle outline{.stroke = svg_color::ink, .width = 2, .fill = "#eef3f7"};
const SvgStyle solid{.stroke = svg_color::blue, .width = 2};
const SvgStyle backwards{.stroke = svg_color::grey, .width = 1.5, .dash = "4 4"};

void dot_at(Svg& svg, Vec2 at, const char* color, bool filled = true) {
    circle(svg, at, 5, {.stroke = color, .width = 2, .fill = filled ? color : "white"});
}

Svg perpendicular() {
    Svg svg{.width = 700, .height = 300, .body = {}};
    const Vec2 o{50, 225}, c{470, 135}, foot{c.x, o.y};
    const Real r = 120, half = std::sqrt(r * r - (foot.y - c.y) * (foot.y - c.y));
    const Vec2 t0{foot.x - half, o.y}, t1{foot.x + half, o.y};
    circle(svg, c, r, outline);
    line(svg, o, {680, o.y}, {.stroke = svg_color::grey, .width = 1.5});
    arrow(svg, o, {150, o.y}, {.stroke = svg_color::blue, .width = 3}, 12);
    arrow(svg, c, o, {.stroke = svg_color::ink, .width = 1.5});
    arrow(svg, c, foot, {.stroke = svg_color::red, .width = 2.5});
    line(svg, c, t1, {.stroke = svg_color::green, .width = 2});
    line(svg, foot, t1, {.stroke = svg_color::orange, .width = 4});
    rectangle(svg, {foot.x, foot.y - 12}, {12, 12}, {.stroke = svg_color::grey, .width = 1});
    for (const Vec2& p : {o, c}) dot_at(svg, p, svg_color::ink);
    for (const Vec2& p : {t0, t1}) dot_at(svg, p, svg_color::orange);
    const SvgFont name{.size = 21, .italic = true};
    text(svg, o + Vec2(-6, 30), "o", name);
    text(svg, c + Vec2(8, -8), "centre", {.size = 20});
    text(svg, {105, 255}, "d", {.size = 21, .color = svg_color::blue, .italic = true});
    text(svg, {150, 165}, "f = o − centre", name);
    text(svg, {foot.x - 24, 195}, "w", {.size = 21, .color = svg_color::red, .italic = true});
    text(svg, {c.x + 50, 185}, "r", {.size = 21, .color = svg_color::green, .italic = true});
    text(svg, t0 + Vec2(-34, 28), "t0", name);
    text(svg, t1 + Vec2(18, -10), "t1", name);
    line(svg, {foot.x + half / 2, o.y + 4}, {foot.x + 95, 270}, {.stroke = "#a06c00", .width = 1});
    text(svg, {foot.x + 100, 275}, "√(r² − w·w)", {.size = 20, .color = "#a06c00"});
    text(svg, {foot.x - 10, 217}, "−h/a", {.size = 19, .anchor = "end", .italic = true});
    return svg;
}

Svg four_cases() {
    Svg svg{.width = 760, .height = 270, .body = {}};
    const Real r = 50, cy = 122;
    const auto root_x = [&](Real y) { return std::sqrt(r * r - (y - cy) * (y - cy)); };
    const auto panel = [&](int i, const char* title, const char* order, const char* hit) {
        const Vec2 c{95.0 + 190 * i, cy};
        text(svg, {c.x, 28}, title, {.size = 19, .anchor = "middle", .bold = true});
        text(svg, {c.x, 224}, order, {.size = 18, .anchor = "middle", .italic = true});
        text(svg, {c.x, 250}, hit, {.size = 18, .anchor = "middle"});
        circle(svg, c, r, outline);
        return c.x;
    };

    Real x = panel(0, "two roots ahead", "0 < t0 < t1", "hit at t0"), y = cy + 20;
    arrow(svg, {x - 80, y}, {x + 85, y}, solid);
    dot_at(svg, {x - 80, y}, svg_color::blue);
    dot_at(svg, {x - root_x(y), y}, svg_color::red);
    dot_at(svg, {x + root_x(y), y}, svg_color::red, false);

    x = panel(1, "tangent", "0 < t0 = t1", "hit once"), y = cy - r;
    arrow(svg, {x - 80, y}, {x + 85, y}, solid);
    dot_at(svg, {x - 80, y}, svg_color::blue);
    dot_at(svg, {x, y}, svg_color::red);

    x = panel(2, "from inside", "t0 ≤ 0 < t1", "hit at t1"), y = cy + 10;
    line(svg, {x - 80, y}, {x - 10, y}, backwards);
    arrow(svg, {x - 10, y}, {x + 85, y}, solid);
    dot_at(svg, {x - 10, y}, svg_color::blue);
    dot_at(svg, {x - root_x(y), y}, svg_color::red, false);
    dot_at(svg, {x + root_x(y), y}, svg_color::red);

    x = panel(3, "none", "none, or both ≤ 0", "a miss"), y = cy + 15;
    arrow(svg, {x - 80, cy - 65}, {x + 80, cy - 65}, solid);
    dot_at(svg, {x - 80, cy - 65}, svg_color::blue);
    line(svg, {x - 80, y}, {x + 58, y}, backwards);
    arrow(svg, {x + 58, y}, {x + 85, y}, solid);
    dot_at(svg, {x + 58, y}, svg_color::blue);
    dot_at(svg, {x - root_x(y), y}, svg_color::red, false);
    dot_at(svg, {x + root_x(y), y}, svg_color::red, false);
    return svg;
}

// ------------------------------------------------------------------------------------------ cancellation

using Method = Roots (*)(const Sphere&, const Ray&);

/// Line from far away towards the point (x, y) of a disc around the origin that faces the line's origin.
Ray towards_disc(Real distance, Real x, Real y) {
    const Vec3 w = normalize(Vec3(1, 1.5, 2)), u = normalize(cross(Vec3(0, 1, 0), w)), v = cross(w, u);
    const Vec3 from = distance * w;
    return {from, normalize(x * u + y * v - from)};
}

/// The normals of the unit sphere at the smaller root, from this distance.
Image far_sphere(Method method, Real distance, int size) {
    Image image = make_image(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const auto at = [&](int i) { return 2.4 * ((i + 0.5) / size - 0.5); };
            const Ray ray = towards_disc(distance, at(x), -at(y));
            const Roots roots = method({{0, 0, 0}, 1}, ray);
            pixel(image, x, y) = Vec3(0.02, 0.02, 0.03);
            if (roots.count > 0) pixel(image, x, y) = 0.5 * (normalize(point_at(ray, roots.t0)) + 1.0);
        }
    return image;
}

/// A row a method, a column a distance.
Svg far_spheres() {
    const std::pair<Real, const char*> distances[] = {
        {1e6, "10⁶ radii"}, {1e7, "10⁷"}, {3e7, "3 · 10⁷"}, {1e8, "10⁸"}};
    const std::pair<Method, const char*> methods[] = {{naive::intersections, "h² − a·c"},
                                                      {intersections, "a·(r² − w·w)"}};
    const int size = 150;
    const Real left = 150, top = 34, step = size + 10;
    Svg svg{.width = static_cast<int>(left + 4 * step), .height = static_cast<int>(top + 2 * step)};
    for (std::size_t i = 0; i < 4; ++i)
        text(svg, {left + (static_cast<Real>(i) + 0.5) * step - 5, 20}, distances[i].second,
             {.size = 20, .anchor = "middle", .bold = true});
    for (std::size_t m = 0; m < 2; ++m) {
        const Real y = top + static_cast<Real>(m) * step;
        text(svg, {left - 10, y + size / 2.0 + 5}, methods[m].second,
             {.size = 19, .anchor = "end", .bold = true});
        for (std::size_t i = 0; i < 4; ++i)
            figures::picture(svg, {left + static_cast<Real>(i) * step, y},
                             far_sphere(methods[m].first, distances[i].first, size));
    }
    return svg;
}

/// For each distance: how many of many lines are judged wrongly, and how far from the sphere the points are
/// that the roots lead to. Judged by exact arithmetic.
std::string far_sphere_errors() {
    const int lines = 10000;
    std::string csv =
        "distance from the surface in radii,wrong of 10000 (naive),wrong of 10000 (stable),"
        "farthest from the sphere in radii (naive),farthest from the sphere in radii (stable)\n";
    const std::vector<Method> methods{naive::intersections, intersections};
    for (int power = 0; power <= 8; ++power) {
        int wrong[2] = {};
        Real off[2] = {};
        test::Random random(2200);
        for (int i = 0; i < lines; ++i) {
            const Real x = random.uniform(-1.2, 1.2), y = random.uniform(-1.2, 1.2);
            const Sphere sphere{{0, 0, 0}, 1};
            const Ray ray = towards_disc(1 + std::pow(10.0, power), x, y);
            for (std::size_t m = 0; m < methods.size(); ++m) {
                const Roots roots = methods[m](sphere, ray);
                const oracle::SphereTruth truth = oracle::judge_sphere(sphere, ray, roots.t0, roots.t1);
                const bool hit = roots.count > 0;
                wrong[m] += hit != (truth.roots > 0);
                if (hit && truth.roots > 0) off[m] = std::max(off[m], std::abs(truth.distance0));
            }
        }
        csv += fmt::format("1e{},{},{},{:.0e},{:.0e}\n", power, wrong[0], wrong[1], off[0], off[1]);
    }
    return csv;
}

/// Whether the line meets the sphere around the origin, by h² − a·c in single precision.
bool hit_in_single(const glm::vec3& origin, const glm::vec3& direction, float radius) {
    const float a = dot(direction, direction), h = dot(origin, direction);
    return h * h - a * (dot(origin, origin) - radius * radius) >= 0;
}

/// The first column of `far_sphere_errors`, but in single precision.
std::string far_sphere_in_single() {
    const int lines = 10000;
    std::string csv = "distance from the surface in radii,wrong of 10000 (naive)\n";
    for (const int distance : {10, 30, 100, 300, 1000, 3000, 10000}) {
        int wrong = 0;
        test::Random random(2250);
        for (int i = 0; i < lines; ++i) {
            const Real x = random.uniform(-1.2, 1.2), y = random.uniform(-1.2, 1.2);
            const Ray ray = towards_disc(1 + distance, x, y);
            const glm::vec3 origin(ray.origin), direction(ray.direction);
            const oracle::SphereTruth truth =
                oracle::judge_sphere({{0, 0, 0}, 1}, {Vec3(origin), Vec3(direction)}, 0, 0);
            wrong += hit_in_single(origin, direction, 1) != (truth.roots > 0);
        }
        csv += fmt::format("{},{}\n", distance, wrong);
    }
    return csv;
}

/// Relative error of the smaller root of t² − 2·10^k·t + 1, judged by exact arithmetic.
std::string small_root_errors() {
    std::string csv = "h,small root (exact to 6 digits),error of (-h - s)/a,error of c/q\n";
    for (int power = 1; power <= 8; ++power) {
        const Real h = -std::pow(10.0, power), discriminant = h * h - 1;
        const Real naive = -h - std::sqrt(discriminant);
        const Real stable = solve_quadratic(1, h, 1, discriminant).t0;
        const oracle::QuadraticTruth truth = oracle::judge_quadratic(1, h, 1, naive, stable);
        const oracle::QuadraticTruth again = oracle::judge_quadratic(1, h, 1, stable, naive);
        csv += fmt::format("-1e{},{:.6g},{:.0e},{:.0e}\n", power, truth.t0, std::abs(truth.error0 / truth.t0),
                           std::abs(again.error0 / again.t0));
    }
    return csv;
}

// ---------------------------------------------------------------------------------------------- mistakes

const std::vector<Sphere> still_life{{{-0.35, 0.55, 4}, 0.45},  // behind the eye
                                     {{0, -0.65, -3}, 0.35},
                                     {{0.9, -0.35, -3.9}, 0.65},
                                     {{-0.9, 0.1, -4.6}, 1.1},
                                     {{1.5, 0.9, -5.5}, 0.5}};

/// What one pixel shows; the eye is the origin.
using Look = std::function<Vec3(const Ray&)>;

const Vec3 nothing{0.02, 0.02, 0.03};

/// The loop over all spheres with a choice of root and of hit that the lesson's reader might make.
Look mistaken(const std::function<std::optional<Real>(const Roots&)>& choose, bool keep_last,
              const std::function<Vec3(const Sphere&, const Vec3&)>& normal) {
    return [=](const Ray& ray) {
        Real nearest = infinity;
        Vec3 color = nothing;
        for (const Sphere& sphere : still_life) {
            const Roots roots = intersections(sphere, ray);
            if (roots.count == 0) continue;
            const std::optional<Real> t = choose(roots);
            if (!t || (*t > nearest && !keep_last)) continue;
            nearest = *t;
            // Coloured as `integrator normals` does.
            color = 0.5 * (turned_to_viewer(normal(sphere, point_at(ray, *t)), ray.direction) + 1.0);
        }
        return color;
    };
}

std::vector<figures::Panel> panels_of(const std::vector<std::pair<Look, const char*>>& looks) {
    const int width = 200, height = 150;
    std::vector<figures::Panel> panels;
    for (const auto& [look, words] : looks) {
        panels.push_back({make_image(width, height), words});
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Vec3 d((x + 0.5 - width / 2) / width, (height / 2 - y - 0.5) / width, -0.9);
                pixel(panels.back().image, x, y) = look({Vec3(0), normalize(d)});
            }
    }
    return panels;
}

void draw_mistakes(const Path& out) {
    const auto nearer = [](const Roots& r) { return r.t0 > 0 ? std::optional(r.t0) : std::nullopt; };
    const auto farther = [](const Roots& r) { return r.t1 > 0 ? std::optional(r.t1) : std::nullopt; };
    const auto unchecked = [](const Roots& r) { return std::optional(r.t0); };
    const auto outward = [](const Sphere& s, const Vec3& p) { return normalize(p - s.center); };
    const auto long_normal = [](const Sphere& s, const Vec3& p) { return p - s.center; };
    const Look right = mistaken(nearer, false, outward);
    write_svg(out / "wrong_roots.svg",
              figures::side_by_side(panels_of({{right, "right"},
                                               {mistaken(farther, false, outward), "farther root first"},
                                               {mistaken(unchecked, false, outward), "behind the eye"}}),
                                    3));
    write_svg(out / "wrong_surfaces.svg",
              figures::side_by_side(panels_of({{right, "right"},
                                               {mistaken(nearer, false, long_normal), "not unit vectors"},
                                               {mistaken(nearer, true, outward), "last one wins"}}),
                                    3));
}

void draw_all(const Path& out) {
    write_svg(out / "perpendicular.svg", perpendicular());
    write_svg(out / "four_cases.svg", four_cases());
    write_svg(out / "far_sphere.svg", far_spheres());
    write_file(out / "far_sphere.csv", far_sphere_errors());
    write_file(out / "far_sphere_single.csv", far_sphere_in_single());
    write_file(out / "small_root.csv", small_root_errors());
    draw_mistakes(out);
    figures::draw_scenes(out, __FILE__, {"normals", "inside", "row", "far"}, 240, 180);
}

}  // namespace

int main(int argc, char** argv) { return figures::draw_figures(argc, argv, draw_all); }
