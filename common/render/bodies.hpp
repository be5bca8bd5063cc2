// Which transparent faces of a scene, each an object of its own, enclose a body together.
#pragma once

#include "common/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace rt {

/// The bodies of a scene.
struct Bodies {
    std::vector<std::uint32_t> of;      ///< for each object the first object of its body, often itself; empty
                                        ///< where each is a body of its own
    std::vector<std::uint32_t> sheets;  ///< the first objects of those that have no inside, ascending
};

/// Joins the transparent triangles and polygons that meet at an edge: with the same two corners, to the bit,
/// the same material and the same transform, and no third face there but in pairs. Together they have an
/// inside if every edge is met an even number of times; if not, they are a sheet that only filters light,
/// which needs the index of refraction 1 and no absorption. Two faces with the same corners are two sheets in
/// one place and are not joined. A surface that its box cuts open (common/scene/cut_open.hpp) is a sheet,
/// too.
///
/// Throws InputError with the place of a face for a sheet of another material, where `refraction` says that
/// rays go through things.
Bodies bodies_of(const Scene& scene, bool refraction);

}  // namespace rt
