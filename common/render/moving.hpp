// Shapes that move or turn while the shutter is open: asked where they are at the ray's time.
#pragma once

#include "common/world/hit.hpp"
#include "common/world/shapes.hpp"

#include <optional>

namespace rt {

/// As a shape's contract has them (common/world/shapes.hpp), at the time of the ray.
std::optional<Hit> intersect(const Moving& moving, const Ray& ray, Interval range);
std::optional<Hit> intersect(const Turning& turning, const Ray& ray, Interval range);
Surface surface_at(const Moving& moving, const Ray& ray, const Hit& hit);
Surface surface_at(const Turning& turning, const Ray& ray, const Hit& hit);

/// Of all the places where it is between the times 0 and 1; of what turns, often wider than need be.
Bounds bounds_of(const Moving& moving);
Bounds bounds_of(const Turning& turning);

/// The surface at a hit, with texture coordinates if the world uses any.
Surface surface_at(const Moving& moving, const Ray& ray, const Hit& hit, bool uvs);
Surface surface_at(const Turning& turning, const Ray& ray, const Hit& hit, bool uvs);

/// The ray as the shape sees it, which stays as it is at time 0.
Ray seen_by(const Moving& moving, const Ray& ray);
Ray seen_by(const Turning& turning, const Ray& ray);

/// A direction on the shape, given as it is at time 0, at another time.
Vec3 turned(const Turning& turning, Vec3 direction, Real time);

}  // namespace rt
