// Hierarchies beside grids and beside asking every triangle.
#include "tests/report/hierarchies.hpp"

#include "chapters/03_triangles/triangle.hpp"
#include "chapters/09_grids/walk.hpp"
#include "chapters/13_hierarchies/build.hpp"
#include "chapters/13_hierarchies/volumes.hpp"
#include "chapters/13_hierarchies/walk.hpp"
#include "tests/report/cpu_clock.hpp"
#include "tests/report/grids.hpp"
#include "tests/report/statistics.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace rt::report {
namespace {

using test::Random;

// ------------------------------------------------------------------------------------------------ scenes

struct MeasuredScene {
    std::string name;
    std::vector<Triangle> triangles;
};

void add_box(std::vector<Triangle>& triangles, const Vec3& low, const Vec3& high) {
    const auto corner = [&](int i) {
        return Vec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    };
    constexpr int faces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                 {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    for (const auto& f : faces) {
        triangles.push_back({corner(f[0]), corner(f[1]), corner(f[2])});
        triangles.push_back({corner(f[0]), corner(f[2]), corner(f[3])});
    }
}

/// Towers in blocks, and on every roof much that is small.
std::vector<Triangle> city(double size) {
    Random random(131);
    std::vector<Triangle> triangles;
    const int edge = std::max(2, static_cast<int>(std::sqrt(size / (12 * 8))));
    for (int i = 0; i < edge; ++i)
        for (int j = 0; j < edge; ++j) {
            const Vec3 low(22 * i, 0, 22 * j);
            const Vec3 high =
                low + Vec3(random.uniform(8, 16), 80 * random.magnitude(-1, 0), random.uniform(8, 16));
            add_box(triangles, low, high);
            for (int k = 0; k < 7; ++k) {
                const Vec3 at(random.uniform(low.x, high.x), high.y, random.uniform(low.z, high.z));
                add_box(triangles, at, at + random.uniform(0.2, 2) * Vec3(1, random.uniform(0.5, 4), 1));
            }
        }
    add_box(triangles, Vec3(-500, -1, -500), Vec3(22 * edge + 500, 0, 22 * edge + 500));
    return triangles;
}

/// Long thin triangles, slanted to all sides.
std::vector<Triangle> needles(double size) {
    return test::many(static_cast<std::size_t>(size), 132, [](Random& random) {
        const Vec3 foot = random.in_cube(), along = 0.5 * random.direction();
        const Vec3 side = 0.002 * random.perpendicular_to(along);
        return Triangle{foot - side, foot + side, foot + along};
    });
}

int squares_for(double size) { return std::max(2, static_cast<int>(std::lround(std::sqrt(size / 12)))); }

/// The ball on a floor that is a thousand times as wide.
std::vector<Triangle> stadium(double size) {
    std::vector<Triangle> triangles = bumpy_ball(squares_for(size));
    const Vec3 a(-1000, -1.1, -1000), b(1000, -1.1, -1000), c(1000, -1.1, 1000), d(-1000, -1.1, 1000);
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
    return triangles;
}

std::vector<MeasuredScene> scenes(double size) {
    return {{"dented ball", bumpy_ball(squares_for(size))},
            {"ball in a stadium", stadium(size)},
            {"city", city(size)},
            {"needles", needles(size)}};
}

/// Each from outside towards some triangle, or a little beside it; most go on to where most triangles are.
std::vector<Ray> rays_at(const std::vector<Triangle>& triangles, std::size_t count) {
    Random random(133);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const Triangle& t = triangles[random.index(triangles.size())];
        const Vec3 middle = (t.a + t.b + t.c) / Real(3);
        const Real edge = glm::length(t.b - t.a) + glm::length(t.c - t.a);
        Vec3 from = random.direction();
        from.y = std::abs(from.y);
        const Real away = 3 * random.magnitude(0, 1.5);
        rays.push_back({middle + away * from, random.in_cube() * edge / away - from});
    }
    return rays;
}

/// Lines that meet the box, from everywhere alike: through a ball around it, along any direction, at any
/// place of the disc across that.
std::vector<Ray> lines_through(const Bounds& box, std::size_t count) {
    Random random(134);
    const Vec3 middle = middle_of(box);
    const Real radius = glm::length(box.high - box.low) / 2;
    std::vector<Ray> lines;
    for (std::size_t tries = 0; lines.size() < count && tries < 10'000 * count; ++tries) {
        const Vec3 d = random.direction(), across = random.perpendicular_to(d);
        const Ray line{middle + radius * std::sqrt(random.uniform(0, 1)) * across - 2 * radius * d, d};
        if (clip(box, line, {0, infinity})) lines.push_back(line);
    }
    return lines;
}

// -------------------------------------------------------------------------------------------------- ways

using Found = std::optional<Hit>;

/// A way to search: what it builds, and how it asks that.
struct Way {
    std::string name;
    std::function<Accelerator(std::span<const Triangle>)> build;
    Accelerator built{};
    std::vector<double> builds{}, times{};
};

Grid grid_over(std::span<const Triangle> triangles, bool nested) {
    return build_grid(triangles, {.nested = nested});
}

std::vector<Way> ways() {
    const auto tree = [](SplitMethod method, std::size_t most) {
        return [=](std::span<const Triangle> triangles) -> Accelerator {
            return build_hierarchy(triangles, {.method = method, .most = most});
        };
    };
    const auto volumes = [](auto around) {
        return [=](std::span<const Triangle> triangles) -> Accelerator {
            ShapePoints points;
            for (const Triangle& triangle : triangles) add_points(points, triangle, bounds_of(triangle));
            return around(build_hierarchy(triangles), points);
        };
    };
    return {
        {"every triangle", [](std::span<const Triangle>) { return Accelerator(); }},
        {"grid", [](std::span<const Triangle> t) -> Accelerator { return grid_over(t, false); }},
        {"grids in a grid", [](std::span<const Triangle> t) -> Accelerator { return grid_over(t, true); }},
        {"hierarchy by halves", tree(SplitMethod::Halves, 4)},
        {"hierarchy by codes", tree(SplitMethod::Codes, 4)},
        {"hierarchy by bins", tree(SplitMethod::Bins, 16)},
        {"hierarchy by sweep", tree(SplitMethod::Sweep, 16)},
        {"by bins, with spheres", volumes(sphere_tree)},
        {"by bins, with turned boxes", volumes(oriented_box_tree)},
        {"by bins, with ellipsoids", volumes(ellipsoid_tree)}};
}

volatile Real sink = 0;  // what is measured must not be optimised away

/// CPU nanoseconds a ray for the nearest hits of these rays.
double time_rays(const Accelerator& built, std::span<const Triangle> triangles, std::span<const Ray> rays) {
    return std::visit(
        [&](const auto& accelerator) {
            Mailbox mailbox;
            const double start = cpu_seconds();
            Real sum = 0;
            for (const Ray& ray : rays)
                if (const Found hit = closest_hit(accelerator, triangles, ray, {0, infinity}, mailbox))
                    sum += hit->t;
            sink = sum;
            return (cpu_seconds() - start) * 1e9 / static_cast<double>(rays.size());
        },
        built);
}

/// What lines that nothing stops pay on average: inner nodes that they look into, and triangles.
double paid_by_lines(const Hierarchy& tree, std::size_t count) {
    const std::vector<Ray> lines = lines_through(tree.nodes[0].box, count);
    std::uint64_t leaves = 0, shapes = 0;
    const std::uint64_t before = search_counts().cells;
    for (const Ray& line : lines)
        search(tree, line, {0, infinity}, [&](std::span<const std::uint32_t> some, Interval) {
            ++leaves, shapes += some.size();
            return infinity;
        });
    const std::uint64_t nodes = search_counts().cells - before - leaves;
    return static_cast<double>(nodes + shapes) / static_cast<double>(lines.size());
}

SearchPoint point_of(const Way& way, const MeasuredScene& scene, std::span<const Ray> rays,
                     const std::vector<Found>& right) {
    SearchPoint point{.scene = scene.name, .way = way.name};
    const std::span<const Triangle> triangles(scene.triangles);
    point.triangles = static_cast<double>(triangles.size());
    point.build_seconds = median(way.builds);
    point.ns = median(way.times);
    std::visit(
        [&](const auto& accelerator) {
            point.bytes = static_cast<double>(bytes_of(accelerator)) / point.triangles;
            Mailbox mailbox;
            const SearchCounts before = search_counts();
            for (std::size_t i = 0; i < rays.size(); ++i) {
                if (std::holds_alternative<Nothing>(way.built)) break;
                const Found hit = closest_hit(accelerator, triangles, rays[i], {0, infinity}, mailbox);
                if (i >= right.size()) continue;
                ++point.compared;
                const bool same = hit.has_value() == right[i].has_value() &&
                                  (!hit || (hit->t == right[i]->t && hit->uv == right[i]->uv &&
                                            hit->primitive == right[i]->primitive));
                point.different += !same;
            }
            const auto a_ray = [&](std::uint64_t now, std::uint64_t then) {
                return static_cast<double>(now - then) / static_cast<double>(rays.size());
            };
            point.nodes = a_ray(search_counts().cells, before.cells);
            point.asked = a_ray(search_counts().shapes, before.shapes);
        },
        way.built);
    if (std::holds_alternative<Nothing>(way.built)) point.asked = point.triangles;
    if (const auto* tree = std::get_if<Hierarchy>(&way.built)) {
        point.predicted = predicted_cost(*tree);
        point.paid = paid_by_lines(*tree, 2'000);
    }
    return point;
}

std::vector<SearchPoint> measure(const MeasuredScene& scene, const SearchesOptions& options) {
    const std::span<const Triangle> triangles(scene.triangles);
    const std::vector<Ray> rays = rays_at(scene.triangles, options.rays);
    const double affordable = options.brute_tests / static_cast<double>(triangles.size());
    const auto few = static_cast<std::size_t>(std::clamp(affordable, 4.0, static_cast<double>(rays.size())));
    std::vector<Found> right;
    for (std::size_t i = 0; i < few; ++i) right.push_back(closest_hit(triangles, rays[i], {0, infinity}));

    std::vector<Way> all = ways();
    // The ways in turn, so that what else the machine does meets all of them alike.
    for (int repeat = 0; repeat < options.repeats; ++repeat)
        for (Way& way : all) {
            if (repeat == 0 || way.builds[0] < 1) {
                way.built = {};
                const double start = cpu_seconds();
                way.built = way.build(triangles);
                way.builds.push_back(cpu_seconds() - start);
            }
            const bool asks_all = std::holds_alternative<Nothing>(way.built);
            way.times.push_back(
                time_rays(way.built, triangles, std::span(rays).first(asks_all ? few : rays.size())));
        }
    std::vector<SearchPoint> points;
    for (const Way& way : all) {
        SearchPoint point = point_of(way, scene, rays, right);
        if (!points.empty())
            point.break_even = std::ceil(point.build_seconds * 1e9 / std::max(1e-9, points[0].ns - point.ns));
        points.push_back(point);
    }
    points[0].build_seconds = 0;
    return points;
}

}  // namespace

SearchesOptions quick_searches() { return {1e4, 5'000, 1e7, 3}; }

std::vector<SearchPoint> measure_searches(const SearchesOptions& options, const Told& told) {
    std::vector<SearchPoint> points;
    const std::vector<MeasuredScene> all = scenes(options.size);
    double done = 0;
    for (const MeasuredScene& scene : all) {
        for (const SearchPoint& point : measure(scene, options)) points.push_back(point);
        if (told) told(++done / static_cast<double>(all.size()));
    }
    return points;
}

}  // namespace rt::report
