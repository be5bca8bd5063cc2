// Velvet: fibres that stand up, and shine at the horizon.
// The lesson uses the same letters: l and v for the directions to the light and to the viewer, h for a
// facet's normal, θ for its angle with the z axis, σ for how far the facets lean.
#pragma once

#include "chapters/11_textures/lobe.hpp"
#include "common/math/vec.hpp"

#include <algorithm>
#include <optional>

namespace rt {

/// Cloth of fibres, seen as facets of which most stand upright: nearly black from above, bright at the rim.
struct Velvet {
    Vec3 color{0.5};  ///< what a facet reflects, each channel in [0, 1]
    Real roughness =
        0.5;  ///< σ in (0, 1]: the less, the more upright the facets. Less than 1e-4 counts as that
};

/// σ of a velvet. Given.
inline Real velvet_spread(const Velvet& velvet) { return std::max(velvet.roughness, least_roughness); }

/// [11.20] How many facets have the normal h, per sr, as GGX's density in 11.16:
///   D = exp(−cot²θ/σ²) / (π·σ²·sin⁴θ)
/// (an inverted Gaussian as Ashikhmin, Premože & Shirley's of 2000, normalised as in Cycles). 0 if h.z < 0,
/// and where h is the z axis; never NaN. Right to gamma(16)·(1 + cot²θ/σ²), up to underflow.
Real velvet_density(Real sigma, const Vec3& h);

/// [11.20] Which part of a facet w sees, where facets stand in pairs that lean on each other like the two
/// sides of a V (Torrance & Sparrow 1967): the least of 1 and 2·h.z·w.z/(w·h). h is the facet's normal, and
/// w·h > 0.
Real cavity_g1(const Vec3& w, const Vec3& h);

/// [11.20] The lobe f in 1/sr, without the cosine: color·D(h)·G/(4·l.z·v.z) with h between l and v, where G
/// is the lesser of cavity_g1 of l and of v. 0 if either direction is not above the surface. Right to
/// gamma(64)·(1 + (1 + cotθ/(σ²·sin²θ))/|l + v|²), up to underflow; never NaN.
Vec3 evaluate(const Velvet& velvet, const Vec3& to_light, const Vec3& to_viewer);

/// [11.20] The density of sample's directions per sr: D(h)·cavity_g1(v, h)/(4·v.z). As right as evaluate; 0
/// if either direction is not above the surface.
Real pdf(const Velvet& velvet, const Vec3& to_light, const Vec3& to_viewer);

/// [11.21] Light mirrored to the viewer by a facet that he sees (Heitz & d'Eon 2014): of a facet drawn with
/// the density D·h.z, and of its partner (−h.x, −h.y, h.z), one with probabilities as max(0, v·h) of the two.
/// The weight is color·G/cavity_g1(v, h), which is at most 1. Nothing if the viewer is not above the surface,
/// or if the light would have to come from below.
std::optional<LobeSample> sample(const Velvet& velvet, const Vec3& to_viewer, const Vec3& random);

}  // namespace rt
