// Choosing one of many by their weights, and keeping the random number.
#include "chapters/12_distribution/choice.hpp"

#include <algorithm>

namespace rt {

std::vector<Real> cumulative(std::span<const Real> weights) {
    // [exercise 12.15] The sums of the weights as parts of the whole; of equal weights, if all are 0.
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
    // [exercise 12.15] The chosen index, its probability, and what is left of the random number. There may be
    // many sums.
    const auto found = std::upper_bound(cumulative.begin(), cumulative.end(), random);
    const Real low = found == cumulative.begin() ? 0 : *(found - 1);
    const Real probability = *found - low;
    // The quotient is less than 1, but it may round to 1.
    const Real rest = std::min((random - low) / probability, 0x1.fffffffffffffp-1);
    return {static_cast<std::uint32_t>(found - cumulative.begin()), probability, rest};
    // [/exercise]
}

}  // namespace rt
