// The exact judge of lines, discs and cones.
// A convex solid is met by a part of a line where some linear and at most one quadratic inequality in t hold
// together. All of that is decided by signs of rational numbers.
#include "tests/oracle/solid.hpp"

#include "tests/oracle/exact.hpp"

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rt::oracle {
namespace {

using Number = CGAL::Gmpq;
using Vec = ExactVec3<Number>;

/// The t of a line at which some linear inequalities hold; an end is missing where it is infinite.
struct Part {
    std::optional<Number> low, high;
    bool is_empty = false;

    explicit Part(Interval part) {
        if (std::isfinite(part.min)) low = Number(part.min);
        if (std::isfinite(part.max)) high = Number(part.max);
        is_empty = part.min > part.max;
    }

    /// Keeps those t with x + t·v ≥ 0.
    void keep(const Number& x, const Number& v) {
        if (v == 0) {
            is_empty |= x < 0;
            return;
        }
        const Number t = -x / v;
        if (v > 0 && (!low || t > *low)) low = t;
        if (v < 0 && (!high || t < *high)) high = t;
        is_empty |= low && high && *low > *high;
    }

    bool has_within(const Number& t) const { return !(low && t < *low) && !(high && t > *high); }
};

/// Whether a·t² + 2·h·t + c ≤ 0 somewhere in the part.
bool is_met(const Part& part, const Number& a, const Number& h, const Number& c) {
    if (part.is_empty) return false;
    const auto at = [&](const Number& t) { return (a * t + h + h) * t + c; };
    if ((part.low && at(*part.low) <= 0) || (part.high && at(*part.high) <= 0)) return true;
    if (a > 0) return part.has_within(-h / a) && h * h - a * c >= 0;
    // At infinity the highest power decides; between two ends where it is positive, a concave parabola is,
    // too.
    if (!part.low && (a < 0 || (a == 0 && (h > 0 || (h == 0 && c <= 0))))) return true;
    if (!part.high && (a < 0 || (a == 0 && (h < 0 || (h == 0 && c <= 0))))) return true;
    return false;
}

}  // namespace

bool meets(const Cone& cone, const Ray& ray, Interval range, Growth growth) {
    const Vec u = Vec(cone.b) - Vec(cone.a), f = Vec(ray.origin) - Vec(cone.a), d(ray.direction);
    const Number u2 = dot(u, u), along = dot(f, u), along_step = dot(d, u);
    // Everything is multiplied by u·u, or by its square, so that it need not be divided by.
    const Number ends = Number(growth.along / length(cone.b - cone.a)) * u2;
    const Number widening = Number(cone.radius_b) - Number(cone.radius_a);
    const Number radius = (Number(cone.radius_a) + Number(growth.across)) * u2 + widening * along;
    const Number radius_step = widening * along_step;
    Part part(range);
    part.keep(along + ends, along_step);
    part.keep(u2 + ends - along, -along_step);
    part.keep(radius, radius_step);
    const Vec e = cross(f, u), m = cross(d, u);
    return is_met(part, u2 * dot(m, m) - radius_step * radius_step, u2 * dot(e, m) - radius * radius_step,
                  u2 * dot(e, e) - radius * radius);
}

DiscTruth judge_disc(const Disc& disc, const Ray& ray, Real proposed) {
    const Vec n(disc.normal), f = Vec(ray.origin) - Vec(disc.center), d(ray.direction);
    const Number slope = dot(n, d);
    if (slope == 0) return {};
    const Number t = -dot(n, f) / slope;
    const Vec q(f.x + t * d.x, f.y + t * d.y, f.z + t * d.z);
    return {.crosses = true,
            .t = CGAL::to_double(t),
            .error = CGAL::to_double(Number(proposed) - t),
            .distance = std::sqrt(CGAL::to_double(dot(q, q))),
            .slope = CGAL::to_double(slope) / length(disc.normal)};
}

}  // namespace rt::oracle
