// How to part the shapes of a node: in halves, or where a ray is expected to have the least to do.
#include "chapters/13_hierarchies/split.hpp"

#include "chapters/09_grids/bounds.hpp"

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
    // [exercise 13.9] Return the number of the bin, less than `count`; 0 if all middles are equal.
    if (!(least < greatest)) return 0;
    const auto n = static_cast<Real>(count);
    return std::min(static_cast<std::size_t>(n * (middle - least) / (greatest - least)), count - 1);
    // [/exercise]
}

}  // namespace

std::size_t split_in_halves(std::span<const Bounds> boxes, std::span<std::uint32_t> items) {
    // [exercise 13.3] Find the axis along which the middles reach farthest, put the items in order along it,
    // and return how many are in the first half.
    const Bounds middles = bounds_of_middles(boxes, items);
    const Vec3 extent = middles.high - middles.low;
    int axis = 0;
    for (const int a : {1, 2})
        if (extent[a] > extent[axis]) axis = a;
    const std::size_t half = items.size() / 2;
    // Neither half needs an order in itself.
    std::ranges::nth_element(items, items.begin() + static_cast<std::ptrdiff_t>(half), {},
                             [&](std::uint32_t i) { return middle_of(boxes[i])[axis]; });
    return half;
    // [/exercise]
}

Real half_area(const Bounds& box) {
    // [exercise 13.5] Return the sum of the areas of three sides that meet in a corner, 0 for an empty box.
    if (is_empty(box)) return 0;
    const Vec3 edges = box.high - box.low;
    return edges.x * edges.y + edges.y * edges.z + edges.z * edges.x;
    // [/exercise]
}

Real predicted_cost(const Hierarchy& hierarchy, const SplitCosts& costs) {
    // [exercise 13.6] Return the sum over all nodes of the probability that the node is met, times what it
    // costs then.
    if (hierarchy.nodes.empty()) return 0;
    const Real all = half_area(hierarchy.nodes[0].box);
    Real cost = 0;
    for (const HierarchyNode& node : hierarchy.nodes) {
        const Real probability = all > 0 ? half_area(node.box) / all : 1;
        cost += probability * (node.count > 0 ? costs.shape * static_cast<Real>(node.count) : costs.node);
    }
    return cost;
    // [/exercise]
}

Cut cheapest_cut(std::span<const Bin> bins, const SplitCosts& costs) {
    // [exercise 13.7] Return the cheapest cut that has a shape on both sides, in time proportional to the
    // number of bins.
    const auto add = [](Bin& side, const Bin& bin) {
        side = {merge(side.box, bin.box), side.count + bin.count};
    };
    Bin all;
    for (const Bin& bin : bins) add(all, bin);
    const Real area = half_area(all.box);
    const auto cost_of = [&](const Bin& side) {
        const Real probability = area > 0 ? half_area(side.box) / area : 1;
        return probability * costs.shape * static_cast<Real>(side.count);
    };
    std::vector<Real> second(bins.size());  // what the bins from here on cost
    Bin side;
    for (std::size_t i = bins.size(); i-- > 0;) {
        add(side, bins[i]);
        second[i] = cost_of(side);
    }
    Cut best;
    side = {};
    for (std::size_t at = 1; at < bins.size(); ++at) {
        add(side, bins[at - 1]);
        const Real cost = costs.node + cost_of(side) + second[at];
        if (side.count > 0 && side.count < all.count && cost < best.cost) best = {at, cost};
    }
    return best;
    // [/exercise]
}

std::size_t split_by_sweep(std::span<const Bounds> boxes, std::span<std::uint32_t> items,
                           const SplitCosts& costs) {
    // [exercise 13.8] Part the items at the cheapest of all cuts along the three axes. Return how many are in
    // the first part, or 0 if a leaf costs no more.
    Cut best;
    std::vector<std::uint32_t> row(items.begin(), items.end()), best_row = row;
    for (const int axis : {0, 1, 2}) {
        std::ranges::sort(row, {}, [&](std::uint32_t i) { return std::pair(middle_of(boxes[i])[axis], i); });
        std::vector<Bin> bins;
        for (const std::uint32_t i : row) bins.push_back({boxes[i], 1});
        const Cut cut = cheapest_cut(bins, costs);
        if (cut.cost < best.cost) best = cut, best_row = row;
    }
    std::ranges::copy(best_row, items.begin());
    return best.cost < costs.shape * static_cast<Real>(items.size()) ? best.at : 0;
    // [/exercise]
}

std::vector<Bin> bins_along(std::span<const Bounds> boxes, std::span<const std::uint32_t> items, int axis,
                            std::size_t count) {
    // [exercise 13.9] Return the bins, each with the box around its shapes and how many they are.
    const Bounds middles = bounds_of_middles(boxes, items);
    std::vector<Bin> bins(count);
    for (const std::uint32_t i : items) {
        Bin& bin = bins[bin_at(middle_of(boxes[i])[axis], middles.low[axis], middles.high[axis], count)];
        bin = {merge(bin.box, boxes[i]), bin.count + 1};
    }
    return bins;
    // [/exercise]
}

std::size_t split_by_bins(std::span<const Bounds> boxes, std::span<std::uint32_t> items,
                          const SplitCosts& costs) {
    // [exercise 13.10] Part the items at the cheapest cut between bins along the three axes. Return how many
    // are in the first part, or 0 if a leaf costs no more.
    Cut best;
    int axis = 0;
    for (const int a : {0, 1, 2}) {
        const Cut cut = cheapest_cut(bins_along(boxes, items, a, bins_an_axis), costs);
        if (cut.cost < best.cost) best = cut, axis = a;
    }
    if (!(best.cost < costs.shape * static_cast<Real>(items.size()))) return 0;
    const Bounds middles = bounds_of_middles(boxes, items);
    const auto second = std::partition(items.begin(), items.end(), [&](std::uint32_t i) {
        const Real middle = middle_of(boxes[i])[axis];
        return bin_at(middle, middles.low[axis], middles.high[axis], bins_an_axis) < best.at;
    });
    return static_cast<std::size_t>(second - items.begin());
    // [/exercise]
}

}  // namespace rt
