// A scene made of a size that POV-Ray can tell apart: its tolerances are lengths.
#pragma once

#include "common/scene/scene.hpp"

namespace rt::povray {

/// The power of two by which all lengths of the scene are multiplied for POV-Ray: 1 where everything is
/// between 0.01 and 1e4, as it must be. Refuses scenes that no factor brings there.
Real factor_for(const Scene& scene);

/// The same picture, with all lengths multiplied by a factor, a power of two; and where a transform makes
/// much or little of a shape, the shape has a size near 1 before it, because the tolerances hold there, too.
Scene scaled(Scene scene, Real factor);

}  // namespace rt::povray
