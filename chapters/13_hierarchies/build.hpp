// Building a hierarchy of boxes, and fitting it to shapes that have moved.
#pragma once

#include "chapters/09_grids/bounds.hpp"
#include "chapters/13_hierarchies/split.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// What a hierarchy is to be made like.
struct HierarchyOptions {
    Split split{};          ///< how the shapes of a node are parted; empty for split_by_bins
    std::size_t most = 16;  ///< shapes that `split` may keep together; more are parted in halves
    Real distortion = 1;    ///< the greatest of the shapes' transforms: the margin is multiplied by it
};

/// The hierarchy over shapes with these boxes. Given, but for 13.4.
///
/// The margin and the reach are a grid's (`allowance_for`, chapter 9). Shapes without a point, whose boxes
/// are empty, are in no leaf. Where 64 splits have led to a node its shapes are parted in halves, so that no
/// leaf is deeper than deepest_leaf. Boxes multiplied by a power of two get the same tree.
///
/// [13.4] A node's box is the one around the boxes of its shapes, grown by the margin. One shape is a leaf.
/// Of more, the split says how many go to the first child, and where it says 0 the node is a leaf if it has
/// no more than `most`; else they are parted in halves. Two children have numbers next to each other, greater
/// than their parent's.
Hierarchy build_hierarchy(std::span<const Bounds> boxes, const HierarchyOptions& options = {});

/// The hierarchy over these shapes; `options.distortion` is worked out. Given.
template <class Shape>
requires requires(const Shape& shape) { bounds_of(shape); }
Hierarchy build_hierarchy(std::span<const Shape> shapes, HierarchyOptions options = {}) {
    std::vector<Bounds> boxes;
    boxes.reserve(shapes.size());
    for (const Shape& shape : shapes) {
        boxes.push_back(bounds_of(shape));
        if constexpr (requires { shape.transform; })
            options.distortion = std::max(options.distortion, distortion_of(shape.transform));
    }
    return build_hierarchy(std::span<const Bounds>(boxes), options);
}

template <class Shape>
requires requires(const Shape& shape) { bounds_of(shape); }
Hierarchy build_hierarchy(const std::vector<Shape>& shapes, const HierarchyOptions& options = {}) {
    return build_hierarchy(std::span<const Shape>(shapes), options);
}

/// [13.11] Gives the nodes the boxes that they need now that the shapes have moved: `boxes` are the new ones,
/// in the same order, and shapes that were without a point still are. The margin and the reach become those
/// of the new boxes; that is given. The tree stays as it is: it finds what is right, but a new one might be
/// cheaper.
void refit(Hierarchy& hierarchy, std::span<const Bounds> boxes, Real distortion = 1);

// ------------------------------------------------------------------------------------------ extra credit

/// [13.12] Where the point is along a curve through all of the box that keeps neighbours near each other
/// (Morton 1966). Along each axis the box is cut into 2^21 equal parts, and the point is in part number ⌊2^21
/// · (point − low) / (high − low)⌋, at least 0 and at most the last; 0 along an axis in which the box has no
/// extent. Bit k of the number along x becomes bit 3k of the code, along y 3k + 1, along z 3k + 2.
std::uint64_t morton_code(const Bounds& box, const Vec3& point);

/// A split for build_hierarchy over these boxes, which sorts the shapes along that curve once, and then parts
/// them where the highest bit changes that is not the same in all codes (Lauterbach et al. 2009). Shapes with
/// equal codes stay together. Given.
Split split_by_codes(std::span<const Bounds> boxes);

}  // namespace rt
