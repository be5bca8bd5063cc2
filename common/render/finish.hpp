// Light on surfaces that do not spread it evenly.
#pragma once

#include "common/world/query.hpp"

namespace rt {

/// As `local_light`, of a material with a finish, in a world whose needs say `finishes`: in place of
/// diffuse · max(n·l, 0) it is π · f · max(n·l, 0), with the lobe f of chapter 11 in that colour. So a matte
/// surface without roughness is as bright as a plain one.
Vec3 local_light_of_finish(const World& world, const Surface& surface, const Material& material,
                           const Vec3& normal, const Vec3& to_viewer);

}  // namespace rt
