// Real roots of a polynomial, none of them missed.
#include "chapters/10_surfaces/polynomial.hpp"

#include "common/math/error.hpp"
#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Real root_between(const Polynomial& p, Real low, Real high) {
    // 10.7  Return the t at which p changes its sign between low and high. Keep it between two ends
    // that close in on it; take Newton's step where that is safe, and go to the middle where it is not.
    return todo("10.7");
}

SignChanges sign_changes(const Polynomial& p, Real low, Real high) {
    // 10.8  Return all changes of sign from low to high: find those of the derivative between its
    // inflections, and with their help those of p.
    return todo("10.8");
}

}  // namespace rt
