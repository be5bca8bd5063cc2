// Runs the program of an expression: on numbers, on enclosures, and on either with derivatives.
#pragma once

#include "common/math/dual.hpp"
#include "common/scene/formula.hpp"

#include <utility>

namespace rt {

/// f(x, y, z). NaN, or an empty enclosure, where f has no value.
template <class T>
T evaluate(const Formula& f, const T& x, const T& y, const T& z) {
    using std::sqrt, std::exp, std::log, std::sin, std::cos, std::abs;
    T stack[most_numbers + 1];  // one more for another unit
    T* end = stack;
    const auto push = [&](const T& a) { *end++ = a; };
    const auto change = [&](auto by) { end[-1] = by(end[-1]); };
    const auto combine = [&](auto by) {
        --end;
        end[-1] = by(end[-1], end[0]);
    };
    for (const Instruction& step : f.steps) switch (step.operation) {
            case Operation::Constant:
                push(constant<T>(step.constant));
                break;
            case Operation::X:
                push(x);
                break;
            case Operation::Y:
                push(y);
                break;
            case Operation::Z:
                push(z);
                break;
            case Operation::Negate:
                change([](const T& a) { return -a; });
                break;
            case Operation::Power:
                change([&](const T& a) { return power(a, step.exponent); });
                break;
            case Operation::SquareRoot:
                change([](const T& a) { return sqrt(a); });
                break;
            case Operation::Exponential:
                change([](const T& a) { return exp(a); });
                break;
            case Operation::Logarithm:
                change([](const T& a) { return log(a); });
                break;
            case Operation::Sine:
                change([](const T& a) { return sin(a); });
                break;
            case Operation::Cosine:
                change([](const T& a) { return cos(a); });
                break;
            case Operation::Absolute:
                change([](const T& a) { return abs(a); });
                break;
            case Operation::Add:
                combine([](const T& a, const T& b) { return a + b; });
                break;
            case Operation::Subtract:
                combine([](const T& a, const T& b) { return a - b; });
                break;
            case Operation::Multiply:
                combine([](const T& a, const T& b) { return a * b; });
                break;
            case Operation::Divide:
                combine([](const T& a, const T& b) { return a / b; });
                break;
            case Operation::Minimum:
                combine([](const T& a, const T& b) { return min(a, b); });
                break;
            case Operation::Maximum:
                combine([](const T& a, const T& b) { return max(a, b); });
                break;
        }
    return end[-1];
}

/// f at a point.
inline Real value_at(const Formula& f, const Vec3& p) { return evaluate<Real>(f, p.x, p.y, p.z); }

/// f and its gradient, in the box from x, y, z.low to .high; or at a point.
template <class T>
Dual<T, 3> with_gradient(const Formula& f, const T& x, const T& y, const T& z) {
    return evaluate(f, variable<3>(x, 0), variable<3>(y, 1), variable<3>(z, 2));
}
inline Vec3 gradient_at(const Formula& f, const Vec3& p) {
    const Dual<Real, 3> d = with_gradient<Real>(f, p.x, p.y, p.z);
    return {d.slope[0], d.slope[1], d.slope[2]};
}

}  // namespace rt
