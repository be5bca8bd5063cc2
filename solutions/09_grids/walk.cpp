// Walking through a grid along a ray, cell by cell, and asking the shapes on the way.
#include "chapters/09_grids/walk.hpp"

#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/polygon.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/04_transforms/instance.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// The walk along one axis.
struct Axis {
    Real t0 = 0;           ///< where the ray meets boundary number 0, and
    Real delta = 0;        ///< how much farther on the next: boundary number i is at t0 + i · delta
    Real next = infinity;  ///< where the ray leaves the current cell
    int boundary = 0;      ///< the number of the boundary there
    int step = 0;          ///< +1, −1, or 0 where the ray stays between two boundaries for ever
    int last = 0;          ///< the last boundary: behind it is no cell
    int stride = 0;        ///< how much greater the number of the next cell is
};

/// Calls visit(number of the cell, part of the ray in it) for the cells along the ray in order, until a call
/// returns true or the range or the grid ends. Returns whether a call did. The ray is in the box all over the
/// range, up to rounding.
template <class Visit>
bool walk(const GridShape& shape, const Ray& ray, Interval range, const Visit& visit) {
    // [exercise 09.6] Set up the three axes. cell_size is edge/cells, t0 = (low − o)/d, delta = cell_size/d.
    // Where one of these is not finite, the ray is parallel to the boundaries: its cell follows from its
    // origin, and `next` stays infinite. Else find the cell at range.min: roughly by division, then, because
    // that rounds, step by step until boundaries t0 + i · delta that are computed as below say the same.
    //
    // In the loop, the ray leaves the cell where the least of the three `next` is. Visit the cell; stop where
    // the walk has come beyond range.max or to the last boundary of that axis; else move on by one cell, and
    // compute the new `next` from the number of its boundary, not from the old one.
    const Vec3 cell_size = (shape.box.high - shape.box.low) / Vec3(shape.cells);
    const Cells strides(1, shape.cells.x, shape.cells.x * shape.cells.y);
    int number = 0;
    const auto set_up = [&](int a) {
        Axis axis;
        const int cells = shape.cells[a];
        const Real to_low = shape.box.low[a] - ray.origin[a];
        axis.t0 = to_low / ray.direction[a];
        axis.delta = cell_size[a] / ray.direction[a];
        const bool parallel = !(std::abs(axis.t0) < infinity && std::abs(axis.delta) < infinity);
        const Real place = parallel ? -to_low / cell_size[a] : (range.min - axis.t0) / axis.delta;
        // Written so that NaN becomes 0.
        int cell = place > 0 ? static_cast<int>(std::min(place, static_cast<Real>(cells - 1))) : 0;
        if (!parallel) {
            const bool up = axis.delta > 0;
            const auto t_at = [&](int boundary) { return axis.t0 + boundary * axis.delta; };
            axis.step = up ? 1 : -1;
            axis.last = up ? cells : 0;
            axis.boundary = up ? cell + 1 : cell;
            while (axis.boundary != axis.last && t_at(axis.boundary) <= range.min) axis.boundary += axis.step;
            const int first = cells - axis.last + axis.step;
            while (axis.boundary != first && t_at(axis.boundary - axis.step) > range.min)
                axis.boundary -= axis.step;
            axis.next = std::max(t_at(axis.boundary), range.min);
            axis.stride = axis.step * strides[a];
            cell = up ? axis.boundary - 1 : axis.boundary;
        }
        number += cell * strides[a];
        return axis;
    };
    Axis x = set_up(0), y = set_up(1), z = set_up(2);

    // Written out for each axis: that keeps all of it in registers.
    const auto go_on = [&](Axis& axis) {
        if (axis.boundary == axis.last) return false;
        axis.boundary += axis.step;
        axis.next = axis.t0 + axis.boundary * axis.delta;
        number += axis.stride;
        return true;
    };
    for (Real t = range.min;;) {
        const Real next = std::min(x.next, std::min(y.next, z.next));
        if (visit(static_cast<std::size_t>(number), Interval{t, std::min(next, range.max)})) return true;
        if (!(next <= range.max)) return false;
        if (!(next == x.next ? go_on(x) : next == y.next ? go_on(y) : go_on(z))) return false;
        t = next;
    }
    // [/exercise]
}

/// Whether this ray's rounding errors stay below the grid's margin, and its parameters in the range of Real.
bool within_reach(const Grid& grid, const Ray& ray) {
    const Vec3 away = glm::abs(ray.origin - (grid.shape.box.low + grid.shape.box.high) * Real(0.5));
    if (!(away.x <= grid.reach && away.y <= grid.reach && away.z <= grid.reach)) return false;
    const Vec3 d = glm::abs(ray.direction);
    const auto is_moderate = [&](Real x) {
        return x == 0 || (x >= 0x1p-900 * grid.reach && x <= 0x1p900 * grid.reach);
    };
    return is_moderate(d.x) && is_moderate(d.y) && is_moderate(d.z);
}

