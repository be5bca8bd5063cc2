// What is inside of bodies, in POV-Ray's language.
#pragma once

#include "common/povray/writer.hpp"

namespace rt::povray {

/// All that an object's statement says of its inside: interior, hollow, inverse.
std::string inside(const Scene& scene, const Object& object);

/// POV-Ray lets light from the background through any medium. So where a ray in an absorbing body may go on
/// for ever, the background is a sphere so large that nothing is left of light from there.
void write_sky(Writer& out);

}  // namespace rt::povray
