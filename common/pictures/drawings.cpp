// Drawings of what single functions answer, for steps that no scene shows yet.
#include "common/pictures/drawings.hpp"

#include "chapters/01_ray_casting/fisheye.hpp"
#include "chapters/02_spheres/lens.hpp"
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/polygon.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/08_antialiasing/samples.hpp"
#include "chapters/09_grids/walk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace rt {
namespace {

const Vec3 dark(0.03, 0.04, 0.08), light(0.9, 0.85, 0.7), lines(0.15, 0.17, 0.25);

std::string in_words(const Vec2& p) { return fmt::format("({:.3g}, {:.3g})", p.x, p.y); }

/// The drawing whose pixel with its centre at (x, y) answers `ask(Vec2(x, y))`; x goes from −1 to 1, y
/// upwards.
template <class Ask>
std::vector<DrawnPixel> asked_everywhere(const Drawing& drawing, const Ask& ask) {
    std::vector<DrawnPixel> pixels;
    for (int y = 0; y < drawing.height; ++y)
        for (int x = 0; x < drawing.width; ++x)
            pixels.push_back(ask(Vec2(2 * x + 1 - drawing.width, drawing.height - 2 * y - 1) /
                                 static_cast<Real>(drawing.width)));
    return pixels;
}

// ------------------------------------------------------------------------------------------- chapters 1 to 3

/// The directions of a fisheye's rays, (d + 1)/2 as red, green and blue, as the integrator of that name shows
/// them.
std::vector<DrawnPixel> fisheye(const Drawing& drawing) {
    View view;
    view.width = drawing.width;
    view.height = drawing.height;
    std::vector<DrawnPixel> pixels;
    for (int y = 0; y < drawing.height; ++y)
        for (int x = 0; x < drawing.width; ++x) {
            const Vec3 d = fisheye_ray(view, x + 0.5, y + 0.5, pi).direction;
            pixels.push_back({Real(0.5) * (d + Real(1)), fmt::format("the point ({}, {})", x + 0.5, y + 0.5),
                              fmt::format("the direction ({:.4g}, {:.4g}, {:.4g})", d.x, d.y, d.z)});
        }
    return pixels;
}

/// The line along −z through each point, and a sphere.
std::vector<DrawnPixel> silhouette(const Drawing& drawing) {
    const Sphere sphere{Vec3(0.1, 0, -3), 0.6};
    return asked_everywhere(drawing, [&](const Vec2& p) -> DrawnPixel {
        const Roots roots = intersections(sphere, {Vec3(p, 0), Vec3(0, 0, -1)});
        const std::string place = fmt::format("the line along -z through {}", in_words(p));
        if (roots.count == 0) return {dark, place, "no root"};
        // Nearer is brighter.
        const Real depth = std::clamp((4 - roots.t0) / 2, Real(0), Real(1));
        return {Vec3(0.15 + 0.75 * depth), place, fmt::format("roots {:.4g} and {:.4g}", roots.t0, roots.t1)};
    });
}

/// The ray along −z from each point, and a lens: one side reddish, the other bluish.
std::vector<DrawnPixel> lens(const Drawing& drawing) {
    const Sphere left{Vec3(-0.45, 0.1, -3), 0.75}, right{Vec3(0.45, -0.1, -2.7), 0.75};
    return asked_everywhere(drawing, [&](const Vec2& p) -> DrawnPixel {
        const std::string place = fmt::format("the ray along -z from {}", in_words(p));
        const std::optional<Hit> hit =
            intersect_lens(left, right, {Vec3(p, 0), Vec3(0, 0, -1)}, {0, infinity});
        if (!hit) return {dark, place, "beside the lens"};
        // Nearer is brighter.
        const Real depth = std::clamp(Real(3) - hit->t, Real(0), Real(1));
        const Vec3 tint = hit->primitive == 0 ? Vec3(1, 0.7, 0.5) : Vec3(0.5, 0.75, 1);
        return {(Real(0.2) + Real(0.7) * depth) * tint, place,
                fmt::format("t = {:.4g}, on the surface of ball {}", hit->t, hit->primitive)};
    });
}

/// The inside test alone, on an outline that is not convex.
std::vector<DrawnPixel> inside(const Drawing& drawing) {
    const std::vector<Vec2> outline{{-0.8, -0.6}, {-0.1, -0.1}, {0.6, -0.65}, {0.85, 0.3},
                                    {0.3, 0},     {0.35, 0.6},  {-0.45, 0.1}, {-0.7, 0.65}};
    return asked_everywhere(drawing, [&](const Vec2& p) -> DrawnPixel {
        const bool is_inside = point_in_polygon(outline, p);
        return {is_inside ? light : dark, "the point " + in_words(p), is_inside ? "inside" : "outside"};
    });
}

/// On which side of each edge of a triangle the points are, by the sign of the edge function.
std::vector<DrawnPixel> sides(const Drawing& drawing) {
    const std::array<Vec2, 3> corners{Vec2(-0.7, -0.5), Vec2(0.75, -0.35), Vec2(-0.1, 0.6)};
    return asked_everywhere(drawing, [&](const Vec2& p) {
        DrawnPixel pixel{dark, "the point " + in_words(p), "beside edges 1, 2, 3:"};
        for (std::size_t i = 0; i < 3; ++i) {
            const Real side = edge_function(corners[i] - p, corners[(i + 1) % 3] - p);
            if (side > 0) pixel.color[static_cast<int>(i)] = 0.8;
            pixel.answer += side > 0 ? " left" : side < 0 ? " right" : " on it";
        }
        return pixel;
    });
}

// ------------------------------------------------------------------------------------------------- chapter 8

/// One pixel, large, with a dot for each of its samples.
std::vector<DrawnPixel> dots(const Drawing& drawing, const std::vector<PixelSample>& samples) {
    constexpr Real radius = 0.03;
    std::vector<DrawnPixel> pixels;
    for (int y = 0; y < drawing.height; ++y)
        for (int x = 0; x < drawing.width; ++x) {
            const Vec2 at = Vec2(x + 0.5, y + 0.5) / Vec2(drawing.width, drawing.height);
            const bool on_line = x % 16 == 0 || y % 16 == 0;
            DrawnPixel pixel{on_line ? lines : dark, "the place " + in_words(at), "no sample"};
            for (std::size_t i = 0; i < samples.size(); ++i)
                if (length(samples[i].at - at) <= radius)
                    pixel = {samples[i].weight * static_cast<Real>(samples.size()) * Vec3(0.7), pixel.place,
                             fmt::format("sample {} of {}, at {}, weight {:.4g}", i + 1, samples.size(),
                                         in_words(samples[i].at), samples[i].weight)};
            pixels.push_back(pixel);
        }
    return pixels;
}

std::vector<DrawnPixel> regular(const Drawing& drawing) { return dots(drawing, regular_samples(16)); }
std::vector<DrawnPixel> jittered(const Drawing& drawing) {
    return dots(drawing, jittered_samples(16, random_for(1, 0, 0)));
}
std::vector<DrawnPixel> poisson(const Drawing& drawing) {
    return dots(drawing, poisson_disk_samples(16, random_for(1, 0, 0)).samples);
}
std::vector<DrawnPixel> trapezoid(const Drawing& drawing) { return dots(drawing, trapezoid_samples(16)); }
std::vector<DrawnPixel> centered(const Drawing& drawing) { return dots(drawing, centered_samples(17)); }

// ------------------------------------------------------------------------------------------------- chapter 9

constexpr int cell_pixels = 6;

/// A grid of one layer, with lines around its cells.
GridShape layer(const Drawing& drawing) {
    const Cells cells(drawing.width / cell_pixels, drawing.height / cell_pixels, 1);
    return {{Vec3(0), Vec3(cells)}, cells};
}

template <class Ask>
std::vector<DrawnPixel> cell_by_cell(const Drawing& drawing, const Ask& ask) {
    const GridShape shape = layer(drawing);
    std::vector<DrawnPixel> pixels;
    for (int y = 0; y < drawing.height; ++y)
        for (int x = 0; x < drawing.width; ++x) {
            const Cells cell(std::min(x / cell_pixels, shape.cells.x - 1),
                             std::max(shape.cells.y - 1 - y / cell_pixels, 0), 0);
            DrawnPixel pixel = ask(shape, cell);
            pixel.place = fmt::format("the cell ({}, {}, {})", cell.x, cell.y, cell.z);
            if (x % cell_pixels == 0 || y % cell_pixels == 0) pixel.color = lines;
            pixels.push_back(pixel);
        }
    return pixels;
}

/// The cells that a ray visits, darker the later.
std::vector<DrawnPixel> way(const Drawing& drawing) {
    const GridShape shape = layer(drawing);
    const std::vector<CellVisit> visits =
        cells_along(shape, {Vec3(-1.5, 7.8, 0.5), Vec3(2, -1.1, 0)}, {0, infinity});
    std::map<std::pair<int, int>, std::size_t> turn;
    for (std::size_t i = 0; i < visits.size(); ++i)
        turn.try_emplace({visits[i].cell.x, visits[i].cell.y}, i + 1);
    return cell_by_cell(drawing, [&](const GridShape&, const Cells& cell) -> DrawnPixel {
        const auto found = turn.find({cell.x, cell.y});
        if (found == turn.end()) return {dark, "", "not visited"};
        const Real late = static_cast<Real>(found->second) / 24;
        return {light * (1 - Real(0.7) * std::min(late, Real(1))), "",
                fmt::format("visited, number {} on the way", found->second)};
    });
}

DrawnPixel held(bool may_hold, const char* what) {
    return {may_hold ? light : dark, "", fmt::format("{} hold {}", may_hold ? "may" : "cannot", what)};
}

std::vector<DrawnPixel> cells_of_triangle(const Drawing& drawing) {
    const Triangle triangle{Vec3(1.3, 1.2, 0.5), Vec3(10.7, 3.4, 0.5), Vec3(3.6, 7.7, 0.5)};
    return cell_by_cell(drawing, [&](const GridShape& shape, const Cells& cell) {
        return held(overlaps(triangle, cell_box(shape, cell)), "the triangle");
    });
}

std::vector<DrawnPixel> cells_of_sphere(const Drawing& drawing) {
    const Sphere sphere{Vec3(6.2, 4.4, 0.5), 3.7};
    return cell_by_cell(drawing, [&](const GridShape& shape, const Cells& cell) {
        return held(overlaps(sphere, cell_box(shape, cell)), "the sphere's surface");
    });
}

constexpr Drawing drawings[] = {
    {"fisheye", 65, 49, fisheye},
    {"silhouette", 64, 48, silhouette},
    {"lens", 64, 48, lens},
    {"inside", 64, 48, inside},
    {"sides", 64, 48, sides},
    {"regular", 65, 65, regular},
    {"jittered", 65, 65, jittered},
    {"poisson", 65, 65, poisson},
    {"trapezoid", 65, 65, trapezoid},
    {"centered", 65, 65, centered},
    {"way", 12 * cell_pixels + 1, 9 * cell_pixels + 1, way},
    {"cells_of_triangle", 12 * cell_pixels + 1, 9 * cell_pixels + 1, cells_of_triangle},
    {"cells_of_sphere", 12 * cell_pixels + 1, 9 * cell_pixels + 1, cells_of_sphere},
};

}  // namespace

const Drawing* drawing_named(std::string_view name) {
    const auto* found = std::ranges::find(drawings, name, &Drawing::name);
    return found == std::end(drawings) ? nullptr : found;
}

}  // namespace rt
