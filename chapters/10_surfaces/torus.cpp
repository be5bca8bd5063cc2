// The torus: a tube whose middle is a ring.
// The lesson uses the same letters: n for the axis, q for where the line is nearest to the centre, e for its
// direction, τ for the way along it from q, R for the ring's radius and r for the tube's.
#include "chapters/10_surfaces/torus.hpp"

#include "chapters/10_surfaces/disc.hpp"
#include "common/math/error.hpp"
#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

std::optional<TorusLine> torus_line(const Torus& torus, const Ray& ray) {
    const Vec3& d = ray.direction;
    const Real reach = torus.ring + torus.tube, d2 = dot(d, d);
    const Vec3 f = ray.origin - torus.center;
    TorusLine line;
    line.from = -dot(f, d) / d2;
    line.q = f + line.from * d;
    if (dot(line.q, line.q) > reach * reach) return std::nullopt;  // most lines pass most tori
    line.speed = std::sqrt(d2);
    line.e = d / line.speed;
    line.n = normalize(torus.axis);
    // The way from the eye, and so its error, may be much longer than what is left of it.
    const Real left = dot(line.q, line.e);
    line.q -= left * line.e;
    line.from -= left / line.speed;
    return line;
}

namespace {

/// Whether the ring is so wide that the surface is far from the axis.
[[maybe_unused]] bool is_wide(const Torus& torus) { return torus.ring >= 2 * torus.tube; }

}  // namespace

Polynomial torus_quartic(const Torus& torus, const TorusLine& line, Real base) {
    // 10.9  Return Q² − P as its five coefficients in σ, in the form that suits the torus.
    return todo("10.9");
}

namespace {

/// Adds the part from `enter` to `leave`, which is not before the last one; if it touches that, it goes on
/// with it.
[[maybe_unused]] void add(TorusSpans& inside, Real enter, Real leave) {
    // A line has no more than two; what rounding may add to them belongs to the second.
    const bool touches =
        inside.count > 0 && enter <= inside.spans[static_cast<std::size_t>(inside.count) - 1].leave;
    if (!touches && inside.count < 2)
        inside.spans[static_cast<std::size_t>(inside.count++)] = {enter, leave};
    else
        inside.spans[static_cast<std::size_t>(inside.count) - 1].leave = leave;
}

/// Adds what is inside between two τ, if low ≤ high, by the quartic from `base`: where that is not positive.
[[maybe_unused]] void add_piece(TorusSpans& inside, const Torus& torus, const TorusLine& line, Real base,
                                Real low, Real high) {
    if (!(low <= high)) return;
    const Polynomial quartic = torus_quartic(torus, line, base);
    const SignChanges changes = sign_changes(quartic, low - base, high - base);
    bool is_inside = !(evaluate(quartic, low - base).value > 0);
    Real enter = low;
    for (int i = 0; i < changes.count; ++i) {
        const Real tau = base + changes.t[static_cast<std::size_t>(i)];
        if (is_inside) add(inside, enter, tau);
        is_inside = !is_inside;
        enter = tau;
    }
    if (is_inside) add(inside, enter, high);
}

}  // namespace

TorusSpans inside(const Torus& torus, const Ray& ray) {
    TorusSpans spans;
    const std::optional<TorusLine> line = torus_line(torus, ray);
    if (!line) return spans;
    // 10.10  Return the parts of the line that are inside, in the ray's t. Look only at what is in
    // the ball |x| ≤ R + r and between the planes |z| = r, and leave out the ball about the centre that is
    // known to be outside or inside. `add_piece` and `add` collect the parts.
    return todo("10.10");
}

std::optional<Hit> intersect(const Torus& torus, const Ray& ray, Interval range) {
    const TorusSpans spans = inside(torus, ray);
    for (int i = 0; i < spans.count; ++i)
        if (const std::optional<Hit> hit = first_hit(spans.spans[static_cast<std::size_t>(i)], range))
            return hit;
    return std::nullopt;
}

Surface surface_at(const Torus& torus, const Ray& ray, const Hit& hit) {
    const Real R = torus.ring, r = torus.tube;
    const Vec3 n = normalize(torus.axis);
    // What the next ray, which starts here, may get wrong about its distance from the surface: η of `inside`,
    // with |f| no longer than R + r and a little.
    const Real slack = gamma(64) * (R + r);

    // From the centre to the hit, along the axis and across it; once more, because the way there may be much
    // longer than what is left of it.
    const Vec3 way = (ray.origin - torus.center) + hit.t * ray.direction;
    const Real z = dot(way, n);
    Vec3 across = way - z * n;
    across -= dot(across, n) * n;
    // On the axis itself any direction is as good as another.
    if (across == Vec3(0)) across = any_across(n);
    const Vec3 radial = normalize(near_one(across));

    // From the ring to the hit, and there onto the tube. On the ring itself, where the tube is thinner than
    // rounding, any direction is as good as another.
    Vec2 out(length(across) - R, z);
    if (out == Vec2(0)) out = Vec2(1, 0);
    out *= r / std::hypot(out.x, out.y);

    // Near the axis a step away from one side of the hole may lead into the other: there the point is moved
    // along the surface, until the hole is wide enough.
    const Real least = 4 * (slack + gamma(4) * size_of(torus.center));
    if (R + out.x < least) {
        out.x = std::min(least - R, r);
        out.y = std::copysign(std::sqrt((r - out.x) * (r + out.x)), out.y);
    }

    Surface surface;
    surface.normal = (out.x * radial + out.y * n) / r;
    surface.shading_normal = surface.normal;
    surface.point = torus.center + (R + out.x) * radial + out.y * n;
    surface.error = gamma(2) * (glm::abs(torus.center) + glm::abs(surface.point)) + Vec3(slack);
    return surface;
}

Bounds bounds_of(const Torus& torus) {
    const Bounds ring = bounds_of(Disc{torus.center, torus.axis, torus.ring});
    return {ring.low - torus.tube, ring.high + torus.tube};
}

}  // namespace rt
