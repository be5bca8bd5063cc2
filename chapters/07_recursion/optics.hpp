// Optics of a smooth surface: where light goes, and how much of it.
#pragma once

#include "common/math/vec.hpp"

#include <optional>

namespace rt {

/// [07.1] Mirror direction d − 2(d·n)n. n: unit; d: any length, which is kept.
Vec3 reflect(const Vec3& d, const Vec3& n);

/// [07.2] Refracted unit direction by Snell's law, or nothing where reflection is total.
///
/// d: unit, towards the surface; n: unit, against d (d·n ≤ 0); `eta` = ior before / ior behind the surface.
/// The sign of 1 − eta²·sin² is looked at before its root is taken, so no NaN ever appears; at the critical
/// angle the direction lies in the surface. Within a few roundings of that angle either answer is right.
std::optional<Vec3> refract(const Vec3& d, const Vec3& n, Real eta);

/// [07.3] Reflected part R of unpolarised light at a dielectric, exactly (Fresnel 1823); the transmitted
/// part is 1 − R. `cos_i` = |d·n| in [0, 1]; eta as in refract. 1 where reflection is total and where
/// grazing. Right to about four roundings of each step, however cosₜ² is associated.
Real fresnel(Real cos_i, Real eta);

/// [07.3] The same by Schlick's approximation F0 + (1 − F0)(1 − cos)⁵ (1994). The cosine is that on the
/// side of the lower index: for eta > 1 the transmitted angle's.
Real schlick(Real cos_i, Real eta);

/// [07.4] Part of the light left after `distance` in a medium: exp(−absorption · distance) a channel
/// (Bouguer 1729, Lambert 1760, Beer 1852). distance ≥ 0; no NaN for infinite distance: 1 where absorption is
/// 0, else 0.
Vec3 transmitted(const Vec3& absorption, Real distance);

/// Wavelengths in nanometres that stand for red, green and blue.
inline constexpr Vec3 wavelengths(630, 532, 465);

/// [07.7] The part of unpolarised light that a thin film in air mirrors, in red, green and blue.
///
/// `cos_i` from 1e-6 to 1; `ior` ≥ 1, of the film; `thickness` ≥ 0, in nanometres. Light is a wave: what is
/// mirrored at the front and what comes back from inside, after any number of reflections there, meet with
/// their phases (Airy 1833). From front to back and forth again the phase grows by 2·2π·ior·thickness·cosₜ/λ.
Vec3 soap_film(Real cos_i, Real ior, Real thickness);

}  // namespace rt
