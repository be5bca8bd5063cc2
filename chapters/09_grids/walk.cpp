// Walking through a grid along a ray, cell by cell, and asking the shapes on the way.
#include "chapters/09_grids/walk.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// The walk along one axis.
struct Axis {
    Boundaries all;
    Real next = infinity;  ///< where the ray leaves the current cell
    int boundary = 0;      ///< the number of the boundary there
    int stride = 0;        ///< how much greater the number of the next cell is
};

/// The axis at the beginning of a walk, at t. Adds what it has to do with the number of the first cell.
Axis first_of(const GridShape& shape, const Ray& ray, int axis, Real t, int& number) {
    Axis first{.all = boundaries_along(shape, ray, axis)};
    const int cell = cell_at(shape, ray, axis, first.all, t);
    const int stride = axis == 0 ? 1 : axis == 1 ? shape.cells.x : shape.cells.x * shape.cells.y;
    number += cell * stride;
    if (first.all.step == 0) return first;
    first.boundary = first.all.step > 0 ? cell + 1 : cell;
    first.next = std::max(first.all.t0 + first.boundary * first.all.delta, t);
    first.stride = first.all.step * stride;
    return first;
}

/// Goes on from the cell with this number, where the ray is at range.min; the axes are as they are there.
/// Calls visit(number of the cell, part of the ray in it) for that and each cell behind it in order, until a
/// call returns true or the range or the grid ends. Returns whether a call did.
template <class Visit>
bool walk_on(Axis x, Axis y, Axis z, int number, Interval range, const Visit& visit) {
    // 09.11  Visit the cells, each for the part of the range in it, until a visit says so, the
    // range ends, or the axis along which the ray leaves its cell is at its last boundary. Compute each
    // boundary's `next` from its number, not from the old one.
    return todo("09.11");
}

/// The walk through the cells along the ray. The ray is in the box all over the range, up to rounding.
template <class Visit>
bool walk(const GridShape& shape, const Ray& ray, Interval range, const Visit& visit) {
    int number = 0;
    const Axis x = first_of(shape, ray, 0, range.min, number);
    const Axis y = first_of(shape, ray, 1, range.min, number);
    const Axis z = first_of(shape, ray, 2, range.min, number);
    return walk_on(x, y, z, number, range, visit);
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
    // 09.12  Ask the shapes that the cell lists, all at once, if there are any, and keep in
    // search.end what `ask` returns. Return whether nothing that is left can be as near as search.end.
    return todo("09.12");
}

/// Asks the cells of the grid that a cell has of its own; t is the part of the ray in the outer cell. Returns
/// whether the search is over.
bool search_inner(const Grid& inner, Interval t, Search& search) {
    // 09.14  Search the inner grid in the part t of the ray, and return whether the search is over
    // then, in the outer grid, too.
    return todo("09.14");
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

Boundaries boundaries_along(const GridShape& shape, const Ray& ray, int axis) {
    // 09.9  Return where the ray meets the boundaries, and the last of them on its way; all 0 where
    // t0 or delta would not be finite.
    return todo("09.9");
}

int cell_at(const GridShape& shape, const Ray& ray, int axis, const Boundaries& boundaries, Real t) {
    // 09.10  Return the cell in which the ray is at t. The boundaries decide, as t0 + i · delta
    // computes them; a division can only guess where to begin. Where `step` is 0 it is the cell of the
    // origin.
    return todo("09.10");
}

std::vector<CellVisit> cells_along(const GridShape& shape, const Ray& ray, Interval range) {
    std::vector<CellVisit> visits;
    const std::optional<Interval> inside = clip(shape.box, ray, range);
    if (!inside) return visits;
    const auto most = static_cast<std::size_t>(shape.cells.x + shape.cells.y + shape.cells.z + 1);
    walk(shape, ray, *inside, [&](std::size_t number, Interval t) {
        const int n = static_cast<int>(number), x = n % shape.cells.x, yz = n / shape.cells.x;
        visits.push_back({{x, yz % shape.cells.y, yz / shape.cells.y}, t});
        // A walk that has lost its way need not fill the memory.
        return visits.size() > most;
    });
    return visits;
}

bool serves(const Grid& grid, const Ray& ray) { return is_within_reach(ray, grid.shape.box, grid.reach); }

void search(const Grid& grid, const Ray& ray, Interval range, const Ask& ask) {
    Search search{ray, ask};
    search_cells(grid, search, range);
    search_counts().cells += search.cells;
}

}  // namespace rt
