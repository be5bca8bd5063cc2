// What is said where POV-Ray has no words for a scene.
#pragma once

#include "common/scene/scene.hpp"

#include <string_view>

namespace rt::povray {

/// Throws InputError with the object's or light's `file:line:column`, or the scene's name, and the reason.
[[noreturn]] void refuse(const Scene& scene, const Object& object, std::string_view why);
[[noreturn]] void refuse(const Scene& scene, const AreaLightObject& light, std::string_view why);
[[noreturn]] void refuse(const Scene& scene, std::string_view why);

/// Refuses scenes whose rays POV-Ray sends on otherwise: bodies with Fresnel's mirror inside others, whose
/// way out it takes for the way into nothing; light that is absorbed on its way to what it lights; glass of
/// single faces; rays that spread; lights with an extent where rays go on; and materials that have no layers
/// of POV-Ray's.
void refuse_other_optics(const Scene& scene);

/// Refuses glass that does not surround the still scene's eye as it does the scene's: our rays are all inside
/// of what the pinhole is inside of when the shutter opens, and POV-Ray asks for each place.
void refuse_other_eye(const Scene& scene, const Scene& still);

}  // namespace rt::povray
