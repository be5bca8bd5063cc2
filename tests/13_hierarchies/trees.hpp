// Hierarchies for tests: written by hand, drawn as text, and held against what the contract says of them.
#pragma once

#include "chapters/13_hierarchies/build.hpp"
#include "chapters/13_hierarchies/walk.hpp"
#include "tests/show.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rt::test {

/// The cube of edge 1 whose lowest corner is at x on the x axis.
inline Bounds cube_at(Real x) { return {{x, 0, 0}, {x + 1, 1, 1}}; }

/// A part of the row of such cubes: from `low` to `high` on the x axis.
inline Bounds part_of_row(Real low, Real high) { return {{low, 0, 0}, {high, 1, 1}}; }

inline HierarchyNode leaf(const Bounds& box, std::uint32_t first, std::uint32_t count = 1) {
    return {box, first, count};
}
inline HierarchyNode inner_node(const Bounds& box, std::uint32_t first_child) {
    return {box, first_child, 0};
}

/// A hierarchy without margin of these nodes; items 0, 1, 2, ... unless others are given.
inline Hierarchy tree_of(std::vector<HierarchyNode> nodes, std::vector<std::uint32_t> items = {}) {
    std::uint32_t end = 0;
    for (const HierarchyNode& node : nodes)
        if (node.count > 0) end = std::max(end, node.first + node.count);
    for (auto i = static_cast<std::uint32_t>(items.size()); i < end; ++i) items.push_back(i);
    return {std::move(nodes), std::move(items), 0, 0x1p16};
}

/// Four cubes at x = 0, 2, 4, 6 in two pairs: the root is node 0, the pairs are nodes 1 and 2, and the
/// leaves, in the order of x, nodes 3, 4, 5, 6.
inline Hierarchy row_of_four() {
    return tree_of({inner_node(part_of_row(0, 7), 1), inner_node(part_of_row(0, 3), 3),
                    inner_node(part_of_row(4, 7), 5), leaf(cube_at(0), 0), leaf(cube_at(2), 1),
                    leaf(cube_at(4), 2), leaf(cube_at(6), 3)});
}

inline constexpr const char* four_in_words =
    "cubes of edge 1 at x = 0, 2, 4 and 6, each a leaf; the root has two children, each of them two leaves";

/// A tree over the boxes in their order, two shapes a leaf: no method of the chapter made it.
inline Hierarchy plain_tree(std::span<const Bounds> boxes) {
    struct Part {
        std::uint32_t node, begin, end;
    };
    Bounds around;
    for (const Bounds& box : boxes) around = merge(around, box);
    const Allowance allowance = allowance_for(around, 1);
    Hierarchy tree = tree_of({{}});
    tree.margin = allowance.margin;
    tree.reach = allowance.reach;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) tree.items.push_back(i);
    std::vector<Part> parts{{0, 0, static_cast<std::uint32_t>(boxes.size())}};
    while (!parts.empty()) {
        const auto [node, begin, end] = parts.back();
        parts.pop_back();
        Bounds box;
        for (std::uint32_t k = begin; k < end; ++k) box = merge(box, boxes[k]);
        tree.nodes[node] = leaf(grown(box, tree.margin), begin, end - begin);
        if (end - begin <= 2) continue;
        const auto child = static_cast<std::uint32_t>(tree.nodes.size());
        tree.nodes[node] = inner_node(tree.nodes[node].box, child);
        tree.nodes.resize(child + 2);
        parts.push_back({child, begin, (begin + end) / 2});
        parts.push_back({child + 1, (begin + end) / 2, end});
    }
    return tree;
}

inline std::vector<std::uint32_t> sorted(std::span<const std::uint32_t> items) {
    std::vector<std::uint32_t> list(items.begin(), items.end());
    std::ranges::sort(list);
    return list;
}

/// Whether the list holds these numbers, in whichever order.
inline Told same_numbers(std::span<const std::uint32_t> actual, std::vector<std::uint32_t> expected) {
    std::ranges::sort(expected);
    return or_say(sorted(actual) == expected, show(sorted(actual)) + ", expected " + show(expected));
}

/// What is wrong with the numbers in a tree, on which others rely to find their way in it; empty if nothing
/// is.
inline std::string broken_numbers(const Hierarchy& tree) {
    for (std::uint32_t number = 0; number < tree.nodes.size(); ++number) {
        const HierarchyNode& node = tree.nodes[number];
        const std::string which = "node " + show(number);
        if (node.count > 0) {
            if (node.first > tree.items.size() || node.count > tree.items.size() - node.first)
                return which + " has more items than there are";
        } else if (node.first <= number || node.first >= tree.nodes.size() - 1) {
            return which + " has its first child at number " + show(node.first) + " of " +
                   show(tree.nodes.size());
        }
    }
    return {};
}

