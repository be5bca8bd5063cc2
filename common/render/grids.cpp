// Grids where they pay: what a grid would cost is found out on samples before much is spent on it.
#include "common/render/grids.hpp"

#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/09_grids/walk.hpp"
#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

namespace rt {
namespace {

// ------------------------------------------------------------------------------------- shapes and their
// boxes

template <class Shape>
Bounds box_of(const World&, const Shape& shape) {
    return bounds_of(shape);
}
Bounds box_of(const World& world, const Instance& shape) {
    return bounds_of(shape, world.meshes[shape.mesh]);
}

/// Shapes of one kind, and what chapter 9 asks of them.
template <class Shape>
struct Boxed {
    const World& world;
    const std::vector<Shape>& shapes;
    std::vector<Bounds> bounds;
    Real distortion = 1;

    static constexpr bool exact = std::is_same_v<Shape, Sphere> || std::is_same_v<Shape, Triangle>;

    Boxed(const World& in, const std::vector<Shape>& all) : world(in), shapes(all) {
        bounds.reserve(shapes.size());
        for (const Shape& shape : shapes) {
            bounds.push_back(box_of(world, shape));
            if constexpr (requires { shape.transform; })
                distortion = std::max(distortion, distortion_of(shape.transform));
        }
    }

    std::size_t size() const { return shapes.size(); }
    Vec3 middle(std::size_t i) const { return bounds[i].low * Real(0.5) + bounds[i].high * Real(0.5); }

    /// The diagonal of the box around all.
    Real reach() const {
        Bounds around;
        for (const Bounds& box : bounds) around = merge(around, box);
        return glm::length(around.high - around.low);
    }

    bool may_be_in(std::uint32_t i, const Bounds& box) const {
        if constexpr (exact) return overlaps(shapes[i], box);
        return overlaps(bounds[i], box);
    }

    std::optional<Hit> closest(const Grid& grid, const Ray& ray, Mailbox& mailbox) const {
        const std::span<const Shape> all(shapes);
        if constexpr (std::is_same_v<Shape, Instance>)
            return closest_hit(grid, all, world.meshes, ray, {0, infinity}, mailbox);
        else
            return closest_hit(grid, all, ray, {0, infinity}, mailbox);
    }

    bool any(const Grid& grid, const Ray& ray, Interval range, Mailbox& mailbox) const {
        const std::span<const Shape> all(shapes);
        if constexpr (std::is_same_v<Shape, Instance>)
            return any_hit(grid, all, world.meshes, ray, range, mailbox);
        else
            return any_hit(grid, all, ray, range, mailbox);
    }
};

/// The middle of three numbers at least: that of an odd number of them.
Real median(std::vector<Real> numbers) {
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), middle, numbers.end());
    return *middle;
}

/// About `count` of the numbers below `size`, evenly spread.
std::vector<std::size_t> sample(std::size_t size, std::size_t count) {
    std::vector<std::size_t> chosen;
    const std::size_t step = std::max<std::size_t>(1, size / std::max<std::size_t>(1, count));
    for (std::size_t i = step / 2; i < size; i += step) chosen.push_back(i);
    return chosen;
}

// ------------------------------------------------------------------------------------------ far outliers

/// How far each box reaches from where most of them are, along the axis where that is farthest.
std::vector<Real> reaches(const std::vector<Bounds>& bounds) {
    Vec3 center;
    for (int a = 0; a < 3; ++a) {
        std::vector<Real> middles;
        for (const std::size_t i : sample(bounds.size(), 1000))
            middles.push_back(bounds[i].low[a] / 2 + bounds[i].high[a] / 2);
        center[a] = median(middles);
    }
    std::vector<Real> reach;
    reach.reserve(bounds.size());
    for (const Bounds& box : bounds) {
        const Vec3 away = glm::max(glm::abs(box.low - center), glm::abs(box.high - center));
        reach.push_back(max_component(away));
    }
    return reach;
}

