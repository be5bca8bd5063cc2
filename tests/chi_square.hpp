// Pearson's χ²: whether counts that should be equal differ by more than chance allows.
#pragma once

#include "common/math/vec.hpp"

#include <cmath>
#include <vector>

namespace rt::test {

/// Pearson's χ² of counts that should be equal.
inline Real chi_square(const std::vector<int>& counts) {
    Real all = 0, sum = 0;
    for (const int count : counts) all += count;
    const Real expected = all / static_cast<Real>(counts.size());
    for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
    return sum;
}

/// What χ² of so many classes exceeds once in ten million times (Wilson & Hilferty 1931, normal
/// quantile 5.2).
inline Real chi_square_limit(std::size_t classes) {
    const Real f = static_cast<Real>(classes - 1), root = 1 - 2 / (9 * f) + 5.2 * std::sqrt(2 / (9 * f));
    return f * root * root * root;
}

}  // namespace rt::test
