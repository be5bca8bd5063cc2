// Real roots of a polynomial, none of them missed.
#include "chapters/10_surfaces/polynomial.hpp"

#include "common/math/error.hpp"
#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Real root_between(const Polynomial& p, Real low, Real high) {
    // 10.7  Begin in the middle. As long as t is between low and high: evaluate, and let t take the
    // place of low or of high, so that the change stays between them. Newton's step leads to t − value/slope.
    // Where it is no longer than 4u|t|, return where it leads to, but not beyond low or high. Take it if it
    // leads between low and high and is at most half as long as the last step; if not, go to the middle. When
    // nothing is left between, return t.
    return todo("10.7");
}

SignChanges sign_changes(const Polynomial& p, Real low, Real high) {
    // 10.7  Keep a list of places: at first low, those inflections that are strictly between,
    // ascending, and high. Between neighbours the derivative is monotone. Look at its sign in all the places;
    // wherever it changes from one place to the next, there is a root_between. The new places are low, these
    // roots, and high. Between those p itself is monotone; do the same with it. The last places, without low
    // and high, are the answer.
    return todo("10.7");
}

}  // namespace rt
