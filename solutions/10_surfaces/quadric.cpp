// Quadrics in a box: given. Ellipsoids, paraboloids, hyperboloids, cones and cylinders of any section.
#include "chapters/10_surfaces/quadric.hpp"

#include "chapters/02_spheres/quadratic.hpp"
#include "chapters/10_surfaces/surface_around.hpp"
#include "common/math/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {
namespace {

/// yz, xz and xy as the coefficients F, E and D want them, in the order D, E, F.
Vec3 mixed(const Vec3& p) { return {p.x * p.y, p.x * p.z, p.y * p.z}; }

Real value_at(const Quadric& q, const Vec3& p) {
    return dot(q.squares, p * p) + dot(q.mixed, mixed(p)) + (dot(q.linear, p) + q.constant);
}

/// The sum of the sizes of all that `value_at` adds up.
Real magnitude_at(const Quadric& q, const Vec3& p) {
    return dot(abs(q.squares), p * p) + dot(abs(q.mixed), abs(mixed(p))) + dot(abs(q.linear), abs(p)) +
           std::abs(q.constant);
}

Vec3 gradient_at(const Quadric& q, const Vec3& p) {
    const auto& [d, e, f] = std::array{q.mixed.x, q.mixed.y, q.mixed.z};
    return Real(2) * q.squares * p + Vec3(d * p.y + e * p.z, d * p.x + f * p.z, e * p.x + f * p.y) + q.linear;
}

/// a·λ² + 2·h·λ + c along a chord, and its roots, ascending. Where a is 0, there is one root or none.
struct Equation {
    Real a = 0, h = 0, c = 0;
    Roots roots;
};

Equation equation_of(const Quadric& q, const Chord& chord) {
    const auto& [start, way, from, length] = chord;
    Equation equation{dot(q.squares, way * way) + dot(q.mixed, mixed(way)),
                      dot(gradient_at(q, start), way) / 2,
                      value_at(q, start),
                      {}};
    const auto& [a, h, c, roots] = equation;
    if (a == 0) {
        if (h != 0) equation.roots = {1, -c / (2 * h), -c / (2 * h)};
        return equation;
    }
    // The discriminant is the same wherever λ is counted from: best, from where the line is nearest to a
    // double root.
    const Real lambda = std::clamp(-h / a, Real(0), Real(1)), slope = h + a * lambda;
    equation.roots = solve_quadratic(a, h, c, slope * slope - a * value_at(q, chord.at(lambda)));
    return equation;
}

}  // namespace

std::optional<Hit> intersect(const Quadric& quadric, const Ray& ray, Interval range) {
    const std::optional<Chord> part = chord(quadric.box, ray, {0, infinity});
    if (!part) return std::nullopt;
    const Roots roots = equation_of(quadric, *part).roots;
    if (roots.count == 0) return std::nullopt;
    for (const Real lambda : {roots.t0, roots.t1})
        if (const Real t = part->t_at(lambda); 0 <= lambda && lambda <= 1 && contains(range, t))
            return Hit{.t = t, .element = surface_face};
    return std::nullopt;
}

std::vector<Span> inside(const Quadric& quadric, const Ray& ray) {
    std::vector<Span> spans;
    const std::optional<Span> box = inside(quadric.box, ray);
    const std::optional<Chord> part = box ? chord(*box, ray, {-infinity, infinity}) : std::nullopt;
    if (!part) return spans;
    const auto [a, h, c, roots] = equation_of(quadric, *part);
    // What of a part of the line is in the box; it is a part between two points of the surface, or from or up
    // to one.
    const auto append = [&](Real enter, Real leave) {
        const Span between{part->t_at(enter), part->t_at(leave), surface_face, surface_face};
        if (const std::optional<Span> common = common_part(*box, between); common && enter < leave)
            spans.push_back(*common);
    };
    const bool is_whole = roots.count == 0 ? (a == 0 ? c <= 0 : a < 0) : a < 0 && roots.t0 == roots.t1;
    if (is_whole) {
        append(-infinity, infinity);
    } else if (roots.count > 0 && a > 0) {
        append(roots.t0, roots.t1);
    } else if (roots.count > 0) {
        if (a < 0 || h > 0) append(-infinity, roots.t0);
        if (a < 0 || h < 0) append(roots.t1, infinity);
    }
    return spans;
}

Surface surface_at(const Quadric& quadric, const Ray& ray, const Hit& hit) {
    if (hit.element != surface_face) return surface_at(quadric.box, ray, hit);
    const Box& box = quadric.box;
    const auto value = [&](const Vec3& there) { return value_at(quadric, there); };
    const auto gradient = [&](const Vec3& there) { return gradient_at(quadric, there); };
    const Vec3 p = polished(point_in(box, ray, hit.t), box, 2, value, gradient);
    // Whether the value is above rounding at both ends. In the part it is then no less: where it is negative,
    // it was so at an end, too, or the part is as wide as the quadric.
    const auto side_at = [&](const Vec3& there) {
        const Real f = value(there), rounding = gamma(64) * magnitude_at(quadric, there);
        return f > rounding ? 1 : f < -rounding ? -1 : 0;
    };
    const auto side = [&](const Vec3& n, Real low, Real high) {
        const int at_low = side_at(p + low * n);
        return at_low == side_at(p + high * n) ? at_low : 0;
    };
    return surface_around(p, gradient(p), ray, box, side);
}

Bounds bounds_of(const Quadric& quadric) { return {quadric.box.low, quadric.box.high}; }

}  // namespace rt
