// The sphere: hit or miss, where, and the surface there.
#pragma once

#include "chapters/02_spheres/quadratic.hpp"
#include "common/scene/shapes.hpp"
#include "common/world/hit.hpp"

#include <optional>
#include <span>

namespace rt {

/// [02.2] Both parameters where the line of the ray meets the sphere, in units of |ray.direction|.
///
/// The discriminant comes from the line's distance to the centre, not from the coefficients, so that it
/// does not cancel when the sphere is far away or small (Haines, Günther & Akenine-Möller 2019).
Roots intersections(const Sphere& sphere, const Ray& ray);

/// [02.3] Nearest hit of the ray with the sphere in (range.min, range.max], or nothing.
///
/// `t` is in units of |ray.direction|, which need not be 1. A tangent ray counts as one hit; from inside
/// the far root is returned. Stable for distance/radius up to 1e8.
std::optional<Hit> intersect(const Sphere& sphere, const Ray& ray, Interval range);

/// [02.4] The surface at a hit: the point, moved onto the sphere, and the unit normal, outward. `uv` stays 0:
/// most pictures do not need it.
Surface surface_at(const Sphere& sphere, const Ray& ray, const Hit& hit);

/// [02.4] Texture coordinates of the point with this unit normal (x, y, z):
/// (atan2(z, x)/2π wrapped to [0, 1), ½ + asin(y)/π).
Vec2 sphere_uv(const Vec3& normal);

/// [02.5] Nearest of the hits with all the spheres, or nothing. `Hit::primitive` is the sphere's index; of
/// equal distances the lowest index wins.
std::optional<Hit> closest_hit(std::span<const Sphere> spheres, const Ray& ray, Interval range);

/// [02.5] Whether any sphere is hit in the range; stops at the first.
bool any_hit(std::span<const Sphere> spheres, const Ray& ray, Interval range);

}  // namespace rt