/// A ray on its way through a grid and the grids in it.
struct Search {
    const Ray& ray;
    Interval range;  ///< in which hits count
    Mailbox& mailbox;
    WalkCounts counts;
    std::optional<Hit> nearest;

    Search(const Ray& of, Interval in, Mailbox& from, std::size_t shapes)
        : ray(of), range(in), mailbox(from) {
        if (mailbox.asked_by.size() < shapes) mailbox.asked_by.resize(shapes, 0);
        // After 2^32 rays the numbers begin anew, and those of old rays mean nothing any more.
        if (++mailbox.ray == 0) {
            std::ranges::fill(mailbox.asked_by, 0);
            mailbox.ray = 1;
        }
    }
    ~Search() {
        WalkCounts& total = walk_counts();
        total.cells += counts.cells;
        total.shapes += counts.shapes;
    }
    Search(const Search&) = delete;
    Search& operator=(const Search&) = delete;

    /// Whether this ray has not asked the shape yet; from now on it has.
    bool is_new(std::uint32_t shape) {
        if (mailbox.asked_by[shape] == mailbox.ray) return false;
        mailbox.asked_by[shape] = mailbox.ray;
        ++counts.shapes;
        return true;
    }
};

/// The part of the search that goes through the grid, or through an inner one: calls look(cell's number, part
/// of the ray in it) until a call says that it is over. Returns whether one did.
template <class Look>
bool search_grid(const Grid& grid, Search& search, Interval part, const Look& look) {
    const std::optional<Interval> inside = clip(grid.shape.box, search.ray, part);
    if (!inside) return false;
    return walk(grid.shape, search.ray, *inside, [&](std::size_t number, Interval t) -> bool {
        ++search.counts.cells;
        return look(number, t);
    });
}

/// The grid that the cell has of its own, if it has one.
const Grid* inner_grid(const Grid& grid, std::size_t number) {
    return grid.inner.empty() || grid.inner[number] == 0 ? nullptr : &grid.grids[grid.inner[number] - 1];
}

/// Looks for the nearest hit with the shapes of a cell; ask(shape, range) is the nearest hit with one shape.
/// Returns whether the search is over.
template <class Ask>
bool closest_in_cell(const Grid& grid, std::size_t number, const Grid* inner, Interval t, Search& search,
                     const Ask& ask) {
    // [exercise 09.7] Ask the shapes of the cell that this ray has not asked yet (search.is_new) in the whole
    // of search.range, and keep the nearest hit in search.nearest, with the shape's index in `primitive`: of
    // equal distances the lowest index, whichever was found first. search.range.max becomes its t. If the
    // cell has a grid of its own, call search_grid for that, in the part t, with this function for its cells.
    // Return true if nothing that is left can be as near: the hit found may lie in a later cell, where others
    // are nearer.
    for (std::uint32_t k = grid.first[number]; k < grid.first[number + 1]; ++k) {
        const std::uint32_t i = grid.items[k];
        if (!search.is_new(i)) continue;
        std::optional<Hit> hit = ask(i, search.range);
        if (!hit) continue;
        hit->primitive = i;
        const std::optional<Hit>& best = search.nearest;
        // Nothing beyond the nearest hit is in the range: this one is nearer, or as near.
        if (best && hit->t == best->t && i > best->primitive) continue;
        search.nearest = hit;
        search.range.max = hit->t;
    }
    if (inner && search_grid(*inner, search, t, [&](std::size_t n, Interval part) {
            return closest_in_cell(*inner, n, inner_grid(*inner, n), part, search, ask);
        }))
        return true;
    return search.nearest && search.nearest->t < t.max;
    // [/exercise]
}

/// Whether a shape of a cell is hit; ask(shape, range) tells it of one shape.
template <class Ask>
bool any_in_cell(const Grid& grid, std::size_t number, const Grid* inner, Interval t, Search& search,
                 const Ask& ask) {
    // [exercise 09.8] Return true as soon as a shape of the cell, that this ray has not asked yet, is hit
    // anywhere in search.range; else what the grid of the cell says in the part t, if there is one.
    for (std::uint32_t k = grid.first[number]; k < grid.first[number + 1]; ++k)
        if (search.is_new(grid.items[k]) && ask(grid.items[k], search.range)) return true;
    return inner && search_grid(*inner, search, t, [&](std::size_t n, Interval part) {
               return any_in_cell(*inner, n, inner_grid(*inner, n), part, search, ask);
           });
    // [/exercise]
}

