// Shapes that move while the shutter is open: asked where they are at the ray's time.
#pragma once

#include "common/world/hit.hpp"
#include "common/world/shapes.hpp"

#include <optional>

namespace rt {

/// As a shape's contract has them (common/world/shapes.hpp), at the time of the ray.
std::optional<Hit> intersect(const Moving& moving, const Ray& ray, Interval range);
Surface surface_at(const Moving& moving, const Ray& ray, const Hit& hit);

/// Of all the places where it is between the times 0 and 1.
Bounds bounds_of(const Moving& moving);

/// The surface at a hit, with texture coordinates if the world uses any.
Surface surface_at(const Moving& moving, const Ray& ray, const Hit& hit, bool uvs);

}  // namespace rt
