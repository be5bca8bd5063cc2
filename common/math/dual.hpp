// Automatic differentiation, forward: numbers that bring along how fast they change (Wengert 1964).
#pragma once

#include "common/math/enclosure.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace rt {

/// A value and its derivatives by n variables; of numbers, or of enclosures. Where a function has no
/// derivative, or no value, at some of the enclosed numbers, the enclosure of its derivative is everything;
/// at a kink of abs, min and max it encloses those of both sides.
template <class T, std::size_t n>
struct Dual {
    T value;
    std::array<T, n> slope;
};

template <class T>
T constant(Real c) {
    if constexpr (std::is_same_v<T, Real>)
        return c;
    else if constexpr (std::is_same_v<T, Enclosure>)
        return {c, c};
    else {
        T dual{constant<decltype(T::value)>(c), {}};
        dual.slope.fill(constant<decltype(T::value)>(0));
        return dual;
    }
}

/// The number as the k-th variable.
template <std::size_t n, class T>
Dual<T, n> variable(const T& value, std::size_t k) {
    Dual<T, n> x{value, {}};
    for (std::size_t i = 0; i < n; ++i) x.slope[i] = constant<T>(i == k ? 1 : 0);
    return x;
}

/// A value whose slopes are `of(i)`.
template <std::size_t n, class T, class Of>
Dual<T, n> dual(const T& value, Of of) {
    Dual<T, n> y{value, {}};
    for (std::size_t i = 0; i < n; ++i) y.slope[i] = of(i);
    return y;
}

// As std::min and std::max, but without a value where one of the two has none, whichever it is.
inline Real min(Real a, Real b) { return a < b || a != a ? a : b; }
inline Real max(Real a, Real b) { return a > b || a != a ? a : b; }

inline Real power(Real x, int n) {
    if (n < 0) return 1 / power(x, -n);
    Real y = 1;
    for (int i = 0; i < n; ++i) y *= x;
    return y;
}

template <class T, std::size_t n>
Dual<T, n> operator-(const Dual<T, n>& a) {
    return dual<n>(-a.value, [&](std::size_t i) { return -a.slope[i]; });
}
template <class T, std::size_t n>
Dual<T, n> operator+(const Dual<T, n>& a, const Dual<T, n>& b) {
    return dual<n>(a.value + b.value, [&](std::size_t i) { return a.slope[i] + b.slope[i]; });
}
template <class T, std::size_t n>
Dual<T, n> operator-(const Dual<T, n>& a, const Dual<T, n>& b) {
    return dual<n>(a.value - b.value, [&](std::size_t i) { return a.slope[i] - b.slope[i]; });
}
template <class T, std::size_t n>
Dual<T, n> operator*(const Dual<T, n>& a, const Dual<T, n>& b) {
    return dual<n>(a.value * b.value,
                   [&](std::size_t i) { return a.slope[i] * b.value + a.value * b.slope[i]; });
}
template <class T, std::size_t n>
Dual<T, n> operator*(Real c, const Dual<T, n>& a) {
    return dual<n>(c * a.value, [&](std::size_t i) { return c * a.slope[i]; });
}
template <class T, std::size_t n>
Dual<T, n> operator/(const Dual<T, n>& a, const Dual<T, n>& b) {
    const T quotient = a.value / b.value;
    return dual<n>(quotient, [&](std::size_t i) { return (a.slope[i] - quotient * b.slope[i]) / b.value; });
}

/// f(a), where f has the derivative `rate` at a.
template <class T, std::size_t n>
Dual<T, n> chained(const T& value, const T& rate, const Dual<T, n>& a) {
    return dual<n>(value, [&](std::size_t i) { return rate * a.slope[i]; });
}
template <class T, std::size_t n>
Dual<T, n> power(const Dual<T, n>& a, int m) {
    if (m == 0) return dual<n>(power(a.value, 0), [&](std::size_t i) { return a.slope[i] * constant<T>(0); });
    return chained(power(a.value, m), static_cast<Real>(m) * power(a.value, m - 1), a);
}
template <class T, std::size_t n>
Dual<T, n> sqrt(const Dual<T, n>& a) {
    using std::sqrt;
    const T root = sqrt(a.value);
    return chained(root, constant<T>(0.5) / root, a);
}
template <class T, std::size_t n>
Dual<T, n> exp(const Dual<T, n>& a) {
    using std::exp;
    const T value = exp(a.value);
    return chained(value, value, a);
}
template <class T, std::size_t n>
Dual<T, n> log(const Dual<T, n>& a) {
    using std::log;
    return chained(log(a.value), constant<T>(1) / a.value, a);
}
template <class T, std::size_t n>
Dual<T, n> sin(const Dual<T, n>& a) {
    using std::cos, std::sin;
    return chained(sin(a.value), cos(a.value), a);
}
template <class T, std::size_t n>
Dual<T, n> cos(const Dual<T, n>& a) {
    using std::cos, std::sin;
    return chained(cos(a.value), -sin(a.value), a);
}

constexpr int sign_of(Real x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
constexpr Real hull(Real a, Real) { return a; }

// Of values with derivatives, as derivatives of derivatives are. Between the two sides of a kink the values
// jump, so how fast they change there is not known.
template <class T, std::size_t n>
int sign_of(const Dual<T, n>& a) {
    return sign_of(a.value);
}
template <std::size_t n>
Dual<Enclosure, n> hull(const Dual<Enclosure, n>& a, const Dual<Enclosure, n>& b) {
    return dual<n>(hull(a.value, b.value), [](std::size_t) { return everything_between; });
}

/// The one of a negative sign, the other of a positive one; or if that is open, both.
template <class T, std::size_t n>
Dual<T, n> either(int sign, const T& value, const Dual<T, n>& one, const Dual<T, n>& other) {
    if (sign != 0) return sign < 0 ? one : other;
    return dual<n>(value, [&](std::size_t i) { return hull(one.slope[i], other.slope[i]); });
}
template <class T, std::size_t n>
Dual<T, n> abs(const Dual<T, n>& a) {
    using std::abs;
    return either(sign_of(a.value), abs(a.value), -a, a);
}
template <class T, std::size_t n>
Dual<T, n> min(const Dual<T, n>& a, const Dual<T, n>& b) {
    return either(sign_of(a.value - b.value), min(a.value, b.value), a, b);
}
template <class T, std::size_t n>
Dual<T, n> max(const Dual<T, n>& a, const Dual<T, n>& b) {
    return either(sign_of(a.value - b.value), max(a.value, b.value), b, a);
}

}  // namespace rt
