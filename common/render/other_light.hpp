// Light from the sky, and light on surfaces that do not spread it evenly.
#pragma once

#include "common/world/query.hpp"

namespace rt {

/// `local_light` in a world whose needs say `other_light`. To the sum over the lamps comes the skylight. And
/// where the material has a finish, in place of diffuse · max(n·l, 0) stands π · f · max(n·l, 0), with the
/// lobe f of chapter 11 in that colour: so a matte surface without roughness is as bright as a plain one.
Vec3 other_light(const World& world, const Surface& surface, const Material& material, const Vec3& normal,
                 const Vec3& to_viewer);

}  // namespace rt
