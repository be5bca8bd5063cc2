// Choosing one of many by their weights, and keeping the random number.
#include "chapters/12_distribution/choice.hpp"

#include "common/math/todo.hpp"

#include <algorithm>

namespace rt {

std::vector<Real> cumulative(std::span<const Real> weights) {
    // 12.15  Add up, then divide each sum by the last. If all weights are 0, take 1 for each.
    return todo("12.15");
}

Choice choose(std::span<const Real> cumulative, Real random) {
    // 12.15  Find the first sum that is greater than the number, by bisection: there may be many.
    // Where between the two sums the number lies is uniform again.
    return todo("12.15");
}

}  // namespace rt
