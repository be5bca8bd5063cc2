// The figures and tables of part 4 of lesson 13: volumes around shapes, and hierarchies of them.
#pragma once

#include "chapters/03_triangles/triangle.hpp"
#include "chapters/13_hierarchies/build.hpp"
#include "chapters/13_hierarchies/volumes.hpp"
#include "chapters/13_hierarchies/walk.hpp"
#include "common/math/random.hpp"
#include "references/costs.hpp"

#include <fmt/format.h>

#include <array>

namespace rt::figures {

// ------------------------------------------------------------------------------------------- shapes and rays

/// Numbers in (−1, 1), the same on every machine.
inline Vec3 in_cube(Random& random) {
    const Real x = random_real(random), y = random_real(random), z = random_real(random);
    return Real(2) * Vec3(x, y, z) - Real(1);
}

/// Triangles of a kind: fat ones, thin ones that stand aslant, or a smooth surface of them.
inline std::vector<Triangle> triangles_of(const std::string& kind, int count) {
    Random random = random_for(13, 4 + 20, 0);
    std::vector<Triangle> triangles;
    const int around = static_cast<int>(std::sqrt(count));
    const auto on_ring = [&](int i, int j) {
        const Real u = 2 * pi * i / around, v = 4 * pi * j / around, r = 2 + std::cos(v);
        return Vec3(r * std::cos(u), r * std::sin(u), std::sin(v));
    };
    for (int k = 0; k < count; ++k) {
        const Vec3 p = in_cube(random), along = in_cube(random), across = in_cube(random);
        if (kind == "soup") {
            triangles.push_back({p, p + Real(0.04) * along, p + Real(0.04) * across});
        } else if (kind == "needles") {
            triangles.push_back({p, p + Real(0.5) * along, p + Real(0.5) * along + Real(0.004) * across});
        } else {
            const int i = k / 2 / (around / 2), j = k / 2 % (around / 2);
            if (k % 2 == 0)
                triangles.push_back({on_ring(i, j), on_ring(i + 1, j), on_ring(i + 1, j + 1)});
            else
                triangles.push_back({on_ring(i, j), on_ring(i + 1, j + 1), on_ring(i, j + 1)});
        }
    }
    return triangles;
}

/// Rays from outside towards points of a cube of edge 2 around the origin.
inline std::vector<Ray> rays_into_cube(std::size_t count, Real size) {
    Random random = random_for(13, 5 + 20, 0);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const Vec3 from = in_cube(random);
        if (length(from) > 1 || length(from) < 0.1) continue;
        const Vec3 origin = Real(6) / length(from) * from;
        rays.push_back({origin, size * in_cube(random) - origin});
    }
    return rays;
}

/// A hierarchy, and all that takes its place.
struct AllTrees {
    std::vector<Triangle> triangles;
    ShapePoints points;
    Hierarchy boxes;
    SphereTree spheres;
    OrientedBoxTree oriented;
    EllipsoidTree ellipsoids;
    std::array<double, 4> seconds{};  ///< that it took to build each
};

inline AllTrees all_trees(const std::string& kind, int count) {
    AllTrees all{.triangles = triangles_of(kind, count),
                 .points = {},
                 .boxes = {},
                 .spheres = {},
                 .oriented = {},
                 .ellipsoids = {}};
    for (const Triangle& t : all.triangles) add_points(all.points, t, bounds_of(t));
    const auto timed = [&](std::size_t k, const auto& build) { all.seconds[k] = seconds_of(build); };
    timed(0, [&] { all.boxes = build_hierarchy(all.triangles); });
    timed(1, [&] { all.spheres = sphere_tree(all.boxes, all.points); });
    timed(2, [&] { all.oriented = oriented_box_tree(all.boxes, all.points); });
    timed(3, [&] { all.ellipsoids = ellipsoid_tree(all.boxes, all.points); });
    return all;
}

inline constexpr std::array<const char*, 4> volume_names{"boxes", "spheres", "oriented boxes", "ellipsoids"};
inline constexpr std::array<const char*, 4> volume_colors{blue, red, green, purple};

inline const Bounds& volume_of(const HierarchyNode& node) { return node.box; }
template <class Volume>
const Volume& volume_of(const VolumeNode<Volume>& node) {
    return node.volume;
}

// -------------------------------------------------------------------------------------------------- figures

