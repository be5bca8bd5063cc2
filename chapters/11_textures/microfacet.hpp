// Microfacets: a rough surface as many small mirrors whose normals are spread around the surface's.
// The lesson uses the same letters: l and v for the directions to the light and to the viewer, h for a
// facet's normal, α for how widely the facets' normals are spread.
// ε is the unit roundoff of `Real`.
#pragma once

#include "chapters/11_textures/lobe.hpp"
#include "common/math/vec.hpp"

#include <algorithm>
#include <optional>

namespace rt {

/// α of a roughness: its square, as it is usual (Burley 2012), of no less than least_roughness. Given.
inline Real ggx_alpha(Real roughness) {
    const Real r = std::max(roughness, least_roughness);
    return r * r;
}

/// [11.16] How many facets have the normal h, per sr: their area as a part of the surface's (GGX, Walter and
/// others 2007; Trowbridge & Reitz 1975),
///   D = α² / (π · (α²·cos²θ + sin²θ)²),  θ the angle between h and the z axis; 0 if h.z ≤ 0.
/// h: unit. sin²θ is taken from h.x and h.y: D is right to gamma(16), however small α is. alpha in [1e-8, 1].
Real ggx_density(Real alpha, const Vec3& h);

/// [11.16] Which part of the facets that are turned to w is not hidden behind others (Smith 1967, for GGX):
///   G₁ = 2·cosθ / (cosθ + √(cos²θ + α²·sin²θ)),  θ the angle between w and the z axis; 0 if w.z ≤ 0.
/// Right to gamma(12).
Real smith_g1(Real alpha, const Vec3& w);

/// [11.17] The normal of a facet that is seen from v, v.z > 0, by two random numbers in [0, 1): with the
/// density G₁(v)·max(0, v·h)·D(h)/v.z per sr (Heitz 2018). Unit, h.z ≥ 0 and v·h ≥ 0, all up to rounding.
/// Which numbers give which facet is left open.
Vec3 visible_normal(Real alpha, const Vec3& v, Real a, Real b);

/// Metal whose surface is rough.
struct RoughMetal {
    Vec3 color{0.9};       ///< what it reflects where light meets a facet straight, in [0, 1]
    Real roughness = 0.3;  ///< in [0, 1]; α is its square
};

/// [11.16] The lobe f in 1/sr, without the cosine: F·D(h)·G₁(l)·G₁(v)/(4·l.z·v.z), with h between l and v,
/// and F = color + (1 − color)·(1 − l·h)⁵ (Schlick 1994). Light that met a second facet is left out. Never
/// negative, finite for cosines of 1e-8 and more; 0 if either direction is not above the surface.
/// Right to gamma(32) + 16ε/(α·|l + v|), as a part of white metal's lobe: rounding turns h by some ε/|l + v|,
/// of which D feels the α-th part.
Vec3 evaluate(const RoughMetal& metal, const Vec3& to_light, const Vec3& to_viewer);

/// [11.16] The density of sample's directions per sr: G₁(v)·D(h)/(4·v.z). As right as evaluate; 0 if either
/// direction is not above the surface.
Real pdf(const RoughMetal& metal, const Vec3& to_light, const Vec3& to_viewer);

/// [11.17] Light mirrored to the viewer by a visible_normal of random.x and random.y. The weight is F·G₁(l),
/// which is at most 1. Nothing if the viewer is not above the surface, or if the light would have to come
/// from below: what met a second facet is lost.
std::optional<LobeSample> sample(const RoughMetal& metal, const Vec3& to_viewer, const Vec3& random);

}  // namespace rt
