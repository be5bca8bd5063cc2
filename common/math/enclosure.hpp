// Interval arithmetic: numbers that are known only to lie between two others, and what can be computed with
// them for certain (Moore 1966).
#pragma once

#include "common/math/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt {

/// All numbers from `low` to `high`; both may be infinite. Where there is no number at all, as of the square
/// root of negative ones, both are NaN.
///
/// A function of enclosures encloses its values at all the numbers that they enclose; if it has none at some
/// of them, such as 1/x at 0, everything, and so does all that is computed from that. Each end is rounded
/// outward.
struct Enclosure {
    Real low, high;
};

inline constexpr Enclosure everything_between{-infinity, infinity};
inline constexpr Enclosure nothing_between{std::numeric_limits<Real>::quiet_NaN(),
                                           std::numeric_limits<Real>::quiet_NaN()};

constexpr bool is_empty(const Enclosure& a) { return a.low != a.low; }

/// Perhaps because there is no number in some places: a sine of that must not pretend to know better.
constexpr bool is_everything(const Enclosure& a) { return a.low == -infinity && a.high == infinity; }

/// Whether x may be the number; false where there is none.
constexpr bool contains(const Enclosure& a, Real x) { return a.low <= x && x <= a.high; }

inline Real width_of(const Enclosure& a) { return a.high - a.low; }

/// −1 or 1 where all the numbers are negative or positive; 0 where that is open, or where there are none.
constexpr int sign_of(const Enclosure& a) { return a.high < 0 ? -1 : a.low > 0 ? 1 : 0; }

