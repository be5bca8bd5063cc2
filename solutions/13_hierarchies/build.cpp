// Building a hierarchy of boxes, and fitting it to shapes that have moved.
#include "chapters/13_hierarchies/build.hpp"

#include "chapters/09_grids/bounds.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace rt {
namespace {

/// A hierarchy that is being built.
struct Task {
    std::span<const Bounds> boxes;
    const HierarchyOptions& options;
    std::vector<std::uint64_t> codes{};  ///< of all shapes, where these are parted by codes
    Hierarchy hierarchy{};
};

/// How many of the items the first child gets, by the options' method; 0 where all stay together.
std::size_t split(const Task& task, std::span<std::uint32_t> items) {
    const HierarchyOptions& options = task.options;
    switch (options.method) {
        case SplitMethod::Halves:
            return 0;
        case SplitMethod::Sweep:
            return split_by_sweep(task.boxes, items, options.costs);
        case SplitMethod::Bins:
            return split_by_bins(task.boxes, items, options.costs);
        case SplitMethod::Codes:
            return items.size() > options.most ? split_by_codes(task.codes, items) : 0;
    }
    return 0;
}

/// How many of the items go to the first child, and are the first of them then; 0 for a leaf. `above` is how
/// many nodes are above theirs.
[[maybe_unused]] std::size_t part(const Task& task, std::span<std::uint32_t> items, int above) {
    // Each of 2^32 shapes is alone after 32 halvings.
    const bool may_choose = items.size() > 1 && above < deepest_leaf - 32;
    const std::size_t first = may_choose ? split(task, items) : 0;
    // A split that is still wrong may give the first child all: a tree with an empty node would have no end.
    if (first > 0 && first < items.size()) return first;
    return items.size() > std::max<std::size_t>(task.options.most, 1) ? split_in_halves(task.boxes, items)
                                                                      : 0;
}

/// Makes node number `node` and all that is below it of the shapes in the places from `begin` up to, but not
/// including, `end` of task.hierarchy.items. Returns how many nodes there are then in all.
std::size_t fill(Task& task, std::uint32_t node, std::uint32_t begin, std::uint32_t end, int above) {
    // [exercise 13.4] Give the node its box, and let `part` say how its shapes are parted. If they stay
    // together it is a leaf; else add two nodes at the end of task.hierarchy.nodes, and fill each with its
    // part of the shapes. A reference to a node is worth nothing after nodes were added.
    std::vector<HierarchyNode>& nodes = task.hierarchy.nodes;
    const std::span<std::uint32_t> items{task.hierarchy.items.data() + begin, end - begin};
    Bounds box;
    for (const std::uint32_t i : items) box = merge(box, task.boxes[i]);
    nodes[node] = {grown(box, task.hierarchy.margin), begin, end - begin};
    const std::size_t first = part(task, items, above);
    if (first == 0) return nodes.size();

    const auto child = static_cast<std::uint32_t>(nodes.size());
    const auto middle = begin + static_cast<std::uint32_t>(first);
    nodes[node].first = child;
    nodes[node].count = 0;
    nodes.resize(nodes.size() + 2);
    fill(task, child, begin, middle, above + 1);
    return fill(task, child + 1, middle, end, above + 1);
    // [/exercise]
}

/// The box that node number `node` needs. The nodes behind it have theirs already.
Bounds box_needed(const Hierarchy& hierarchy, std::uint32_t node, std::span<const Bounds> boxes) {
    // [exercise 13.11] Return the box around the boxes of a leaf's shapes, grown by the margin, or of an
    // inner node around those of its children.
    const HierarchyNode& of = hierarchy.nodes[node];
    if (of.count == 0) return merge(hierarchy.nodes[of.first].box, hierarchy.nodes[of.first + 1].box);
    Bounds box;
    for (std::uint32_t k = 0; k < of.count; ++k) box = merge(box, boxes[hierarchy.items[of.first + k]]);
    return grown(box, hierarchy.margin);
    // [/exercise]
}

/// The codes of the shapes' middles in the box around all middles; 0 of shapes without a point.
std::vector<std::uint64_t> codes_of(std::span<const Bounds> boxes) {
    Bounds around;
    for (const Bounds& box : boxes)
        if (!is_empty(box)) around = merge(around, {middle_of(box), middle_of(box)});
    std::vector<std::uint64_t> codes;
    codes.reserve(boxes.size());
    for (const Bounds& box : boxes) codes.push_back(is_empty(box) ? 0 : morton_code(around, middle_of(box)));
    return codes;
}

/// Sets the hierarchy's margin and reach for shapes with these boxes.
void allow_for(Hierarchy& hierarchy, std::span<const Bounds> boxes, Real distortion) {
    Bounds around;
    for (const std::uint32_t i : hierarchy.items) around = merge(around, boxes[i]);
    const Allowance allowance = allowance_for(around, distortion);
    hierarchy.margin = allowance.margin;
    hierarchy.reach = allowance.reach;
}

}  // namespace

Hierarchy build_hierarchy(std::span<const Bounds> boxes, const HierarchyOptions& options) {
    Task task{boxes, options};
    Hierarchy& hierarchy = task.hierarchy;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (!is_empty(boxes[i])) hierarchy.items.push_back(i);
    if (hierarchy.items.empty()) return {};
    allow_for(hierarchy, boxes, options.distortion);
    if (options.method == SplitMethod::Codes) task.codes = codes_of(boxes);
    hierarchy.nodes.resize(1);
    fill(task, 0, 0, static_cast<std::uint32_t>(hierarchy.items.size()), 0);
    hierarchy.nodes.shrink_to_fit();
    hierarchy.items.shrink_to_fit();
    return std::move(hierarchy);
}

Hierarchy refit(Hierarchy hierarchy, std::span<const Bounds> boxes, Real distortion) {
    allow_for(hierarchy, boxes, distortion);
    // Children stand behind their parents.
    for (auto node = static_cast<std::uint32_t>(hierarchy.nodes.size()); node-- > 0;)
        hierarchy.nodes[node].box = box_needed(hierarchy, node, boxes);
    return hierarchy;
}

std::uint64_t morton_code(const Bounds& box, const Vec3& point) {
    // [exercise 13.12] Return the code: bit k of the part's number along axis number a is bit 3k + a.
    std::uint64_t code = 0;
    for (int a = 0; a < 3; ++a) {
        const Real extent = box.high[a] - box.low[a];
        const Real place = extent > 0 ? 0x1p21 * (point[a] - box.low[a]) / extent : 0;
        const auto number = static_cast<std::uint64_t>(std::clamp(place, Real(0), Real(0x1p21 - 1)));
        for (int k = 0; k < 21; ++k) code |= (number >> k & 1) << (3 * k + a);
    }
    return code;
    // [/exercise]
}

std::size_t split_by_codes(std::span<const std::uint64_t> codes, std::span<std::uint32_t> items) {
    const auto code_of = [&](std::uint32_t i) { return codes[i]; };
    // What was sorted at the root is sorted below it.
    if (!std::ranges::is_sorted(items, {}, code_of)) std::ranges::sort(items, {}, code_of);
    const std::uint64_t differing = code_of(items.front()) ^ code_of(items.back());
    if (differing == 0) return 0;
    const std::uint64_t highest = std::bit_floor(differing);
    const auto second =
        std::ranges::partition_point(items, [&](std::uint32_t i) { return (code_of(i) & highest) == 0; });
    return static_cast<std::size_t>(second - items.begin());
}

}  // namespace rt