/// The shapes that a grid is better without, ascending: so far out, or so large, that all the others would
/// share a few of its cells, or lie within its margin. To ask one of them costs every ray 1; a box half as
/// large is worth about `octave` to it.
std::vector<std::uint32_t> outliers(const std::vector<Bounds>& bounds) {
    constexpr Real octave = 16;
    const std::size_t most = std::min<std::size_t>(64, bounds.size() / 8);
    const std::vector<Real> reach = reaches(bounds);
    std::vector<std::uint32_t> order(bounds.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto farther = [&](std::uint32_t i, std::uint32_t k) { return reach[i] > reach[k]; };
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most + 1), order.end(),
                      farther);
    const Real least = reach[order[most]];
    std::size_t best = 0;
    Real best_cost = infinity;
    for (std::size_t k = 0; k <= most; ++k) {
        const Real cost = static_cast<Real>(k) + octave * std::log2(reach[order[k]] / least);
        if (cost < best_cost) best = k, best_cost = cost;
    }
    // A little farther out than the others is no outlier.
    const Real gain = octave * std::log2(reach[order[0]] / least) - best_cost;
    order.resize(gain > 2 * octave ? best : 0);
    std::ranges::sort(order);
    return order;
}

/// The elements whose numbers are in `chosen`, which is ascending, and the others, both in their order.
template <class Element>
std::pair<std::vector<Element>, std::vector<Element>> parted(const std::vector<Element>& all,
                                                             const std::vector<std::uint32_t>& chosen) {
    std::pair<std::vector<Element>, std::vector<Element>> parts;
    std::size_t next = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool is_chosen = next < chosen.size() && chosen[next] == i;
        (is_chosen ? parts.first : parts.second).push_back(all[i]);
        if (is_chosen) ++next;
    }
    return parts;
}

/// Moves these shapes of the group into one that is returned.
template <class Kind>
Kind set_apart(Kind& group, const std::vector<std::uint32_t>& chosen) {
    Kind apart;
    const auto part = [&](auto& from, auto& to) {
        if (!from.empty()) std::tie(to, from) = parted(from, chosen);
    };
    part(group.shapes, apart.shapes);
    part(group.primitive, apart.primitive);
    if constexpr (std::is_same_v<Kind, Triangles>) {
        part(group.normals, apart.normals);
        part(group.uvs, apart.uvs);
    }
    return apart;
}

// --------------------------------------------------------------------------------------- what it would cost

// Costs are in units of one shape asked.
constexpr Real cost_of_shape = 60;    // to be entered in a grid
constexpr Real cost_of_question = 2;  // whether a shape may be in a box;
constexpr Real cost_of_triangle = 6;  // a triangle
constexpr Real cost_of_clip = 14;     // a ray, before the first cell
constexpr Real cost_of_cell = 0.5;    // a ray, a cell

template <class Shape>
constexpr Real question = std::is_same_v<Shape, Triangle> ? cost_of_triangle : cost_of_question;

/// Thrown out of a build that has cost more than it was worth.
struct TooMuchWork {};

/// The cells from `low` up to and including `high`.
struct Block {
    Cells low;
    Cells high;
};

/// What it takes to list the cells of shapes, on average.
struct Listing {
    Real cells = 0;      ///< that a shape is listed in; counted up to 64
    Real questions = 0;  ///< that it takes to find them
    Real share = 0;      ///< of all cells
};

/// Finds the cells of shape i in the block by halves, as chapter 9 does, until there are more than 64.
template <class Shape>
void count_cells(const Boxed<Shape>& boxed, const GridShape& shape, std::uint32_t i, const Block& block,
                 Listing& listing) {
    if (listing.cells > 64) return;
    ++listing.questions;
    if (!boxed.may_be_in(i, {cell_box(shape, block.low).low, cell_box(shape, block.high).high})) return;
    const Cells size = block.high - block.low + 1;
    if (size == Cells(1)) {
        ++listing.cells;
        return;
    }
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    Block lower = block, upper = block;
    lower.high[axis] = block.low[axis] + size[axis] / 2 - 1;
    upper.low[axis] = lower.high[axis] + 1;
    count_cells(boxed, shape, i, lower, listing);
    count_cells(boxed, shape, i, upper, listing);
}

