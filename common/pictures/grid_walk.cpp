// The cells of a world's grids along a ray, and what they list.
#include "common/pictures/grid_walk.hpp"

#include "chapters/09_grids/walk.hpp"

#include <nlohmann/json.hpp>

namespace rt {

using nlohmann::ordered_json;

namespace {

ordered_json to_json(const Vec3& v) { return {v.x, v.y, v.z}; }
ordered_json to_json(const Cells& v) { return {v.x, v.y, v.z}; }

/// What a cell lists, or the grid in it; neither, if a grid that was built wrongly does not say.
void add_content(const Grid& grid, const Cells& cell, ordered_json& visit) {
    const Cells& cells = grid.shape.cells;
    const auto number = static_cast<std::size_t>((cell.z * cells.y + cell.y) * cells.x + cell.x);
    if (number >= grid.first.size()) return;
    if (number < grid.inner.size() && grid.inner[number] != 0) {
        if (grid.inner[number] > grid.grids.size()) return;
        visit["inner"] = to_json(grid.grids[grid.inner[number] - 1].shape.cells);
        return;
    }
    if (number + 1 >= grid.first.size() || grid.first[number + 1] > grid.items.size()) return;
    visit["shapes"] = ordered_json::array();
    for (std::uint32_t i = grid.first[number]; i < grid.first[number + 1]; ++i)
        visit["shapes"].push_back(grid.items[i]);
}

ordered_json walk_of(const Grid& grid, const Ray& ray) {
    auto visits = ordered_json::array();
    if (serves(grid, ray))
        for (const CellVisit& visit : cells_along(grid.shape, ray, {0, infinity})) {
            visits.push_back({{"cell", to_json(visit.cell)}, {"t", {visit.t.min, visit.t.max}}});
            add_content(grid, visit.cell, visits.back());
        }
    return visits;
}

}  // namespace

ordered_json walks_of(const World& world, const Ray& ray) {
    auto walks = ordered_json::array();
    for (const AnyGroup& any : world.groups)
        std::visit(
            [&]<class Shape>(const Group<Shape>& group) {
                const Grid* grid = std::get_if<Grid>(&group.accelerator);
                if (!grid) return;
                walks.push_back({{"of", words<Shape>.many},
                                 {"cells", to_json(grid->shape.cells)},
                                 {"low", to_json(grid->shape.box.low)},
                                 {"high", to_json(grid->shape.box.high)},
                                 {"visits", walk_of(*grid, ray)}});
            },
            any);
    return walks;
}

}  // namespace rt
