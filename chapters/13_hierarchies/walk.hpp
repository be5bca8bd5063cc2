// Searching a hierarchy along a ray, from the root down, the nearer child first.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/hierarchy.hpp"
#include "common/world/search.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace rt {

/// A node that a ray comes to.
struct NodeVisit {
    std::uint32_t node = 0;  ///< its number
    Interval t;              ///< the part of the ray in its box
};

/// The children of an inner node that a ray comes to.
struct ChildVisits {
    int count = 0;                      ///< 0, 1 or 2
    std::array<NodeVisit, 2> visits{};  ///< the first `count` of them count
};

/// [13.1] The children of inner node number `node` that the ray meets within `range`, in the order in which
/// it enters their boxes; if it enters both at the same t, the first child comes first. A box is met where
/// 09.2 (`clip`) says so, and for the part of the ray that it says.
ChildVisits children_met(const Hierarchy& hierarchy, std::uint32_t node, const Ray& ray, Interval range);

/// Whether the hierarchy can tell what the ray may meet: the ray's rounding errors stay below the margin, and
/// its numbers in the range of Real. An empty hierarchy serves none. Given.
bool serves(const Hierarchy& hierarchy, const Ray& ray);

/// [13.2] Asks the shapes of the leaves that the ray meets within the range: of two children the one that the
/// ray enters first, with all that is below it, before the other. `ask` is told all the shapes of a leaf at
/// once, and the part of the ray in the leaf's box; it returns how far along the ray there is still something
/// to find. A node whose box the ray enters only beyond that is passed over. One that it enters exactly there
/// is not, for it may have a shape that is as near.
///
/// The ray must be one that the hierarchy serves. Adds to search_counts().cells the nodes that it looked
/// into, at their children or their shapes.
void search(const Hierarchy& hierarchy, const Ray& ray, Interval range, const Ask& ask);

/// Bytes that the hierarchy takes. Given.
std::size_t bytes_of(const Hierarchy& hierarchy);

/// The hierarchy in words: "hierarchy of 1999 boxes, 14 deep". Given.
std::string in_words(const Hierarchy& hierarchy);

}  // namespace rt
