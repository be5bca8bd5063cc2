// What tests ask about the visits of a walk through a grid.
#pragma once

#include "common/math/error.hpp"
#include "tests/09_grids/show.hpp"
#include "tests/oracle/box.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace rt::test {

/// A box from 0 to the numbers of its cells: cells of edge 1.
inline GridShape unit_cells(const Cells& cells) { return {{Vec3(0), Vec3(cells)}, cells}; }

inline std::string show_all(const std::vector<Cells>& cells) {
    std::string text;
    for (const Cells& cell : cells) text += (text.empty() ? "" : " ") + show(cell);
    return text;
}

inline std::vector<Cells> cells_of(const std::vector<CellVisit>& visits) {
    std::vector<Cells> visited;
    for (const CellVisit& visit : visits) visited.push_back(visit.cell);
    return visited;
}

/// Where two lists of cells differ first, for a person; empty if they do not.
inline std::string first_difference(const std::vector<Cells>& actual, const std::vector<Cells>& expected) {
    for (std::size_t i = 0; i < std::max(actual.size(), expected.size()); ++i) {
        if (i < actual.size() && i < expected.size() && actual[i] == expected[i]) continue;
        return "visit " + std::to_string(i + 1) + " of " + std::to_string(expected.size()) + " is " +
               (i < actual.size() ? "in cell " + show(actual[i]) : "missing") + ", expected " +
               (i < expected.size() ? "cell " + show(expected[i]) : "none");
    }
    return {};
}

inline int steps_between(const Cells& a, const Cells& b) {
    return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

/// How far, in units of u times the size of the numbers, the ray may be outside the cell that it is said to
/// be in: 4 roundings a boundary in t, 2 in the box, and 3 in each of near and far.
inline constexpr Real allowed_outside = 16;

/// What is wrong with the visits, whatever the order of cells; empty if nothing is.
inline std::string fault_of(const GridShape& shape, const Ray& ray, const std::vector<CellVisit>& visits) {
    const Cells& n = shape.cells;
    if (visits.size() > static_cast<std::size_t>(n.x + n.y + n.z + 1))
        return "more visits than nx + ny + nz + 1";
    const Vec3 size =
        glm::max(glm::max(glm::abs(shape.box.low), glm::abs(shape.box.high)), glm::abs(ray.origin));
    const Real unit = unit_roundoff * max_component(size);
    for (std::size_t i = 0; i < visits.size(); ++i) {
        const auto& [cell, t] = visits[i];
        const std::string which = "visit " + std::to_string(i) + " of cell " + show(cell);
        if (glm::any(glm::lessThan(cell, Cells(0))) || glm::any(glm::greaterThanEqual(cell, n)))
            return which + " is outside the grid";
        if (!(t.min <= t.max)) return which + " ends before it begins";
        if (i > 0 && t.min != visits[i - 1].t.max) return which + " does not begin where the last one ends";
        if (i > 0 && steps_between(cell, visits[i - 1].cell) != 1)
            return which + " is not next to the last one";
        for (const Real s : {t.min, t.max, t.min + (t.max - t.min) / 2})
            if (oracle::distance_from_cell(shape, cell, ray, s) > allowed_outside * unit)
                return which + ": the ray is not there at t = " + show(s);
    }
    return {};
}

}  // namespace rt::test
