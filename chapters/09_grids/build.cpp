// Building a grid: how many cells, and which shapes may be met in which.
#include "chapters/09_grids/build.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace rt {
namespace {

/// What all the grids inside one another have in common.
struct Task {
    std::span<const Bounds> bounds;
    const Overlaps& overlaps;
    const GridOptions& options;
    Real margin;
    Real reach;
};

std::size_t size_of(const Cells& cells) {
    return static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y) *
           static_cast<std::size_t>(cells.z);
}

std::uint32_t number_of(const GridShape& shape, const Cells& cell) {
    return static_cast<std::uint32_t>((cell.z * shape.cells.y + cell.y) * shape.cells.x + cell.x);
}

/// The cells that the box reaches into, up to two margins away.
CellBlock block_around(const GridShape& shape, const Bounds& box, Real margin) {
    const Vec3 per_length = Vec3(shape.cells) / (shape.box.high - shape.box.low);
    const auto cell_at = [&](const Vec3& point) {
        const Vec3 place = (point - shape.box.low) * per_length;
        Cells cell(0);
        for (int a = 0; a < 3; ++a)
            if (place[a] > 0)
                cell[a] = static_cast<int>(std::min(place[a], static_cast<Real>(shape.cells[a] - 1)));
        return cell;
    };
    return {cell_at(box.low - 2 * margin), cell_at(box.high + 2 * margin)};
}

/// Appends to `numbers` those of the cells in the block whose box, grown by the margin, shape i overlaps.
/// Returns how many there are.
std::size_t list_cells(const Task& task, const GridShape& shape, std::uint32_t i, const CellBlock& block,
                       std::vector<std::uint32_t>& numbers) {
    // 09.7  Append the numbers of the cells, and return how many there are. A loop over all cells
    // of the block is right. To be fast as well, ask about a large block as a whole first, its box grown by
    // two margins to be on the safe side.
    return todo("09.7");
}

/// The grid of this shape over these of the shapes, without inner grids; nothing as soon as its cells list
/// more than `most`.
std::optional<Grid> flat_grid(const Task& task, const GridShape& shape, std::span<const std::uint32_t> shapes,
                              std::size_t most) {
    std::vector<std::uint32_t> numbers;  // the cells of the first shape, then those of the second, ...
    std::vector<std::uint32_t> ends;     // where in `numbers` those of each shape end
    numbers.reserve(2 * shapes.size());
    ends.reserve(shapes.size());
    for (const std::uint32_t i : shapes) {
        const CellBlock block = block_around(shape, task.bounds[i], task.margin);
        // Most shapes are much smaller than the grid: there is no doubt about the only cell around one.
        if (block.low == block.high)
            numbers.push_back(number_of(shape, block.low));
        else
            list_cells(task, shape, i, block, numbers);
        if (numbers.size() > most) return std::nullopt;
        ends.push_back(static_cast<std::uint32_t>(numbers.size()));
    }

    CellLists lists = lists_by_cell(size_of(shape.cells), numbers, ends, shapes);
    Grid grid;
    grid.shape = shape;
    grid.reach = task.reach;
    grid.first = std::move(lists.first);
    grid.items = std::move(lists.items);
    return grid;
}

/// As many cells as the options ask for, but none thinner than 16 margins.
GridShape shape_for(const Task& task, const Bounds& box, std::size_t count) {
    GridShape shape{box, grid_resolution(box, count, task.options.density)};
    const Vec3 most = glm::floor((box.high - box.low) / (16 * task.margin));
    for (int a = 0; a < 3; ++a)
        if (most[a] < shape.cells[a]) shape.cells[a] = most[a] > 1 ? static_cast<int>(most[a]) : 1;
    return shape;
}

/// What the cell and the box around the bounds of its shapes, each grown by the margin, have in common.
[[maybe_unused]] Bounds box_of_crowd(const Task& task, const GridShape& shape, std::uint32_t number,
                                     std::span<const std::uint32_t> shapes) {
    Bounds around;
    for (const std::uint32_t i : shapes) around = merge(around, task.bounds[i]);
    around = grown(around, task.margin);
    const int x = static_cast<int>(number) % shape.cells.x, yz = static_cast<int>(number) / shape.cells.x;
    const Bounds cell = cell_box(shape, {x, yz % shape.cells.y, yz / shape.cells.y});
    const Bounds box = grown(cell, task.margin);
    return {glm::max(box.low, around.low), glm::min(box.high, around.high)};
}

/// Gives crowded cells grids of their own, as long as there are not more than options.depth inside each
/// other; `depth` is how many there are around the cells. Returns how many cells got one.
std::size_t refine(const Task& task, Grid& grid, int depth) {
    if (depth >= task.options.depth) return 0;
    const std::size_t cells = size_of(grid.shape.cells);
    std::uint32_t kept = 0, begin = 0;
    for (std::uint32_t number = 0; number < cells; ++number) {
        const std::uint32_t end = grid.first[number + 1];
        const std::span<const std::uint32_t> shapes{grid.items.data() + begin, end - begin};
        std::optional<Grid> inner;
        // 09.13  Where there are more than task.options.crowd shapes in the cell, make `inner` the
        // flat grid over them, as build.hpp says, and refine it. Leave it empty where it would end with one
        // cell.
        return todo("09.13");
        grid.first[number] = kept;
        if (inner) {
            grid.inner.resize(cells);
            grid.grids.push_back(std::move(*inner));
            grid.inner[number] = static_cast<std::uint32_t>(grid.grids.size());
        } else {
            // Nothing has moved yet where no cell before this one has an inner grid.
            if (kept != begin) std::copy(shapes.begin(), shapes.end(), grid.items.begin() + kept);
            kept += end - begin;
        }
        begin = end;
    }
    grid.first[cells] = kept;
    grid.items.resize(kept);
    if (!grid.grids.empty()) grid.items.shrink_to_fit();
    return grid.grids.size();
}

}  // namespace

