// Families of extreme cases for chapter 7, their judges, and the textbook methods that break on them.
// u is the unit roundoff 2^-53; c and s are the cosine and sine of the angle of incidence, cosₜ the cosine of
// the refracted one. Each judge writes its condition number κ down.
#pragma once

#include "common/math/vec.hpp"
#include "tests/stability/verdict.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rt::stability {

/// A ray of direction d meets a surface with the normal n; both are unit vectors to rounding, d·n ≤ 0, and
/// eta = ior before / ior behind the surface.
struct InterfaceCase {
    Vec3 d{0, 0, -1}, n{0, 0, 1};
    Real eta = 1;
};

struct InterfaceFamily {
    const char* name;
    const char* condition;  ///< what κ of refraction is like here
    std::vector<InterfaceCase> (*make)(std::size_t count, std::uint64_t seed);
};

/// All the families; any prefix of a family's cases is the same for every count.
std::span<const InterfaceFamily> interface_families();

/// Judges `refract`: refracted or total right outside a band of 4 ulp of the data; the direction of unit
/// length within 4u and off by at most 8κu, κ = 1 + eta·c/cosₜ: how far the refracted ray turns when d turns;
/// cosₜ is the mean of those for d and for d turned by 4 ulp, because next to the band it changes by much of
/// itself in between. eta is exact. In the band both answers are right, but never NaN.
Verdict judge_refraction(std::span<const InterfaceCase> cases, std::span<const std::optional<Vec3>> answers);

/// Judges refraction there and back, `back` being refract(−t, −n, 1/eta) of each refracted t: −d again, to
/// 8κu with κ = 2·(1 + cosₜ/(eta·c)), the κ of the way there as the way back passes it on and that of the way
/// back itself; and twice what the rounding of 1/eta does. Total reflections are left out; where the way back
/// is critical itself nothing is right too.
Verdict judge_way_back(std::span<const InterfaceCase> cases, std::span<const std::optional<Vec3>> there,
                       std::span<const std::optional<Vec3>> back);

/// The arguments of `fresnel`.
struct CosineCase {
    Real cos_i = 1, eta = 1;
};

/// The same families as cosines, and exact ends: cosines 0 and 1.
std::vector<CosineCase> cosine_cases(const InterfaceFamily& family, std::size_t count, std::uint64_t seed);

/// Judges `fresnel` against the formulas in 64 bits of mantissa: off by at most 8κu, κ = 1 + |dR/dx|·(1 +
/// (eta·c/cosₜ)²), x being the ratio of the two terms of an amplitude, for cosines and ratios off by u; 1
/// where reflection is total.
Verdict judge_reflectance(std::span<const CosineCase> cases, std::span<const Real> answers);

/// Judges R + T = 1 ± 4κu, with T from the transmitted amplitudes (not from R) and κ as above: R is right to
/// four roundings of each of its steps.
Verdict judge_energy(std::span<const CosineCase> cases, std::span<const Real> answers);

}  // namespace rt::stability

namespace rt::naive {

/// Takes the root first and asks afterwards: total reflection comes out as NaN.
std::optional<Vec3> refract_root_first(const Vec3& d, const Vec3& n, Real eta);

/// Asks first, but computes cosₜ² as 1 − eta²·(1 − c²), which cancels between nearly equal media.
std::optional<Vec3> refract_cancelling(const Vec3& d, const Vec3& n, Real eta);

/// Fresnel's formulas with the root first: NaN where reflection is total.
Real fresnel_root_first(Real cos_i, Real eta);

/// Fresnel's formulas with the cosₜ² that cancels.
Real fresnel_cancelling(Real cos_i, Real eta);

}  // namespace rt::naive
