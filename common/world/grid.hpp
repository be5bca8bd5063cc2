// A uniform grid over shapes: which of them may be met in which cell. Plain data; chapter 9 builds and walks
// it.
#pragma once

#include "common/world/bounds.hpp"

#include <cstdint>
#include <vector>

namespace rt {

/// Number of cells along each axis, or the place of one cell.
using Cells = glm::vec<3, std::int32_t, glm::defaultp>;

/// A box cut into equal cells.
struct GridShape {
    Bounds box;
    Cells cells{1};  ///< at least 1 along each axis
};

/// For each cell of a box the shapes that may be met in it. A cell with too many shapes may have a grid of
/// its own instead of a list.
struct Grid {
    GridShape shape;
    /// Cell (x, y, z) is number (z · cells.y + y) · cells.x + x. Its shapes are items[first[number]] up to
    /// items[first[number + 1]]: indices of shapes, ascending.
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> items;
    /// Empty where no cell has a grid of its own; else for each cell 0, or 1 + the index into `grids`. A cell
    /// that has one has no items.
    std::vector<std::uint32_t> inner;
    std::vector<Grid> grids;

    /// Rays whose origin is farther from the box's middle than this along some axis ask every shape: their
    /// rounding errors are greater than the margin by which shapes are entered into neighbouring cells.
    Real reach = 0;
};

}  // namespace rt
