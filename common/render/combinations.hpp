// The trees of combinations, from their parts upwards.
#pragma once

#include "common/world/shapes.hpp"

#include <cstdint>
#include <span>

namespace rt {

/// Appends a part; returns its name in the tree.
std::int32_t add_part(Combination& tree, Solid solid, bool is_taken_away);

/// Makes one solid of several, of a difference the first without the others, and returns its name. About half
/// of them go into each branch, so that a line asks few parts that it does not meet; of a difference, all but
/// the first are one union.
std::int32_t join(Combination& tree, SetOperation operation, std::span<const std::int32_t> solids);

/// To be called once the tree is whole: finds the flat faces of boxes, cones and planes, and of boxes that
/// close other surfaces, across an axis, that lie in one plane, but for rounding. What is decided where faces
/// lie in one place must not depend on what each has rounded.
void find_common_planes(Combination& tree);

/// The part of a combination that a hit is of, and which element of the part.
struct PartHit {
    const Combination::Part& part;
    std::uint32_t element = 0;
};
PartHit part_hit(const Combination& tree, std::uint32_t element);

/// How often a line can cross the surface of a shape, at most.
template <class Shape>
Real crossings_of(const Shape&) {
    return words<Shape>.crossings;
}
Real crossings_of(const Instance& instance);
Real crossings_of(const Combination& tree);
Real crossings_of(const Moving& moving);
Real crossings_of(const Turning& turning);

}  // namespace rt
