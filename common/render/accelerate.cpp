// Accelerators where they pay: what a grid would cost is found out on samples before much is spent on it.
#include "common/render/accelerate.hpp"

#include "common/math/todo.hpp"
#include "common/render/grid_cost.hpp"
#include "common/render/groups.hpp"
#include "common/render/outliers.hpp"
#include "common/render/primitives.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// Thrown out of a build that has cost more than it was worth.
struct TooMuchWork {};

/// The grid; throws TooMuchWork if more than `most` questions are asked.
template <class Shape>
Grid build_over(const Boxed<Shape>& boxed, GridOptions options, Real most = infinity) {
    options.distortion = boxed.distortion;
    std::uint64_t asked = 0;
    const auto limit = static_cast<std::uint64_t>(std::min(most, Real(0x1p60)));
    const auto finish = [&] {
        grid_work().questions += asked;
        grid_work().entered += boxed.size();
    };
    try {
        Grid grid = build_grid(
            boxed.bounds,
            [&](std::uint32_t i, const Bounds& box) {
                if (++asked > limit) throw TooMuchWork();
                return boxed.may_be_in(i, box);
            },
            options);
        finish();
        return grid;
    } catch (const TooMuchWork&) {
        finish();
        throw;
    }
}

/// The points that the shapes are between.
template <class Shape>
ShapePoints points_of(const Boxed<Shape>& boxed) {
    ShapePoints points;
    for (std::size_t i = 0; i < boxed.size(); ++i) add_points(points, boxed.shapes[i], boxed.bounds[i]);
    return points;
}

/// A picture's rays, as far as they are known before it is rendered.
struct Rays {
    Real count = 0;  ///< of all kinds
    Real paths = 0;  ///< from the camera, and those that are mirrored or refracted
    bool shadows = false;
};

/// Number i of a sequence that fills the unit square evenly (Roberts 2018).
Vec2 spread(int i) {
    const Real x = 0.5 + 0.7548776662466927 * i, y = 0.5 + 0.5698402909980532 * i;
    return {x - std::floor(x), y - std::floor(y)};
}

/// Builds the accelerators of a world.
struct AcceleratorBuilder {
    World& world;
    AcceleratorChoice choice;
    Rays rays;
    std::uint32_t mailbox = 0;

    bool always() const { return choice != AcceleratorChoice::Auto; }
    template <class Shape>
    bool wants(const Group<Shape>& group) const {
        return always() || grid_pays(group.shapes.size(), rays.count, words<Shape>.ask);
    }

    /// Some rays of the picture; into a mesh, whose space the camera is not in, some from all around.
    template <class Shape>
    std::vector<Ray> probes(const Boxed<Shape>& boxed, bool from_camera) const {
        const int count = static_cast<int>(std::clamp(rays.paths / 64, Real(4), Real(64)));
        std::vector<Ray> some;
        for (int i = 0; i < count; ++i) {
            const Vec2 place = spread(i);
            if (from_camera) {
                some.push_back(
                    pixel_ray(world.view, place.x * world.view.width, place.y * world.view.height));
                continue;
            }
            const Real z = 2 * place.x - 1, around = 2 * pi * place.y, r = std::sqrt(1 - z * z);
            const Vec3 direction(r * std::cos(around), r * std::sin(around), z);
            const std::size_t at =
                static_cast<std::size_t>(i) * boxed.size() / static_cast<std::size_t>(count);
            const Vec3 middle = boxed.middle(at);
            some.push_back({middle - direction * boxed.reach(), direction});
        }
        return some;
    }

    /// What an average ray costs in the grid, how much of that is shapes asked, and how many rays there are.
    struct Walk {
        Real cost = 0;
        Real asked = 0;
        Real rays = 0;
    };
    /// Follows the rays, and from what they hit on to the lights.
    template <class Shape>
    Walk walk_of(const Boxed<Shape>& boxed, const Grid& grid, const std::vector<Ray>& some) const {
        const SearchCounts before = search_counts();
        const std::span<const Shape> shapes(boxed.shapes);
        Mailbox own;
        std::size_t count = some.size();
        for (const Ray& ray : some) {
            const std::optional<Hit> hit = closest_hit(grid, shapes, ray, {0, infinity}, own);
            if (!hit || !rays.shadows) continue;
            const Vec3 point = ray.origin + hit->t * ray.direction;
            for (const PointLight& light : world.point_lights)
                any_hit(grid, shapes, {point, light.position - point}, {0x1p-20, 1}, own), ++count;
            for (const DirectionalLight& light : world.directional_lights)
                any_hit(grid, shapes, {point, light.direction}, {0x1p-20 * hit->t, infinity}, own), ++count;
        }
        const Real each = 1 / static_cast<Real>(count);
        const Real asked =
            words<Shape>.ask * each * static_cast<Real>(search_counts().shapes - before.shapes);
        const Real cells = each * static_cast<Real>(search_counts().cells - before.cells);
        grid_work().probes += search_counts().shapes - before.shapes;
        search_counts() = before;
        return {cost_of_clip + cost_of_cell * cells + asked, asked,
                rays.paths * static_cast<Real>(count) / static_cast<Real>(some.size())};
    }

