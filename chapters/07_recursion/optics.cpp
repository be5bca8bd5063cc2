// Optics of a smooth surface: where light goes, and how much of it.
#include "chapters/07_recursion/optics.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// cosₜ² by Snell's law, negative where reflection is total.
[[maybe_unused]] Real refracted_cosine_squared(Real cos_i, Real eta) {
    // 07.2  Snell's law says sinₜ = eta·sinᵢ, so cosₜ² = 1 − eta²·(1 − cosᵢ²). Return that in the
    // form (1 − eta)·(1 + eta) + (eta·cosᵢ)², in which the large terms have cancelled on paper already.
    return todo("07.2");
}

}  // namespace

Vec3 reflect(const Vec3& d, const Vec3& n) {
    // 07.1  Turn the part of d along n around: d − 2(d·n)n.
    return todo("07.1");
}

std::optional<Vec3> refract(const Vec3& d, const Vec3& n, Real eta) {
    // 07.2  cosᵢ = −d·n; the function above gives cosₜ². Negative: reflection is total, return
    // nothing. Only then take the root. The direction is eta·d + (eta·cosᵢ − cosₜ)·n, made a unit vector.
    return todo("07.2");
}

Real fresnel(Real cos_i, Real eta) {
    // 07.3  With cosₜ from Snell's law (where it does not exist, 1 is reflected), the amplitudes
    // are r∥ = (cosᵢ − eta·cosₜ)/(cosᵢ + eta·cosₜ) and r⊥ = (eta·cosᵢ − cosₜ)/(eta·cosᵢ + cosₜ), and of
    // unpolarised light the part (r∥² + r⊥²)/2 is reflected. Where cosᵢ is 0, all of it is. Compute
    // |a − b|/(a + b) as 1 − 2·min(a, b)/(a + b): near 1 only one rounding counts then.
    return todo("07.3");
}

Real schlick(Real cos_i, Real eta) {
    // 07.3  F0 = ((1 − eta)/(1 + eta))², and R = F0 + (1 − F0)·(1 − cos)⁵. The cosine is cosᵢ, but
    // for eta > 1 it is cosₜ (and 1 is reflected where that does not exist).
    return todo("07.3");
}

Vec3 transmitted(const Vec3& absorption, Real distance) {
    // 07.4  exp(−absorption · distance) in each channel; 1 where the absorption is 0, also for an
    // infinite distance, where 0·∞ would be NaN.
    return todo("07.4");
}

}  // namespace rt
