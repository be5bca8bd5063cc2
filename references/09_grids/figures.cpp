// Draws the figures of lesson 9 into the directory that it is given.
// Boxes, cells and counts in them are those of the course's own functions.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/09_grids/walk.hpp"
#include "common/math/random.hpp"
#include "references/09_grids/teapots.hpp"
#include "references/costs.hpp"

#include <fmt/format.h>

#include <array>

using namespace rt;
using namespace rt::figures;
using teapot::rays_around;
using teapot::teapot_of;

namespace {

/// Numbers of the lesson that have no figure of their own: what each is, and its value.
std::string numbers = "name,value\n";
template <class Value>
void note_number(const std::string& name, const Value& value) {
    numbers += fmt::format("{},{}\n", name, value);
}

// The slab test -----------------------------------------------------------------------------------------

void draw_slabs(const Path& directory) {
    Svg svg{.width = 700, .height = 430};
    const Bounds box{{2.4, 1.2, -1}, {5.2, 2.9, 1}};
    const Ray ray{{0.4, 0.45, 0}, {1, 0.5, 0}};
    const auto place = [](Real x, Real y) { return Vec2(30 + 92 * x, 285 - 80 * y); };
    const Real right = 6.9, top = 3.35;
    rectangle(svg, place(box.low.x, top), {92 * (box.high.x - box.low.x), 80 * top},
              {.stroke = "none", .fill = "#dcebf5", .opacity = 0.7});
    rectangle(svg, place(0, box.high.y), {92 * right, 80 * (box.high.y - box.low.y)},
              {.stroke = "none", .fill = "#fbe6d4", .opacity = 0.7});
    for (const Real x : {box.low.x, box.high.x})
        line(svg, place(x, 0), place(x, top), {.stroke = blue, .width = 1.2, .dash = "5 4"});
    for (const Real y : {box.low.y, box.high.y})
        line(svg, place(0, y), place(right, y), {.stroke = red, .width = 1.2, .dash = "5 4"});
    rectangle(svg, place(box.low.x, box.high.y),
              {92 * (box.high.x - box.low.x), 80 * (box.high.y - box.low.y)}, {.stroke = ink, .width = 2.2});
    const auto at = [&](Real t) { return place(point_at(ray, t).x, point_at(ray, t).y); };
    arrow(svg, at(0), at(6.1), {.stroke = ink, .width = 1.6});
    dot_at(svg, at(0), ink, 5);
    text(svg, at(0) + Vec2(-4, 22), "o", {.size = 17, .italic = true});
    const auto x_at = [&](Real x) { return (x - ray.origin.x) / ray.direction.x; };
    const auto y_at = [&](Real y) { return (y - ray.origin.y) / ray.direction.y; };
    const std::array<Real, 2> tx{x_at(box.low.x), x_at(box.high.x)}, ty{y_at(box.low.y), y_at(box.high.y)};
    for (const Real t : tx) dot_at(svg, at(t), blue, 5);
    for (const Real t : ty) dot_at(svg, at(t), red, 5);
    text(svg, place(2.4, 3.35) + Vec2(6, 16), "between the x planes", colored(label, blue));
    text(svg, place(0, 2.9) + Vec2(6, 18), "between the y planes", colored(label, red));
    // The same on the t axis.
    const Interval inside = clip(box, ray, {0, infinity}).value_or(Interval{0, 0});
    const auto on_axis = [](Real t) { return 67 + 92 * t; };
    const std::array<std::pair<std::array<Real, 2>, const char*>, 2> spans{{{tx, blue}, {ty, red}}};
    for (std::size_t i = 0; i < 2; ++i) {
        const Real y = 322 + 26 * static_cast<Real>(i);
        line(svg, {on_axis(spans[i].first[0]), y}, {on_axis(spans[i].first[1]), y},
             {.stroke = spans[i].second, .width = 5});
        text(svg, {on_axis(spans[i].first[0]) - 10, y + 5}, i == 0 ? "tx₀" : "ty₀",
             {.size = 16, .color = spans[i].second, .anchor = "end"});
        text(svg, {on_axis(spans[i].first[1]) + 10, y + 5}, i == 0 ? "tx₁" : "ty₁",
             {.size = 16, .color = spans[i].second});
    }
    line(svg, {on_axis(inside.min), 380}, {on_axis(inside.max), 380}, {.width = 6});
    text(svg, {on_axis((inside.min + inside.max) / 2), 373}, "inside both", middle(label));
    arrow(svg, {on_axis(0), 400}, {on_axis(6.3), 400});
    text(svg, {on_axis(6.3) + 8, 405}, "t", {.size = 16, .italic = true});
    for (int t = 0; t <= 6; ++t) {
        line(svg, {on_axis(t), 397}, {on_axis(t), 403});
        text(svg, {on_axis(t), 420}, std::to_string(t), middle(SvgFont{.size = 12, .color = grey}));
    }
    write_svg(directory / "slabs.svg", svg);
}

std::string shown(Real x) {
    if (std::isnan(x)) return "NaN";
    if (std::isinf(x)) return x > 0 ? "∞" : "−∞";
    if (x == 0) return std::signbit(x) ? "−0" : "0";
    return (x < 0 ? "−" : "") + fmt::format("{:.4g}", std::abs(x));
}

/// What IEEE arithmetic gives for (plane − o)/d along one axis, and what becomes of it.
void write_zeros(const Path& directory) {
    std::string csv =
        "case,o,d,low,high,(low-o)/d,(high-o)/d,min/max of both by std::min and std::max,clip\n";
    struct {
        const char* name;
        Real o, d, low, high;
    } const cases[] = {{"ahead", 0, 1, 2, 3},
                       {"backwards", 5, -1, 2, 3},
                       {"between", 2.5, 0, 2, 3},
                       {"between (-0)", 2.5, -0.0, 2, 3},
                       {"beside", 4, 0, 2, 3},
                       {"beside (-0)", 4, -0.0, 2, 3},
                       {"in the low face", 2, 0, 2, 3},
                       {"in the low face (-0)", 2, -0.0, 2, 3},
                       {"in the high face", 3, 0, 2, 3},
                       {"in a flat box", 2, 0, 2, 2},
                       {"overflow", 0, 1e-300, 1e200, 2e200}};
    for (const auto& c : cases) {
        const Real a = (c.low - c.o) / c.d, b = (c.high - c.o) / c.d;
        // The other axes are no obstacle.
        const Bounds box{{c.low, -1, -1}, {c.high, 1, 1}};
        const auto inside = clip(box, {{c.o, 0, 0}, {c.d, 0, 0}}, {0, infinity});
        csv += fmt::format("{},{},{},{},{},{},{},{} to {},{}\n", c.name, shown(c.o), shown(c.d), shown(c.low),
                           shown(c.high), shown(a), shown(b), shown(std::min(a, b)), shown(std::max(a, b)),
                           inside ? shown(inside->min) + " to " + shown(inside->max) : "missed");
    }
    write_file(directory / "zeros.csv", csv);
}

// The walk ----------------------------------------------------------------------------------------------

void draw_walk(const Path& directory) {
    Svg svg{.width = 700, .height = 400};
    const GridShape shape{{{0, 0, 0}, {8, 5, 1}}, {8, 5, 1}};
    const Ray ray{{-0.8, -0.1, 0.5}, {1, 0.5, 0}};
    const auto place = [](Real x, Real y) { return Vec2(105 + 62 * x, 355 - 62 * y); };
    const std::vector<CellVisit> visits = cells_along(shape, ray, {0, infinity});
    for (std::size_t i = 0; i < visits.size(); ++i) {
        const Vec2 corner = place(visits[i].cell.x, visits[i].cell.y + 1);
        rectangle(svg, corner, {62, 62}, {.stroke = "none", .fill = "#e3eff7"});
        // Where the ray is not.
        const Real middle_y = point_at(ray, (visits[i].t.min + visits[i].t.max) / 2).y - visits[i].cell.y;
        const SvgFont font{
            .size = 14, .color = blue, .anchor = middle_y < 0.5 ? "start" : "end", .bold = true};
        text(svg, corner + (middle_y < 0.5 ? Vec2(7, 18) : Vec2(55, 55)), std::to_string(i + 1), font);
    }
    for (int x = 0; x <= 8; ++x) line(svg, place(x, 0), place(x, 5), {.stroke = grey, .width = 1});
    for (int y = 0; y <= 5; ++y) line(svg, place(0, y), place(8, y), {.stroke = grey, .width = 1});
    const auto at = [&](Real t) { return place(point_at(ray, t).x, point_at(ray, t).y); };
    arrow(svg, at(0), at(9.4), {.width = 1.6});
    dot_at(svg, at(0), ink, 5);
    text(svg, at(0) + Vec2(-4, 24), "o", {.size = 17, .italic = true});
    for (int i = 0; i <= 8; ++i) {
        const Real t = (i - ray.origin.x) / ray.direction.x;
        dot_at(svg, at(t), blue, 4.5);
        text(svg, place(i, 0) + Vec2(0, 22), fmt::format("x{}: {:.1f}", i, t),
             middle(colored(SvgFont{.size = 14}, blue)));
    }
    for (int i = 0; i <= 4; ++i) {
        const Real t = (i - ray.origin.y) / ray.direction.y;
        dot_at(svg, at(t), red, 4.5);
        text(svg, place(8, i) + Vec2(12, 5), fmt::format("y{}: {:.1f}", i, t), colored(label, red));
    }
    write_svg(directory / "walk.svg", svg);
    std::string csv = "visit,cell x,cell y,t from,t to\n";
    for (std::size_t i = 0; i < visits.size(); ++i)
        csv += fmt::format("{},{},{},{:.3g},{:.3g}\n", i + 1, visits[i].cell.x, visits[i].cell.y,
                           visits[i].t.min, visits[i].t.max);
    write_file(directory / "walk.csv", csv);
}

/// How far computed boundaries are off: t += Δ against t₀ + i·Δ, with the same t₀ and Δ.
void draw_drift(const Path& directory) {
    const int most = 1024, rays = 2000;
    std::vector<Real> added(most + 1), multiplied(most + 1);
    Random random = random_for(9, 0, 0);
    for (int ray = 0; ray < rays; ++ray) {
        const Real o = -random_real(random), d = 0.05 + random_real(random),
                   width = (1 + random_real(random)) / most;
        const Real t0 = (0 - o) / d, step = width / d;
        Real sum = t0;
        for (int i = 1; i <= most; ++i) {
            sum += step;
            const long double exact = (static_cast<long double>(i) * width - o) / d;
            const auto off = [&](Real t) {
                return static_cast<Real>(std::abs((t - exact) / exact)) * 0x1p53;
            };
            added[static_cast<std::size_t>(i)] = std::max(added[static_cast<std::size_t>(i)], off(sum));
            multiplied[static_cast<std::size_t>(i)] =
                std::max(multiplied[static_cast<std::size_t>(i)], off(t0 + i * step));
        }
    }
    std::string csv = "boundary,worst error of t += step (units of u*t),worst error of t0 + i*step\n";
    std::vector<Vec2> add, multiply;
    for (int i = 1; i <= most; i *= 2) {
        const auto n = static_cast<std::size_t>(i);
        csv += fmt::format("{},{:.1f},{:.1f}\n", i, added[n], multiplied[n]);
        add.push_back({i, added[n]}), multiply.push_back({i, multiplied[n]});
    }
    write_file(directory / "drift.csv", csv);
    Svg svg{.width = 700, .height = 330};
    const Plot plot{{80, 50}, {560, 220}, {1, 1100, true}, {1, 1000, true}};
    draw_axes(svg, plot, "number of the boundary", "error of its t, in units of u·t");
    draw_curve(svg, plot, add, red);
    draw_curve(svg, plot, multiply, blue);
    text(svg, plot.place(24, add[5].y) + Vec2(-8, -16), "t += Δ",
         colored(SvgFont{.size = 16, .italic = true}, red));
    text(svg, plot.place(100, 2.4), "t₀ + i·Δ", colored(SvgFont{.size = 16, .italic = true}, blue));
    write_svg(directory / "drift.svg", svg);
}

// Overlap -----------------------------------------------------------------------------------------------

void draw_overlap(const Path& directory) {
    const GridShape shape{{{0, 0, -0.5}, {14, 8, 0.5}}, {14, 8, 1}};
    const Triangle triangle{{0.6, 0.5, 0}, {13.3, 6.6, 0}, {12.2, 7.5, 0}};
    const auto place = [](Real x, Real y) { return Vec2(42 + 44 * x, 380 - 44 * y); };
    Svg svg{.width = 700, .height = 396};
    int by_box = 0, by_axes = 0;
    for (int x = 0; x < 14; ++x)
        for (int y = 0; y < 8; ++y) {
            const Bounds cell = cell_box(shape, {x, y, 0});
            if (!overlaps(bounds_of(triangle), cell)) continue;
            ++by_box;
            const bool both = overlaps(triangle, cell);
            by_axes += both;
            rectangle(svg, place(x, y + 1), {44, 44},
                      {.stroke = "none", .fill = both ? "#9cc9e6" : "#f0f0f0"});
        }
    for (int x = 0; x <= 14; ++x) line(svg, place(x, 0), place(x, 8), {.stroke = "#c4c4c4", .width = 1});
    for (int y = 0; y <= 8; ++y) line(svg, place(0, y), place(14, y), {.stroke = "#c4c4c4", .width = 1});
    const std::array<Vec2, 3> corners{place(triangle.a.x, triangle.a.y), place(triangle.b.x, triangle.b.y),
                                      place(triangle.c.x, triangle.c.y)};
    polygon(svg, corners, {.stroke = red, .width = 2, .fill = red, .opacity = 0.75});
    const Bounds box = bounds_of(triangle);
    rectangle(svg, place(box.low.x, box.high.y),
              {44 * (box.high.x - box.low.x), 44 * (box.high.y - box.low.y)},
              {.stroke = ink, .width = 1.3, .dash = "5 4"});
    text(svg, {42, 16}, fmt::format("{} cells meet the box around it, {} the triangle", by_box, by_axes),
         {.size = 16});
    write_svg(directory / "overlap.svg", svg);

    // The same in space: a triangle across a cube of n × n × n cells.
    std::string csv = "cells along an edge,cells that its box meets,cells that it meets\n";
    for (const int n : {4, 8, 16, 32, 64}) {
        const GridShape cube{{{0, 0, 0}, {1, 1, 1}}, {n, n, n}};
        const Triangle across{{0.01, 0.02, 0.03}, {0.98, 0.05, 0.97}, {0.04, 0.99, 0.9}};
        std::array<int, 2> count{0, 0};
        for (int z = 0; z < n; ++z)
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) {
                    const Bounds cell = cell_box(cube, {x, y, z});
                    count[0] += overlaps(bounds_of(across), cell);
                    count[1] += overlaps(across, cell);
                }
        csv += fmt::format("{},{},{}\n", n, count[0], count[1]);
    }
    write_file(directory / "overlap.csv", csv);
}

