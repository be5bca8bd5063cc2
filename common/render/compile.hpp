// From a scene as written to a world as rendered.
#pragma once

#include "common/scene/scene.hpp"
#include "common/world/world.hpp"

namespace rt {

/// Keeps what the picture of `scene` needs and leaves out the rest: transforms are baked into shapes where
/// that is possible, black lights dropped, equal meshes shared, primitives of one kind put side by side.
/// Throws InputError with the place in the file for a singular transform, a polygon that is not planar, an
/// integrator that cannot draw an object, and for what is out of range (common/scene/range.hpp).
World compile(const Scene& scene);

}  // namespace rt
