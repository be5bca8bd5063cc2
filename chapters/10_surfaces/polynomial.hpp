// Real roots of a polynomial, none of them missed.
// ε is the unit roundoff of `Real`.
#pragma once

#include "chapters/02_spheres/quadratic.hpp"

#include <array>

namespace rt {

/// a[0] + a[1]·t + a[2]·t² + a[3]·t³ + a[4]·t⁴; any of the coefficients may be 0.
struct Polynomial {
    std::array<Real, 5> a{};
};

/// The value of a polynomial at one t, and its slope there.
struct ValueAndSlope {
    Real value = 0;
    Real slope = 0;
};

/// Both by Horner's rule; the value is wrong by 8ε·Σ|aᵢtⁱ| at most. Given.
inline ValueAndSlope evaluate(const Polynomial& p, Real t) {
    ValueAndSlope at{p.a[4], 0};
    for (std::size_t i = 4; i-- > 0;) {
        at.slope = at.slope * t + at.value;
        at.value = at.value * t + p.a[i];
    }
    return at;
}

/// The derivative. Given.
inline Polynomial derivative(const Polynomial& p) {
    return {{p.a[1], 2 * p.a[2], 3 * p.a[3], 4 * p.a[4], 0}};
}

/// The t at which a polynomial changes from positive to not positive, or back, ascending.
struct SignChanges {
    int count = 0;
    std::array<Real, 4> t{};
};

/// The real roots of the second derivative, for which the quadratic formula of chapter 2 is enough. Given.
inline Roots inflections(const Polynomial& p) {
    const Real a = 6 * p.a[4], h = 1.5 * p.a[3], c = p.a[2];
    if (a == 0) return h == 0 ? Roots{} : Roots{1, -c / (2 * h), -c / (2 * h)};
    return solve_quadratic(a, h, c, h * h - a * c);
}

/// [10.7] The t between `low` and `high` at which the polynomial changes its sign, to the last bits:
/// |p(t)| ≤ 16ε·Σ|aᵢtⁱ|. It is positive, by `evaluate`, at one of the two and not at the other; between them
/// it has no other change.
///
/// Newton's steps, as long as they stay between and each is at most half as long as the last one; bisection
/// where not (Press et al., Numerical Recipes 2007, §9.4). So it always ends.
Real root_between(const Polynomial& p, Real low, Real high);

/// [10.8] Every t from `low` to `high`, both finite, low ≤ high, at which the polynomial changes from
/// positive to not positive, or back. At `low` it is positive, or not, as `evaluate` says there. A double
/// root is two changes, or none.
///
/// Between neighbouring roots of its derivative a polynomial is monotone, and so has one root at most; the
/// derivative's roots are found in the same way (Yuksel, High-performance polynomial root finding for
/// graphics, 2022). None is missed and none invented, unless moving each coefficient by 8ε of itself would
/// change their number.
SignChanges sign_changes(const Polynomial& p, Real low, Real high);

}  // namespace rt
