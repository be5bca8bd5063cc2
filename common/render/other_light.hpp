// Light from the sky, and light on surfaces that do not spread it evenly.
#pragma once

#include "chapters/05_lighting/lighting.hpp"
#include "chapters/11_textures/lobes.hpp"
#include "common/world/query.hpp"

#include <optional>

namespace rt {

/// `local_light` in a world whose needs say `other_light`. To the sum over the lamps comes the skylight. And
/// where the material has a finish, in place of diffuse · max(n·l, 0) stands π · f · max(n·l, 0), with the
/// lobe f of chapter 11 in that colour: so a matte surface without roughness is as bright as a plain one.
Vec3 other_light(const World& world, const Surface& surface, const Material& material, const Vec3& normal,
                 const Vec3& to_viewer);

/// How a surface sends the light of lamps to the viewer: evenly and by its highlight, or by the lobe of its
/// finish and its highlight.
struct LampShading {
    Material plain;  ///< without its diffuse colour where there is a lobe
    Vec3 normal, to_viewer;
    std::optional<Finish> finish;  ///< here, if it is not the plain one
    Lobe lobe;                     ///< of that
    Mat3 frame;                    ///< in which it is asked
    Vec3 viewer;                   ///< to_viewer in it
};

LampShading lamp_shading(const World& world, const Surface& surface, const Material& material,
                         const Vec3& normal, const Vec3& to_viewer);

/// Whether lamps behind the surface count.
bool shines_through(const LampShading& lamps);

/// The lobe, in 1/sr, of a surface that has one.
Vec3 lobe_towards(const LampShading& lamps, const LightSample& light);

/// What a lamp gives of which this part is visible; one behind the surface by its lobe only.
Vec3 sent_on(const LampShading& lamps, const LightSample& light, const Vec3& visible);

/// What a surface sends on of the skylight.
Vec3 light_of_sky(const World& world, const Material& material, const Vec3& normal);

}  // namespace rt
