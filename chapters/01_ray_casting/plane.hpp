// The plane: the simplest thing that a ray can hit.
#pragma once

#include "common/scene/shapes.hpp"
#include "common/world/hit.hpp"

#include <optional>
#include <span>

namespace rt {

/// [01.4] Hit of the ray with the plane in (range.min, range.max], or nothing.
///
/// `t` is in units of |ray.direction|. A ray parallel to the plane misses it, even one that lies in it.
std::optional<Hit> intersect(const Plane& plane, const Ray& ray, Interval range);

/// The surface at a hit: the point, moved onto the plane; the unit normal; (u, v) = 0. Given.
Surface surface_at(const Plane& plane, const Ray& ray, const Hit& hit);

/// [01.5] Nearest of the hits with all the planes, or nothing. `Hit::primitive` is the plane's index; of
/// equal distances the lowest index wins.
std::optional<Hit> closest_hit(std::span<const Plane> planes, const Ray& ray, Interval range);

}  // namespace rt
