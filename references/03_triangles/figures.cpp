// Figures of chapter 3: three inside tests, edge functions, the leak, and what rays and scan conversion cost.
// Usage: figures_03 DIRECTORY
#include "references/figures.hpp"
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/03_triangles/polygon.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "common/math/exact.hpp"
#include "common/render/scan_convert.hpp"
#include "references/03_triangles/knot.hpp"
#include "references/panels.hpp"
#include "tests/stability/naive.hpp"
#include "tests/stability/triangles.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <ctime>
#include <stdexcept>

using namespace rt;

namespace {

// ------------------------------------------------------------------------------------------- drawings

using Corners = std::array<Vec2, 3>;

const SvgFont italic{.size = 16, .italic = true};
const SvgFont middle{.size = 14, .anchor = "middle"};

void dot_at(Svg& svg, Vec2 at, const char* color, Real radius = 5) {
    circle(svg, at, radius, {.stroke = color, .width = 1, .fill = color});
}

void panel_title(Svg& svg, Real x, const char* title, const char* below) {
    text(svg, {x, 26}, title, {.size = 16, .anchor = "middle", .bold = true});
    text(svg, {x, 286}, below, middle);
}

/// Crossings of a half-line, areas, and signs of edge functions.
Svg inside_tests() {
    Svg svg{.width = 720, .height = 300, .body = {}};

    panel_title(svg, 120, "crossings", "5 crossings: odd, inside");
    const std::array<Vec2, 9> outline = {Vec2(20, 70),   Vec2(225, 50),  Vec2(225, 240),
                                         Vec2(185, 130), Vec2(150, 235), Vec2(118, 100),
                                         Vec2(105, 245), Vec2(25, 245),  Vec2(50, 160)};
    polygon(svg, outline, {.stroke = svg_color::ink, .width = 2, .fill = "#eef3f7"});
    const Vec2 p(70, 180);
    arrow(svg, p, {240, 180}, {.stroke = svg_color::blue, .width = 2});
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
        if ((a.y <= p.y) == (b.y <= p.y)) continue;
        const Real x = a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
        if (x > p.x) circle(svg, {x, p.y}, 5, {.stroke = svg_color::red, .width = 2, .fill = "white"});
    }
    dot_at(svg, p, svg_color::blue);

    panel_title(svg, 360, "areas", "weights, all positive: inside");
    const Corners t = {Vec2(270, 235), Vec2(455, 215), Vec2(345, 55)};
    const Vec2 q(355, 175);
    const std::array<const char*, 3> fills = {"#bfdcee", "#f6dfb3", "#bfe6da"};
    for (std::size_t i = 0; i < 3; ++i)
        polygon(svg, Corners{t[(i + 1) % 3], t[(i + 2) % 3], q},
                {.stroke = svg_color::grey, .width = 1, .fill = fills[i]});
    polygon(svg, t, {.stroke = svg_color::ink, .width = 2});
    dot_at(svg, q, svg_color::blue);
    text(svg, t[0] + Vec2(-14, 10), "a", italic);
    text(svg, t[1] + Vec2(6, 10), "b", italic);
    text(svg, t[2] + Vec2(-4, -8), "c", italic);
    text(svg, {386, 152}, "of a", {.size = 12, .anchor = "middle"});
    text(svg, {322, 150}, "of b", {.size = 12, .anchor = "middle"});
    text(svg, {358, 212}, "of c", {.size = 12, .anchor = "middle"});

