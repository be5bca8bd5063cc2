// Bumps as POV-Ray's `normal`.
#pragma once

#include "common/povray/writer.hpp"

namespace rt::povray {

const Bumps* bumps_of(const Scene& scene, const Material& material);

/// Declares the functions that all bumps are made of, if there are any; after `write_noise`.
void write_bump_functions(Writer& out);

/// Declares what the object's bumps are made of, and returns its `normal { }`; empty where it has none.
std::string write_bumps(Writer& out, const Object& object, std::size_t number);

}  // namespace rt::povray
