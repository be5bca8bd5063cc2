// Meshes in POV-Ray's language.
#pragma once

#include "common/povray/writer.hpp"

#include <cstddef>

namespace rt::povray {

/// Declares the scene's mesh of that index, as `Mesh0`.
void write_mesh(Writer& out, std::size_t index);

}  // namespace rt::povray
