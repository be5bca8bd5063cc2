// The trees of combinations, from their parts upwards.
#pragma once

#include "common/world/shapes.hpp"

#include <cstdint>
#include <span>

namespace rt {

/// Appends a part; returns its name in the tree.
std::int32_t add_part(Combination& tree, Solid solid, bool is_taken_away);

/// Makes one solid of several, of a difference the first without the others, and returns its name. Of as many
/// as there are, about half are in either branch, so that a line asks for few more than it meets.
std::int32_t join(Combination& tree, SetOperation operation, std::span<const std::int32_t> solids);

/// To be called once the tree is whole: finds the flat faces across an axis that lie in one plane. What is
/// decided where faces lie in one place must not depend on what each has rounded.
void find_common_planes(Combination& tree);

/// How often a line can cross the combination's surface, at most.
Real crossings_of(const Combination& tree);

}  // namespace rt