    panel_title(svg, 600, "turns around the ray", "all turn the same way: inside");
    const Corners s = {Vec2(510, 235), Vec2(700, 205), Vec2(585, 55)};
    const Vec2 ray(592, 170);
    line(svg, {495, ray.y}, {712, ray.y}, {.stroke = svg_color::light, .width = 1.5});
    line(svg, {ray.x, 45}, {ray.x, 255}, {.stroke = svg_color::light, .width = 1.5});
    polygon(svg, s, {.stroke = svg_color::ink, .width = 2, .fill = "none"});
    for (const Vec2& corner : s) arrow(svg, ray, corner, {.stroke = svg_color::grey, .width = 1.5}, 8);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto angle = [&](Vec2 v) { return std::atan2(ray.y - v.y, v.x - ray.x); };
        const Real from = angle(s[i]);
        Real to = angle(s[(i + 1) % 3]);
        if (to < from) to += 2 * pi;
        arc(svg, ray, 30.0 + 5 * static_cast<Real>(i), from + 0.12, to - 0.12,
            {.stroke = svg_color::green, .width = 2.5});
    }
    dot_at(svg, ray, svg_color::blue);
    text(svg, s[0] + Vec2(-14, 10), "a", italic);
    text(svg, s[1] + Vec2(4, 14), "b", italic);
    text(svg, s[2] + Vec2(-4, -8), "c", italic);
    return svg;
}

/// Before and after the map that makes the ray the z axis.
Svg shear_figure() {
    Svg svg{.width = 700, .height = 245, .body = {}};
    const auto panel = [&](Real x, const char* title, Vec2 (*map)(Vec2)) {
        const auto at = [&](Vec2 v) {
            const Vec2 m = map(v);
            return Vec2(x + 46 * m.x, 150 - 46 * m.y);
        };
        text(svg, {x + 110, 26}, title, {.size = 16, .anchor = "middle", .bold = true});
        arrow(svg, {x - 20, 150}, {x + 285, 150}, {.stroke = svg_color::light, .width = 2});
        arrow(svg, {x, 235}, {x, 45}, {.stroke = svg_color::light, .width = 2});
        text(svg, {x + 272, 170}, "z", italic);
        text(svg, {x - 18, 58}, "x", italic);
        const Vec2 o(0, 0), d(5.6, 1.9), a(2.2, 2), b(4.6, 0.3);
        arrow(svg, at(o), at(d), {.stroke = svg_color::blue, .width = 2.5}, 11);
        line(svg, at(a), at(b), {.stroke = svg_color::ink, .width = 3});
        dot_at(svg, at(a), svg_color::ink, 4);
        dot_at(svg, at(b), svg_color::ink, 4);
        dot_at(svg, at(o), svg_color::blue, 4);
        for (const Vec2& corner : {a, b}) {
            // How far a corner is from the ray, across z: what the test looks at.
            const Vec2 foot(corner.x, corner.x * d.y / d.x);
            line(svg, at(corner), at(foot), {.stroke = svg_color::red, .width = 1.5, .dash = "4 3"});
        }
        text(svg, at(a) + Vec2(-4, -10), "a", italic);
        text(svg, at(b) + Vec2(2, 20), "b", italic);
        text(svg, at(d) + Vec2(-8, -12), "ray", {.size = 15, .color = svg_color::blue});
    };
    panel(45, "as it is", [](Vec2 v) { return v; });
    panel(400, "sheared: the ray is the z axis", [](Vec2 v) { return Vec2(v.x, v.y - v.x * 1.9 / 5.6); });
    return svg;
}

// ------------------------------------------------------------------------------------------- the leak

using Test = std::optional<Hit> (*)(const Triangle&, const Ray&, Interval);

/// Two triangles with a common edge, through a microscope: one pixel across is less than the spacing of the
/// numbers that the rays are made of. Blue and orange: one triangle hit; purple: both; white: a leak.
Image leak(Test test) {
    const Vec3 a(-0.71, -0.33, 0.2), b(0.82, 0.57, -0.4), c(-0.4, 0.9, 0.1), d(0.6, -0.8, 0.3),
        eye(0.3, 0.2, 3);
    const Triangle upper{a, b, c}, lower{b, a, d};
    Image image = make_image(113, 40);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Vec3 on_edge = a + (0.45 + 1e-15 * x) * (b - a);
            const Vec3 target = on_edge + Vec3(0, (image.height / 2 - y) * 0x1p-55, 0);
            const Ray ray{eye, target - eye};
            const bool up = test(upper, ray, Interval{}).has_value();
            const bool low = test(lower, ray, Interval{}).has_value();
            const Vec3 blue(0, 0.17, 0.45), orange(0.79, 0.35, 0), purple(0.6, 0.18, 0.39);
            pixel(image, x, y) = up && low ? purple : up ? blue : low ? orange : Vec3(1);
        }
    return image;
}

