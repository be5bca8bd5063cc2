// The exact judge of lines and spheres: CGAL's exact numbers behind a plain header.
// Every input must be finite; nothing is rounded until an answer is handed out.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"

namespace rt::oracle {

/// The facts about the polynomial a·t² + 2·h·t + c, a > 0, and how far two proposed roots are from its roots.
/// Every number is rounded at the end only: its sign is exact and its relative error at most 8u.
struct QuadraticTruth {
    int roots = 0;                      ///< exact number of real roots: 0, 1 (double) or 2
    Real discriminant = 0;              ///< h² − a·c
    Real t0 = 0, t1 = 0;                ///< the roots, ascending; where there is none, −h/a twice
    Real error0 = 0, error1 = 0;        ///< proposed minus true root; not finite where that is not
    Real residual0 = 0, residual1 = 0;  ///< the polynomial at the proposed roots
};

QuadraticTruth judge_quadratic(Real a, Real h, Real c, Real proposed0, Real proposed1);

/// The same for the line of a ray and a sphere: a = d·d, h = f·d, c = f·f − r², where f = origin − centre is
/// not rounded either.
struct SphereTruth : QuadraticTruth {
    Real a = 0;
    /// Radius minus the line's distance from the centre: positive where the line enters the sphere.
    Real depth = 0;
    /// Signed distance from the sphere of the points of the line at the proposed parameters.
    Real distance0 = 0, distance1 = 0;
};

SphereTruth judge_sphere(const Sphere& sphere, const Ray& ray, Real proposed0, Real proposed1);

/// The same for the line and the image of the unit sphere around the origin under the affine map `to_world`,
/// whose inverse is not rounded either. `depth` and the distances are in the sphere's own space, where the
/// radius is 1; `a` and `discriminant` are too large by the square of the map's determinant, which must not
/// be zero.
SphereTruth judge_ellipsoid(const Mat4& to_world, const Ray& ray, Real proposed0, Real proposed1);

/// Whether the ray (t ≥ 0) meets the ball, asked of CGAL's own predicate `do_intersect(Ray_3, Sphere_3)` over
/// rational numbers. Slow; it checks `judge_sphere`.
bool cgal_ray_meets_ball(const Sphere& sphere, const Ray& ray);

/// Whether low ≤ root ≤ high for the smaller (or `greater`) root of the line with the sphere, compared as
/// algebraic numbers (CGAL `make_root_of_2` over rational numbers). The line must meet the sphere. Slow; it
/// checks `judge_sphere`.
bool cgal_root_is_between(const Sphere& sphere, const Ray& ray, bool greater, Real low, Real high);

}  // namespace rt::oracle
