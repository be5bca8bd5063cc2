// Shapes so far out that an accelerator is better without them.
#pragma once

#include "common/world/world.hpp"

#include <tuple>
#include <utility>

namespace rt {

/// About `count` of the numbers below `size`, evenly spread.
std::vector<std::size_t> sample(std::size_t size, std::size_t count);

/// The shapes that an accelerator is better without, by their boxes; ascending, at most 64 and an eighth of
/// all. They are so far out, or so large, that all the others would share a few cells, or lie within its
/// margin.
std::vector<std::uint32_t> outliers(const std::vector<Bounds>& bounds);

/// The elements whose numbers are in `chosen`, which is ascending, and the others, both in their order.
template <class Element>
std::pair<std::vector<Element>, std::vector<Element>> parted(const std::vector<Element>& all,
                                                             const std::vector<std::uint32_t>& chosen) {
    std::pair<std::vector<Element>, std::vector<Element>> parts;
    std::size_t next = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool is_chosen = next < chosen.size() && chosen[next] == i;
        (is_chosen ? parts.first : parts.second).push_back(all[i]);
        if (is_chosen) ++next;
    }
    return parts;
}

/// Moves these shapes of the group into one that is returned.
template <class Shape>
Group<Shape> set_apart(Group<Shape>& group, const std::vector<std::uint32_t>& chosen) {
    Group<Shape> apart;
    const auto part = [&](auto& from, auto& to) {
        if (!from.empty()) std::tie(to, from) = parted(from, chosen);
    };
    part(group.shapes, apart.shapes);
    part(group.primitive, apart.primitive);
    std::apply([&](auto&... from) { std::apply([&](auto&... to) { (part(from, to), ...); }, apart.lists()); },
               group.lists());
    return apart;
}

}  // namespace rt