/// How many of `count` rays from inside of a closed mesh escape. Each is aimed at an edge from a point
/// nearby.
int escaped(Test test, const Mesh& mesh, const std::vector<Triangle>& triangles, int count) {
    int lost = 0;
    for (int i = 0; i < count; ++i) {
        const std::size_t k = static_cast<std::size_t>(i) % triangles.size();
        const auto corner = static_cast<std::size_t>(mesh.triangles[k][0].position);
        const Real along = 0.05 + 0.9 * std::fmod(i * 0.6180339887498949, 1.0);
        const Vec3 eye = mesh.positions[corner] - 0.3 * mesh.normals[corner];
        const Vec3 target = triangles[k].a + along * (triangles[k].b - triangles[k].a);
        const Ray ray{eye, target - eye};
        lost += std::none_of(triangles.begin(), triangles.end(),
                             [&](const Triangle& t) { return test(t, ray, Interval{}).has_value(); });
    }
    return lost;
}

std::vector<Triangle> triangles_of(const Mesh& mesh) {
    std::vector<Triangle> triangles;
    const auto at = [&](const Mesh::Corner& corner) {
        return mesh.positions[static_cast<std::size_t>(corner.position)];
    };
    for (const auto& [a, b, c] : mesh.triangles) triangles.push_back({at(a), at(b), at(c)});
    return triangles;
}

// ----------------------------------------------------------------------------------------- mistakes

/// A knot by a ray caster that makes a mistake: `accept` says which hits count, `nearer` whether a new hit
/// takes the place of the one before it, `weigh` the weights at which normals are interpolated.
struct Mistaken {
    const char* words;
    bool (*accept)(const Vec3& flat_normal, const Ray& ray);
    bool (*nearer)(const Hit& hit, const Hit& before);
    Vec2 (*weigh)(const Vec2& uv);
};

/// A picture a mistake.
std::vector<figures::Panel> panels_of(const std::vector<Mistaken>& mistakes) {
    const int width = 186, height = 176;
    const Mesh mesh = knot(60, 10);
    const std::vector<Triangle> triangles = triangles_of(mesh);
    const Camera camera{.eye = {1.5, -4.5, 8.5}, .look_at = {0, -0.1, 0}, .up = {0, 1, 0}};
    const View view{.frame = camera_frame(camera),
                    .eye = camera.eye,
                    .half_height = std::tan(radians(21)),
                    .width = width,
                    .height = height};
    std::vector<figures::Panel> panels;
    for (const Mistaken& mistake : mistakes) {
        panels.push_back({make_image(width, height), mistake.words});
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Ray ray = pixel_ray(view, x + 0.5, y + 0.5);
                std::optional<Hit> best;
                for (std::size_t i = 0; i < triangles.size(); ++i) {
                    std::optional<Hit> hit = intersect(triangles[i], ray, Interval{});
                    if (!hit || !mistake.accept(unit_normal(triangles[i]), ray)) continue;
                    if (best && !mistake.nearer(*hit, *best)) continue;
                    hit->primitive = static_cast<std::uint32_t>(i);
                    best = hit;
                }
                Vec3& p = pixel(panels.back().image, x, y);
                p = Vec3(0.02, 0.02, 0.03);
                if (!best) continue;
                const auto normal = [&](std::size_t corner) {
                    return mesh
                        .normals[static_cast<std::size_t>(mesh.triangles[best->primitive][corner].normal)];
                };
                const Vec3 n = interpolate(TriangleNormals{normal(0), normal(1), normal(2)},
                                           mistake.weigh(best->uv), Vec3(0, 0, 1));
                p = 0.5 * ((glm::dot(n, ray.direction) > 0 ? -n : n) + Vec3(1));
            }
    }
    return panels;
}