/// A hit that is found in an early cell but lies in a later one.
void draw_behind(const Path& directory) {
    Svg svg{.width = 700, .height = 260};
    const auto place = [](Real x, Real y) { return Vec2(60 + 116 * x, 215 - 92 * y); };
    for (int i = 0; i < 5; ++i) rectangle(svg, place(i, 1.5), {116, 138}, {.stroke = grey, .width = 1.2});
    for (int i = 0; i < 5; ++i)
        text(svg, place(i + 0.5, 0) + Vec2(0, 20), std::to_string(i + 1), middle(remark));
    const std::array<Vec2, 3> large{place(0.45, 0.1), place(4.75, 1.38), place(4.86, 1.2)};
    polygon(svg, large, {.stroke = blue, .width = 1.6, .fill = "#dcebf5"});
    const std::array<Vec2, 3> near{place(2.42, 0.95), place(2.7, 0.62), place(2.62, 1.2)};
    polygon(svg, near, {.stroke = red, .width = 1.6, .fill = "#f6d9c6"});
    const Vec2 from = place(-0.35, 1.12), to = place(5.25, 0.94);
    const Vec2 d = to - from;
    arrow(svg, from, to, {.width = 1.6});
    const auto meet = [&](Vec2 a, Vec2 b) {
        const Vec2 e = b - a, f = a - from;
        return from + d * ((f.x * e.y - f.y * e.x) / (d.x * e.y - d.y * e.x));
    };
    dot_at(svg, meet(large[0], large[1]), blue, 5.5);
    dot_at(svg, meet(near[0], near[2]), red, 5.5);
    text(svg, place(0.06, 1.28), "asked here …", colored(SvgFont{.size = 14}, blue));
    text(svg, place(3.5, 0.5), "… hit in cell 4", middle(colored(SvgFont{.size = 14}, blue)));
    text(svg, place(2.05, 1.32), "nearer", colored(SvgFont{.size = 16}, red));
    write_svg(directory / "behind.svg", svg);
}