    /// How many cells a shape the grid is to have; 0 if no number would pay.
    template <class Shape>
    Real density_for(const Boxed<Shape>& boxed) const {
        const auto n = static_cast<Real>(boxed.size());
        const Real all = n * words<Shape>.ask, none = rays.count * all;
        Bounds around;
        for (const Bounds& box : boxed.bounds) around = merge(around, box);
        Real best = 0, least = none;
        for (const Real density : {Real(4), Real(0.5), Real(1) / 16, Real(1) / 128}) {
            const GridShape shape{around, grid_resolution(around, boxed.size(), density)};
            const Listing listing = listing_of(boxed, shape);
            grid_work().questions += static_cast<std::uint64_t>(listing.questions);
            // Where every shape is in most of the cells, they separate nothing.
            if (listing.cells > 24 || listing.share > 0.5) continue;
            const Real building = n * (cost_of_shape + question<Shape> * listing.questions);
            if (building <= 0.15 * none) return density;
            const Real asked = all * std::pow(listing.share, Real(2) / 3);
            const Real total = building + rays.count * (cost_of_clip + std::cbrt(n) + asked);
            if (total < least) best = density, least = total;
        }
        return best;
    }

    /// The grid that makes the picture cheapest, or nothing. What is tried in vain costs at most a third of
    /// what the picture costs without.
    template <class Shape>
    Accelerator cheapest(const Boxed<Shape>& boxed, bool from_camera) const {
        const auto n = static_cast<Real>(boxed.size());
        const Real all = n * words<Shape>.ask;
        GridOptions options;
        options.nested = false;
        options.density = density_for(boxed);
        if (options.density == 0) return {};
        const std::uint64_t before = grid_work().questions;
        Grid flat = build_over(boxed, options);
        const auto questions = static_cast<Real>(grid_work().questions - before);
        const std::vector<Ray> some = probes(boxed, from_camera);
        const Walk walk = walk_of(boxed, flat, some);
        // Grids inside can save shapes asked, no more; and the one outside is built again around them.
        const Real worth = 0.3 * walk.rays * walk.asked;
        const Real again = n * cost_of_shape + question<Shape> * questions;
        if (again < worth) {
            try {
                options.nested = true;
                Grid deep = build_over(boxed, options, questions + (worth - again) / question<Shape>);
                const Walk deeper = walk_of(boxed, deep, some);
                if (deeper.cost < walk.cost) return deeper.cost < all ? std::move(deep) : Accelerator();
            } catch (const TooMuchWork&) {
                // The flat one is good enough.
            }
        }
        return walk.cost < all ? std::move(flat) : Accelerator();
    }

    /// What the scene asks for by name, over these shapes.
    template <class Shape>
    Accelerator build(const Boxed<Shape>& boxed, bool from_camera) const {
        GridOptions options;
        const auto hierarchy = [&] {
            return build_hierarchy(boxed.bounds, {.distortion = boxed.distortion});
        };
        switch (choice) {
            case AcceleratorChoice::Auto:
                return cheapest(boxed, from_camera);
            case AcceleratorChoice::None:
                return {};
            case AcceleratorChoice::Grid:
                options.nested = false;
                return build_over(boxed, options);
            case AcceleratorChoice::Nested:
                return build_over(boxed, options);
            case AcceleratorChoice::Bvh:
                return hierarchy();
            case AcceleratorChoice::Spheres:
                return sphere_tree(hierarchy(), points_of(boxed));
            case AcceleratorChoice::OrientedBoxes:
                return oriented_box_tree(hierarchy(), points_of(boxed));
            case AcceleratorChoice::Ellipsoids:
                return ellipsoid_tree(hierarchy(), points_of(boxed));
        }
        return {};
    }

