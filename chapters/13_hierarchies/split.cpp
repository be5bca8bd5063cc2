// How to part the shapes of a node: in halves, or where a ray is expected to have the least to do.
#include "chapters/13_hierarchies/split.hpp"

#include "chapters/09_grids/bounds.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rt {
namespace {

/// From where to where the middles of boxes reach along each axis.
[[maybe_unused]] Bounds bounds_of_middles(std::span<const Bounds> boxes,
                                          std::span<const std::uint32_t> items) {
    Bounds middles;
    for (const std::uint32_t i : items) {
        const Vec3 middle = middle_of(boxes[i]);
        middles = merge(middles, {middle, middle});
    }
    return middles;
}

/// The number of the bin for a middle, of `count` bins from the least middle to the greatest.
[[maybe_unused]] std::size_t bin_at(Real middle, Real least, Real greatest, std::size_t count) {
    // 13.9  Return the number of the bin, less than `count`; 0 if all middles are equal.
    return todo("13.9");
}

}  // namespace

std::size_t split_in_halves(std::span<const Bounds> boxes, std::span<std::uint32_t> items) {
    // 13.3  Find the axis along which the middles reach farthest, put the items in order along it,
    // and return how many are in the first half.
    return todo("13.3");
}

Real half_area(const Bounds& box) {
    // 13.5  Return the sum of the areas of three sides that meet in a corner, 0 for an empty box.
    return todo("13.5");
}

Real predicted_cost(const Hierarchy& hierarchy, const SplitCosts& costs) {
    // 13.6  Return the sum over all nodes of the probability that the node is met, times what it
    // costs then.
    return todo("13.6");
}

Cut cheapest_cut(std::span<const Bin> bins, const SplitCosts& costs) {
    // 13.7  Return the cheapest cut that has a shape on both sides, in time proportional to the
    // number of bins.
    return todo("13.7");
}

std::size_t split_by_sweep(std::span<const Bounds> boxes, std::span<std::uint32_t> items,
                           const SplitCosts& costs) {
    // 13.8  Part the items at the cheapest of all cuts along the three axes. Return how many are in
    // the first part, or 0 if a leaf costs no more.
    return todo("13.8");
}

std::vector<Bin> bins_along(std::span<const Bounds> boxes, std::span<const std::uint32_t> items, int axis,
                            std::size_t count) {
    // 13.9  Return the bins, each with the box around its shapes and how many they are.
    return todo("13.9");
}

std::size_t split_by_bins(std::span<const Bounds> boxes, std::span<std::uint32_t> items,
                          const SplitCosts& costs) {
    // 13.10  Part the items at the cheapest cut between bins along the three axes. Return how many
    // are in the first part, or 0 if a leaf costs no more.
    return todo("13.10");
}

}  // namespace rt
