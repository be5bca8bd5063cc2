// Lights in POV-Ray's language.
#pragma once

#include "common/povray/writer.hpp"

namespace rt::povray {

/// The scene's lights.
void write_lights(Writer& out);

/// Six lights that shine along the axes paint the unit normal n as sign · n/2, a channel an axis: the
/// positive half from one side, the negative half, with a negative colour, from the other.
void write_normal_lights(Writer& out, Real sign);

}  // namespace rt::povray
