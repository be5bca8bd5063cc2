// Ray differentials: how a ray changes from one pixel to the next.
// The lesson uses the same letters: p for a point on the ray, d for its direction, n for a normal, and dp,
// dd, dn for how these change.
#include "chapters/11_textures/differential.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

RayDifferential camera_differential(const View& view, Real x, Real y) {
    // 11.10  Say how pixel_ray changes with x and with y. In the picture, a grows by the size k of
    // a pixel with each x, and b shrinks by k with each y. In an orthographic view that moves the origin. In
    // perspective it changes g = a·u + b·v − w, and so the unit vector g/|g|.
    return todo("11.10");
}

RayDifferential transferred(const RayDifferential& differential, const Ray& ray, Real t, const Vec3& normal) {
    // 11.10  At the distance t the neighbouring ray has moved by dp + t·dd. That is not on the
    // tangent plane yet: slide it along d until it is perpendicular to the normal. Divide by no cosine that
    // is smaller in size than least_cosine.
    return todo("11.10");
}

NormalChange normal_change(const RayDifferential& at_surface, const Vec3& normal, Real curvature) {
    // 11.11  How does the normal tilt when the point moves by dp? On a sphere by dp/r, if dp is
    // tangential; leave out of dp what is not.
    return todo("11.11");
}

RayDifferential reflected(const RayDifferential& at_surface, const Vec3& d, const Vec3& n,
                          const NormalChange& change) {
    // 11.11  Differentiate d − 2(d·n)n by the product rule: d and n both change. The point of the
    // surface is where the mirrored ray starts, so the origin's change stays.
    return todo("11.11");
}

RayDifferential refracted(const RayDifferential& at_surface, const Vec3& d, const Vec3& n,
                          const NormalChange& change, Real eta) {
    // 11.11  The direction is eta·d + μ·n with μ = eta·cosᵢ − cosₜ, cosᵢ = −d·n and
    // cosₜ² = (1 − eta)(1 + eta) + (eta·cosᵢ)². Differentiate it: d, n and with them μ change. Divide by no
    // cosₜ that is less than least_cosine.
    return todo("11.11");
}

}  // namespace rt
