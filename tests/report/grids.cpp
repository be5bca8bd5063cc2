// A mesh in a grid, from a thousand triangles to ten million.
#include "tests/report/grids.hpp"

#include "chapters/03_triangles/triangle.hpp"
#include "chapters/09_grids/build.hpp"
#include "chapters/09_grids/walk.hpp"
#include "tests/report/cpu_clock.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>

namespace rt::report {
namespace {

/// From a sphere of radius 3 towards points in a cube around the ball: two in three hit it.
std::vector<Ray> rays_at_ball(std::size_t count) {
    test::Random random(9);
    std::vector<Ray> rays(count);
    for (Ray& ray : rays) {
        ray.origin = Real(3) * random.direction();
        ray.direction = normalize(random.in_cube() - ray.origin);
    }
    return rays;
}

volatile Real sink = 0;  // what is measured must not be optimised away

GridPoint measure(double size, const GridsOptions& options) {
    const std::vector<Triangle> triangles = bumpy_ball(static_cast<int>(std::lround(std::sqrt(size / 12))));
    const std::vector<Ray> rays = rays_at_ball(options.rays);
    GridPoint point;
    point.triangles = static_cast<double>(triangles.size());
    point.rays = rays.size();

    Grid grid;
    std::vector<double> builds;
    for (int i = 0; i < options.repeats && (i == 0 || builds[0] < 1); ++i) {
        grid = {};
        const double start = cpu_seconds();
        std::vector<Bounds> bounds;
        bounds.reserve(triangles.size());
        for (const Triangle& triangle : triangles) bounds.push_back(bounds_of(triangle));
        grid = build_grid(
            bounds, [&](std::uint32_t which, const Bounds& box) { return overlaps(triangles[which], box); });
        builds.push_back(cpu_seconds() - start);
    }
    point.build_seconds = median(builds);
    point.bytes = static_cast<double>(bytes_of(grid)) / point.triangles;

    Mailbox mailbox;
    const auto by_grid = [&](const Ray& ray) {
        return closest_hit(grid, triangles, ray, Interval{}, mailbox);
    };
    std::vector<double> times;
    for (int i = 0; i < options.repeats; ++i) {
        const SearchCounts before = search_counts();
        const double start = cpu_seconds();
        Real sum = 0;
        for (const Ray& ray : rays)
            if (const std::optional<Hit> hit = by_grid(ray)) sum += hit->t;
        times.push_back((cpu_seconds() - start) * 1e9 / static_cast<double>(rays.size()));
        sink = sum;
        const auto a_ray = [&](std::uint64_t now, std::uint64_t then) {
            return static_cast<double>(now - then) / static_cast<double>(rays.size());
        };
        point.cells = a_ray(search_counts().cells, before.cells);
        point.asked = a_ray(search_counts().shapes, before.shapes);
    }
    point.grid_ns = median(times);

    const double affordable = std::clamp(options.brute_tests / point.triangles, 4.0, 4000.0);
    point.brute_rays = std::min(rays.size(), static_cast<std::size_t>(affordable));
    std::vector<std::optional<Hit>> answers;
    answers.reserve(point.brute_rays);
    const double start = cpu_seconds();
    for (std::size_t i = 0; i < point.brute_rays; ++i)
        answers.push_back(closest_hit(triangles, rays[i], Interval{}));
    point.brute_ns = (cpu_seconds() - start) * 1e9 / static_cast<double>(point.brute_rays);
    for (std::size_t i = 0; i < point.brute_rays; ++i) {
        const std::optional<Hit> hit = by_grid(rays[i]);
        const bool same = hit.has_value() == answers[i].has_value() &&
                          (!hit || (hit->t == answers[i]->t && hit->uv == answers[i]->uv &&
                                    hit->primitive == answers[i]->primitive));
        point.different += !same;
    }
    point.break_even = std::ceil(point.build_seconds * 1e9 / (point.brute_ns - point.grid_ns));
    return point;
}

}  // namespace

std::vector<Triangle> bumpy_ball(int n) {
    const auto on_ball = [&](int face, int i, int j) {
        const Real a = 2.0 * i / n - 1, b = 2.0 * j / n - 1, side = face % 2 == 0 ? 1 : -1;
        Vec3 p(0);
        const int axis = face / 2;
        p[axis] = side;
        p[(axis + 1) % 3] = a * side;
        p[(axis + 2) % 3] = b;
        p = normalize(p);
        return p * (1 + 0.08 * std::sin(7 * p.x + 1) * std::sin(9 * p.y + 2) * std::sin(8 * p.z + 3));
    };
    std::vector<Triangle> triangles;
    triangles.reserve(12 * static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    for (int face = 0; face < 6; ++face)
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const Vec3 p = on_ball(face, i, j), q = on_ball(face, i + 1, j);
                const Vec3 r = on_ball(face, i + 1, j + 1), s = on_ball(face, i, j + 1);
                triangles.push_back({p, q, r});
                triangles.push_back({p, r, s});
            }
    return triangles;
}

GridsOptions quick_grids() { return {{1e3, 3e3, 1e4, 3e4, 1e5}, 20'000, 5e6, 3}; }

Grids measure_grids(const GridsOptions& options, const Told& told) {
    Grids grids;
    double all = 0, done = 0;
    for (const double size : options.sizes) all += size;
    std::vector<double> sizes, build, grid_ray, brute_ray, asked, break_even;
    for (const double size : options.sizes) {
        const GridPoint point = measure(size, options);
        grids.points.push_back(point);
        sizes.push_back(point.triangles);
        build.push_back(point.build_seconds);
        grid_ray.push_back(point.grid_ns);
        brute_ray.push_back(point.brute_ns);
        asked.push_back(point.asked);
        break_even.push_back(point.break_even);
        if (told) told((done += size) / all);
    }
    grids.build = fit_power_law(sizes, build);
    grids.grid_ray = fit_power_law(sizes, grid_ray);
    grids.brute_ray = fit_power_law(sizes, brute_ray);
    grids.asked = fit_power_law(sizes, asked);
    grids.break_even = fit_power_law(sizes, break_even);
    return grids;
}

}  // namespace rt::report
