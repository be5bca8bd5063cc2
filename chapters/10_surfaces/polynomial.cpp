// Real roots of a polynomial, none of them missed.
#include "chapters/10_surfaces/polynomial.hpp"

#include "common/math/error.hpp"
#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Real root_between(const Polynomial& p, Real low, Real high) {
    // 10.7  Return the t at which p changes its sign between low and high, to the last bits,
    // however p bends on the way.
    return todo("10.7");
}

SignChanges sign_changes(const Polynomial& p, Real low, Real high) {
    // 10.8  Return all changes of sign from low to high, ascending, with none missed.
    return todo("10.8");
}

}  // namespace rt