/// The outline of what a volume is around a leaf of a plant, seen from the front.
inline void draw_fits(const Path& directory) {
    Random random = random_for(13, 6 + 20, 0);
    std::vector<Vec3> points;
    for (int k = 0; k < 60; ++k) {
        const Real along = random_real(random),
                   wide = 0.24 * std::sin(pi * along) * (2 * random_real(random) - 1);
        const Vec3 u(0.8, 0.6, 0), v(-0.6, 0.8, 0);
        points.push_back((2 * along - 1) * u + wide * v + Vec3(0, 0, 0.06 * random_real(random)));
    }
    const Real scale = 78;
    Svg svg{.width = 760, .height = 240};
    const auto panel = [&](int number, const char* words, const auto& is_inside) {
        const Vec2 at(95 + 190 * number, 135);
        const auto place = [&](const Vec2& p) { return at + scale * Vec2(p.x, -p.y); };
        // The outline: where a ray from the middle leaves it.
        std::vector<Vec2> outline;
        for (int k = 0; k < 720; ++k) {
            const Vec2 out(std::cos(pi * k / 360), std::sin(pi * k / 360));
            Real low = 0, high = 3;
            for (int step = 0; step < 30; ++step) {
                const Real mid = (low + high) / 2;
                (is_inside(mid * out) ? low : high) = mid;
            }
            outline.push_back(place(low * out));
        }
        polygon(svg, outline,
                {.stroke = volume_colors[static_cast<std::size_t>(number)], .width = 2, .fill = "#f4f4f4"});
        for (const Vec3& p : points) dot_at(svg, place({p.x, p.y}), ink, 2);
        text(svg, at + Vec2(0, -115), words, heading);
    };
    // Whether a line along z through the place meets the volume.
    const auto met = [](const auto& volume) {
        return [&volume](const Vec2& p) {
            return clip(volume, Ray{{p.x, p.y, 9}, {0, 0, -1}}, {}).has_value();
        };
    };
    Bounds box;
    for (const Vec3& p : points) box = merge(box, {p, p});
    const BoundingSphere sphere = smallest_sphere(points).sphere;
    const OrientedBox oriented = small_box(points);
    const BoundingEllipsoid ellipsoid = small_ellipsoid(points, 0);
    panel(0, "box", met(box));
    panel(1, "sphere", met(sphere));
    panel(2, "oriented box", met(oriented));
    panel(3, "ellipsoid", met(ellipsoid));
    write_svg(directory / "fits.svg", svg);
}

/// How many of the rays that meet a leaf's volume hit nothing in it, and what a test takes.
inline void draw_tightness(const Path& directory) {
    std::string csv = "shapes,boxes,spheres,oriented boxes,ellipsoids\n";
    std::string measured = "volume,ns a test\n";
    std::array<std::array<Real, 4>, 3> in_vain{};
    std::array<double, 4> ns{};
    const std::array<const char*, 3> kinds{"ring", "soup", "needles"};
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const AllTrees all = all_trees(kinds[k], 1800);
        const std::vector<Ray> rays = rays_into_cube(400, k == 0 ? 2.5 : 1);
        csv += kinds[k];
        const auto count = [&](std::size_t which, const auto& tree) {
            std::uint64_t met = 0, hit = 0, tests = 0;
            const double seconds = seconds_of([&] {
                for (const Ray& ray : rays)
                    for (const auto& node : tree.nodes) tests += clip(volume_of(node), ray, {}) ? 1u : 0u;
            });
            if (k == 1)
                ns[which] = 1e9 * seconds /
                            (static_cast<double>(rays.size()) * static_cast<double>(tree.nodes.size()));
            for (const Ray& ray : rays)
                for (const auto& node : tree.nodes) {
                    if (node.count == 0 || !clip(volume_of(node), ray, {})) continue;
                    ++met;
                    bool any = false;
                    for (std::uint32_t i = 0; i < node.count; ++i)
                        any =
                            any || intersect(all.triangles[tree.items[node.first + i]], ray, {}).has_value();
                    hit += any ? 1u : 0u;
                }
            in_vain[k][which] = 1 - static_cast<Real>(hit) / static_cast<Real>(met);
            csv += fmt::format(",{:.4f}", in_vain[k][which]);
        };
        count(0, all.boxes);
        count(1, all.spheres);
        count(2, all.oriented);
        count(3, all.ellipsoids);
        csv += "\n";
    }
    for (std::size_t which = 0; which < 4; ++which)
        measured += fmt::format("{},{:.3g}\n", volume_names[which], ns[which]);
    // Beside the time that a test takes, which is a machine's.
    Svg svg{.width = 700, .height = 330};
    const Real most = 1.15 * *std::ranges::max_element(ns);
    const Plot plot{{70, 30}, {430, 240}, {0, most}, {0, 1}};
    Ticks times;
    for (int k = 0; k * 20 < most; ++k) times.emplace_back(k * 20, std::to_string(k * 20));
    draw_axes(svg, plot, times, {{0, "0"}, {0.25, "25 %"}, {0.5, "50 %"}, {0.75, "75 %"}, {1, "100 %"}});
    text(svg, {285, 312}, "ns a test", middle(small));
    text(svg, {20, 150}, "met in vain", {.size = 13, .anchor = "middle", .turn = -90});
    for (std::size_t which = 0; which < 4; ++which) {
        const Vec2 at(530, 60 + 28 * static_cast<Real>(which));
        dot_at(svg, at, volume_colors[which], 6);
        text(svg, at + Vec2(15, 5), volume_names[which], small);
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            dot_at(svg, plot.place(ns[which], in_vain[k][which]), volume_colors[which], 6);
            text(svg, plot.place(ns[which], in_vain[k][which]) + Vec2(10, 5), kinds[k], note);
        }
    }
    write_svg(directory / "measured_tightness.svg", svg);
    write_file(directory / "tightness.csv", csv);
    write_file(directory / "measured_tests.csv", measured);
}

