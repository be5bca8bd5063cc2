// The methods of textbooks, which break on the stability families: that shows that the families can fail,
// and lessons draw what it looks like.
#pragma once

#include "chapters/02_spheres/quadratic.hpp"
#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"
#include "common/world/hit.hpp"
#include "common/world/world.hpp"

#include <optional>
#include <span>

namespace rt::naive {

/// Distances below this count as no hit, as is often advised against surfaces that shadow themselves.
inline constexpr Real epsilon = 1e-4;

/// Determinants below this count as parallel (Möller & Trumbore 1997 print 1e-6).
inline constexpr Real parallel = 1e-6;

/// (−b ± √(b² − 4ac)) / 2a, with b = 2h; the discriminant is computed from the coefficients.
Roots solve_quadratic(Real a, Real h, Real c);

/// Both roots for a line and a sphere, by the formula above.
Roots intersections(const Sphere& sphere, const Ray& ray);

/// The nearest hit beyond `epsilon` in the range.
std::optional<Hit> intersect(const Sphere& sphere, const Ray& ray, Interval range);

/// The test of Möller & Trumbore (1997), without culling, for hits beyond `epsilon` in the range.
std::optional<Hit> intersect(const Triangle& triangle, const Ray& ray, Interval range);

/// Barycentric coordinates by Cramer's rule from the dot products of the edges (Ericson 2005, §3.4).
std::optional<Vec3> barycentric(const Triangle& triangle, const Vec3& point);

/// The product of the edges from the first corner, made a unit vector; zero if it is zero.
Vec3 unit_normal(const Triangle& triangle);

/// The point where the ray meets the plane of the polygon, then that point in the polygon's shadow on a
/// coordinate plane, by the crossings of chapter 3.
std::optional<Hit> intersect(const Polygon& polygon, const Ray& ray, Interval range);

/// Even-odd rule that compares the point's x with where the edge, taken in the polygon's direction, crosses
/// its height (Franklin's PNPOLY).
bool point_in_polygon(std::span<const Vec2> polygon, const Vec2& point);

/// Determinants below this count as zero.
inline constexpr Real singular = 1e-12;

/// The inverse of an affine matrix as the adjugate over the determinant; nothing where the determinant counts
/// as zero.
std::optional<Mat4> inverse(const Mat4& m);

/// A normal taken for a direction: the linear part of `m` times n.
Vec3 transform_normal(const Mat4& m, const Vec3& n);

/// The ray in local space with its direction made a unit vector, as is often advised.
Ray to_local(const Transform& transform, const Ray& ray);

}  // namespace rt::naive
