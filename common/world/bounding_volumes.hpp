// Volumes that shapes are inside of, and trees of them. Plain data; chapter 13 fits, builds and searches
// them.
#pragma once

#include "common/world/bounds.hpp"

#include <cstdint>
#include <vector>

namespace rt {

/// A ball around something. Points on its surface are inside.
struct BoundingSphere {
    Vec3 center{0};
    Real radius = -1;  ///< less than 0: no point is inside
};

/// A box with axes of its own. Point p is inside where |dot(axes[k], p − center)| <= half[k] for k = 0, 1, 2.
struct OrientedBox {
    Mat3 axes{1};  ///< its columns: unit vectors across one another
    Vec3 center{0};
    Vec3 half{-1};  ///< half its extent along each axis; less than 0: no point is inside
};

/// The image of a ball under an affine map. Point p is inside where |to_unit · (p − center)| <= 1.
struct BoundingEllipsoid {
    Vec3 center{0};
    Mat3 to_unit{1};   ///< takes what is inside, seen from the centre, into the unit ball; can be inverted
    Real longest = 1;  ///< at least half its greatest diameter
};

/// A node of a tree of volumes: a leaf, which has shapes, or an inner node, which has two children.
template <class Volume>
struct VolumeNode {
    Volume volume;            ///< around all that is in it
    std::uint32_t first = 0;  ///< as HierarchyNode has it
    std::uint32_t count = 0;  ///< how many shapes a leaf has; 0 of an inner node
};

/// A hierarchy of other volumes than boxes along the axes. What is not said here is as in Hierarchy.
template <class Volume>
struct VolumeTree {
    std::vector<VolumeNode<Volume>> nodes;
    std::vector<std::uint32_t> items;
    Bounds box;       ///< around all shapes
    Real margin = 0;  ///< by how much every volume is larger than what is in it, along each axis
    Real reach = 0;
};

}  // namespace rt