Svg mistakes() {
    const auto any = [](const Vec3&, const Ray&) { return true; };
    const auto back = [](const Vec3& n, const Ray& ray) { return glm::dot(n, ray.direction) > 0; };
    const auto first = [](const Hit& hit, const Hit& before) { return hit.t < before.t; };
    const auto last = [](const Hit&, const Hit&) { return true; };
    const auto as_they_are = [](const Vec2& uv) { return uv; };
    const auto exchanged = [](const Vec2& uv) { return Vec2(uv.y, uv.x); };
    return figures::side_by_side(panels_of({{"right", any, first, as_they_are},
                                            {"swapped weights", any, first, exchanged},
                                            {"backs only", back, first, as_they_are},
                                            {"last hit", any, last, as_they_are}}),
                                 4);
}

/// Crossings where both ends of an edge count.
bool in_polygon_by_both_ends(std::span<const Vec2> polygon, const Vec2& point) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2& p = polygon[i];
        const Vec2& q = polygon[(i + 1) % polygon.size()];
        if (point.y < std::min(p.y, q.y) || point.y > std::max(p.y, q.y) || p.y == q.y) continue;
        if (p.x + (point.y - p.y) / (q.y - p.y) * (q.x - p.x) > point.x) inside = !inside;
    }
    return inside;
}

/// An outline filled pixel by pixel; all its corners are at the height of a row of pixels.
Svg corners() {
    const std::vector<Vec2> outline{{4, 22},  {14, 4},  {26, 12}, {39, 2},  {60, 18}, {52, 26},
                                    {61, 40}, {44, 34}, {34, 43}, {24, 30}, {13, 38}};
    const auto filled = [&](bool (*inside)(std::span<const Vec2>, const Vec2&)) {
        Image image = make_image(64, 46);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                pixel(image, x, y) =
                    inside(outline, Vec2(x, y)) ? Vec3(0.9, 0.85, 0.7) : Vec3(0.03, 0.04, 0.08);
        return image;
    };
    return figures::side_by_side(
        {{filled(point_in_polygon), "lower ends only"}, {filled(in_polygon_by_both_ends), "both ends"}}, 2,
        5);
}

// --------------------------------------------------------------------------------------- measurements

