// A point moved onto f = 0 in a box, the surface around it, and how wrong it may be: given.
#pragma once

#include "chapters/10_surfaces/chord.hpp"
#include "common/math/error.hpp"

#include <algorithm>

namespace rt {

/// A point where f is nearly 0, moved along its gradient by a few steps of Newton's until f is 0 but for
/// rounding; not where that leads away.
template <class ValueAt, class GradientAt>
Vec3 polished(Vec3 p, const Box& box, int steps, const ValueAt& value_at, const GradientAt& gradient_at) {
    const Real near = 0x1p-20 * size_of(box.high - box.low);
    for (int i = 0; i < steps; ++i) {
        const Vec3 g = gradient_at(p), step = -value_at(p) / dot(g, g) * g;
        if (!(size_of(step) <= near)) break;
        p += step;
    }
    return p;
}

/// The least distance from `least` to `most`, doubled again and again, from which on both sides of the normal
/// are sure; or if that is not soon after the ray's own side is, the least for that one; 0 if there is none.
/// `side_of` as for `surface_around`.
template <class SideOf>
Real sure_distance(const Vec3& n, bool comes_from_outside, const SideOf& side_of, Real least, Real most) {
    constexpr Real soon = 64;
    Real own = 0;
    for (Real e = least; e < most && (own == 0 || e < soon * own); e *= 2) {
        const bool out = side_of(n, e, 2 * e) > 0, in = side_of(n, -2 * e, -e) < 0;
        if (out && in) return e;
        if (own == 0 && (comes_from_outside ? out : in)) own = e;
    }
    return own;
}

/// The surface around the point p. side_of(n, low, high) is the side of the surface on which the points from
/// p + low·n to p + high·n surely are: −1 inside, 1 outside, 0 where that is open.
///
/// The normal is along the gradient, or where that is 0 or leads nowhere, along the ray, to where the ray is
/// outside. The error is found by trying: from there on, up to twice as far, one is surely outside along the
/// normal and surely inside on the other side. Where the solid or the gap is thinner than that, only the side
/// that the ray comes from is sure. Where the box is thinner than 4e-12 of its distance from the origin, no
/// distance is tried, and the normal is along the ray, too.
template <class SideOf>
Surface surface_around(const Vec3& p, const Vec3& gradient, const Ray& ray, const Box& box,
                       const SideOf& side_of) {
    // The next ray's chord begins beside its origin by as much as the first.
    const Real least = gamma(8) * std::max(size_of(box.low), size_of(box.high));
    const Real most = 0x1p-12 * size_of(box.high - box.low);
    const Vec3 back = -unit(ray.direction);
    Surface surface;
    surface.point = p;
    surface.normal = size_of(gradient) > 0 && size_of(gradient) < infinity ? unit(gradient) : back;
    Real e = sure_distance(surface.normal, dot(surface.normal, back) >= 0, side_of, least, most);
    if (e == 0) {
        const bool comes_from_outside = side_of(back, most, 2 * most) >= 0;
        surface.normal = comes_from_outside ? back : -back;
        e = sure_distance(surface.normal, comes_from_outside, side_of, least, most);
    }
    surface.shading_normal = surface.normal;
    surface.error = Vec3(e > 0 ? e : most);
    return surface;
}

}  // namespace rt
