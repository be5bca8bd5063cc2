// Grids where they pay.
#include "common/render/grids.hpp"

#include "chapters/09_grids/walk.hpp"
#include "common/math/todo.hpp"

#include <cmath>
#include <type_traits>

namespace rt {
namespace {

template <class Shape>
Grid build_over(const World&, const std::vector<Shape>& shapes, const GridOptions& options) {
    return build_grid(std::span<const Shape>(shapes), options);
}
Grid build_over(const World& world, const std::vector<Instance>& shapes, const GridOptions& options) {
    return build_grid(shapes, world.meshes, options);
}

/// Throws NotImplemented where a student has not written all of chapter 9 yet.
void try_to_walk() {
    const Sphere sphere;
    const std::span<const Sphere> shapes(&sphere, 1);
    const Ray ray{{0, 0, 3}, {0, 0, -1}};
    Mailbox mailbox;
    const Grid grid = build_grid(shapes);
    closest_hit(grid, shapes, ray, {}, mailbox);
    any_hit(grid, shapes, ray, {}, mailbox);
}

struct Builder {
    World& world;
    bool always;
    bool nested;
    Real rays;
    std::uint32_t mailbox = 0;

    bool wants(std::size_t shapes) const { return always || grid_pays(shapes, rays); }

    /// The grid; without cells where a student has not written chapter 9 yet and the scene does not insist.
    template <class Shape>
    Grid grid_over(const std::vector<Shape>& shapes) {
        try {
            try_to_walk();
            GridOptions options;
            options.nested = nested;
            Grid grid = build_over(world, shapes, options);
            grid.mailbox = mailbox++;
            world.needs.grids = true;
            return grid;
        } catch (const NotImplemented&) {
            if (always) throw;
            return {};
        }
    }
};

}  // namespace

bool grid_pays(std::size_t shapes, Real rays) {
    constexpr Real building = 320;  // a shape; less in large grids
    constexpr Real walking = 24;    // a ray, and more for larger grids
    const auto n = static_cast<Real>(shapes);
    return rays * n > building * n + rays * (walking + 2 * std::cbrt(n));
}

Real expected_rays(const Scene& scene, const World& world) {
    const Real lights = static_cast<Real>(world.point_lights.size() + world.directional_lights.size());
    const Needs& needs = world.needs;
    const Real paths = needs.reflection || needs.refraction ? 3 : 1;
    return static_cast<Real>(scene.width) * scene.height * scene.sampling.count * paths *
           (1 + (needs.shadows ? lights : 0));
}

void add_grids(const Scene& scene, World& world) {
    if (scene.accelerator == Accelerator::None || scene.integrator == Integrator::Rasterize) return;
    Builder builder{world, scene.accelerator != Accelerator::Auto, scene.accelerator != Accelerator::Grid,
                    expected_rays(scene, world)};
    for (AnyGroup& any : world.groups) {
        std::optional<AnyGroup> gridded;
        std::visit(
            [&]<class Kind>(Kind& group) {
                if constexpr (!has_grid<Kind> && !std::is_same_v<Kind, Planes>) {
                    if (!builder.wants(group.shapes.size())) return;
                    Grid grid = builder.grid_over(group.shapes);
                    if (!grid.empty()) gridded = Gridded<Kind>{std::move(group), std::move(grid)};
                }
            },
            any);
        if (gridded) any = std::move(*gridded);
    }
    for (SharedMesh& mesh : world.meshes)
        if (builder.wants(mesh.triangles.shapes.size())) mesh.grid = builder.grid_over(mesh.triangles.shapes);
}

}  // namespace rt
