// The exact judge of polynomials: Sturm's theorem behind a plain header.
#pragma once

#include "common/math/ray.hpp"

#include <array>

namespace rt::oracle {

/// From the lowest to the highest.
using Coefficients = std::array<Real, 5>;

/// How many different real roots in (range.min, range.max], both finite, the polynomial has to whose value
/// `moved`·Σ|aᵢtⁱ| is added: each coefficient moved by a part `moved` of itself, up or down.
int count_roots(const Coefficients& a, Interval range, Real moved = 0);

/// Whether one of the polynomials whose coefficients are within a part `relative` of a's is positive from
/// range.min to range.max, but perhaps for the ends; or is not positive.
bool can_be_positive(const Coefficients& a, Interval range, Real relative);
bool can_be_not_positive(const Coefficients& a, Interval range, Real relative);

/// |p(t)| / Σ|aᵢtⁱ|, rounded.
Real residual(const Coefficients& a, Real t);

}  // namespace rt::oracle
