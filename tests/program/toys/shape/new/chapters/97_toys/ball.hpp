// A toy shape: a sphere by another name.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"
#include "common/world/bounds.hpp"
#include "common/world/hit.hpp"

#include <optional>

namespace rt {

/// [97.1] Nearest hit with the ball in (range.min, range.max], or nothing.
std::optional<Hit> intersect(const Ball& ball, const Ray& ray, Interval range);

/// [97.1] The surface at a hit.
Surface surface_at(const Ball& ball, const Ray& ray, const Hit& hit);

/// A box around the ball. Given.
Bounds bounds_of(const Ball& ball);

}  // namespace rt