// Teapots -----------------------------------------------------------------------------------------------

/// Cells of the grid and of those in it, entries in their lists, the longest list, and how many grids.
struct Inventory {
    std::size_t grids = 0, cells = 0, items = 0, longest = 0;
};
void take(const Grid& grid, Inventory& inventory) {
    ++inventory.grids;
    inventory.cells += grid.first.size() - 1;
    inventory.items += grid.items.size();
    for (std::size_t i = 0; i + 1 < grid.first.size(); ++i)
        inventory.longest = std::max<std::size_t>(inventory.longest, grid.first[i + 1] - grid.first[i]);
    for (const Grid& inner : grid.grids) take(inner, inventory);
}

struct Leaf {
    const Grid* grid = nullptr;
    std::size_t cell = 0;
    std::size_t count = 0;
};

/// The innermost cell at a point.
Leaf leaf_at(const Grid& grid, const Vec3& point) {
    const Vec3 share =
        (point - grid.shape.box.low) / (grid.shape.box.high - grid.shape.box.low) * Vec3(grid.shape.cells);
    Cells cell;
    for (int i = 0; i < 3; ++i) {
        if (!(share[i] >= 0 && share[i] < grid.shape.cells[i])) return {};
        cell[i] = static_cast<std::int32_t>(share[i]);
    }
    const auto number =
        static_cast<std::size_t>((cell.z * grid.shape.cells.y + cell.y) * grid.shape.cells.x + cell.x);
    if (!grid.inner.empty() && grid.inner[number] > 0)
        return leaf_at(grid.grids[grid.inner[number] - 1], point);
    return {&grid, number, grid.first[number + 1] - grid.first[number]};
}

