// Real roots of a polynomial, none of them missed.
#include "chapters/10_surfaces/polynomial.hpp"

#include "common/math/error.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Real root_between(const Polynomial& p, Real low, Real high) {
    // [exercise 10.7] Return the t at which p changes its sign between low and high, to the last bits,
    // however p bends on the way.
    const bool falls = evaluate(p, low).value > 0;
    Real t = low + 0.5 * (high - low), last = high - low;
    while (low < t && t < high) {
        const auto [value, slope] = evaluate(p, t);
        ((value > 0) == falls ? low : high) = t;
        Real step = -value / slope;
        if (std::abs(step) <= 4 * unit_roundoff * std::abs(t)) return std::clamp(t + step, low, high);
        const bool is_safe = low < t + step && t + step < high && std::abs(step) <= 0.5 * last;
        if (!is_safe) step = low + 0.5 * (high - low) - t;
        last = std::abs(step);
        t += step;
    }
    return t;
    // [/exercise]
}

SignChanges sign_changes(const Polynomial& p, Real low, Real high) {
    // [exercise 10.8] Return all changes of sign from low to high, ascending, with none missed.
    const Roots bends = inflections(p);
    std::array<Real, 6> places{low};
    std::size_t count = 1;
    if (bends.count > 0 && low < bends.t0 && bends.t0 < high) places[count++] = bends.t0;
    if (bends.count > 1 && low < bends.t1 && bends.t1 < high) places[count++] = bends.t1;
    places[count++] = high;
    for (const Polynomial& q : {derivative(p), p}) {
        std::array<Real, 6> next{low};
        std::size_t found = 1;
        bool was_positive = evaluate(q, low).value > 0;
        for (std::size_t i = 1; i < count; ++i) {
            const bool is_positive = evaluate(q, places[i]).value > 0;
            if (is_positive != was_positive) next[found++] = root_between(q, places[i - 1], places[i]);
            was_positive = is_positive;
        }
        next[found++] = high;
        places = next;
        count = found;
    }
    SignChanges changes{static_cast<int>(count) - 2};
    for (std::size_t i = 0; i + 2 < count; ++i) changes.t[i] = places[i + 1];
    return changes;
    // [/exercise]
}

}  // namespace rt
