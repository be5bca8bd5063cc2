// How a material spreads light, at a place.
#pragma once

#include "common/world/query.hpp"

namespace rt {

/// The finish of a material that `material_at` returned, in a world that keeps finishes: its textured numbers
/// times what the texture says there, in their ranges. The plain one where the material has none.
Finish finish_at(const World& world, const Material& material);

}  // namespace rt
