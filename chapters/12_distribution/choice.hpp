// Choosing one of many by their weights, and keeping the random number.
#pragma once

#include "common/math/vec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// What was chosen, how likely that was, and what is left of the random number.
struct Choice {
    std::uint32_t index = 0;
    Real probability = 1;  ///< in (0, 1]
    Real random = 0;       ///< in [0, 1): uniform again, whichever was chosen
};

/// [12.15] The sums w₀, w₀ + w₁, … of the weights, as parts of the sum of all. They never fall, and the last
/// is exactly 1. Of a weight of 0 the sum is equal to the one before it, or 0 if there is none. If all
/// weights are 0, they count as equal. Nothing for no weights.
///
/// weights: n of them, each 0 or in [1e-150, 1e150]. Each sum is right to gamma(n + 2), as a part of itself;
/// so a weight that is less than that of the sum before it may be lost.
std::vector<Real> cumulative(std::span<const Real> weights);

/// [12.15] The first index whose sum is greater than `random`, so never one of weight 0. Its probability is
/// its sum less the one before it. `random` of the choice is how far the number was on its way from the one
/// sum to the other: right to gamma(4) for the given sums, and never 1, not even by rounding. cumulative: not
/// empty, as `cumulative` makes it. random in [0, 1).
Choice choose(std::span<const Real> cumulative, Real random);

}  // namespace rt