/// Shapes in each cell of a level cut through the teapot, seen from above.
Image cut(const Grid& grid) {
    const int size = 344;
    Image image = make_image(size, size);
    const auto leaf = [&](int x, int y) {
        const Real reach = 5;
        return leaf_at(grid,
                       {reach * (2 * (x + 0.5) / size - 1) + 0.3, 2.2, reach * (2 * (y + 0.5) / size - 1)});
    };
    const auto same = [](const Leaf& a, const Leaf& b) { return a.grid == b.grid && a.cell == b.cell; };
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Leaf here = leaf(x, y);
            const bool edge = !same(here, leaf(x + 1, y)) || !same(here, leaf(x, y + 1));
            pixel(image, x, y) = heat(static_cast<Real>(here.count)) * (edge ? 0.72 : 1.0);
        }
    return image;
}

void draw_stadium(const Path& directory) {
    const int width = 256, height = 192;
    const World world = compile(scene_beside(__FILE__, "stadium", width, height));
    const std::vector<Triangle> triangles = shapes_of<Triangle>(world);
    std::string csv =
        "accelerator,grids,cells,entries,longest list,bytes a triangle,triangles asked a ray,most asked,"
        "cells entered a ray,most entered\n";
    csv += fmt::format("none,0,0,0,0,0,{0},{0},0,0\n", triangles.size());
    std::vector<Image> heats, cuts;
    for (const bool nested : {false, true}) {
        const Grid grid = build_grid(triangles, {.nested = nested});
        if (!nested) {
            const std::size_t teapot = teapot_of(40).size();
            note_number("triangles of the teapot", teapot);
            note_number("other triangles of the stadium", triangles.size() - teapot);
            for (int a = 0; a < 3; ++a)
                note_number(fmt::format("cells of the stadium along {}", "xyz"[a]), grid.shape.cells[a]);
            const Vec3 size = (grid.shape.box.high - grid.shape.box.low) / Vec3(grid.shape.cells);
            note_number("edge of the stadium's cells", fmt::format("{:.2f}", size.x));
        }
        cuts.push_back(cut(grid));
        Image shapes = make_image(width, height), cells = shapes;
        Mailbox mailbox;
        SearchCounts sum, most;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const SearchCounts one =
                    cost(grid, triangles, pixel_ray(world.view, x + 0.5, y + 0.5), mailbox);
                pixel(shapes, x, y) = heat(static_cast<Real>(one.shapes));
                pixel(cells, x, y) = heat(static_cast<Real>(one.cells));
                sum.cells += one.cells, sum.shapes += one.shapes;
                most.cells = std::max(most.cells, one.cells), most.shapes = std::max(most.shapes, one.shapes);
            }
        heats.push_back(shapes), heats.push_back(cells);
        Inventory inventory;
        take(grid, inventory);
        const Real rays = width * height;
        csv += fmt::format("{},{},{},{},{},{:.0f},{:.1f},{},{:.1f},{}\n", nested ? "nested" : "grid",
                           inventory.grids, inventory.cells, inventory.items, inventory.longest,
                           static_cast<Real>(bytes_of(grid)) / static_cast<Real>(triangles.size()),
                           static_cast<Real>(sum.shapes) / rays, most.shapes,
                           static_cast<Real>(sum.cells) / rays, most.cells);
    }
    write_file(directory / "stadium.csv", csv);
    write_image(directory / "heat.png", in_rows(heats, 2));
    write_image(directory / "cut.png", in_rows(cuts, 2));
}

