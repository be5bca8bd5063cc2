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
    // 11.16  Return D, with all its digits also where θ is tiny.
    return todo("11.16");
}

Real smith_g1(Real alpha, const Vec3& w) {
    // 11.16  Which part of the facets turned to w can w see?
    return todo("11.16");
}

Vec3 visible_normal(Real alpha, const Vec3& v, Real a, Real b) {
    // 11.17  Return a facet that is seen from v, by Heitz's method.
    return todo("11.17");
}

Vec3 evaluate(const RoughMetal& metal, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.16  Return the lobe of rough metal, or 0 if one of the directions is not above the
    // surface.
    return todo("11.16");
}

Real pdf(const RoughMetal& metal, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.16  Return the density of directions that visible facets mirror to v; 0 as in evaluate.
    return todo("11.16");
}

std::optional<LobeSample> sample(const RoughMetal& metal, const Vec3& to_viewer, const Vec3& random) {
    // 11.17  Draw a facet that the viewer sees, and return the light that it mirrors there. What
    // is left of f·cos/pdf?
    return todo("11.17");
}

}  // namespace rt
