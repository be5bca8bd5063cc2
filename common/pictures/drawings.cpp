// Drawings of what single functions answer, for steps that no scene shows yet.
#include "common/pictures/drawings.hpp"

#include "chapters/01_ray_casting/fisheye.hpp"
#include "chapters/02_spheres/lens.hpp"
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/polygon.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/05_lighting/spot.hpp"
#include "chapters/06_shadows/eclipse.hpp"
#include "chapters/08_antialiasing/samples.hpp"
#include "chapters/09_grids/walk.hpp"
#include "chapters/12_distribution/area_light.hpp"
#include "chapters/12_distribution/glossy.hpp"
#include "chapters/12_distribution/lens.hpp"
#include "chapters/12_distribution/motion.hpp"
#include "chapters/12_distribution/rectangle_light.hpp"
#include "chapters/12_distribution/samples.hpp"
#include "chapters/12_distribution/sobol.hpp"
#include "chapters/12_distribution/sphere_light.hpp"
#include "chapters/12_distribution/triangle_light.hpp"
#include "chapters/13_hierarchies/split.hpp"

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <span>

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

// ------------------------------------------------------------------------------------------ chapters 5 and 6

/// A wall, and a lamp with a shade close before it.
std::vector<DrawnPixel> spot(const Drawing& drawing) {
    const Vec3 lamp(-0.4, 0.6, 0.8), middle(0, 0.15, 0);
    const SpotLight shaded{
        {.position = lamp, .color = {0.9, 0.85, 0.7}}, normalize(middle - lamp), 0.94, 0.84};
    return asked_everywhere(drawing, [&](const Vec2& p) -> DrawnPixel {
        const Vec3 color = sample_light(shaded, Vec3(p, 0)).color;
        return {dark + color, "the wall at " + in_words(p),
                fmt::format("({:.4g}, {:.4g}, {:.4g}) of light", color.x, color.y, color.z)};
    });
}