/// Appends the hits with the shapes of a cell that this ray has not asked yet.
template <class Ask>
void all_in_cell(const Grid& grid, std::size_t number, Interval t, Search& search, const Ask& ask,
                 std::vector<Hit>& hits) {
    for (std::uint32_t k = grid.first[number]; k < grid.first[number + 1]; ++k) {
        const std::uint32_t i = grid.items[k];
        if (!search.is_new(i)) continue;
        if (std::optional<Hit> hit = ask(i, search.range)) {
            hit->primitive = i;
            hits.push_back(*hit);
        }
    }
    if (const Grid* inner = inner_grid(grid, number))
        search_grid(*inner, search, t, [&](std::size_t n, Interval part) {
            all_in_cell(*inner, n, part, search, ask, hits);
            return false;
        });
}

template <class Ask>
std::optional<Hit> closest(const Grid& grid, std::size_t count, const Ray& ray, Interval range,
                           Mailbox& mailbox, const Ask& ask) {
    Search search(ray, range, mailbox, count);
    search_grid(grid, search, range, [&](std::size_t number, Interval t) {
        return closest_in_cell(grid, number, inner_grid(grid, number), t, search, ask);
    });
    return search.nearest;
}

template <class Ask>
bool any(const Grid& grid, std::size_t count, const Ray& ray, Interval range, Mailbox& mailbox,
         const Ask& ask) {
    Search search(ray, range, mailbox, count);
    return search_grid(grid, search, range, [&](std::size_t number, Interval t) {
        return any_in_cell(grid, number, inner_grid(grid, number), t, search, ask);
    });
}

template <class Ask>
void all(const Grid& grid, std::size_t count, const Ray& ray, Interval range, Mailbox& mailbox,
         const Ask& ask, std::vector<Hit>& hits) {
    Search search(ray, range, mailbox, count);
    search_grid(grid, search, range, [&](std::size_t number, Interval t) {
        all_in_cell(grid, number, t, search, ask, hits);
        return false;
    });
}

/// The same without a grid.
template <class Ask>
void all(std::size_t count, Interval range, const Ask& ask, std::vector<Hit>& hits) {
    for (std::uint32_t i = 0; i < count; ++i) {
        if (std::optional<Hit> hit = ask(i, range)) {
            hit->primitive = i;
            hits.push_back(*hit);
        }
    }
}

/// How shapes are asked one at a time.
template <class Shape>
auto asking(std::span<const Shape> shapes, const Ray& ray) {
    return [shapes, &ray](std::uint32_t i, Interval range) { return intersect(shapes[i], ray, range); };
}
auto asking(std::span<const Triangle> shapes, const Ray& ray) {
    return [shapes, sheared = shear(ray)](std::uint32_t i, Interval range) {
        return intersect(shapes[i], sheared, range);
    };
}

template <class Shape>
std::optional<Hit> closest_shape(const Grid& grid, std::span<const Shape> shapes, const Ray& ray,
                                 Interval range, Mailbox& mailbox) {
    if (!within_reach(grid, ray)) return closest_hit(shapes, ray, range);
    return closest(grid, shapes.size(), ray, range, mailbox, asking(shapes, ray));
}

template <class Shape>
bool any_shape(const Grid& grid, std::span<const Shape> shapes, const Ray& ray, Interval range,
               Mailbox& mailbox) {
    if (!within_reach(grid, ray)) return any_hit(shapes, ray, range);
    const auto ask = asking(shapes, ray);
    return any(grid, shapes.size(), ray, range, mailbox,
               [&](std::uint32_t i, Interval in) { return ask(i, in).has_value(); });
}

template <class Shape>
void append_shapes(const Grid& grid, std::span<const Shape> shapes, const Ray& ray, Interval range,
                   Mailbox& mailbox, std::vector<Hit>& hits) {
    const auto ask = asking(shapes, ray);
    if (!within_reach(grid, ray)) return all(shapes.size(), range, ask, hits);
    all(grid, shapes.size(), ray, range, mailbox, ask, hits);
}

}  // namespace

std::vector<CellVisit> cells_along(const GridShape& shape, const Ray& ray, Interval range) {
    std::vector<CellVisit> visits;
    const std::optional<Interval> inside = clip(shape.box, ray, range);
    if (!inside) return visits;
    walk(shape, ray, *inside, [&](std::size_t number, Interval t) {
        const int n = static_cast<int>(number), x = n % shape.cells.x, yz = n / shape.cells.x;
        visits.push_back({{x, yz % shape.cells.y, yz / shape.cells.y}, t});
        return false;
    });
    return visits;
}