/// The smallest enclosure of both.
inline Enclosure hull(const Enclosure& a, const Enclosure& b) {
    if (is_empty(a)) return b;
    if (is_empty(b)) return a;
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// What both enclose, if they enclose the same number.
inline Enclosure intersection(const Enclosure& a, const Enclosure& b) {
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// A number above the finite x, by an ulp or two, and one below it: without changing the rounding of the
/// processor (Rump, Zimmermann, Boldo & Melquiond, Computing predecessor and successor in rounding to
/// nearest, 2009).
inline Real rounded_up(Real x) {
    constexpr Real slightly = unit_roundoff * (1 + 2 * unit_roundoff);
    return x + (slightly * std::abs(x) + std::numeric_limits<Real>::denorm_min());
}
inline Real rounded_down(Real x) { return -rounded_up(-x); }

/// The enclosure whose ends are `low` and `high` but for one rounding each, of an operation with a and b.
/// What overflows has no end.
inline Enclosure outward(Real low, Real high, const Enclosure& a, const Enclosure& b) {
    if (std::abs(low) < infinity && std::abs(high) < infinity) [[likely]]
        return {rounded_down(low), rounded_up(high)};
    if (is_empty(a) || is_empty(b)) return nothing_between;
    return {std::isfinite(low) ? rounded_down(low) : -infinity,
            std::isfinite(high) ? rounded_up(high) : infinity};
}

inline Enclosure operator-(const Enclosure& a) { return {-a.high, -a.low}; }
inline Enclosure operator+(const Enclosure& a, const Enclosure& b) {
    if (b.low == 0 && b.high == 0) return a;
    return outward(a.low + b.low, a.high + b.high, a, b);
}
inline Enclosure operator-(const Enclosure& a, const Enclosure& b) {
    return outward(a.low - b.high, a.high - b.low, a, b);
}

/// The enclosure of four products or quotients of ends. One that is NaN, as 0·∞, is hidden by no other.
inline Enclosure outward_of_four(Real p, Real q, Real r, Real s, const Enclosure& a, const Enclosure& b) {
    if (std::abs(p) + std::abs(q) + std::abs(r) + std::abs(s) < infinity) [[likely]]
        return {rounded_down(std::min(std::min(p, q), std::min(r, s))),
                rounded_up(std::max(std::max(p, q), std::max(r, s)))};
    return is_empty(a) || is_empty(b) ? nothing_between : everything_between;
}

/// Whether the enclosure is one number, 0 or a power of two: as a factor it rounds nothing, short of under-
/// and overflow. So functions in another unit of length have the same digits.
inline bool is_exact_factor(const Enclosure& a) {
    int exponent = 0;
    return a.low == a.high && (a.low == 0 || std::frexp(a.low, &exponent) == 0.5);
}

inline Enclosure operator*(const Enclosure& a, const Enclosure& b) {
    if (is_exact_factor(b)) {
        const Enclosure product{a.low * b.low, a.high * b.low};
        const auto is_exact = [&](Real end, Real times_b) {
            return std::isnormal(times_b) || (times_b == 0 && (end == 0 || b.low == 0));
        };
        if (is_exact(a.low, product.low) && is_exact(a.high, product.high)) return product;
    }
    return outward_of_four(a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high, a, b);
}
inline Enclosure operator*(Real c, const Enclosure& a) { return Enclosure{c, c} * a; }

inline Enclosure operator/(const Enclosure& a, const Enclosure& b) {
    if (contains(b, 0)) return is_empty(a) ? nothing_between : everything_between;
    return outward_of_four(a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high, a, b);
}

/// x·x·…·x, n ≥ 1 times; rounded up for x ≥ 0, and down.
inline Real power_up(Real x, int n) {
    Real power = x;
    for (int i = 1; i < n; ++i) power = rounded_up(power * x);
    return power;
}
inline Real power_down(Real x, int n) {
    Real power = x;
    for (int i = 1; i < n; ++i) power = std::max(Real(0), rounded_down(power * x));
    return power;
}

/// a to the n. An even power is nowhere negative, which a product of enclosures does not know.
inline Enclosure power(const Enclosure& a, int n) {
    if (is_empty(a)) return a;
    if (n == 0) return is_everything(a) ? a : Enclosure{1, 1};
    if (n < 0) return Enclosure{1, 1} / power(a, -n);
    if (!(std::abs(a.low) < infinity && std::abs(a.high) < infinity)) return everything_between;
    if (n % 2 == 1)
        return {a.low < 0 ? -power_up(-a.low, n) : power_down(a.low, n),
                a.high < 0 ? -power_down(-a.high, n) : power_up(a.high, n)};
    const Real far = power_up(std::max(std::abs(a.low), std::abs(a.high)), n);
    if (contains(a, 0)) return {0, far};
    return {power_down(std::min(std::abs(a.low), std::abs(a.high)), n), far};
}

inline Enclosure abs(const Enclosure& a) {
    if (a.low >= 0) return a;
    if (a.high <= 0) return -a;
    return is_empty(a) || is_everything(a) ? a : Enclosure{0, std::max(-a.low, a.high)};
}
inline Enclosure min(const Enclosure& a, const Enclosure& b) {
    if (is_empty(a) || is_empty(b)) return nothing_between;
    if (is_everything(a) || is_everything(b)) return everything_between;
    return {std::min(a.low, b.low), std::min(a.high, b.high)};
}
inline Enclosure max(const Enclosure& a, const Enclosure& b) { return -min(-a, -b); }

/// The root is rounded correctly (IEEE 754).
inline Enclosure sqrt(const Enclosure& a) {
    if (is_empty(a) || a.high < 0) return nothing_between;
    if (a.low < 0 || a.high == infinity) return everything_between;
    return {std::max(Real(0), rounded_down(std::sqrt(a.low))), rounded_up(std::sqrt(a.high))};
}

// The library's functions are assumed to be wrong by less than 2 ulp. (That of GNU says 1, and was found to
// keep it: Zimmermann et al., Accuracy of mathematical functions in single, double, ... precision, 2024.)

/// The enclosure whose ends were computed by such functions.
inline Enclosure outward_by_2(Real low, Real high) {
    return {std::isfinite(low) ? rounded_down(rounded_down(low)) : -infinity,
            std::isfinite(high) ? rounded_up(rounded_up(high)) : infinity};
}

inline Enclosure exp(const Enclosure& a) {
    if (is_empty(a) || is_everything(a)) return a;
    const Enclosure e = outward_by_2(std::exp(a.low), std::exp(a.high));
    return {std::max(Real(0), e.low), e.high};
}
inline Enclosure log(const Enclosure& a) {
    if (is_empty(a) || a.high <= 0) return nothing_between;
    if (a.low <= 0) return everything_between;
    return outward_by_2(std::log(a.low), std::log(a.high));
}

/// `function` is the cosine of angles less so many `quarters` of a turn. Between two ends it is greatest or
/// least where it has a top (at whole turns) or a bottom; an end within rounding of one counts as beyond it.
inline Enclosure cosine(const Enclosure& a, Real quarters, Real (*function)(Real)) {
    if (is_empty(a) || is_everything(a)) return a;
    constexpr Real farthest = 0x1p30;
    if (!(a.low > -farthest && a.high < farthest)) return {-1, 1};
    const auto turns = [&](Real x, Real slack) {
        return x / (2 * pi) - quarters / 4 + slack * (std::abs(x) + 1);
    };
    const Real low = turns(a.low, -gamma(8)), high = turns(a.high, gamma(8));
    const auto passes = [&](Real phase) { return std::floor(high - phase) > std::floor(low - phase); };
    const Real one = function(a.low), other = function(a.high);
    Enclosure c = outward_by_2(std::min(one, other), std::max(one, other));
    if (passes(0.5)) c.low = -1;
    if (passes(0)) c.high = 1;
    return {std::max(Real(-1), c.low), std::min(Real(1), c.high)};
}
inline Enclosure cos(const Enclosure& a) {
    return cosine(a, 0, [](Real x) { return std::cos(x); });
}
inline Enclosure sin(const Enclosure& a) {
    return cosine(a, 1, [](Real x) { return std::sin(x); });
}

}  // namespace rt
