// Searching a hierarchy along a ray, from the root down, the nearer child first.
#include "chapters/13_hierarchies/walk.hpp"

#include "chapters/09_grids/bounds.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace rt {
namespace {

/// A ray on its way through a hierarchy.
struct Search {
    const Hierarchy& hierarchy;
    const Ray& ray;
    const Ask& ask;           ///< ask(shapes, part of the ray)
    Interval range;           ///< where there is still something to find
    std::uint64_t nodes = 0;  ///< that were looked into so far
};

/// Searches the node and all that is below it. Returns the range that is left to be searched.
Interval search_below(const NodeVisit& visit, Search& search) {
    // 13.2  Ask the shapes of a leaf, and let search.range end where `ask` says if that is before
    // its end. Of an inner node search below the children that the ray meets, in their order, but not below
    // one that it enters only beyond the range. Count the node in search.nodes, and return search.range.
    return todo("13.2");
}

/// How many steps it is from the node to the deepest leaf below it.
int depth_below(const Hierarchy& hierarchy, std::uint32_t number) {
    const HierarchyNode& node = hierarchy.nodes[number];
    if (node.count > 0) return 0;
    return 1 + std::max(depth_below(hierarchy, node.first), depth_below(hierarchy, node.first + 1));
}

}  // namespace

ChildVisits children_met(const Hierarchy& hierarchy, std::uint32_t node, const Ray& ray, Interval range) {
    // 13.1  Return the children whose boxes the ray meets, the one that it enters first before the
    // other, each with the part of the ray in its box.
    return todo("13.1");
}

bool serves(const Hierarchy& hierarchy, const Ray& ray) {
    return !hierarchy.nodes.empty() && is_within_reach(ray, hierarchy.nodes[0].box, hierarchy.reach);
}

void search(const Hierarchy& hierarchy, const Ray& ray, Interval range, const Ask& ask) {
    const std::optional<Interval> inside = clip(hierarchy.nodes[0].box, ray, range);
    if (!inside) return;
    Search search{hierarchy, ray, ask, range};
    search_below({0, *inside}, search);
    search_counts().cells += search.nodes;
}

std::size_t bytes_of(const Hierarchy& hierarchy) {
    return sizeof(Hierarchy) + sizeof(HierarchyNode) * hierarchy.nodes.capacity() +
           sizeof(std::uint32_t) * hierarchy.items.capacity();
}

std::string in_words(const Hierarchy& hierarchy) {
    if (hierarchy.nodes.empty()) return "hierarchy without a box";
    const std::size_t boxes = hierarchy.nodes.size();
    return "hierarchy of " + std::to_string(boxes) + (boxes == 1 ? " box, " : " boxes, ") +
           std::to_string(depth_below(hierarchy, 0)) + " deep";
}

}  // namespace rt
