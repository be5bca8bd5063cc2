// Walking through a grid along a ray, cell by cell, and asking the shapes on the way.
#pragma once

#include "chapters/09_grids/build.hpp"
#include "common/world/search.hpp"

#include <vector>

namespace rt {

/// One cell on the way of a ray.
struct CellVisit {
    Cells cell{0};
    Interval t;  ///< the part of the ray in the cell, within the range
};

/// Where a ray meets the boundaries of the cells along one axis: boundary number i at t = t0 + i · delta.
/// Boundary 0 is the low side of the box, and cell i lies between boundaries i and i + 1.
struct Boundaries {
    Real t0 = 0;
    Real delta = 0;  ///< less than 0 where the ray goes down
    int step = 0;    ///< +1 or −1 as the ray goes up or down, or 0 where it stays between two for ever
    int last = 0;    ///< the last boundary on its way: behind it is no cell
};

/// [09.9] The boundaries along axis number `axis`. Where t0 or delta would not be finite, because the
/// direction is 0 along this axis, or nearly, the ray never meets one: all is 0.
Boundaries boundaries_along(const GridShape& shape, const Ray& ray, int axis);

/// [09.10] The cell along axis number `axis`, from 0 to cells − 1, in which the ray is at t, by the
/// boundaries that 09.9 computes: a ray that goes up comes from cell 0, one that goes down from the last,
/// and at t it has gone on by a cell for each boundary between two cells that it meets at t or before. One
/// that meets no boundaries is in the cell of its origin (at a boundary, up to rounding, in either beside
/// it), or in the first or the last if it starts outside. Any cell where t or the ray is not a number.
int cell_at(const GridShape& shape, const Ray& ray, int axis, const Boundaries& boundaries, Real t);

/// [09.11] The cells along the ray in order, from the first that it is in within `range` and the box
/// (Amanatides & Woo 1987). The boundary number i of an axis is at t₀ + i·Δ, one multiplication and not i
/// additions; the loop ends at the last cell of an axis, so that it takes at most cells.x + cells.y + cells.z
/// steps whatever the numbers. The visits' intervals join without gaps, the last one ends where the range
/// does if the ray is still in the box there, and the place of the ray in each is in the cell up to the
/// grid's margin.
std::vector<CellVisit> cells_along(const GridShape& shape, const Ray& ray, Interval range);

/// Whether the grid can tell what the ray may meet: the ray's rounding errors stay below the grid's margin,
/// and its numbers in the range of Real. Rays from beyond the grid's reach ask every shape instead. Given.
bool serves(const Grid& grid, const Ray& ray);

/// [09.12] Asks the shapes in the cells along the ray, cell by cell, until nothing that is left can be as
/// near as a hit that was found. What `ask` is told is what a cell lists, and the part of the ray in that
/// cell; it returns how far along the ray there is still something to find.
///
/// [09.14] In a cell with a grid of its own, the cells of that along the ray are asked in its place.
///
/// The ray must be one that the grid serves. Adds the cells it enters to search_counts().
void search(const Grid& grid, const Ray& ray, Interval range, const Ask& ask);

}  // namespace rt