std::optional<Hit> closest_hit(const Grid& grid, std::span<const Sphere> shapes, const Ray& ray,
                               Interval range, Mailbox& mailbox) {
    return closest_shape(grid, shapes, ray, range, mailbox);
}

std::optional<Hit> closest_hit(const Grid& grid, std::span<const Triangle> shapes, const Ray& ray,
                               Interval range, Mailbox& mailbox) {
    return closest_shape(grid, shapes, ray, range, mailbox);
}

std::optional<Hit> closest_hit(const Grid& grid, std::span<const Polygon> shapes, const Ray& ray,
                               Interval range, Mailbox& mailbox) {
    return closest_shape(grid, shapes, ray, range, mailbox);
}

std::optional<Hit> closest_hit(const Grid& grid, std::span<const Ellipsoid> shapes, const Ray& ray,
                               Interval range, Mailbox& mailbox) {
    return closest_shape(grid, shapes, ray, range, mailbox);
}

std::optional<Hit> closest_hit(const Grid& grid, std::span<const Instance> shapes,
                               std::span<const SharedMesh> meshes, const Ray& ray, Interval range,
                               Mailbox& mailbox) {
    if (!within_reach(grid, ray)) return closest_hit(shapes, meshes, ray, range);
    return closest(grid, shapes.size(), ray, range, mailbox, [&](std::uint32_t i, Interval in) {
        return closest_hit(shapes.subspan(i, 1), meshes, ray, in);
    });
}

bool any_hit(const Grid& grid, std::span<const Sphere> shapes, const Ray& ray, Interval range,
             Mailbox& mailbox) {
    return any_shape(grid, shapes, ray, range, mailbox);
}

bool any_hit(const Grid& grid, std::span<const Triangle> shapes, const Ray& ray, Interval range,
             Mailbox& mailbox) {
    return any_shape(grid, shapes, ray, range, mailbox);
}

bool any_hit(const Grid& grid, std::span<const Polygon> shapes, const Ray& ray, Interval range,
             Mailbox& mailbox) {
    return any_shape(grid, shapes, ray, range, mailbox);
}

bool any_hit(const Grid& grid, std::span<const Ellipsoid> shapes, const Ray& ray, Interval range,
             Mailbox& mailbox) {
    return any_shape(grid, shapes, ray, range, mailbox);
}

bool any_hit(const Grid& grid, std::span<const Instance> shapes, std::span<const SharedMesh> meshes,
             const Ray& ray, Interval range, Mailbox& mailbox) {
    if (!within_reach(grid, ray)) return any_hit(shapes, meshes, ray, range);
    return any(grid, shapes.size(), ray, range, mailbox,
               [&](std::uint32_t i, Interval in) { return any_hit(shapes.subspan(i, 1), meshes, ray, in); });
}

void append_hits(const Grid& grid, std::span<const Sphere> shapes, const Ray& ray, Interval range,
                 Mailbox& mailbox, std::vector<Hit>& hits) {
    append_shapes(grid, shapes, ray, range, mailbox, hits);
}

void append_hits(const Grid& grid, std::span<const Triangle> shapes, const Ray& ray, Interval range,
                 Mailbox& mailbox, std::vector<Hit>& hits) {
    append_shapes(grid, shapes, ray, range, mailbox, hits);
}

void append_hits(const Grid& grid, std::span<const Polygon> shapes, const Ray& ray, Interval range,
                 Mailbox& mailbox, std::vector<Hit>& hits) {
    append_shapes(grid, shapes, ray, range, mailbox, hits);
}

void append_hits(const Grid& grid, std::span<const Ellipsoid> shapes, const Ray& ray, Interval range,
                 Mailbox& mailbox, std::vector<Hit>& hits) {
    append_shapes(grid, shapes, ray, range, mailbox, hits);
}

void append_hits(const Grid& grid, std::span<const Instance> shapes, std::span<const SharedMesh> meshes,
                 const Ray& ray, Interval range, Mailbox& mailbox, std::vector<Hit>& hits) {
    const auto ask = [&](std::uint32_t i, Interval in) {
        return closest_hit(shapes.subspan(i, 1), meshes, ray, in);
    };
    if (!within_reach(grid, ray)) return all(shapes.size(), range, ask, hits);
    all(grid, shapes.size(), ray, range, mailbox, ask, hits);
}

WalkCounts& walk_counts() {
    thread_local WalkCounts counts;
    return counts;
}

}  // namespace rt