Cells grid_resolution(const Bounds& box, std::size_t count, Real density, int most) {
    // 09.3  Return the numbers of cells, density · count in all, as nearly cubes as possible. An
    // axis without length, or too short for one cell, gets one, and the others share them all. Whole numbers,
    // at least 1 and at most `most`.
    return todo("09.3");
}

Bounds cell_box(const GridShape& shape, const Cells& cell) {
    const Vec3 size = (shape.box.high - shape.box.low) / Vec3(shape.cells);
    return {shape.box.low + Vec3(cell) * size, shape.box.low + Vec3(cell + 1) * size};
}

bool overlaps(const Bounds& shape, const Bounds& box) {
    // 09.4  Say whether the boxes have a point in common; that they touch is enough.
    return todo("09.4");
}

bool overlaps(const Sphere& sphere, const Bounds& box) {
    // 09.5  Say whether the sphere's surface may have a point in the box. A box that is wholly
    // inside the sphere has none.
    return todo("09.5");
}

bool overlaps(const Triangle& triangle, const Bounds& box) {
    // 09.6  Say whether the triangle may have a point in the box: it has none if one of the
    // thirteen axes parts them. Along each axis project all three corners, even where two would give the same
    // without rounding.
    return todo("09.6");
}

std::vector<std::uint32_t> cells_with(const GridShape& shape, const CellBlock& block,
                                      const Overlaps& overlaps, std::uint32_t i, Real margin) {
    std::vector<std::uint32_t> numbers;
    const GridOptions options;
    list_cells({.bounds = {}, .overlaps = overlaps, .options = options, .margin = margin, .reach = 0}, shape,
               i, block, numbers);
    return numbers;
}

CellLists lists_by_cell(std::size_t count, std::span<const std::uint32_t> numbers,
                        std::span<const std::uint32_t> ends, std::span<const std::uint32_t> shapes) {
    // 09.8  Return the lists of the cells, one after another in `items`; each has the shapes in the
    // order of `shapes`. `first` says where each begins, and has one number more than there are cells.
    return todo("09.8");
}

Grid build_grid(std::span<const Bounds> bounds, const Overlaps& overlaps, const GridOptions& options) {
    Bounds around;
    std::vector<std::uint32_t> shapes;  // those that have a point
    shapes.reserve(bounds.size());
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        if (is_empty(bounds[i])) continue;
        around = merge(around, bounds[i]);
        shapes.push_back(static_cast<std::uint32_t>(i));
    }
    if (shapes.empty()) {
        Grid grid;
        grid.shape.box = around;
        grid.first = {0, 0};
        return grid;
    }

    const Allowance allowance = allowance_for(around, options.distortion);
    const Task task{.bounds = bounds,
                    .overlaps = overlaps,
                    .options = options,
                    .margin = allowance.margin,
                    .reach = allowance.reach};
    GridShape shape = shape_for(task, grown(around, task.margin), shapes.size());
    std::optional<Grid> grid;
    // Places in the list have 32 bits.
    const auto most = static_cast<std::size_t>(std::min(
        8 * std::max(options.density, Real(1)) * static_cast<Real>(shapes.size()), Real(0xffffffff)));
    while (!(grid = flat_grid(task, shape, shapes, most))) shape.cells = (shape.cells + 1) / 2;
    if (options.nested) refine(task, *grid, 1);
    return std::move(*grid);
}

std::vector<int> king_steps(const Cells& cells, std::span<const std::uint32_t> first) {
    // 09.15  Return the king's distances of all cells, cell (x, y, z) at number (z · cells.y + y) ·
    // cells.x + x.
    return todo("09.15");
}

std::size_t bytes_of(const Grid& grid) {
    std::size_t bytes =
        sizeof(Grid) +
        sizeof(std::uint32_t) * (grid.first.capacity() + grid.items.capacity() + grid.inner.capacity());
    for (const Grid& inner : grid.grids) bytes += bytes_of(inner);
    return bytes;
}

std::string in_words(const Grid& grid) {
    const auto grids_in = [](const auto& self, const Grid& outer) -> std::size_t {
        std::size_t sum = outer.grids.size();
        for (const Grid& inner : outer.grids) sum += self(self, inner);
        return sum;
    };
    const Cells& cells = grid.shape.cells;
    std::string text = "grid of " + std::to_string(cells.x) + " × " + std::to_string(cells.y) + " × " +
                       std::to_string(cells.z) + " cells";
    if (!grid.grids.empty()) text += " and " + std::to_string(grids_in(grids_in, grid)) + " grids in it";
    return text;
}

}  // namespace rt
