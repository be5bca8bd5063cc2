// The exact judge of lines and spheres.
// Roots are irrational, so errors of roots come from exact values of the polynomial instead.
#include "tests/oracle/sphere.hpp"

#include "tests/oracle/exact.hpp"

#include <CGAL/Gmpq.h>
#include <CGAL/Root_of_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>

namespace rt::oracle {
namespace {

using Vec = ExactVec3<Exact>;
using Rational = CGAL::Simple_cartesian<CGAL::Gmpq>;

struct Quadratic {
    Exact a, h, c;
    Exact discriminant = h * h - a * c;
    Real root_of_discriminant = std::sqrt(std::max(CGAL::to_double(discriminant), Real(0)));
};

/// t minus the root (−h ± √D)/a, where `sign` says which.
Real error_of(const Quadratic& q, const Exact& value, const Exact& t, int sign) {
    // With s = a·t + h and the root r±: a·(t − r±) = s ∓ √D, and value = a·(t − r+)·(t − r−).
    // Of the two ways to t − r±, take the one that does not cancel.
    const Real s = CGAL::to_double(q.a * t + q.h);
    const Real root = sign * q.root_of_discriminant;
    if (s * root > 0) return CGAL::to_double(value) / (s + root);
    return (s - root) / CGAL::to_double(q.a);
}

void judge(const Quadratic& q, Real proposed0, Real proposed1, QuadraticTruth& truth) {
    const int sign = CGAL::sign(q.discriminant);
    truth.roots = sign + 1;
    truth.discriminant = CGAL::to_double(q.discriminant);

    const Real a = CGAL::to_double(q.a), h = CGAL::to_double(q.h), c = CGAL::to_double(q.c);
    if (sign <= 0) {
        truth.t0 = truth.t1 = -h / a;
    } else {
        const Real sum = h + std::copysign(q.root_of_discriminant, h);
        truth.t0 = std::min(-sum / a, -c / sum);
        truth.t1 = std::max(-sum / a, -c / sum);
    }
    const auto one = [&](Real proposed, int which, Real& error, Real& residual) {
        error = residual = infinity;
        if (!std::isfinite(proposed)) return;
        const Exact t(proposed);
        const Exact value = (q.a * t + q.h + q.h) * t + q.c;
        residual = CGAL::to_double(value);
        error = error_of(q, value, t, which);
    };
    one(proposed0, -1, truth.error0, truth.residual0);
    one(proposed1, +1, truth.error1, truth.residual1);
}

/// The line f + t·d and the sphere of radius r around the origin.
SphereTruth judge(const Vec& f, const Vec& d, const Exact& r, Real proposed0, Real proposed1) {
    const Quadratic q{dot(d, d), dot(f, d), dot(f, f) - r * r};
    SphereTruth truth;
    judge(q, proposed0, proposed1, truth);
    truth.a = CGAL::to_double(q.a);
    // D = a·(r − ℓ)·(r + ℓ), and (a·ℓ)² = a·(a·r² − D); only the sign and size of r − ℓ need care.
    const Real radius = CGAL::to_double(r), r2 = radius * radius, excess = truth.discriminant / truth.a;
    truth.depth = excess / (radius + std::sqrt(std::max(r2 - excess, Real(0))));
    const auto distance = [&](Real residual) {
        return residual / (radius + std::sqrt(std::max(r2 + residual, Real(0))));
    };
    truth.distance0 = distance(truth.residual0);
    truth.distance1 = distance(truth.residual1);
    return truth;
}

Rational::Sphere_3 rational(const Sphere& sphere) {
    const CGAL::Gmpq r(sphere.radius);
    return {Rational::Point_3(sphere.center.x, sphere.center.y, sphere.center.z), r * r};
}

}  // namespace

QuadraticTruth judge_quadratic(Real a, Real h, Real c, Real proposed0, Real proposed1) {
    QuadraticTruth truth;
    judge({Exact(a), Exact(h), Exact(c)}, proposed0, proposed1, truth);
    return truth;
}

SphereTruth judge_sphere(const Sphere& sphere, const Ray& ray, Real proposed0, Real proposed1) {
    return judge(Vec(ray.origin) - Vec(sphere.center), Vec(ray.direction), Exact(sphere.radius), proposed0,
                 proposed1);
}

SphereTruth judge_ellipsoid(const Mat4& to_world, const Ray& ray, Real proposed0, Real proposed1) {
    // The determinant times the inverse needs no division: its rows are cross products of the columns. The
    // unit sphere has the determinant for its radius then, and t is the same.
    const auto column = [&](int c) { return Vec(Vec3(to_world[c])); };
    const Vec x = column(0), y = column(1), z = column(2);
    const Vec rows[3] = {cross(y, z), cross(z, x), cross(x, y)};
    const auto to_local = [&](const Vec& v) {
        return Vec(dot(rows[0], v), dot(rows[1], v), dot(rows[2], v));
    };
    const Exact determinant = dot(x, rows[0]);
    const Exact radius = CGAL::sign(determinant) < 0 ? -determinant : determinant;
    SphereTruth truth = judge(to_local(Vec(ray.origin) - column(3)), to_local(Vec(ray.direction)), radius,
                              proposed0, proposed1);
    for (Real* length : {&truth.depth, &truth.distance0, &truth.distance1})
        *length /= CGAL::to_double(radius);
    return truth;
}

bool cgal_ray_meets_ball(const Sphere& sphere, const Ray& ray) {
    const Rational::Ray_3 exact_ray(Rational::Point_3(ray.origin.x, ray.origin.y, ray.origin.z),
                                    Rational::Vector_3(ray.direction.x, ray.direction.y, ray.direction.z));
    return CGAL::do_intersect(exact_ray, rational(sphere));
}

bool cgal_root_is_between(const Sphere& sphere, const Ray& ray, bool greater, Real low, Real high) {
    using Number = CGAL::Gmpq;
    const ExactVec3<Number> d(ray.direction);
    const ExactVec3<Number> f = ExactVec3<Number>(ray.origin) - ExactVec3<Number>(sphere.center);
    const Number r(sphere.radius);
    const auto root = CGAL::make_root_of_2(dot(d, d), Number(2) * dot(f, d), dot(f, f) - r * r, !greater);
    return Number(low) <= root && root <= Number(high);
}

}  // namespace rt::oracle
