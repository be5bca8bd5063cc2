// How the tests of this chapter print rays, boxes and cells, with all digits, and small helpers.
#pragma once

#include "chapters/09_grids/walk.hpp"
#include "tests/03_triangles/show.hpp"

#include <ostream>

namespace rt {

inline bool operator==(const Bounds& a, const Bounds& b) { return a.low == b.low && a.high == b.high; }
inline std::ostream& operator<<(std::ostream& out, const Bounds& box) {
    return out << "box " << test::show(box.low) << " to " << test::show(box.high);
}
inline std::ostream& operator<<(std::ostream& out, const Interval& range) {
    const auto precision = out.precision(17);
    out << "[" << range.min << ", " << range.max << "]";
    out.precision(precision);
    return out;
}

}  // namespace rt

namespace rt::test {

inline std::string show(const Cells& c) {
    return "(" + std::to_string(c.x) + ", " + std::to_string(c.y) + ", " + std::to_string(c.z) + ")";
}

inline std::string show(const std::vector<std::uint32_t>& numbers) {
    std::string text = "{";
    for (const std::uint32_t number : numbers) text += (text.size() > 1 ? ", " : "") + std::to_string(number);
    return text + "}";
}

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
