// The lens: what two balls have in common.
#pragma once

#include "chapters/02_spheres/sphere.hpp"

namespace rt {

/// [02.6] Nearest hit of the ray in (range.min, range.max] with the surface of the lens, or nothing. The lens
/// is every point that both balls have in common, their surfaces included.
///
/// `Hit::primitive` is 0 where the surface is that of `a`, and 1 where it is that of `b` alone.
std::optional<Hit> intersect_lens(const Sphere& a, const Sphere& b, const Ray& ray, Interval range);

}  // namespace rt
