// Microfacets: a rough surface as many small mirrors whose normals are spread around the surface's.
#include "chapters/11_textures/microfacet.hpp"

#include "chapters/07_recursion/optics.hpp"

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
    // [exercise 11.16] Return D, with all its digits also where θ is tiny.
    if (!(h.z > 0)) return 0;
    // The sine is in h.x and h.y: 1 − h.z² would have lost it where it is small.
    const Real spread = alpha * alpha * h.z * h.z + (h.x * h.x + h.y * h.y);
    // In this order α²/spread² does not leave the range of numbers.
    const Real ratio = alpha / spread;
    return ratio * ratio / pi;
    // [/exercise]
}

Real smith_g1(Real alpha, const Vec3& w) {
    // [exercise 11.16] Which part of the facets turned to w can w see?
    if (!(w.z > 0)) return 0;
    return 2 * w.z / (w.z + std::hypot(w.z, alpha * std::hypot(w.x, w.y)));
    // [/exercise]
}

Vec3 visible_normal(Real alpha, const Vec3& v, Real a, Real b) {
    // [exercise 11.17] Return a facet that is seen from v, by Heitz's method.
    const Vec3 seen = normalize(Vec3(alpha * v.x, alpha * v.y, v.z));
    const Real flat = std::hypot(seen.x, seen.y);
    const Vec3 across = flat > 0 ? Vec3(-seen.y, seen.x, 0) / flat : Vec3(1, 0, 0);
    const Vec3 along = cross(seen, across);
    const Real r = std::sqrt(a), phi = 2 * pi * b, s = (1 + seen.z) / 2;
    const Real p = r * std::cos(phi);
    const Real q = (1 - s) * std::sqrt(1 - p * p) + s * r * std::sin(phi);
    const Real toward = std::sqrt(std::max(1 - p * p - q * q, Real(0)));
    const Vec3 n = p * across + q * along + toward * seen;
    return normalize(Vec3(alpha * n.x, alpha * n.y, std::max(n.z, Real(0))));
    // [/exercise]
}

Vec3 evaluate(const RoughMetal& metal, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 11.16] Return the lobe of rough metal, or 0 if one of the directions is not above the
    // surface.
    if (!(to_light.z > 0) || !(to_viewer.z > 0)) return Vec3(0);
    const Real alpha = ggx_alpha(metal.roughness);
    const Vec3 h = normalize(to_light + to_viewer);
    const Real seen = smith_g1(alpha, to_light) / to_light.z * (smith_g1(alpha, to_viewer) / to_viewer.z);
    return metal_fresnel(metal.color, dot(to_light, h)) * (ggx_density(alpha, h) * seen / 4);
    // [/exercise]
}

Real pdf(const RoughMetal& metal, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 11.16] Return the density of directions that visible facets mirror to v; 0 as in evaluate.
    if (!(to_light.z > 0) || !(to_viewer.z > 0)) return 0;
    const Real alpha = ggx_alpha(metal.roughness);
    const Vec3 h = normalize(to_light + to_viewer);
    return smith_g1(alpha, to_viewer) / to_viewer.z * ggx_density(alpha, h) / 4;
    // [/exercise]
}

std::optional<LobeSample> sample(const RoughMetal& metal, const Vec3& to_viewer, const Vec3& random) {
    // [exercise 11.17] Draw a facet that the viewer sees, and return the light that it mirrors there. What
    // is left of f·cos/pdf?
    if (!(to_viewer.z > 0)) return std::nullopt;
    const Real alpha = ggx_alpha(metal.roughness);
    const Vec3 h = visible_normal(alpha, to_viewer, random.x, random.y);
    const Vec3 to_light = normalize(reflect(-to_viewer, h));
    if (!(to_light.z > 0)) return std::nullopt;
    const Vec3 weight = metal_fresnel(metal.color, dot(to_light, h)) * smith_g1(alpha, to_light);
    return LobeSample{to_light, weight, pdf(metal, to_light, to_viewer)};
    // [/exercise]
}

}  // namespace rt