/// Shapes and rays of the chapter's scenes, and how many rays a second there are with and without grids.
void measure_scenes(const Path& directory) {
    std::string csv = "scene and accelerator,rays,s,rays/s,minutes for all rays\n";
    const std::array<std::pair<AcceleratorChoice, const char*>, 3> accelerators{
        {{AcceleratorChoice::None, "none"},
         {AcceleratorChoice::Grid, "grid"},
         {AcceleratorChoice::Nested, "nested"}}};
    for (const char* name : {"stadium", "crowd", "forest", "cloud"}) {
        std::array<Real, 3> speeds{};
        Real rays = 0;
        std::array<std::string, 3> rows;
        for (std::size_t i = 0; i < accelerators.size(); ++i) {
            const auto& [accelerator, words] = accelerators[i];
            // Without grids a picture would take minutes: a label one shows as much.
            const int width = accelerator == AcceleratorChoice::None   ? 24
                              : accelerator == AcceleratorChoice::Grid ? 160
                                                                       : 320;
            Scene scene = scene_beside(__FILE__, name, width, width * 3 / 4);
            scene.accelerator = accelerator;
            RenderOptions one_thread;
            one_thread.threads = 1;
            const RenderResult result = render(compile(scene), one_thread);
            const RayCounts& counts = result.rays;
            rays = static_cast<Real>(counts.camera + counts.shadow + counts.reflection + counts.refraction);
            speeds[i] = rays / result.cpu_seconds;
            rows[i] =
                fmt::format("{} {},{:.0f},{:.2g},{:.2g}", name, words, rays, result.cpu_seconds, speeds[i]);
        }
        // The last picture is the large one.
        for (std::size_t i = 0; i < rows.size(); ++i)
            csv += fmt::format("{},{:.2g}\n", rows[i], rays / speeds[i] / 60);
    }
    write_file(directory / "measured_scenes.csv", csv);
}

// Cost as the scene grows -------------------------------------------------------------------------------

/// Entries in the lists on the way to the hit: what would be asked without mailboxes.
std::uint64_t entries_met(const Grid& grid, const std::vector<Triangle>& triangles, const Ray& ray,
                          Mailbox& mailbox) {
    const std::optional<Hit> hit = closest_hit(grid, triangles, ray, {0, infinity}, mailbox);
    std::uint64_t count = 0;
    for (const CellVisit& visit : cells_along(grid.shape, ray, {0, hit ? hit->t : infinity})) {
        const auto [x, y, z] = std::array{visit.cell.x, visit.cell.y, visit.cell.z};
        const auto number = static_cast<std::size_t>((z * grid.shape.cells.y + y) * grid.shape.cells.x + x);
        count += grid.first[number + 1] - grid.first[number];
    }
    return count;
}

