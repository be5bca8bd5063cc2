// The sky as POV-Ray's sky_sphere, and its diffuse light.
#pragma once

#include "common/povray/writer.hpp"

namespace rt::povray {

/// Writes the sky_sphere of a scene that has a sky, and whose integrator shows it.
void write_sky_sphere(Writer& out);

/// Whether the sky lights what is diffuse.
bool has_skylight(const Scene& scene);

/// What a surface of this diffuse colour reflects of the skylight, as the inside of `pigment { }`; `more`
/// stands after each colour.
std::string skylight_pigment(const Scene& scene, const Vec3& diffuse, std::string_view more);

}  // namespace rt::povray
