// Cones and cylinders, solid or open: all that is round about an axis and straight along it.
// The lesson uses the same letters: u for the axis from a to b, e and m across it, α and β for the radius.
#include "chapters/10_surfaces/cone.hpp"

#include "chapters/10_surfaces/disc.hpp"
#include "common/math/error.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

ConeLine cone_line(const Cone& cone, const Ray& ray) {
    // [exercise 10.4] Return the line as `ConeLine` describes it, with τ counted from the point of the line
    // that is nearest to the cone's narrower end (a, if both are equal).
    const Vec3 u = cone.b - cone.a, &d = ray.direction;
    const Real u2 = dot(u, u), length_of_u = std::sqrt(u2), widening = cone.radius_b - cone.radius_a;
    const bool is_b = cone.radius_b < cone.radius_a;
    Vec3 f = ray.origin - (is_b ? cone.b : cone.a);
    ConeLine line;
    line.from = -dot(f, d) / dot(d, d);
    f += line.from * d;
    line.e = cross(f, u);
    line.m = cross(d, u);
    const Real from_end = dot(f, u) / u2;
    line.along = from_end + (is_b ? 1 : 0);
    line.along_step = dot(d, u) / u2;
    line.alpha = length_of_u * ((is_b ? cone.radius_b : cone.radius_a) + from_end * widening);
    line.beta = length_of_u * line.along_step * widening;
    line.a = dot(line.m, line.m) - line.beta * line.beta;
    return line;
    // [/exercise]
}

Roots side_roots(const ConeLine& line) {
    // [exercise 10.4] Return the roots of a·τ² + 2·h·τ + c = 0, where |e + τ·m|² = (α + τ·β)², with the
    // discriminant as the contract has it. Mind a = 0.
    const auto& [e, m, alpha, beta, a, along, along_step, from] = line;
    const Real h = dot(e, m) - alpha * beta;
    const Real c = dot(e, e) - alpha * alpha;
    if (a == 0) return h == 0 ? Roots{} : Roots{1, -c / (2 * h), -c / (2 * h)};
    const Vec3 wide = alpha * m - beta * e, far = cross(e, m);
    return solve_quadratic(a, h, c, dot(wide, wide) - dot(far, far));
    // [/exercise]
}

namespace {

/// The τ at which the line is inside the side: where |e + τ·m| ≤ α + τ·β.
[[maybe_unused]] std::optional<Span> inside_side(const ConeLine& line) {
    // [exercise 10.5] Return the part of the line that is inside the side, or nothing. There are four cases:
    // across the side, steeper than it, parallel to it, and no roots.
    const auto& [e, m, alpha, beta, a, along, along_step, from] = line;
    const Roots roots = side_roots(line);
    if (roots.count == 0)
        return a <= 0 && alpha >= 0 && dot(e, e) <= alpha * alpha ? std::optional(Span{}) : std::nullopt;
    if (a > 0) return Span{roots.t0, roots.t1};
    const Real root = beta > 0 ? roots.t1 : roots.t0;
    if (a == 0 && alpha + root * beta < 0) return std::nullopt;
    return beta > 0 ? Span{root, infinity} : Span{-infinity, root};
    // [/exercise]
}

}  // namespace

std::optional<Span> inside(const Cone& cone, const Ray& ray) {
    // [exercise 10.5] Return what the side and the slab between the ends, 0 ≤ s ≤ 1, have in common, or
    // nothing: with the cone's faces, and in the ray's t.
    const ConeLine line = cone_line(cone, ray);
    const std::optional<Span> side = inside_side(line);
    std::optional<Span> ends = slab(line.along, line.along_step, 0, 1);
    if (!side || !ends) return std::nullopt;
    ++ends->enter_face;
    ++ends->leave_face;
    std::optional<Span> span = common_part(*side, *ends);
    if (!span) return std::nullopt;
    span->enter += line.from;
    span->leave += line.from;
    return span;
    // [/exercise]
}

std::optional<Hit> intersect(const Cone& cone, const Ray& ray, Interval range) {
    const std::optional<Span> span = inside(cone, ray);
    return span ? first_hit(*span, range) : std::nullopt;
}

