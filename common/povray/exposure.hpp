// A scene made so dark that POV-Ray, whose pictures end at white, cuts nothing off.
#pragma once

#include "common/scene/scene.hpp"

namespace rt {

/// By how much all light is multiplied for POV-Ray, a power of two. Below 1 only for a blurred scene whose
/// pixels do not share their samples: its stills, of lights with an extent, are brighter in places than the
/// scene is, so everything that shines is to be 1/4 at most. It is 1 where the sky is a picture, and where
/// what is shown is no light.
Real exposure_of(const Scene& scene);

namespace povray {

/// The scene with all light multiplied by `exposure`.
Scene exposed(Scene scene, Real exposure);

}  // namespace povray
}  // namespace rt
