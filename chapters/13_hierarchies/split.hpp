// How to part the shapes of a node: in halves, or where a ray is expected to have the least to do.
#pragma once

#include "common/world/hierarchy.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rt {

// Functions that part the shapes of a node get the boxes of all shapes, and as `items` the numbers of at
// least two whose boxes are not empty. They put the items into another order, those of the first child
// first, and return how many these are; 0 where all had better stay together in a leaf.

/// The middle of a box, which stands for it where boxes are put in order. Given.
inline Vec3 middle_of(const Bounds& box) { return box.low * Real(0.5) + box.high * Real(0.5); }

/// [13.3] Parts the shapes in halves: along the axis in which their middles reach farthest, of equal ones the
/// first, so that no middle in the first part is greater than one in the second. The first part has
/// items.size()/2, rounded down.
std::size_t split_in_halves(std::span<const Bounds> boxes, std::span<std::uint32_t> items);

// --------------------------------------------------------------------------- the surface area heuristic

/// [13.5] Half the area of the box's surface: half, because only ratios are used. Of a box without thickness
/// along one axis the area of one side, of a line, a point and an empty box 0.
Real half_area(const Bounds& box);

/// What a ray pays. The unit is free, since only ratios are used.
struct SplitCosts {
    Real node = 1;   ///< to look at the two children of an inner node
    Real shape = 1;  ///< to ask a shape
};

/// [13.6] What a ray that meets the root's box is expected to pay if such rays come from everywhere alike and
/// nothing stops them. Each node is met with a probability, its half_area divided by the root's. An inner
/// node costs costs.node, and a leaf costs.shape for each of its shapes (Goldsmith & Salmon 1987; MacDonald &
/// Booth 1990). Where the root has no area every probability is 1. An empty hierarchy costs 0.
Real predicted_cost(const Hierarchy& hierarchy, const SplitCosts& costs = {});

/// Shapes that are kept together: the box around them, and how many they are.
struct Bin {
    Bounds box;
    std::size_t count = 0;
};

/// Where a row of bins is cut in two, and what a ray that meets the box around all bins is expected to pay
/// then.
struct Cut {
    std::size_t at = 0;    ///< how many bins are before the cut; 0 where there is no cut
    Real cost = infinity;  ///< infinity where there is no cut
};

/// [13.7] The cheapest cut of the row that leaves a shape on both sides, of equally cheap ones the first; no
/// cut where none does so. A cut costs costs.node, and for each side costs.shape times its number of shapes
/// times the probability that it is met: its half_area, of the box around the side, divided by that of the
/// box around all. Where the box around all has no area every probability is 1.
Cut cheapest_cut(std::span<const Bin> bins, const SplitCosts& costs = {});

/// [13.8] Parts the shapes at the cheapest of all cuts along all three axes. Along each axis they stand in a
/// row by their middles, of equal middles the lower number first, each a bin of its own; of equally cheap
/// cuts the first axis has it. Returns 0 where a leaf is not dearer: it costs costs.shape times the number of
/// shapes.
std::size_t split_by_sweep(std::span<const Bounds> boxes, std::span<std::uint32_t> items,
                           const SplitCosts& costs = {});

/// [13.9] The shapes sorted into `count` bins of equal width along axis number `axis`, from the least of
/// their middles to the greatest: bin number ⌊count · (middle − least) / (greatest − least)⌋, but at most the
/// last. All are in the first where all middles are equal. Bins without shapes have an empty box. `count` is
/// at least 1.
std::vector<Bin> bins_along(std::span<const Bounds> boxes, std::span<const std::uint32_t> items, int axis,
                            std::size_t count);

/// The number of bins along an axis in 13.10.
inline constexpr std::size_t bins_an_axis = 16;

/// [13.10] The same as 13.8, but with the cuts between the bins of 13.9 only, bins_an_axis along each axis
/// (Wald 2007). Returns 0 also where all middles are equal, because then there is no cut.
std::size_t split_by_bins(std::span<const Bounds> boxes, std::span<std::uint32_t> items,
                          const SplitCosts& costs = {});

}  // namespace rt
