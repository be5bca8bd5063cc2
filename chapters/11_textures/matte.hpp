// Matte surfaces: Lambert's, and rough ones, which look flatter.
// The lesson uses the same letters: l and v for the directions to the light and to the viewer, s for the dot
// product of their parts along the surface, σ for the roughness.
#pragma once

#include "chapters/11_textures/lobe.hpp"
#include "common/math/vec.hpp"

#include <optional>

namespace rt {

/// A matte surface. Of the light that comes from near the horizon it returns `color`, of other light a little
/// less if it is rough, and never more.
struct Matte {
    Vec3 color{0.5};     ///< each channel in [0, 1]
    Real roughness = 0;  ///< σ in [0, 1]: 0 is Lambert's surface, which is equally bright from everywhere
};

/// [11.15] The lobe f in 1/sr, without the cosine: Oren & Nayar's in the form of Fujii (2012),
///   f = color · (1 + σ·t) / (π + σ·(3π − 4)/6),
/// t = s where s ≤ 0, and s/max(l.z, v.z) where s > 0, with s = l.x·v.x + l.y·v.y.
/// Never negative, finite where l.z or v.z is a normal number; 0 if either direction is not above the
/// surface. t is right to gamma(8)/max(l.z, v.z).
Vec3 evaluate(const Matte& matte, const Vec3& to_light, const Vec3& to_viewer);

/// [11.15] For comparison, the lobe of a white surface by the 'qualitative model' of Oren & Nayar (1994):
///   f = (A + B · max(0, cos Δφ) · sin α · tan β) / π,
/// A = 1 − ½σ²/(σ² + 0.33), B = 0.45σ²/(σ² + 0.09). α is the greater and β the smaller of the angles from the
/// normal to l and v, and Δφ the angle between l and v as seen from above. `sigma` in radians is the standard
/// deviation of the slopes' angles. Directions and accuracy as in evaluate.
Real oren_nayar_1994(Real sigma, const Vec3& to_light, const Vec3& to_viewer);

/// [11.15] A unit vector above the surface, with the density z/π per sr: a point of the unit disc at the
/// distance √a from the middle and the angle 2π·b, lifted onto the hemisphere (Malley 1988). a, b in [0, 1).
/// z is positive, and right even where a is nearly 1.
Vec3 cosine_direction(Real a, Real b);

/// [11.15] The density of sample's directions per sr: l.z/π; 0 if either direction is not above the surface.
Real pdf(const Matte& matte, const Vec3& to_light, const Vec3& to_viewer);

/// [11.15] A cosine_direction by random.x and random.y. Nothing if the viewer is not above the surface.
std::optional<LobeSample> sample(const Matte& matte, const Vec3& to_viewer, const Vec3& random);

}  // namespace rt