/// The listing of a grid of this shape, from a sample of the shapes.
template <class Shape>
Listing listing_of(const Boxed<Shape>& boxed, const GridShape& shape) {
    const Vec3 per_length = Vec3(shape.cells) / (shape.box.high - shape.box.low);
    const auto cell_at = [&](const Vec3& point) {
        Cells cell(0);
        for (int a = 0; a < 3; ++a) {
            const Real place = (point[a] - shape.box.low[a]) * per_length[a];
            // Written so that NaN becomes 0.
            if (place > 0) cell[a] = static_cast<int>(std::min(place, static_cast<Real>(shape.cells[a] - 1)));
        }
        return cell;
    };
    Listing sum;
    const std::vector<std::size_t> some =
        sample(boxed.size(), std::clamp<std::size_t>(boxed.size() / 32, 8, 64));
    for (const std::size_t i : some) {
        Listing one;
        const Block block{cell_at(boxed.bounds[i].low), cell_at(boxed.bounds[i].high)};
        count_cells(boxed, shape, static_cast<std::uint32_t>(i), block, one);
        sum.cells += one.cells, sum.questions += one.questions;
    }
    const Real each = 1 / static_cast<Real>(some.size());
    const Real all = static_cast<Real>(shape.cells.x) * shape.cells.y * shape.cells.z;
    return {sum.cells * each, sum.questions * each, sum.cells * each / all};
}

// ------------------------------------------------------------------------------------------------ building

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

struct Builder {
    World& world;
    bool always;
    bool nested;
    Rays rays;
    std::uint32_t mailbox = 0;

    bool wants(std::size_t shapes) const { return always || grid_pays(shapes, rays.count); }

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
        const WalkCounts before = walk_counts();
        Mailbox own;
        std::size_t count = some.size();
        for (const Ray& ray : some) {
            const std::optional<Hit> hit = boxed.closest(grid, ray, own);
            if (!hit || !rays.shadows) continue;
            const Vec3 point = ray.origin + hit->t * ray.direction;
            for (const PointLight& light : world.point_lights)
                boxed.any(grid, {point, light.position - point}, {0x1p-20, 1}, own), ++count;
            for (const DirectionalLight& light : world.directional_lights)
                boxed.any(grid, {point, light.direction}, {0x1p-20 * hit->t, infinity}, own), ++count;
        }
        const Real each = 1 / static_cast<Real>(count);
        const Real asked = each * static_cast<Real>(walk_counts().shapes - before.shapes);
        const Real cells = each * static_cast<Real>(walk_counts().cells - before.cells);
        grid_work().probes += walk_counts().shapes - before.shapes;
        walk_counts() = before;
        return {cost_of_clip + cost_of_cell * cells + asked, asked,
                rays.paths * static_cast<Real>(count) / static_cast<Real>(some.size())};
    }

    /// How many cells a shape the grid is to have; 0 if no number would pay.
    template <class Shape>
    Real density_for(const Boxed<Shape>& boxed) const {
        const auto n = static_cast<Real>(boxed.size());
        const Real none = rays.count * n;
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
            const Real asked = n * std::pow(listing.share, Real(2) / 3);
            const Real total = building + rays.count * (cost_of_clip + std::cbrt(n) + asked);
            if (total < least) best = density, least = total;
        }
        return best;
    }

    /// The grid that makes the picture cheapest, or none. What is tried in vain costs at most a third of what
    /// the picture costs without.
    template <class Shape>
    Grid cheapest(const Boxed<Shape>& boxed, bool from_camera) const {
        const auto n = static_cast<Real>(boxed.size());
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
                if (deeper.cost < walk.cost) return deeper.cost < n ? std::move(deep) : Grid{};
            } catch (const TooMuchWork&) {
                // The flat one is good enough.
            }
        }
        return walk.cost < n ? std::move(flat) : Grid{};
    }

    /// The grid; without cells where it does not pay, or where a student has not written chapter 9 yet and
    /// the scene does not insist.
    template <class Shape>
    Grid grid_over(const std::vector<Shape>& shapes, bool from_camera) {
        try {
            try_to_walk();
            const Boxed<Shape> boxed(world, shapes);
            GridOptions options;
            options.nested = nested;
            Grid grid = always ? build_over(boxed, options) : cheapest(boxed, from_camera);
            if (grid.empty()) return grid;
            grid.mailbox = mailbox++;
            world.needs.grids = true;
            return grid;
        } catch (const NotImplemented&) {
            if (always) throw;
            return {};
        }
    }

    /// A grid over the group's shapes; outliers go to a group of their own, which is returned.
    template <class Kind>
    std::optional<AnyGroup> grid_group(AnyGroup& any, Kind& group) {
        std::vector<std::uint32_t> far;
        if (!always) far = outliers_of(group.shapes);
        Grid grid =
            far.empty() ? grid_over(group.shapes, true) : grid_over(parted(group.shapes, far).second, true);
        if (grid.empty()) return std::nullopt;
        std::optional<AnyGroup> apart;
        if (!far.empty()) apart = set_apart(group, far);
        any = Gridded<Kind>{Kind(std::move(group)), std::move(grid)};
        return apart;
    }

    template <class Shape>
    std::vector<std::uint32_t> outliers_of(const std::vector<Shape>& shapes) const {
        try {
            return outliers(Boxed<Shape>(world, shapes).bounds);
        } catch (const NotImplemented&) {
            return {};
        }
    }

    /// Writes down where the shapes of a group are.
    void place(std::size_t number) {
        std::visit(
            [&](const auto& group) {
                for (std::size_t i = 0; i < group.primitive.size(); ++i) {
                    world.primitives[group.primitive[i]].group = static_cast<std::uint32_t>(number);
                    world.primitives[group.primitive[i]].index = static_cast<std::uint32_t>(i);
                }
            },
            world.groups[number]);
    }
};

}  // namespace

