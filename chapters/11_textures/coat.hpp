// Paint under a smooth clear coat: part of the light is mirrored, the rest goes through twice.
// The lesson uses the same letters: l and v for the directions to the light and to the viewer, F for
// Fresnel's reflected part, n for the index of refraction of the coat, T for the part that passes.
// ε is the unit roundoff of `Real`.
#pragma once

#include "chapters/11_textures/lobe.hpp"
#include "common/math/vec.hpp"

#include <optional>

namespace rt {

/// A matte ground under a smooth, clear coat without thickness. The coat is a mirror, too: that is an
/// endlessly narrow lobe, which `sample` draws and of which `evaluate` and `pdf` know nothing.
struct Coated {
    Vec3 color{0.5};  ///< what the ground reflects without a coat, each channel in [0, 1]
    Real ior = 1.5;   ///< index of refraction of the coat, in [1, 4]; 1 is no coat
};

/// What a surface of that index of refraction, in [1, 4], mirrors of light that comes evenly from all sides
/// outside: 2∫F·cosθ d(cosθ) (closed form of Walsh 1926; see Duntley 1942). Right to 1e-7. Given.
Real mean_fresnel(Real ior);

/// [11.22] What the coat mirrors back inside, of light that comes evenly from all sides of the ground:
/// 1 − (1 − mean_fresnel)/n². In [0, 1).
Real inner_reflectance(Real ior);

/// [11.22] The ground's lobe in 1/sr, without the cosine and without the mirror (Wolff 1994):
///   f = T(l)·T(v)·color / (π·n²·(1 − color·inner_reflectance)),  T(w) = 1 − F(w.z),
/// a channel. 0 if either direction is not above the surface. Right to 64ε·(1 + f), and what mean_fresnel is.
Vec3 evaluate(const Coated& coated, const Vec3& to_light, const Vec3& to_viewer);

/// [11.22] The density of sample's directions per sr, without the mirror's: T(v)·l.z/π; 0 if either direction
/// is not above the surface.
Real pdf(const Coated& coated, const Vec3& to_light, const Vec3& to_viewer);

/// [11.22] With probability F(v.z), where random.z is less, the mirror's direction, with weight 1 and
/// infinite pdf; otherwise a cosine_direction by random.x and random.y for the ground, with weight f·cos/pdf.
/// Nothing if the viewer is not above the surface.
std::optional<LobeSample> sample(const Coated& coated, const Vec3& to_viewer, const Vec3& random);

}  // namespace rt
