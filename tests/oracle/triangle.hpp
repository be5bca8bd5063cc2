// The exact judge of rays and triangles: CGAL's exact numbers behind a plain header.
// Every input must be finite; nothing is rounded until an answer is handed out.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"

#include <optional>

namespace rt::oracle {

/// The facts about a ray and a triangle, and how far a proposed parameter is from the exact one. Every
/// number is rounded at the end only: its sign is exact and its relative error at most 2u.
struct TriangleTruth {
    bool degenerate = false;  ///< the corners lie on one line; then everything else stays as it is here
    /// Six times the signed volumes that the direction spans with the edges opposite to a, b, c, as seen from
    /// the origin: divided by `sum` they are the barycentric weights of the point where the line meets the
    /// plane.
    Vec3 volumes{0};
    Real sum = 0;       ///< of the volumes: normal · direction; zero where the ray is parallel to the plane
    Real t = infinity;  ///< where the line meets the plane; infinite where it is parallel
    Real error = infinity;  ///< proposed t minus t; infinite where either is not finite
    bool hit = false;       ///< the closed half-line t ≥ 0 meets the closed triangle in one point
};

TriangleTruth judge_triangle(const Triangle& triangle, const Ray& ray, Real proposed);

/// The unit normal (b − a) × (c − a) normalised, each coordinate right to 4u; zero where there is no area.
Vec3 unit_normal(const Triangle& triangle);

/// The same question put to CGAL's filtered predicate `do_intersect(Ray_3, Triangle_3)`. Nothing where it
/// can't be asked: its ray is given by two points, so origin + direction must need no rounding; and a
/// degenerate triangle breaks its precondition.
std::optional<bool> cgal_ray_meets_triangle(const Triangle& triangle, const Ray& ray);

}  // namespace rt::oracle