/// The tree as text: a leaf's shapes in braces, ascending, an inner node's children in parentheses. "?" where
/// it is too deep or its numbers are broken.
inline std::string drawn(const Hierarchy& tree, std::uint32_t number = 0, int depth = 0) {
    if (depth == 0 && tree.nodes.empty()) return "nothing";
    if (depth > deepest_leaf || !broken_numbers(tree).empty()) return "?";
    const HierarchyNode& node = tree.nodes[number];
    if (node.count == 0)
        return "(" + drawn(tree, node.first, depth + 1) + " " + drawn(tree, node.first + 1, depth + 1) + ")";
    return show(sorted({tree.items.data() + node.first, node.count}));
}

inline Told same_tree(const Hierarchy& tree, const std::string& expected) {
    return or_say(drawn(tree) == expected, drawn(tree) + ", expected " + expected);
}

/// How deep the deepest leaf is; more than deepest_leaf where there is no end.
inline int depth_of(const Hierarchy& tree, std::uint32_t number = 0, int depth = 0) {
    const HierarchyNode& node = tree.nodes[number];
    if (node.count > 0 || depth > deepest_leaf) return depth;
    return std::max(depth_of(tree, node.first, depth + 1), depth_of(tree, node.first + 1, depth + 1));
}

/// What the contract says of a tree over these boxes and this tree does not keep; empty if nothing.
inline std::string fault_of(const Hierarchy& tree, std::span<const Bounds> boxes, std::size_t most) {
    if (const std::string broken = broken_numbers(tree); !broken.empty()) return broken;
    std::vector<int> children(tree.nodes.size(), 0), met(boxes.size(), 0);
    std::vector<Bounds> around(tree.nodes.size());
    for (auto number = static_cast<std::uint32_t>(tree.nodes.size()); number-- > 0;) {
        const HierarchyNode& node = tree.nodes[number];
        const std::string which = "node " + show(number);
        for (std::uint32_t k = 0; k < node.count; ++k) {
            const std::uint32_t item = tree.items[node.first + k];
            if (item >= boxes.size()) return which + " has shape " + show(item) + ", which there is not";
            ++met[item];
            around[number] = merge(around[number], boxes[item]);
        }
        if (node.count > most) return which + " is a leaf of " + show(node.count) + " shapes";
        for (std::uint32_t child = node.first; node.count == 0 && child < node.first + 2; ++child) {
            ++children[child];
            around[number] = merge(around[number], around[child]);
        }
        const Bounds least = grown(around[number], tree.margin * (1 - 0x1p-8)),
                     greatest = grown(around[number], tree.margin * (1 + 0x1p-8));
        const Bounds& box = node.box;
        if (!(glm::all(glm::lessThanEqual(box.low, least.low)) &&
              glm::all(glm::greaterThanEqual(box.high, least.high))))
            return "the box of " + which + " is " + show(box) + ", but what is in it has the " +
                   show(around[number]) + ", to be grown by " + show_size(tree.margin);
        if (!(glm::all(glm::greaterThanEqual(box.low, greatest.low)) &&
              glm::all(glm::lessThanEqual(box.high, greatest.high))))
            return "the box of " + which + " is too large: " + show(box) + " around the " +
                   show(around[number]) + ", to be grown by " + show_size(tree.margin);
    }
    for (std::uint32_t number = 1; number < children.size(); ++number)
        if (children[number] != 1)
            return "node " + show(number) + " is a child of " + show(children[number]) + " nodes";
    for (std::uint32_t item = 0; item < met.size(); ++item) {
        const int expected = is_empty(boxes[item]) ? 0 : 1;
        if (met[item] != expected)
            return "shape " + show(item) + " is in " + show(met[item]) + " leaves, expected " +
                   show(expected);
    }
    if (!tree.nodes.empty() && depth_of(tree) > deepest_leaf)
        return "a leaf is more than " + show(deepest_leaf) + " deep";
    return {};
}

inline Told is_right(const Hierarchy& tree, std::span<const Bounds> boxes, std::size_t most = 16) {
    const std::string fault = fault_of(tree, boxes, most);
    return or_say(fault.empty(), fault);
}

/// The boxes around shapes of one kind, in their order.
template <class Shape>
std::vector<Bounds> boxes_of(const std::vector<Shape>& shapes) {
    std::vector<Bounds> boxes;
    for (const Shape& shape : shapes) boxes.push_back(bounds_of(shape));
    return boxes;
}

/// Boxes of all sizes up to 1 between -10 and 11.
inline std::vector<Bounds> random_boxes(Random& random, std::size_t count) {
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 low = Real(10) * random.in_cube();
        boxes.push_back({low, low + glm::abs(random.in_cube())});
    }
    return boxes;
}

/// What is counted while `action` runs.
template <class Action>
SearchCounts counted(const Action& action) {
    const SearchCounts before = search_counts();
    action();
    return {search_counts().cells - before.cells, search_counts().shapes - before.shapes};
}

}  // namespace rt::test
