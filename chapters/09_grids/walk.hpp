// Walking through a grid along a ray, cell by cell, and asking the shapes on the way.
#pragma once

#include "chapters/09_grids/build.hpp"
#include "common/world/search.hpp"

#include <vector>

namespace rt {

/// One cell on the way of a ray.
struct CellVisit {
    Cells cell{0};
    Interval t;  ///< the part of the ray in the cell
};

/// [09.6] The cells along the ray in order, from the first that it is in within `range` and the box
/// (Amanatides & Woo 1987). The boundary number i of an axis is at t₀ + i·Δ, one multiplication and not i
/// additions; the loop ends at the last cell of an axis, so that it takes at most cells.x + cells.y + cells.z
/// steps whatever the numbers. The visits' intervals join without gaps, and the place of the ray in each is
/// in the cell up to the grid's margin.
std::vector<CellVisit> cells_along(const GridShape& shape, const Ray& ray, Interval range);

/// Whether the grid can tell what the ray may meet: the ray's rounding errors stay below the grid's margin,
/// and its numbers in the range of Real. Rays from beyond the grid's reach ask every shape instead. Given.
bool serves(const Grid& grid, const Ray& ray);

/// [09.13] Asks the shapes in the cells along the ray, cell by cell, until nothing that is left can be as near
/// as a hit that was found. What `ask` is told is what a cell lists, and the part of the ray in that cell; it
/// returns how far along the ray there is still something to find.
///
/// [09.14] In a cell with a grid of its own, the cells of that along the ray are asked in its place.
///
/// The ray must be one that the grid serves. Adds the cells it enters to search_counts().
void search(const Grid& grid, const Ray& ray, Interval range, const Ask& ask);

}  // namespace rt