GridWork& grid_work() {
    thread_local GridWork work;
    return work;
}

bool grid_pays(std::size_t shapes, Real rays) {
    const auto n = static_cast<Real>(shapes);
    return rays * n > cost_of_shape * n + rays * (cost_of_clip + 2 * std::cbrt(n));
}

Real expected_rays(const Scene& scene, const World& world) {
    const Real lights = static_cast<Real>(world.point_lights.size() + world.directional_lights.size());
    const Needs& needs = world.needs;
    const Real paths = needs.reflection || needs.refraction ? 3 : 1;
    return static_cast<Real>(scene.width) * scene.height * scene.sampling.count * paths *
           (1 + (needs.shadows ? lights : 0));
}

void add_grids(const Scene& scene, World& world) {
    if (scene.accelerator == AcceleratorChoice::None || scene.integrator == Integrator::Rasterize) return;
    const Needs& needs = world.needs;
    const Real paths = static_cast<Real>(scene.width) * scene.height * scene.sampling.count *
                       (needs.reflection || needs.refraction ? 3 : 1);
    Builder builder{world,
                    scene.accelerator != AcceleratorChoice::Auto,
                    scene.accelerator != AcceleratorChoice::Grid,
                    {expected_rays(scene, world), paths, needs.shadows}};
    // Meshes first: what an instance costs depends on its mesh's grid. The camera is not in a mesh's space.
    for (SharedMesh& mesh : world.meshes)
        if (builder.wants(mesh.triangles.shapes.size()))
            mesh.grid = builder.grid_over(mesh.triangles.shapes, false);
    const std::size_t groups = world.groups.size();
    for (std::size_t i = 0; i < groups; ++i) {
        AnyGroup any = std::move(world.groups[i]);
        std::optional<AnyGroup> apart;
        std::visit(
            [&]<class Kind>(Kind& group) {
                if constexpr (!has_grid<Kind> && !std::is_same_v<Kind, Planes>)
                    if (builder.wants(group.shapes.size())) apart = builder.grid_group(any, group);
            },
            any);
        world.groups[i] = std::move(any);
        if (!apart) continue;
        world.groups.push_back(std::move(*apart));
        builder.place(i);
        builder.place(world.groups.size() - 1);
    }
}

}  // namespace rt