/// A floor from above, and the shadow of a ball over it; each point sees how much of the sun the ball hides.
std::vector<DrawnPixel> eclipse(const Drawing& drawing) {
    const Vec3 ball(-0.35, 0.2, 0.9), to_sun = normalize(Vec3(-0.4, 0.25, 1));
    constexpr Real radius = 0.35, sun = 0.2;
    return asked_everywhere(drawing, [&](const Vec2& p) -> DrawnPixel {
        const Vec3 to_ball = ball - Vec3(p, 0);
        const Real moon = std::asin(radius / length(to_ball));
        const Real apart = std::acos(std::clamp(dot(normalize(to_ball), to_sun), Real(-1), Real(1)));
        const Real part = eclipsed(sun, moon, apart);
        return {dark + (1 - part) * Vec3(0.9, 0.85, 0.7), "the floor at " + in_words(p),
                fmt::format("{:.4g} of the sun hidden", part)};
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
std::vector<DrawnPixel> halton(const Drawing& drawing) {
    return dots(drawing, halton_samples(16, random_for(1, 0, 0)));
}

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

// ------------------------------------------------------------------------------------------------ chapter 12

constexpr int block = 4;

/// A row for each key, in which the numbers 0 … 31 are moved to other places; the greater, the brighter.
template <class Move>
std::vector<DrawnPixel> moved(const Drawing& drawing, const Move& move) {
    std::vector<DrawnPixel> pixels;
    for (int y = 0; y < drawing.height; ++y)
        for (int x = 0; x < drawing.width; ++x) {
            const auto index = static_cast<std::uint32_t>(x / block);
            const auto key = static_cast<std::uint64_t>(y / block);
            const std::uint32_t place = move(index, key);
            pixels.push_back({dark + place / Real(32) * (light - dark),
                              fmt::format("{} of 32 with the key {}", index, key),
                              fmt::format("goes to {}", place)});
        }
    return pixels;
}

std::vector<DrawnPixel> orders(const Drawing& drawing) {
    return moved(drawing, [](std::uint32_t index, std::uint64_t key) { return permuted(index, 32, key); });
}
std::vector<DrawnPixel> coins(const Drawing& drawing) {
    return moved(drawing, [](std::uint32_t index, std::uint64_t key) {
        return owen_scrambled(index << 27, key) >> 27;
    });
}

constexpr std::uint32_t dots_drawn = 256;

/// Where the numbers 0 … count − 1 are placed, in the unit square with y downwards; lines at every 16 pixels,
/// if they mean anything. Pixels may have no dot near, and numbers no place.
template <class Place>
std::vector<DrawnPixel> placed(const Drawing& drawing, std::uint32_t count, bool lined,
                               const Place& place_of) {
    const Vec2 size(drawing.width, drawing.height);
    std::vector<std::optional<Vec2>> places;
    for (std::uint32_t i = 0; i < count; ++i) places.push_back(place_of(i));
    std::vector<DrawnPixel> pixels;
    for (int y = 0; y < drawing.height; ++y)
        for (int x = 0; x < drawing.width; ++x) {
            const Vec2 here(x + 0.5, y + 0.5);
            const bool on_line = lined && (x % 16 == 0 || y % 16 == 0);
            DrawnPixel pixel{on_line ? lines : dark, "the place " + in_words(here / size), "nothing"};
            for (std::uint32_t i = 0; i < count; ++i)
                if (places[i] && length(*places[i] * size - here) < 1.3)
                    pixel = {light, pixel.place, fmt::format("number {} of {}", i, count)};
            pixels.push_back(pixel);
        }
    return pixels;
}

std::vector<DrawnPixel> stratified(const Drawing& drawing) {
    return placed(drawing, 64, true,
                  [](std::uint32_t i) { return std::optional(stratified_point(i, 64, 5)); });
}
std::vector<DrawnPixel> sequence(const Drawing& drawing) {
    return placed(drawing, 64, true, [](std::uint32_t i) {
        return std::optional(Vec2(sobol_bits(i, 0), sobol_bits(i, 1)) * 0x1p-32);
    });
}
std::vector<DrawnPixel> scrambled(const Drawing& drawing) {
    return placed(drawing, 64, true, [](std::uint32_t i) { return std::optional(sobol_point(i, 5)); });
}

/// Points that fill the unit square evenly, and in no pattern that a map of it would draw: multiples of the
/// powers of 1/p, where p³ = p + 1, without their whole parts (Roberts 2018).
Vec2 even(std::uint32_t i) { return glm::fract((i + 0.5) * Vec2(0.7548776662466927, 0.5698402909980532)); }

/// The disc on the left, and a pentagon on the right.
std::vector<DrawnPixel> aperture(const Drawing& drawing) {
    return placed(drawing, 2 * dots_drawn, false, [](std::uint32_t i) {
        const bool is_disc = i < dots_drawn;
        const Vec2 random = even(i % dots_drawn),
                   p = is_disc ? disc_point(random) : polygon_point(5, pi / 2, random);
        return std::optional(Vec2((is_disc ? 0.25 : 0.75) + 0.24 * p.x, 0.5 - 0.48 * p.y));
    });
}

/// The time, to the right, at which a part of the light has come in, upwards.
std::vector<DrawnPixel> shutter(const Drawing& drawing) {
    return placed(drawing, dots_drawn, true, [](std::uint32_t i) {
        const Real part = (i + 0.5) / dots_drawn;
        return std::optional(Vec2(shutter_time({0.5, 0.25}, part), 1 - part));
    });
}

/// A triangle and a disc, seen from the front.
std::vector<DrawnPixel> on_lamps(const Drawing& drawing) {
    return placed(drawing, 2 * dots_drawn, false, [](std::uint32_t i) {
        const Vec2 random = even(i % dots_drawn);
        const Vec3 p =
            i < dots_drawn
                ? point_on(TriangleLight{Vec3(0.03, 0.9, 0), Vec3(0.47, 0.9, 0), Vec3(0.2, 0.1, 0)}, random)
                      .point
                : point_on(DiscLight{Vec3(0, 0, 0), Vec3(0, 0, 1), 0.45}, random).point + Vec3(0.5, 0.5, 0);
        return std::optional(i < dots_drawn ? Vec2(p) : Vec2(0.5 + p.x / 2, p.y));
    });
}

/// Directions, z towards the viewer of the drawing, so that equal solid angles have equal areas.
template <class Direction>
std::vector<DrawnPixel> directions(const Drawing& drawing, const Direction& direction_for) {
    return placed(drawing, dots_drawn, false, [&](std::uint32_t i) -> std::optional<Vec2> {
        const std::optional<Vec3> d = direction_for(even(i));
        if (!d || !(d->z > -1)) return std::nullopt;
        return Vec2(0.5) + 0.49 / std::sqrt(1 + d->z) * Vec2(d->x, -d->y);
    });
}

/// Directions to a light from the origin.
template <class Light>
std::vector<DrawnPixel> towards(const Drawing& drawing, const Light& lamp) {
    return directions(drawing, [&](const Vec2& random) -> std::optional<Vec3> {
        const std::optional<LightDirection> found = toward(lamp, Vec3(0), random);
        return found ? std::optional(found->direction) : std::nullopt;
    });
}

std::vector<DrawnPixel> to_sphere(const Drawing& drawing) {
    return towards(drawing, SphereLight{Vec3(0.5, 0.3, 1.5), 1});
}
std::vector<DrawnPixel> to_triangle(const Drawing& drawing) {
    return towards(drawing, TriangleLight{Vec3(-1, -0.8, 0.5), Vec3(0, 1.2, 0.6), Vec3(2, -0.5, 0.7)});
}
std::vector<DrawnPixel> to_rectangle(const Drawing& drawing) {
    return towards(drawing, QuadLight{Vec3(-1, -0.8, 0.5), Vec3(3, 0, 0), Vec3(0, 1.6, 0)});
}
std::vector<DrawnPixel> lobe(const Drawing& drawing) {
    return directions(drawing, [](const Vec2& random) {
        return std::optional(around_axis(normalize(Vec3(0.5, 0.3, 1)), 20, random));
    });
}

// ------------------------------------------------------------------------------------------------ chapter 13

/// Squares in the plane: many small ones in a crowd, and a few large ones beside it.
std::vector<Bounds> squares() {
    std::vector<Bounds> boxes;
    const auto add = [&](const Vec2& middle, Real half) {
        boxes.push_back({Vec3(middle - half, 0), Vec3(middle + half, 0)});
    };
    for (int k = 0; k < 30; ++k) {
        // A spiral of the golden angle fills a disc evenly.
        const Real out = 0.06 * std::sqrt(k + 0.5), angle = 2.39996322972865332 * k;
        add(Vec2(-0.55, 0.3) + out * Vec2(std::cos(angle), std::sin(angle)), 0.02);
    }
    add({-0.65, -0.5}, 0.12);
    add({-0.1, -0.3}, 0.1);
    add({0.3, 0.35}, 0.16);
    add({0.2, -0.55}, 0.08);
    add({0.75, 0.05}, 0.14);
    add({0.7, -0.5}, 0.11);
    return boxes;
}

/// In which part each square is.
template <class Split>
std::vector<DrawnPixel> parted(const Drawing& drawing, const Split& split) {
    const std::vector<Bounds> boxes = squares();
    std::vector<std::uint32_t> items(boxes.size());
    std::iota(items.begin(), items.end(), 0u);
    const std::size_t count = std::min(split(boxes, std::span(items)), items.size());
    const std::span<const std::uint32_t> first(items.data(), count);
    return asked_everywhere(drawing, [&](const Vec2& p) -> DrawnPixel {
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            const Vec2 low(boxes[i].low), high(boxes[i].high);
            if (p.x < low.x || p.y < low.y || p.x > high.x || p.y > high.y) continue;
            const bool is_first = std::ranges::find(first, i) != first.end();
            return {is_first ? light : Vec3(0.25, 0.5, 0.85), fmt::format("square {}", i),
                    is_first ? "in the first part" : "in the second part"};
        }
        return {dark, "the point " + in_words(p), "in no square"};
    });
}

std::vector<DrawnPixel> parted_in_halves(const Drawing& drawing) { return parted(drawing, split_in_halves); }
std::vector<DrawnPixel> parted_by_sweep(const Drawing& drawing) {
    return parted(drawing, [](std::span<const Bounds> boxes, std::span<std::uint32_t> items) {
        return split_by_sweep(boxes, items);
    });
}
std::vector<DrawnPixel> parted_by_bins(const Drawing& drawing) {
    return parted(drawing, [](std::span<const Bounds> boxes, std::span<std::uint32_t> items) {
        return split_by_bins(boxes, items);
    });
}

constexpr Drawing drawings[] = {
    {"fisheye", 65, 49, fisheye},
    {"silhouette", 64, 48, silhouette},
    {"lens", 64, 48, lens},
    {"inside", 64, 48, inside},
    {"sides", 64, 48, sides},
    {"spot", 64, 48, spot},
    {"eclipse", 64, 48, eclipse},
    {"regular", 65, 65, regular},
    {"jittered", 65, 65, jittered},
    {"poisson", 65, 65, poisson},
    {"trapezoid", 65, 65, trapezoid},
    {"centered", 65, 65, centered},
    {"halton", 65, 65, halton},
    {"way", 12 * cell_pixels + 1, 9 * cell_pixels + 1, way},
    {"cells_of_triangle", 12 * cell_pixels + 1, 9 * cell_pixels + 1, cells_of_triangle},
    {"cells_of_sphere", 12 * cell_pixels + 1, 9 * cell_pixels + 1, cells_of_sphere},
    {"orders", 32 * block, 24 * block, orders},
    {"stratified", 129, 129, stratified},
    {"sequence", 129, 129, sequence},
    {"coins", 32 * block, 24 * block, coins},
    {"scrambled", 129, 129, scrambled},
    {"aperture", 256, 128, aperture},
    {"shutter", 129, 129, shutter},
    {"on_lamps", 256, 128, on_lamps},
    {"to_sphere", 160, 160, to_sphere},
    {"to_triangle", 160, 160, to_triangle},
    {"to_rectangle", 160, 160, to_rectangle},
    {"lobe", 160, 160, lobe},
    {"parted_in_halves", 160, 120, parted_in_halves},
    {"parted_by_sweep", 160, 120, parted_by_sweep},
    {"parted_by_bins", 160, 120, parted_by_bins},
};

}  // namespace

const Drawing* drawing_named(std::string_view name) {
    const auto* found = std::ranges::find(drawings, name, &Drawing::name);
    return found == std::end(drawings) ? nullptr : found;
}

}  // namespace rt
