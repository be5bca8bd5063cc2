// Rough glass: facets that mirror a part of the light and let the rest through.
// The lesson uses the same letters: l and v for the directions to the light and to the viewer, h for a
// facet's normal, n for indices of refraction.
// ε is the unit roundoff of `Real`.
#pragma once

#include "chapters/11_textures/lobe.hpp"
#include "common/math/vec.hpp"

#include <optional>

namespace rt {

/// The surface of a body of glass whose facets are spread as those of rough metal (11.16). The body is below:
/// where z > 0 the index of refraction is 1, where z < 0 it is `ior`. Light and viewer may be on either side.
///
/// Radiance is not scaled by n² at the surface, as in all of the course: what is passed on is radiance/n².
/// So f(l, v)/n² of l's side is f(v, l)/n² of v's side, and the sum of f·|cos| over all l is at most 1.
struct RoughGlass {
    Vec3 color{1};         ///< what light keeps, mirrored or let through, each channel in [0, 1]
    Real roughness = 0.3;  ///< in [0, 1]; α is its square
    Real ior = 1.5;        ///< in [1.01, 4]
};

/// [11.18] The normal, with h.z > 0, of the facet that brings light from l to v: along l + v if it mirrors;
/// if it lets through, against n_l·l + n_v·v, with the indices of the sides on which l and v are. Nothing if
/// there is none: if l or v lies in the surface, or is on another side of the facet than of the surface.
std::optional<Vec3> glass_facet(const RoughGlass& glass, const Vec3& to_light, const Vec3& to_viewer);

/// [11.18] The density of sample's directions per sr (Walter and others 2007, with visible facets):
///   D(h)·G₁(v)/|v.z| · F/4                                       where l and v are on the same side,
///   D(h)·G₁(v)/|v.z| · (1 − F)·n_l²·|l·h|·|v·h|/|n_l·l + n_v·v|²   where they are not.
/// F is Fresnel's reflected part at the facet, exactly (07.3); G₁ of a direction below is that of the one
/// that is as far above. 0 if there is no facet; never NaN.
///
/// Right to gamma(64) + 64ε/(α·s·c²), where s is |l + v| or |n_l·l + n_v·v|, and c² the least of the squares
/// of the cosines before and behind the facet, as Snell's law has them: near the critical angle rounding
/// decides.
Real pdf(const RoughGlass& glass, const Vec3& to_light, const Vec3& to_viewer);

/// [11.18] The lobe f in 1/sr, without the cosine: color · pdf · G₁(l)/|l.z|. As right as pdf.
Vec3 evaluate(const RoughGlass& glass, const Vec3& to_light, const Vec3& to_viewer);

/// [11.19] Light that a visible_normal of random.x and random.y mirrors to the viewer, if random.z is less
/// than F, or else lets through. The weight is color·G₁(l). Nothing where the facet sends the light to the
/// other side than it should: what met a second facet is lost.
std::optional<LobeSample> sample(const RoughGlass& glass, const Vec3& to_viewer, const Vec3& random);

}  // namespace rt
