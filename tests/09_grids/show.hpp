// Small helpers of the tests of this chapter; how they print values stands in tests/show.hpp.
#pragma once

#include "chapters/09_grids/walk.hpp"
#include "tests/show.hpp"

namespace rt {

inline bool operator==(const Bounds& a, const Bounds& b) { return a.low == b.low && a.high == b.high; }

}  // namespace rt

namespace rt::test {

/// The numbers that the cell lists.
inline std::vector<std::uint32_t> items_of(const Grid& grid, const Cells& cell) {
    const Cells& n = grid.shape.cells;
    const auto number = static_cast<std::size_t>((cell.z * n.y + cell.y) * n.x + cell.x);
    return {grid.items.begin() + grid.first[number], grid.items.begin() + grid.first[number + 1]};
}

/// Calls `visit` for all the cells of the grid in the order of their numbers.
template <class Visit>
void for_each_cell(const Cells& cells, const Visit& visit) {
    for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x) visit(Cells(x, y, z));
}

}  // namespace rt::test
