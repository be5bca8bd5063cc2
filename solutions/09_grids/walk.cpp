// Walking through a grid along a ray, cell by cell, and asking the shapes on the way.
#include "chapters/09_grids/walk.hpp"

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

/// A ray on its way through a grid and the grids in it.
struct Search {
    const Ray& ray;
    const Ask& ask;           ///< ask(shapes, part of the ray)
    Real end = infinity;      ///< what it returned last: there is something to find up to here
    std::uint64_t cells = 0;  ///< entered so far
};

bool search_cells(const Grid& grid, Search& search, Interval part);

/// Asks the shapes that the cell lists; t is the part of the ray in it. Returns whether the search is over.
bool ask_cell(const Grid& grid, std::size_t number, Interval t, Search& search) {
    // [exercise 09.13] The cell's shapes are grid.items from number grid.first[number] up to, but not
    // including, grid.first[number + 1]. If there are any, call search.ask for them, all at once, and keep in
    // search.end what it returns. Return true if nothing that is left can be as near as search.end: a hit
    // that was found may lie in a later cell, where others are nearer, and just at t.max another may be as
    // near.
    const std::uint32_t first = grid.first[number], last = grid.first[number + 1];
    if (first != last) search.end = search.ask({grid.items.data() + first, last - first}, t);
    return search.end < t.max;
    // [/exercise]
}

/// Asks the cells of the grid that a cell has of its own; t is the part of the ray in the outer cell. Returns
/// whether the search is over.
bool search_inner(const Grid& inner, Interval t, Search& search) {
    // [exercise 09.14] Search the inner grid's cells (search_cells) in the part t. If that does not end the
    // search, it may be over all the same, as in 09.13: the inner grid is only as large as its shapes, and the
    // ray may have left it long before t.max.
    return search_cells(inner, search, t) || search.end < t.max;
    // [/exercise]
}

/// Goes through the grid's cells in this part of the ray. Returns whether the search is over.
bool search_cells(const Grid& grid, Search& search, Interval part) {
    const std::optional<Interval> inside = clip(grid.shape.box, search.ray, part);
    if (!inside) return false;
    return walk(grid.shape, search.ray, *inside, [&](std::size_t number, Interval t) {
        ++search.cells;
        const std::uint32_t inner = grid.inner.empty() ? 0 : grid.inner[number];
        return inner == 0 ? ask_cell(grid, number, t, search)
                          : search_inner(grid.grids[inner - 1], t, search);
    });
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

bool serves(const Grid& grid, const Ray& ray) {
    const Vec3 away = glm::abs(ray.origin - (grid.shape.box.low + grid.shape.box.high) * Real(0.5));
    if (!(away.x <= grid.reach && away.y <= grid.reach && away.z <= grid.reach)) return false;
    const Vec3 d = glm::abs(ray.direction);
    const auto is_moderate = [&](Real x) {
        return x == 0 || (x >= 0x1p-900 * grid.reach && x <= 0x1p900 * grid.reach);
    };
    return is_moderate(d.x) && is_moderate(d.y) && is_moderate(d.z);
}

void search(const Grid& grid, const Ray& ray, Interval range, const Ask& ask) {
    Search search{ray, ask};
    search_cells(grid, search, range);
    search_counts().cells += search.cells;
}

}  // namespace rt
