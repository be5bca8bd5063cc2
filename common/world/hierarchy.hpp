// A tree of boxes over shapes: which of them may be met where. Plain data; chapter 13 builds and walks it.
#pragma once

#include "common/world/bounds.hpp"

#include <cstdint>
#include <vector>

namespace rt {

/// A node of a hierarchy: a leaf, which has shapes, or an inner node, which has two children.
struct HierarchyNode {
    Bounds box;  ///< around all that is in it, grown by the hierarchy's margin
    /// Of a leaf the place in `items` where its shapes begin; of an inner node the number of its first child.
    /// The second child's number is the next.
    std::uint32_t first = 0;
    std::uint32_t count = 0;  ///< how many shapes a leaf has, at least 1; 0 of an inner node
};

/// A bounding volume hierarchy of axis-aligned boxes (Rubin & Whitted 1980).
struct Hierarchy {
    /// Number 0 is the root, and children have greater numbers than their parents. Empty where no shape has a
    /// point.
    std::vector<HierarchyNode> nodes;
    /// Numbers of shapes. Each shape that has a point is in exactly one leaf.
    std::vector<std::uint32_t> items;

    Real margin = 0;  ///< by how much every node's box is larger than what is in it, on each side
    /// Rays whose origin is farther from the root's middle than this along some axis ask every shape: their
    /// rounding errors are greater than the margin.
    Real reach = 0;
};

/// From the root to a leaf are at most so many steps.
inline constexpr int deepest_leaf = 96;

}  // namespace rt
