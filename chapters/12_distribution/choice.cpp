// Choosing one of many by their weights, and keeping the random number.
#include "chapters/12_distribution/choice.hpp"

#include "common/math/todo.hpp"

#include <algorithm>

namespace rt {

std::vector<Real> cumulative(std::span<const Real> weights) {
    // 12.15  The sums of the weights as parts of the whole; of equal weights, if all are 0.
    return todo("12.15");
}

Choice choose(std::span<const Real> cumulative, Real random) {
    // 12.15  The chosen index, its probability, and what is left of the random number. There may be
    // many sums.
    return todo("12.15");
}

}  // namespace rt
