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

/// How the shapes of a node are parted: by 13.3, 13.8, 13.10, or by the codes of 13.12.
enum class SplitMethod { Halves, Sweep, Bins, Codes };

/// How a hierarchy is to be built.
struct HierarchyOptions {
    SplitMethod method = SplitMethod::Bins;
    std::size_t most = 16;  ///< shapes in a leaf, 0 as 1; more that a method keeps together are halved
    SplitCosts costs{};     ///< what sweep and bins reckon with
    Real distortion = 1;    ///< the greatest of the shapes' transforms: the margin is multiplied by it
};

/// The hierarchy over shapes with these boxes. Given, but for 13.4.
///
/// The margin and the reach are a grid's (`allowance_for`, chapter 9). Shapes without a point, whose boxes
/// are empty, are in no leaf. Halves and codes part all nodes with more than `most` shapes, and no others.
/// Below 64 splits all methods part in halves, so that no leaf is deeper than deepest_leaf. Boxes multiplied
/// by a power of two get the same tree.
///
/// [13.4] A node's box is the one around the boxes of its shapes, grown by the margin. If they stay together
/// it is a leaf. Else it has two children, with numbers next to each other and greater than its own.
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

/// [13.11] The hierarchy with the boxes that its nodes need now that the shapes have moved: `boxes` are the
/// new ones, in the same order, and shapes that were without a point still are. The margin and the reach
/// become those of the new boxes; that is given. The tree stays as it is: it finds what is right, but a new
/// one might be cheaper.
Hierarchy refit(Hierarchy hierarchy, std::span<const Bounds> boxes, Real distortion = 1);

// ------------------------------------------------------------------------------------------ extra credit

/// [13.12] Where the point is along a curve through all of the box that keeps neighbours near each other
/// (Morton 1966). Along each axis the box is cut into 2^21 equal parts, and the point is in part number ⌊2^21
/// · (point − low) / (high − low)⌋, at least 0 and at most the last; 0 along an axis in which the box has no
/// extent. Bit k of the number along x becomes bit 3k of the code, along y 3k + 1, along z 3k + 2.
std::uint64_t morton_code(const Bounds& box, const Vec3& point);

/// Parts the shapes where the highest bit changes that is not the same in all their codes (Lauterbach et al.
/// 2009); codes[i] is that of shape number i. 0 where all codes are equal. Given.
std::size_t split_by_codes(std::span<const std::uint64_t> codes, std::span<std::uint32_t> items);

}  // namespace rt
