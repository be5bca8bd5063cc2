// Materials in POV-Ray's language.
#pragma once

#include "common/povray/writer.hpp"

#include <string_view>

namespace rt::povray {

/// The colour with the material's pattern, as the inside of `pigment { }`; `more` stands after each colour.
std::string patterned(const Vec3& color, const Checker& checker, std::string_view more = "");

/// Whether the objects of this material have a texture each.
bool is_own(const Scene& scene, const Material& m);

/// The name of an object's texture: `Material0`, or `Object0` of its own.
std::string texture_name(const Scene& scene, const Object& object);

/// Whether each part of the object has a texture of its own: where a picture lies differs from part to part.
bool is_by_parts(const Scene& scene, const Object& object);

/// The name of the texture of such a part, an index into Scene::parts.
std::string part_texture_name(std::uint32_t part);

/// The value of a pattern, between 0 and 1, as the inside of a function; of Marble and Wood in terms of
/// `Noise`.
std::string pattern_function(const SolidPattern& pattern);

/// Likewise 0 in even cubes and 1 in odd ones.
std::string checker_function(Real size);

/// Declares a texture for each material that an object has, as `Material0`: all its light, ...
void write_materials(Writer& out);

/// ... or only what it sends by itself.
void write_flat_materials(Writer& out);

}  // namespace rt::povray