std::optional<Hit> intersect(const OpenCone& open, const Ray& ray, Interval range) {
    // [exercise 10.6] Return a Hit at the first root of the side that is in the range and between the ends,
    // or nothing.
    const ConeLine line = cone_line(open.cone, ray);
    const Roots roots = side_roots(line);
    if (roots.count == 0) return std::nullopt;
    for (const Real tau : {roots.t0, roots.t1}) {
        const Real t = line.from + tau, s = line.along + tau * line.along_step;
        if (contains(range, t) && 0 <= s && s <= 1) return Hit{.t = t};
    }
    return std::nullopt;
    // [/exercise]
}

Vec3 side_normal(const Cone& cone, const Vec3& radial) {
    // [exercise 10.6] Return the unit normal of the side where `radial` leads to it.
    const Vec3 u = cone.b - cone.a;
    return normalize(radial - ((cone.radius_b - cone.radius_a) / dot(u, u)) * u);
    // [/exercise]
}

Surface surface_at(const Cone& cone, const Ray& ray, const Hit& hit) {
    const Vec3 u = cone.b - cone.a;
    const Real u2 = dot(u, u), length_of_u = std::sqrt(u2), widening = cone.radius_b - cone.radius_a;
    // The next ray, which starts here, moves its origin to near a, and what it makes of that and of the cone
    // has 22 roundings at most, of lengths that are no greater than `reach`; they weigh most, by the square
    // root of 2, where the side leans by 45 degrees. (tests/stability/solids.hpp counts them.)
    const Real reach = length_of_u + std::max(cone.radius_a, cone.radius_b), slack = gamma(32) * reach;

    // From a to the hit, along the axis and across it; once more, because the way there may be much longer
    // than what is left of it.
    const Vec3 way = (ray.origin - cone.a) + hit.t * ray.direction;
    Real s = dot(way, u) / u2;
    Vec3 across = way - s * u;
    across -= (dot(across, u) / u2) * u;
    // On the axis itself, at an apex, any direction is as good as another.
    if (across == Vec3(0)) across = any_across(u);
    const Vec3 radial = normalize(near_one(across));

    // A point near a rim or an apex is moved into its own face, so that the next ray does not take it for one
    // that is beyond the other, or beyond the axis. It may start on either side of the face: then it is moved
    // by |error|, at most gamma(4)·|a| + gamma(2)·reach + √3·slack, and rounded by 3u·(|a| + reach); and what
    // the next ray makes of it is off by slack. |a| is at most √3 times its greatest coordinate.
    const bool is_side = hit.element == 0;
    const Real lean = std::abs(widening) / length_of_u, margin = 3 * slack + gamma(13) * size_of(cone.a);
    const Real least_radius = 2 * (1 + lean) * margin;
    if (is_side) {
        Interval part{margin / length_of_u, 1 - margin / length_of_u};
        if (cone.radius_a < least_radius)
            part.min = std::max(part.min, (least_radius - cone.radius_a) / widening);
        if (cone.radius_b < least_radius)
            part.max = std::min(part.max, (least_radius - cone.radius_a) / widening);
        s = part.min < part.max ? std::clamp(s, part.min, part.max) : 0.5;
    } else {
        s = hit.element == 1 ? 0 : 1;
    }
    const Real radius = cone.radius_a + s * widening;
    const Real distance =
        is_side ? radius : std::min(length(across), std::max(radius - least_radius, Real(0)));

    Surface surface;
    surface.normal = is_side ? side_normal(cone, radial) : (hit.element == 1 ? -1 : 1) / length_of_u * u;
    surface.shading_normal = surface.normal;
    surface.point = cone.a + s * u + distance * radial;
    surface.error = gamma(2) * (glm::abs(cone.a) + glm::abs(surface.point)) + Vec3(slack);
    return surface;
}

Surface surface_at(const OpenCone& open, const Ray& ray, const Hit& hit) {
    return surface_at(open.cone, ray, hit);
}

Bounds bounds_of(const Cone& cone) {
    const Vec3 u = cone.b - cone.a;
    const Bounds a = bounds_of(Disc{cone.a, u, cone.radius_a}), b = bounds_of(Disc{cone.b, u, cone.radius_b});
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

Bounds bounds_of(const OpenCone& open) { return bounds_of(open.cone); }

}  // namespace rt
