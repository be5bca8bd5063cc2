// Real roots of a quadratic polynomial, without cancellation.
#pragma once

#include "common/math/vec.hpp"

namespace rt {

/// Real roots in ascending order; `count` is 0, 1 (a double root, in t0 and t1) or 2.
struct Roots {
    int count = 0;
    Real t0 = 0;
    Real t1 = 0;
};

/// [02.1] Real roots of a·t² + 2·h·t + c = 0, a ≠ 0, given the quarter discriminant h² − a·c.
///
/// The discriminant is an argument, because only the caller, who knows where the coefficients come from,
/// can keep it from cancelling. Negative: no root; zero: one. The roots come from
/// q = −(h + sign(h)·√discriminant) as q/a and c/q, so that nothing cancels
/// (Press et al., Numerical Recipes 2007, §5.6). No NaN for finite input: where q = 0 both roots are 0.
Roots solve_quadratic(Real a, Real h, Real c, Real discriminant);

}  // namespace rt
