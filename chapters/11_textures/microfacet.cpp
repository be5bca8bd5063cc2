// Microfacets: a rough surface as many small mirrors whose normals are spread around the surface's.
#include "chapters/11_textures/microfacet.hpp"

#include "chapters/07_recursion/optics.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// What a facet of metal reflects of light that meets it at this cosine, a channel (Schlick 1994). Given.
[[maybe_unused]] Vec3 metal_fresnel(const Vec3& color, Real cosine) {
    const Real m = std::clamp(1 - cosine, Real(0), Real(1));
    return color + (Vec3(1) - color) * (m * m * m * m * m);
}

}  // namespace

Real ggx_density(Real alpha, const Vec3& h) {
    // 11.14  D. The sine is in h.x and h.y: 1 − h.z² would have lost it where it is small.
    return todo("11.14");
}

Real smith_g1(Real alpha, const Vec3& w) {
    // 11.14  The part of the facets turned to w that w can see.
    return todo("11.14");
}

Vec3 visible_normal(Real alpha, const Vec3& v, Real a, Real b) {
    // 11.14  Heitz's method: squeeze the facets by α along the surface and they are those of a
    // hemisphere, seen from v squeezed in the same way. A point of its outline is on a half disc towards the
    // viewer and a half ellipse; the normal there, squeezed again, is the answer.
    return todo("11.14");
}

Vec3 evaluate(const RoughMetal& metal, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.14  F·D·G₁(l)·G₁(v)/(4·l.z·v.z), with the facet's normal halfway between l and v.
    return todo("11.14");
}

Real pdf(const RoughMetal& metal, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.14  The density of the facet's normal, G₁(v)·(v·h)·D(h)/v.z, and 1/(4·v·h), because
    // directions mirrored by facets are spread more widely than the facets' normals.
    return todo("11.14");
}

std::optional<LobeSample> sample(const RoughMetal& metal, const Vec3& to_viewer, const Vec3& random) {
    // 11.14  A facet that the viewer sees, and the light that it mirrors to him. Of f·cos/pdf there
    // remains F·G₁(l).
    return todo("11.14");
}

}  // namespace rt