/// What rays pay in the hierarchies of four kinds of volumes.
inline void draw_trees(const Path& directory) {
    std::string csv = "shapes and volumes,nodes,shapes,bytes a triangle\n";
    std::string measured = "shapes and volumes,build ms,ns a ray\n";
    Svg svg{.width = 700, .height = 380};
    const Plot plot{{70, 30}, {430, 290}, {1, 1000, true}, {1, 1000, true}};
    draw_axes(svg, plot, decades(0, 3),
              {{1, "1"}, {3, "3"}, {10, "10"}, {30, "30"}, {100, "100"}, {300, "300"}, {1000, "1000"}});
    text(svg, {285, 362}, "nodes that a ray looks into", middle(small));
    text(svg, {24, 180}, "triangles that it asks", {.size = 13, .anchor = "middle", .turn = -90});
    for (std::size_t which = 0; which < 4; ++which) {
        dot_at(svg, {530, 60 + 28 * static_cast<Real>(which)}, volume_colors[which], 6);
        text(svg, {545, 65 + 28 * static_cast<Real>(which)}, volume_names[which], small);
    }
    for (const auto& [kind, size] : {std::pair{"ring", 2.5}, {"soup", 1.0}, {"needles", 1.0}}) {
        const std::string name = kind;  // clang++ 14 lets no lambda use `kind` itself
        const AllTrees all = all_trees(kind, 12800);
        const std::vector<Ray> rays = rays_into_cube(4000, size);
        std::size_t which = 0;
        const auto cost = [&](const auto& tree) {
            Mailbox mailbox;
            const SearchCounts before = search_counts();
            const auto search_all = [&] {
                for (const Ray& ray : rays) closest_hit(tree, all.triangles, ray, {}, mailbox);
            };
            search_all();
            const auto n = static_cast<Real>(rays.size());
            const Vec2 at(static_cast<Real>(search_counts().cells - before.cells) / n,
                          static_cast<Real>(search_counts().shapes - before.shapes) / n);
            const double seconds = seconds_of(search_all);
            csv += fmt::format("{}: {},{:.1f},{:.2f},{}\n", name, volume_names[which], at.x, at.y,
                               bytes_of(tree) / all.triangles.size());
            measured += fmt::format("{}: {},{:.2g},{:.3g}\n", name, volume_names[which],
                                    1e3 * all.seconds[which], 1e9 * seconds / n);
            dot_at(svg, plot.place(at.x, std::max(at.y, Real(1))), volume_colors[which], 6);
            if (which == 0)
                text(svg, plot.place(at.x, std::max(at.y, Real(1))) + Vec2(-14, 5), name,
                     anchored(note, "end"));
            ++which;
        };
        cost(all.boxes);
        cost(all.spheres);
        cost(all.oriented);
        cost(all.ellipsoids);
    }
    write_svg(directory / "volumes.svg", svg);
    write_file(directory / "volumes.csv", csv);
    write_file(directory / "measured_volumes.csv", measured);
}

/// All of part 4.
inline void draw_volumes(const Path& directory) {
    draw_fits(directory);
    draw_tightness(directory);
    draw_trees(directory);
}

}  // namespace rt::figures
