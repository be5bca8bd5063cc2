// Lights with an extent in POV-Ray's language: many points that shine, and things that are seen.
#pragma once

#include "common/povray/writer.hpp"

namespace rt::povray {

/// The snapshot's points of area lights, each a spotlight.
void write_facing_lights(Writer& out);

/// The light's shape as a statement, still open for its texture. That is on its bright side, and the
/// `interior_texture` on the other one.
std::string open_statement(const AreaLight& light);

/// How far from a place it reaches.
Real reach_of(const AreaLight& light, const Vec3& from);

/// How long it is, or the radius of a sphere.
Real least_length_of(const AreaLight& light);

/// Multiplies its lengths.
void scale(AreaLight& light, Real factor);

}  // namespace rt::povray