    /// Puts an accelerator over the shapes of a group, if it pays or the scene insists. Where a student has
    /// not written its chapter yet and the scene does not insist, there is none.
    template <class Shape>
    void accelerate(Group<Shape>& group, const std::vector<Shape>& shapes, bool from_camera) {
        try {
            const Boxed<Shape> boxed(shapes);
            if (!always()) try_out(boxed);
            group.accelerator = build(boxed, from_camera);
        } catch (const NotImplemented&) {
            if (always()) throw;
            return;
        }
        if (!has_accelerator(group)) return;
        group.mailbox = mailbox++;
        world.needs.accelerators = true;
    }

    /// Throws NotImplemented where a student has not written all of the chapter yet.
    template <class Shape>
    static void try_out(const Boxed<Shape>& boxed) {
        const std::span<const Shape> one(boxed.shapes.data(), 1);
        const Vec3 to = boxed.middle(0);
        const Ray ray{to - Vec3(0, 0, boxed.reach()), {0, 0, 1}};
        Mailbox own;
        const Grid grid = build_grid(one);
        closest_hit(grid, one, ray, {}, own);
        Grid nested = grid;
        nested.grids.push_back(grid);
        nested.inner.assign(grid.first.size() - 1, 1);
        nested.first.assign(grid.first.size(), 0);
        nested.items.clear();
        closest_hit(nested, one, ray, {}, own);
    }

    /// An accelerator over the group's shapes; outliers go to a group of their own, which is returned.
    template <class Shape>
    std::optional<AnyGroup> accelerate_group(Group<Shape>& group) {
        const std::vector<std::uint32_t> far =
            always() ? std::vector<std::uint32_t>() : outliers_of(group.shapes);
        if (far.empty()) {
            accelerate(group, group.shapes, true);
            return std::nullopt;
        }
        accelerate(group, parted(group.shapes, far).second, true);
        if (!has_accelerator(group)) return std::nullopt;
        return set_apart(group, far);
    }

    template <class Shape>
    std::vector<std::uint32_t> outliers_of(const std::vector<Shape>& shapes) const {
        try {
            return outliers(Boxed<Shape>(shapes).bounds);
        } catch (const NotImplemented&) {
            return {};
        }
    }
};

}  // namespace

GridWork& grid_work() {
    thread_local GridWork work;
    return work;
}

bool grid_pays(std::size_t shapes, Real rays, Real ask) {
    const auto n = static_cast<Real>(shapes);
    return rays * n * ask > cost_of_shape * n + rays * (cost_of_clip + 2 * std::cbrt(n));
}

Real expected_rays(const Scene& scene, const World& world) {
    const Real lights = static_cast<Real>(world.point_lights.size() + world.directional_lights.size());
    const Needs& needs = world.needs;
    const Real paths = needs.reflection || needs.refraction ? 3 : 1;
    return static_cast<Real>(scene.width) * scene.height * scene.sampling.count * paths *
           (1 + (needs.shadows ? lights : 0));
}

void add_accelerators(const Scene& scene, World& world) {
    if (scene.accelerator == AcceleratorChoice::None || scene.visibility == Visibility::Rasterize) return;
    const Needs& needs = world.needs;
    const Real paths = static_cast<Real>(scene.width) * scene.height * scene.sampling.count *
                       (needs.reflection || needs.refraction ? 3 : 1);
    AcceleratorBuilder builder{world, scene.accelerator, {expected_rays(scene, world), paths, needs.shadows}};
    // Meshes first: what an instance costs depends on its mesh's accelerator. The camera is not in a mesh's
    // space.
    for (const auto& mesh : world.meshes)
        if (builder.wants(mesh->triangles))
            builder.accelerate(mesh->triangles, mesh->triangles.shapes, false);
    const std::size_t groups = world.groups.size();
    for (std::size_t i = 0; i < groups; ++i) {
        std::optional<AnyGroup> apart = std::visit(
            [&]<class Shape>(Group<Shape>& group) -> std::optional<AnyGroup> {
                // What has no end is in no box.
                if constexpr (has_bounds<Shape>())
                    if (builder.wants(group)) return builder.accelerate_group(group);
                return std::nullopt;
            },
            world.groups[i]);
        if (!apart) continue;
        world.groups.push_back(std::move(*apart));
        place_shapes(world, i);
        place_shapes(world, world.groups.size() - 1);
    }
}

}  // namespace rt
