// The objects of a scene as the primitives of a world.
#pragma once

#include "common/scene/scene.hpp"
#include "common/world/world.hpp"

namespace rt {

/// Fills world.groups, world.primitives and world.meshes, and says in world.needs.transforms whether a
/// matrix is left. What world.needs says of normals and texture coordinates decides whether they are kept.
///
/// Transforms are baked into points, normals and radii where that is possible; spheres that are stretched
/// become ellipsoids, and a mesh that several objects show is kept once, in its own space; transparent faces
/// that enclose a body are one object. Throws InputError with the place of a transform that has no inverse,
/// and of a transparent face without an inside.
void add_primitives(const Scene& scene, World& world);

/// Writes down in world.primitives that the shapes of world.groups[group] are there.
void place_shapes(World& world, std::size_t group);

}  // namespace rt
