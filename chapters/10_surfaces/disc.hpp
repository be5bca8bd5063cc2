// The disc: a plane with a rim.
// ε is the unit roundoff of `Real`.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"
#include "common/world/bounds.hpp"
#include "common/world/hit.hpp"

#include <optional>

namespace rt {

/// [10.3] Hit of the ray with the disc in (range.min, range.max], or nothing. The rim belongs to the disc; a
/// ray parallel to it misses it, also one that lies in it.
///
/// The answer is that of a disc that is moved by no more than η = 8ε(|origin − centre| + radius), and whose
/// radius is wrong by no more than that, but for 8ε|t| in t.
std::optional<Hit> intersect(const Disc& disc, const Ray& ray, Interval range);

/// The surface at a hit: as of the plane that the disc lies in. Given.
Surface surface_at(const Disc& disc, const Ray& ray, const Hit& hit);

/// The smallest box around the disc, up to rounding: along an axis it reaches as far as its radius times the
/// sine of the angle between the axis and the normal. Given.
Bounds bounds_of(const Disc& disc);

}  // namespace rt
