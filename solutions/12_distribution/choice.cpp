// Choosing one of many by their weights, and keeping the random number.
#include "chapters/12_distribution/choice.hpp"

#include <algorithm>

namespace rt {

std::vector<Real> cumulative(std::span<const Real> weights) {
    // [exercise 12.15] Add up, then divide each sum by the last. If all weights are 0, take 1 for each.
    const bool is_dark = std::none_of(weights.begin(), weights.end(), [](Real w) { return w > 0; });
    std::vector<Real> sums;
    sums.reserve(weights.size());
    Real all = 0;
    for (const Real weight : weights) {
        all += is_dark ? 1 : weight;
        sums.push_back(all);
    }
    // Divided, and not multiplied by 1/all, which would make the last one nearly 1.
    for (Real& part : sums) part /= all;
    return sums;
    // [/exercise]
}

Choice choose(std::span<const Real> cumulative, Real random) {
    // [exercise 12.15] Find the first sum that is greater than the number, by bisection: there may be many.
    // Where between the two sums the number lies is uniform again.
    const auto found = std::upper_bound(cumulative.begin(), cumulative.end(), random);
    const Real low = found == cumulative.begin() ? 0 : *(found - 1);
    const Real probability = *found - low;
    // The quotient is less than 1, but it may round to 1.
    const Real rest = std::min((random - low) / probability, 0x1.fffffffffffffp-1);
    return {static_cast<std::uint32_t>(found - cumulative.begin()), probability, rest};
    // [/exercise]
}

}  // namespace rt
