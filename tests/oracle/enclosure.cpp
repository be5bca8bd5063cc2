// Intersections in interval arithmetic.
#include "tests/oracle/enclosure.hpp"

#include "tests/oracle/exact.hpp"

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>

namespace rt::oracle {
namespace {

// Directed rounding is switched on once a call, not once an operation.
using Number = CGAL::Interval_nt<false>;
using Vec = ExactVec3<Number>;

Enclosure hit(Decision decision, const Number& t) { return {decision, t.inf(), t.sup()}; }

bool contains_zero(const Number& x) { return x.inf() <= 0 && x.sup() >= 0; }

}  // namespace

Enclosure enclose_sphere(const Sphere& sphere, const Ray& ray) {
    const Number::Protector upward;
    const Vec d(ray.direction), f = Vec(ray.origin) - Vec(sphere.center);
    const Number a = dot(d, d), h = dot(f, d), along = h / a;
    const Vec w = f - Vec(along * d.x, along * d.y, along * d.z);
    const Number r2 = CGAL::square(Number(sphere.radius));
    const Number discriminant = a * (r2 - dot(w, w));
    if (discriminant.sup() < 0) return {};
    if (discriminant.inf() < 0) {
        // A negative part of the interval has no root, and adds nothing to where the hit may be.
        const Number root = CGAL::sqrt(Number(0, discriminant.sup()));
        return hit(Decision::Unknown, -(h + root) / a);
    }
    const Number root = CGAL::sqrt(discriminant);
    if (h.sup() < 0) return hit(Decision::Hit, (dot(f, f) - r2) / (root - h));
    return hit(Decision::Hit, -(h + root) / a);
}

Enclosure enclose_triangle(const Triangle& triangle, const Ray& ray) {
    const Number::Protector upward;
    const Vec origin(ray.origin), d(ray.direction);
    const Vec a = Vec(triangle.a) - origin, b = Vec(triangle.b) - origin, c = Vec(triangle.c) - origin;
    const Vec b_c = cross(b, c);
    const Number u = dot(d, b_c), v = dot(d, cross(c, a)), w = dot(d, cross(a, b));
    const Number volumes[3] = {u, v, w};
    const auto positive = [](const Number& x) { return x.inf() > 0; };
    const auto negative = [](const Number& x) { return x.sup() < 0; };
    if (std::any_of(volumes, volumes + 3, positive) && std::any_of(volumes, volumes + 3, negative)) return {};
    const Number sum = dot(cross(b - a, c - a), d);
    if (contains_zero(sum)) return {Decision::Unknown, -infinity, infinity};
    const bool sure =
        std::all_of(volumes, volumes + 3, positive) || std::all_of(volumes, volumes + 3, negative);
    return hit(sure ? Decision::Hit : Decision::Unknown, dot(a, b_c) / sum);
}

}  // namespace rt::oracle
