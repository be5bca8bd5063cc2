// Where what a ray has met lies on a texture, and how it runs there.
#pragma once

#include "chapters/11_textures/texture_coordinates.hpp"
#include "common/world/query.hpp"

namespace rt {

/// The texture point of the surface at a hit, its tangents in world space; without tangents where a shape has
/// none, or nothing in the picture asks for texture coordinates.
TexturePoint texture_point_at(const World& world, const Ray& ray, const Hit& hit, const Surface& surface);

}  // namespace rt
