// Building a grid: how many cells, and which shapes may be met in which.
#pragma once

#include "chapters/09_grids/bounds.hpp"
#include "common/world/grid.hpp"

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace rt {

/// [09.3] Numbers of cells for `count` shapes in the box: about density · count cells that are as nearly
/// cubes as possible, each number at least 1 and at most `most`. An axis along which the box is thinner than
/// a cell gets one cell, and the others are shared out anew. Only ratios of the box's edges are used, so that
/// a box scaled by a power of two gets the same cells. A box that is a point, or empty, gets one cell.
Cells grid_resolution(const Bounds& box, std::size_t count, Real density, int most = 1024);

/// The box of one cell. Given: low + i · (high − low)/cells, as the walk computes it.
Bounds cell_box(const GridShape& shape, const Cells& cell);

/// [09.4] Whether two boxes have a point in common. They are closed: boxes that touch overlap. An empty box
/// overlaps none.
bool overlaps(const Bounds& shape, const Bounds& box);
/// [09.5] Whether some point of the sphere's surface may lie in the box: no where the nearest point of the
/// box is farther from the centre than the radius, or the farthest nearer. May say yes wrongly by rounding
/// only; with a box that was grown by more than rounding it never says no wrongly.
bool overlaps(const Sphere& sphere, const Bounds& box);
/// [09.6] Whether some point of the triangle may lie in the box, by separating axes: the box's three, the
/// triangle's normal, and the nine cross products of their edges (Akenine-Möller 2001). May say yes wrongly
/// as for a sphere, and where products of the triangle's edges underflow.
bool overlaps(const Triangle& triangle, const Bounds& box);

/// What a grid is to be made like.
struct GridOptions {
    Real density = 4;    ///< cells a shape
    bool nested = true;  ///< cells with more than `crowd` shapes get grids of their own
    int crowd = 32;
    int depth = 4;        ///< at most so many grids inside each other, the outermost counted
    Real distortion = 1;  ///< the greatest of the shapes' transforms: the margin is multiplied by it
};

/// Whether shape number i may be met in a box.
using Overlaps = std::function<bool(std::uint32_t, const Bounds&)>;

/// Whether the shape with these bounds may be met in the box: by its own `overlaps` where it has one, else by
/// its bounds. Given.
template <class Shape>
bool may_be_in(const Shape& shape, const Bounds& bounds, const Bounds& box) {
    if constexpr (requires { overlaps(shape, box); })
        return overlaps(shape, box);
    else
        return overlaps(bounds, box);
}

/// The question that may_be_in answers, of these shapes and their bounds. Given.
template <class Shape>
struct ShapeOverlaps {
    std::span<const Shape> shapes;
    std::span<const Bounds> bounds;
    bool operator()(std::uint32_t i, const Bounds& box) const { return may_be_in(shapes[i], bounds[i], box); }
};

/// The cells from `low` up to and including `high` along each axis.
struct CellBlock {
    Cells low;
    Cells high;
};

/// [09.7] The numbers, as Grid has them, of the block's cells in which shape i may be met: where `overlaps`
/// says so of the cell's box grown by the margin. In any order, each once.
std::vector<std::uint32_t> cells_with(const GridShape& shape, const CellBlock& block,
                                      const Overlaps& overlaps, std::uint32_t i, Real margin);

/// The lists of all cells, one after another, as Grid has them.
struct CellLists {
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> items;
};

/// [09.8] The lists of `count` cells. `numbers` are the cells of shapes[0], then those of shapes[1], and so
/// on; those of shapes[k] end before place ends[k]. Each list has the shapes in the order of `shapes`.
CellLists lists_by_cell(std::size_t count, std::span<const std::uint32_t> numbers,
                        std::span<const std::uint32_t> ends, std::span<const std::uint32_t> shapes);

/// The grid over shapes with these bounds, of 09.7 and 09.8. Given, but for its inner grids.
///
/// The margin and the reach are those of `allowance_for`. The grid's box is that box grown by the margin; a
/// shape is entered into a cell if it overlaps the cell grown by the margin. Shapes without a point (empty
/// bounds) are in no cell. No cell is thinner than 16 margins. While the cells list more than 8 · density
/// times as many shapes as there are (all may be in the same place), there are half as many cells along each
/// axis.
///
/// [09.13] A cell with more than `crowd` shapes gets an inner grid, over the part of the cell that the bounds
/// of its shapes take up, with the outermost grid's margin and reach (Jevans & Wyvill 1989). While its cells
/// list more than four times as many shapes as it has, or an average cell more than a quarter of them, it
/// gets half as many cells along each axis; with one cell only it would not separate the shapes, and there is
/// none.
Grid build_grid(std::span<const Bounds> bounds, const Overlaps& overlaps, const GridOptions& options = {});

/// The grid over these shapes, by may_be_in; `options.distortion` is worked out. Given.
template <class Shape>
Grid build_grid(std::span<const Shape> shapes, GridOptions options = {}) {
    std::vector<Bounds> bounds;
    bounds.reserve(shapes.size());
    for (const Shape& shape : shapes) {
        bounds.push_back(bounds_of(shape));
        if constexpr (requires { shape.transform; })
            options.distortion = std::max(options.distortion, distortion_of(shape.transform));
    }
    return build_grid(bounds, ShapeOverlaps<Shape>{shapes, bounds}, options);
}

template <class Shape>
Grid build_grid(const std::vector<Shape>& shapes, const GridOptions& options = {}) {
    return build_grid(std::span<const Shape>(shapes), options);
}

/// [09.15] For each cell, in the order of their numbers, how many steps of a king, who goes to any of the 26
/// cells around his, lead to the nearest cell that lists something: 0 in such a cell itself. If no cell lists
/// anything, the greatest of the numbers of cells. `first` is as Grid has it.
std::vector<int> king_steps(const Cells& cells, std::span<const std::uint32_t> first);

/// Bytes that the grid and the grids in it take. Given.
std::size_t bytes_of(const Grid& grid);

/// The grid in words: "grid of 2 × 3 × 4 cells and 5 grids in it". Given.
std::string in_words(const Grid& grid);

}  // namespace rt
