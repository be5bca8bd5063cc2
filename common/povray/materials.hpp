// Materials in POV-Ray's language.
#pragma once

#include "common/povray/writer.hpp"

#include <string_view>

namespace rt::povray {

/// The colour with the material's pattern, as the inside of `pigment { }`; `more` stands after each colour.
std::string patterned(const Vec3& color, const Checker& checker, std::string_view more = "");

/// Declares a texture for each material that an object has, as `Material0`: all its light, ...
void write_materials(Writer& out);

/// ... or only what it sends by itself.
void write_flat_materials(Writer& out);

}  // namespace rt::povray