void draw_growth(const Path& directory) {
    const std::vector<Ray> rays = rays_around(20'000);
    const auto n_rays = static_cast<Real>(rays.size());
    std::string csv =
        "triangles,cells x,cells y,cells z,entries a triangle,bytes a triangle,cells entered a ray,triangles "
        "asked a ray,without mailboxes\n";
    std::string measured =
        "triangles,build s,grid rays/s,brute force rays/s,rays that pay for the building\n";
    std::vector<Vec2> cells, shapes, brute, build, speed, brute_speed;
    for (const int fineness : {2, 4, 7, 13, 22, 40, 70, 125}) {
        const std::vector<Triangle> triangles = teapot_of(fineness);
        const auto n = static_cast<Real>(triangles.size());
        Grid grid;
        const double build_seconds = seconds_of([&] { grid = build_grid(triangles, {.nested = false}); });
        Mailbox mailbox;
        SearchCounts sum;
        std::uint64_t entries = 0;
        for (const Ray& ray : rays) {
            const SearchCounts one = cost(grid, triangles, ray, mailbox);
            sum.cells += one.cells, sum.shapes += one.shapes;
            entries += entries_met(grid, triangles, ray, mailbox);
        }
        Inventory inventory;
        take(grid, inventory);
        csv += fmt::format("{},{},{},{},{:.2f},{:.0f},{:.2f},{:.2f},{:.2f}\n", triangles.size(),
                           grid.shape.cells.x, grid.shape.cells.y, grid.shape.cells.z,
                           static_cast<Real>(inventory.items) / n, static_cast<Real>(bytes_of(grid)) / n,
                           static_cast<Real>(sum.cells) / n_rays, static_cast<Real>(sum.shapes) / n_rays,
                           static_cast<Real>(entries) / n_rays);
        cells.push_back({n, static_cast<Real>(sum.cells) / n_rays});
        shapes.push_back({n, static_cast<Real>(sum.shapes) / n_rays});
        brute.push_back({n, n});

        const double grid_seconds = seconds_of([&] {
                                        for (const Ray& ray : rays)
                                            closest_hit(grid, triangles, ray, {0, infinity}, mailbox);
                                    }) /
                                    n_rays;
        const std::size_t few = std::clamp<std::size_t>(static_cast<std::size_t>(4e6 / n), 4, rays.size());
        const double brute_seconds = seconds_of([&] {
                                         for (std::size_t i = 0; i < few; ++i)
                                             closest_hit(triangles, rays[i], {0, infinity});
                                     }) /
                                     static_cast<Real>(few);
        measured +=
            fmt::format("{},{:.2g},{:.2g},{:.2g},{:.0f}\n", triangles.size(), build_seconds, 1 / grid_seconds,
                        1 / brute_seconds, build_seconds / (brute_seconds - grid_seconds));
        build.push_back({n, build_seconds}), speed.push_back({n, 1 / grid_seconds}),
            brute_speed.push_back({n, 1 / brute_seconds});
    }
    write_file(directory / "growth.csv", csv);
    write_file(directory / "measured_growth.csv", measured);
    // Slopes over the large scenes, where the ends do not matter.
    const auto tail = [](const std::vector<Vec2>& curve) {
        return std::vector<Vec2>(curve.begin() + 3, curve.end());
    };
    write_file(
        directory / "growth_exponents.csv",
        fmt::format(
            "what,exponent\ncells entered a ray,{:.2f}\ntriangles asked a ray,{:.2f}\nby brute force,1\n",
            exponent(tail(cells)), exponent(tail(shapes))));
    write_file(directory / "measured_exponents.csv",
               fmt::format("what,exponent\nseconds to build,{:.2f}\nrays per second with the grid,{:.2f}\nby "
                           "brute force,{:.2f}\n",
                           exponent(tail(build)), exponent(tail(speed)), exponent(tail(brute_speed))));

    Svg svg{.width = 700, .height = 380};
    const Plot plot{{80, 50}, {570, 270}, {100, 1.2e6, true}, {1, 1e6, true}};
    draw_axes(svg, plot, "triangles", "per ray");
    draw_curve(svg, plot, brute, grey);
    draw_curve(svg, plot, cells, blue);
    draw_curve(svg, plot, shapes, red);
    text(svg, plot.place(2500, 9000), "asked by brute force",
         colored(SvgFont{.size = 16, .anchor = "end"}, "#666666"));
    text(svg, plot.place(1e6, cells.back().y) + Vec2(0, -12),
         fmt::format("cells entered, n^{:.2f}", exponent(tail(cells))),
         {.size = 16, .color = blue, .anchor = "end"});
    text(svg, plot.place(1e6, shapes.back().y) + Vec2(0, 36),
         fmt::format("triangles asked, n^{:.2f}", exponent(tail(shapes))),
         {.size = 16, .color = red, .anchor = "end"});
    write_svg(directory / "growth.svg", svg);
}

void draw_density(const Path& directory) {
    const std::vector<Triangle> triangles = teapot_of(25);
    const std::vector<Ray> rays = rays_around(20'000);
    const auto n = static_cast<Real>(triangles.size()), n_rays = static_cast<Real>(rays.size());
    std::string csv = "density,cells entered a ray,triangles asked a ray,bytes a triangle\n",
                measured = "density,build ms,rays/s\n";
    std::vector<Vec2> cells, shapes;
    for (Real density = 0.0625; density <= 64; density *= 2) {
        Grid grid;
        const double build =
            seconds_of([&] { grid = build_grid(triangles, {.density = density, .nested = false}); });
        Mailbox mailbox;
        SearchCounts sum;
        for (const Ray& ray : rays) {
            const SearchCounts one = cost(grid, triangles, ray, mailbox);
            sum.cells += one.cells, sum.shapes += one.shapes;
        }
        const double seconds = seconds_of([&] {
            for (const Ray& ray : rays) closest_hit(grid, triangles, ray, {0, infinity}, mailbox);
        });
        const Real entered = static_cast<Real>(sum.cells) / n_rays;
        const Real asked = static_cast<Real>(sum.shapes) / n_rays;
        csv += fmt::format("{},{:.2f},{:.2f},{:.0f}\n", density, entered, asked,
                           static_cast<Real>(bytes_of(grid)) / n);
        measured += fmt::format("{},{:.1f},{:.2g}\n", density, build * 1e3, n_rays / seconds);
        cells.push_back({density, entered}), shapes.push_back({density, asked});
    }
    write_file(directory / "density.csv", csv);
    write_file(directory / "measured_density.csv", measured);
    Svg svg{.width = 700, .height = 330};
    const Plot plot{{80, 50}, {570, 220}, {0.05, 80, true}, {1, 1000, true}};
    draw_axes(svg, plot, "density: cells a triangle", "per ray");
    draw_curve(svg, plot, cells, blue);
    draw_curve(svg, plot, shapes, red);
    text(svg, plot.place(0.06, cells.front().y) + Vec2(0, 28), "cells entered",
         colored(SvgFont{.size = 16}, blue));
    text(svg, plot.place(0.06, shapes.front().y) + Vec2(0, -14), "triangles asked",
         colored(SvgFont{.size = 16}, red));
    write_svg(directory / "density.svg", svg);
}

// A tree of boxes ---------------------------------------------------------------------------------------

/// The simplest hierarchy there is: each box is cut into halves that hold equally many shapes.
struct BoxTree {
    struct Node {
        Bounds box;
        std::size_t first, last;  ///< of `order`
        int axis = -1;            ///< along which it is cut; -1 where it is not
        std::size_t lower = 0, upper = 0;
    };
    std::vector<Node> nodes;
    std::vector<std::size_t> order;
};

std::size_t grow(BoxTree& tree, const std::vector<Bounds>& bounds, std::size_t first, std::size_t last) {
    BoxTree::Node node{{}, first, last};
    Bounds centres;
    const auto centre = [&](std::size_t i) { return (bounds[i].low + bounds[i].high) * Real(0.5); };
    for (std::size_t k = first; k < last; ++k) {
        const std::size_t i = tree.order[k];
        node.box = merge(node.box, bounds[i]);
        centres = merge(centres, {centre(i), centre(i)});
    }
    if (last - first > 2) {
        const Vec3 e = centres.high - centres.low;
        node.axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
        const std::size_t half = first + (last - first) / 2;
        const auto at = [&](std::size_t k) { return tree.order.begin() + static_cast<std::ptrdiff_t>(k); };
        std::nth_element(at(first), at(half), at(last), [&](std::size_t a, std::size_t b) {
            return centre(a)[node.axis] < centre(b)[node.axis];
        });
        node.lower = grow(tree, bounds, first, half);
        node.upper = grow(tree, bounds, half, last);
    }
    tree.nodes.push_back(node);
    return tree.nodes.size() - 1;
}

/// Asks the boxes that the ray meets, the nearer half first, and counts: boxes as cells.
void ask(const BoxTree& tree, std::size_t number, const std::vector<Triangle>& triangles, const Ray& ray,
         Interval& range, SearchCounts& counts) {
    const BoxTree::Node& node = tree.nodes[number];
    ++counts.cells;
    if (!clip(node.box, ray, range)) return;
    if (node.axis >= 0) {
        const bool up = ray.direction[node.axis] > 0;
        ask(tree, up ? node.lower : node.upper, triangles, ray, range, counts);
        ask(tree, up ? node.upper : node.lower, triangles, ray, range, counts);
        return;
    }
    for (std::size_t k = node.first; k < node.last; ++k) {
        ++counts.shapes;
        if (const auto hit = intersect(triangles[tree.order[k]], ray, range)) range.max = hit->t;
    }
}

/// What the grid, the grid of grids and the tree have to do for a ray: teapots, and the stadium.
void draw_hierarchies(const Path& directory) {
    std::string csv =
        "scene,triangles,log2 of them,one grid: cells,one grid: triangles,grid of grids: cells,grid of "
        "grids: "
        "triangles,tree: boxes,tree: triangles\n";
    std::vector<Vec2> grid_curve, tree_curve;
    const auto measure = [&](const std::string& name, const std::vector<Triangle>& triangles,
                             const std::vector<Ray>& rays) {
        std::array<SearchCounts, 3> counts;
        for (const bool nested : {false, true}) {
            const Grid grid = build_grid(triangles, {.nested = nested});
            Mailbox mailbox;
            for (const Ray& ray : rays) {
                const SearchCounts one = cost(grid, triangles, ray, mailbox);
                counts[nested].cells += one.cells, counts[nested].shapes += one.shapes;
            }
        }
        BoxTree tree;
        std::vector<Bounds> bounds;
        for (const Triangle& triangle : triangles) {
            tree.order.push_back(bounds.size());
            bounds.push_back(bounds_of(triangle));
        }
        const std::size_t root = grow(tree, bounds, 0, bounds.size());
        for (const Ray& ray : rays) {
            Interval range{0, infinity};
            ask(tree, root, triangles, ray, range, counts[2]);
        }
        const auto n = static_cast<Real>(triangles.size());
        csv += fmt::format("{},{},{:.1f}", name, triangles.size(), std::log2(n));
        const auto mean = [&](std::uint64_t sum) {
            return static_cast<Real>(sum) / static_cast<Real>(rays.size());
        };
        for (const SearchCounts& c : counts)
            csv += fmt::format(",{:.1f},{:.1f}", mean(c.cells), mean(c.shapes));
        csv += "\n";
        return std::pair{Vec2(n, mean(counts[0].cells)), Vec2(n, mean(counts[2].cells))};
    };
    const std::vector<Ray> rays = rays_around(20'000);
    for (const int fineness : {2, 4, 7, 13, 22, 40, 70, 125}) {
        const auto [grid, tree] = measure(fmt::format("teapot {}", fineness), teapot_of(fineness), rays);
        grid_curve.push_back(grid), tree_curve.push_back(tree);
    }
    const World stadium = compile(scene_beside(__FILE__, "stadium", 256, 192));
    std::vector<Ray> camera;
    for (int y = 0; y < 192; ++y)
        for (int x = 0; x < 256; ++x) camera.push_back(pixel_ray(stadium.view, x + 0.5, y + 0.5));
    measure("stadium", shapes_of<Triangle>(stadium), camera);
    write_file(directory / "hierarchies.csv", csv);

    Svg svg{.width = 700, .height = 380};
    const Plot plot{{80, 50}, {570, 270}, {100, 1.2e6, true}, {0, 100}};
    draw_axes(svg, plot, {{1e2, "10²"}, {1e3, "10³"}, {1e4, "10⁴"}, {1e5, "10⁵"}, {1e6, "10⁶"}},
              {{0, "0"}, {20, "20"}, {40, "40"}, {60, "60"}, {80, "80"}, {100, "100"}});
    text(svg, {365, 362}, "triangles of a teapot", middle(SvgFont{.size = 16}));
    text(svg, {80, 38}, "per ray", {.size = 16});
    draw_curve(svg, plot, grid_curve, blue);
    draw_curve(svg, plot, tree_curve, red);
    text(svg, plot.place(grid_curve[7].x, grid_curve[7].y) + Vec2(-14, -4), "grid: cells entered",
         colored(SvgFont{.size = 16, .anchor = "end"}, blue));
    text(svg, plot.place(240, tree_curve[0].y) + Vec2(0, -52), "tree: boxes asked",
         colored(SvgFont{.size = 16}, red));
    write_svg(directory / "hierarchies.svg", svg);
}

// Mistakes ----------------------------------------------------------------------------------------------

enum class Walk { Right, StopsAtFirstHit, ForgetsLaterHits };

/// The nearest hit in a uniform grid, or what a mistaken walk takes for it.
std::optional<Hit> walked(const Grid& grid, const std::vector<Triangle>& triangles, const Ray& ray,
                          Walk kind) {
    std::vector<bool> asked(triangles.size());
    Interval range{0, infinity};
    std::optional<Hit> nearest;
    for (const CellVisit& visit : cells_along(grid.shape, ray, range)) {
        const Cells& c = visit.cell;
        const auto number =
            static_cast<std::size_t>((c.z * grid.shape.cells.y + c.y) * grid.shape.cells.x + c.x);
        for (std::uint32_t k = grid.first[number]; k < grid.first[number + 1]; ++k) {
            const std::uint32_t i = grid.items[k];
            if (asked[i]) continue;
            asked[i] = true;
            std::optional<Hit> hit = intersect(triangles[i], ray, range);
            if (!hit || (kind == Walk::ForgetsLaterHits && !contains(visit.t, hit->t))) continue;
            hit->primitive = i;
            nearest = hit;
            range.max = hit->t;
        }
        if (nearest && (kind == Walk::StopsAtFirstHit || nearest->t < visit.t.max)) break;
    }
    return nearest;
}

/// A teapot between a floor and a screen: right, and by three mistakes.
void draw_mistakes(const Path& directory) {
    std::vector<Triangle> triangles = teapot_of(12);
    const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        triangles.push_back({a, b, c}), triangles.push_back({a, c, d});
    };
    quad({-7, 0, 5}, {7, 0, 5}, {7, 0, -5}, {-7, 0, -5});
    quad({-6, 0, -2.4}, {6, 0, -4}, {6, 4.2, -5}, {-6, 4.2, -3.4});
    const View view =
        compile(
            parse_scene_text("size 340 200\ncamera 2.5 5 10  0 1.5 0  0 1 0  32\nsphere 0 0 0 1\n", "figure"))
            .view;
    const Grid right = build_grid(triangles, {.nested = false});
    const Grid coarse = build_grid(triangles, {.density = 0.02, .nested = false});
    std::vector<Bounds> bounds;
    for (const Triangle& triangle : triangles) bounds.push_back(bounds_of(triangle));
    const Grid corners =
        build_grid(bounds,
                   [&](std::uint32_t i, const Bounds& box) {
                       const auto in_box = [&](const Vec3& p) { return overlaps(Bounds{p, p}, box); };
                       return in_box(triangles[i].a) || in_box(triangles[i].b) || in_box(triangles[i].c);
                   },
                   {.nested = false});
    const std::array<std::pair<const Grid*, Walk>, 4> pictures{{{&right, Walk::Right},
                                                                {&coarse, Walk::StopsAtFirstHit},
                                                                {&right, Walk::ForgetsLaterHits},
                                                                {&corners, Walk::Right}}};
    std::vector<Image> images;
    for (const auto& [grid, walk] : pictures) {
        Image image = make_image(view.width, view.height);
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x)
                if (const auto hit = walked(*grid, triangles, pixel_ray(view, x + 0.5, y + 0.5), walk))
                    pixel(image, x, y) = Real(0.5) * (unit_normal(triangles[hit->primitive]) + Real(1));
        images.push_back(image);
    }
    write_image(directory / "mistakes.png", in_rows(images, 2));
}

void draw(const Path& directory) {
    draw_slabs(directory);
    write_zeros(directory);
    draw_walk(directory);
    draw_drift(directory);
    draw_overlap(directory);
    draw_behind(directory);
    draw_heat_scale(directory);
    draw_mistakes(directory);
    draw_stadium(directory);
    measure_scenes(directory);
    draw_growth(directory);
    draw_density(directory);
    draw_hierarchies(directory);
    write_file(directory / "numbers.csv", numbers);
    draw_scenes(directory, __FILE__, {"forest", "cloud"}, 240, 180);
    draw_scenes(directory, __FILE__, {"stadium"}, 320, 240);
    draw_scenes(directory, __FILE__, {"crowd"}, 184, 138);
}

}  // namespace

int main(int argc, char** argv) { return draw_figures(argc, argv, draw); }
