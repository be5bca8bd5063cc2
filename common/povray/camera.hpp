// The camera in POV-Ray's language.
#pragma once

#include "common/povray/writer.hpp"

namespace rt::povray {

/// Unit vectors to the right, upwards and backwards.
struct Basis {
    Vec3 u, v, w;
};
Basis basis_of(const Camera& camera);

void write_camera(Writer& out);

}  // namespace rt::povray