/// Median of the processor time of `repeats` calls, which run on one thread.
template <class Work>
double median_seconds(int repeats, Work work) {
    std::vector<double> times;
    for (int i = 0; i < repeats; ++i) {
        const std::clock_t start = std::clock();
        work();
        times.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

/// A knot of 2·along·around triangles or, for 0, a ring of six spheres; the camera of the chapter's pictures.
World world_of(int along, int around, int width, int height) {
    Scene scene;
    scene.width = width;
    scene.height = height;
    scene.integrator = Integrator::Normals;
    scene.accelerator = AcceleratorChoice::None;  // every ray asks every triangle: chapter 9 is not there yet
    scene.camera = {.eye = {1.5, -4.5, 8.5}, .look_at = {0, -0.1, 0}, .up = {0, 1, 0}, .fovy = radians(42)};
    scene.materials.push_back({});
    if (along > 0) {
        scene.meshes.push_back(knot(along, around));
        scene.objects.push_back({.shape = MeshObject{0}, .place = {}});
    } else {
        for (int i = 0; i < 6; ++i)
            scene.objects.push_back(
                {.shape = Sphere{{std::cos(i * pi / 3) * 2, std::sin(i * pi / 3) * 2, 0}, 0.9}, .place = {}});
    }
    return compile(scene);
}

std::vector<Ray> rays_of(const World& world) {
    std::vector<Ray> rays;
    for (int y = 0; y < world.view.height; ++y)
        for (int x = 0; x < world.view.width; ++x) rays.push_back(pixel_ray(world.view, x + 0.5, y + 0.5));
    return rays;
}

/// What ray casting does for a picture of one ray a pixel, and how long it takes, in seconds.
struct CastTimes {
    double camera = 0;         ///< making rays
    double intersections = 0;  ///< finding what they hit
    double shading = 0;        ///< the surface there, and its colour
};

CastTimes measured_cast(const World& world) {
    std::vector<Ray> rays;
    std::vector<std::optional<Hit>> hits(static_cast<std::size_t>(world.view.width * world.view.height));
    Vec3 sum(0);
    CastTimes times;
    times.camera = median_seconds(9, [&] { rays = rays_of(world); });
    times.intersections = median_seconds(world.primitives.size() * rays.size() > 50'000'000 ? 3 : 9, [&] {
        for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = closest_hit(world, rays[i], {0, infinity});
    });
    times.shading = median_seconds(9, [&] {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (!hits[i]) continue;
            const Vec3 n = surface_at(world, rays[i], *hits[i]).shading_normal;
            sum += 0.5 * ((glm::dot(n, rays[i].direction) > 0 ? -n : n) + Vec3(1));
        }
    });
    if (!(sum.x > 0)) throw std::runtime_error("nothing is in the picture");
    return times;
}

/// The same work is measured once, so that no two tables say two times for it.
struct Measured {
    int along, around, width, height;
    World world = world_of(along, around, width, height);
    CastTimes cast = measured_cast(world);
};

/// Two significant digits, as the lesson says them.
std::string two_digits(double x) {
    const double unit = std::pow(10., std::floor(std::log10(x)) - 1);
    return fmt::format("{}", std::stod(fmt::format("{:.6f}", std::round(x / unit) * unit)));
}

/// As the lesson writes it: "1,200 triangles".
std::string triangles_in(const Measured& knot) {
    const std::size_t count = knot.world.primitives.size();
    return count < 1000 ? fmt::format("{} triangles", count)
                        : fmt::format("{},{:03} triangles", count / 1000, count % 1000);
}

/// Finding what each pixel sees, both ways, on one thread.
std::string scan_conversion(const std::vector<Measured>& knots) {
    std::string csv = "triangles and pixels,\"ray casting, ms\",\"scan conversion, ms\"\n";
    for (const Measured& knot : knots) {
        std::size_t seen = 0;
        const double scanned = median_seconds(9, [&] { seen += scan_convert(knot.world).size(); });
        if (seen > 0)
            csv += fmt::format("\"{}, {}×{} pixels\",{},{}\n", triangles_in(knot), knot.width, knot.height,
                               two_digits(1e3 * (knot.cast.camera + knot.cast.intersections)),
                               two_digits(1e3 * scanned));
    }
    return csv;
}

/// Where the time of ray casting goes.
std::string profile(const std::vector<Measured>& knots) {
    std::string csv =
        "scene,\"camera, percent\",\"intersections, percent\",\"shading, percent\",\"total, ms\"\n";
    for (const Measured& knot : knots) {
        const double total = knot.cast.camera + knot.cast.intersections + knot.cast.shading;
        csv += fmt::format("\"{}\",{:.2f},{:.2f},{:.2f},{}\n",
                           knot.along == 0 ? "6 spheres" : triangles_in(knot), 100 * knot.cast.camera / total,
                           100 * knot.cast.intersections / total, 100 * knot.cast.shading / total,
                           two_digits(1e3 * total));
    }
    return csv;
}

// -------------------------------------------------------------------------------- what the filter is good
// for

/// The watertight test that believes every sign, as Woop, Benthin and Wald have it.
std::optional<Hit> without_filter(const stability::TriangleCase& item) {
    const ShearedRay ray = shear(item.ray);
    const auto& [triangle, unused] = item;
    const Vec3 a = seen(ray, triangle.a), b = seen(ray, triangle.b), c = seen(ray, triangle.c);
    const Real e_a = edge_function(Vec2(c), Vec2(b)), e_b = edge_function(Vec2(a), Vec2(c)),
               e_c = edge_function(Vec2(b), Vec2(a));
    if (std::min({e_a, e_b, e_c}) < 0 && std::max({e_a, e_b, e_c}) > 0) return std::nullopt;
    if (e_a + e_b + e_c == 0) return std::nullopt;
    return hit_of_seen(ray, a, b, c, {});
}

constexpr std::size_t decided = 100'000, needles = 10'000;
constexpr int rays_at_edges = 20'000;

/// Wrong decisions, without filter and fallback and with them.
std::string decisions() {
    constexpr std::size_t count = decided;
    std::string csv = "cases,count,wrong_without,wrong\n";
    for (const stability::TriangleFamily& family : stability::triangle_families()) {
        const auto cases = family.make(count, 3);
        std::vector<std::optional<Hit>> plain, exact;
        for (const stability::TriangleCase& item : cases) {
            plain.push_back(without_filter(item));
            exact.push_back(intersect(item.triangle, item.ray, {}));
        }
        csv += fmt::format("\"{}\",{},{},{}\n", family.name, count, judge(cases, plain).mismatches,
                           judge(cases, exact).mismatches);
    }
    const auto cases = stability::tiles_cases(count, 3);
    std::vector<std::size_t> plain, exact;
    for (const stability::TilesCase& item : cases) {
        plain.push_back(tiles_hit(item, naive::intersect));
        exact.push_back(tiles_hit(item, rt::intersect));
    }
    return csv + fmt::format("\"seams of tiles\",{},{},{}\n", count, judge(cases, plain).mismatches,
                             judge(cases, exact).mismatches);
}

/// How far the normals of many needles are off at most, in radians: the product of the unit edges from the
/// tip, from a blunt corner, and the chapter's.
std::string normals_of_needles() {
    Real tip = 0, blunt = 0, chapter = 0;
    for (const stability::TriangleCase& item : stability::needles(needles, 3)) {
        const auto& [a, b, c] = item.triangle;
        const Vec3 right = unit_vector(exact_normal(std::array{a, b, c}));
        const Vec3 from_a = unit_vector(cross(unit_vector(b - a), unit_vector(c - a)));
        const bool a_is_tip = length(b - c) < std::min(length(a - b), length(a - c));
        Real& worst = a_is_tip ? tip : blunt;
        worst = std::max(worst, length(from_a - right));
        chapter = std::max(chapter, length(unit_normal(item.triangle) - right));
    }
    return fmt::format(
        "normal of a needle,\"off by, in radians\"\nfrom the edges at the tip,{:.2g}\nfrom the edges at a "
        "blunt "
        "corner,{:.2g}\nby this chapter,{:.2g}\n",
        tip, blunt, chapter);
}

void draw_all(const figures::Path& out) {
    write_svg(out / "inside_tests.svg", inside_tests());
    write_svg(out / "shear.svg", shear_figure());
    write_svg(out / "corners.svg", corners());
    write_svg(out / "leak.svg",
              figures::side_by_side(
                  {{leak(naive::intersect), "Möller–Trumbore"}, {leak(rt::intersect), "watertight"}}, 2, 3));
    write_svg(out / "mistakes.svg", mistakes());

    const Mesh mesh = knot(60, 10);
    const std::vector<Triangle> triangles = triangles_of(mesh);
    write_file(out / "escaped_rays.csv",
               fmt::format("test,rays,escaped\nMöller–Trumbore,{0},{1}\nwatertight,{0},{2}\n", rays_at_edges,
                           escaped(naive::intersect, mesh, triangles, rays_at_edges),
                           escaped(rt::intersect, mesh, triangles, rays_at_edges)));

    write_file(out / "decisions.csv", decisions());
    write_file(out / "normals_of_needles.csv", normals_of_needles());
    figures::Numbers numbers;
    numbers.add("needles", needles);
    numbers.add("rays at edges of the knot", rays_at_edges);
    numbers.add("decisions", decided);
    numbers.write(out);

    figures::draw_scenes(out, __FILE__, {"flat", "smooth", "polygon", "mixed", "uv"});
    const Measured spheres{0, 0, 160, 120}, small{15, 10, 160, 120}, middling{60, 10, 160, 120};
    write_file(out / "measured_scan_conversion.csv", scan_conversion({small,
                                                                      middling,
                                                                      {120, 20, 160, 120},
                                                                      {60, 10, 80, 60},
                                                                      {60, 10, 320, 240},
                                                                      {60, 10, 640, 480},
                                                                      {500, 100, 64, 48}}));
    write_file(out / "measured_profile.csv", profile({spheres, small, middling, {200, 20, 160, 120}}));
}

}  // namespace

int main(int argc, char** argv) { return figures::draw_figures(argc, argv, draw_all); }
