// How wrong a mean of samples is, and where more samples help most.
#include "chapters/08_antialiasing/estimate.hpp"

#include "common/math/todo.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace rt {

Estimate estimate(std::span<const Vec3> values) {
    // 08.7  Fewer than two values say nothing of the error: return their mean (black for none) and
    // the standard error ∞. Else m is the sum divided by n. In a second pass, with d = value − m, sum up d
    // and d·d, each channel for itself. On paper Σd is 0. In floating point Σd/n is the rounding error of m:
    // add it to m, and take it out of the squares: s² = (Σd² − (Σd)²/n)/(n − 1), never below 0. The standard
    // error is √(s²/n).
    return todo("08.7");
}

std::vector<int> sample_counts(std::span<const Real> deviations, long long total) {
    const std::size_t pixels = deviations.size();
    std::vector<int> counts(pixels, 1);
    if (deviations.empty() || total <= static_cast<long long>(pixels)) return counts;
    // Relative to the greatest, no deviation is too large or too small to compute with; this is also right
    // where all of them are 0, and where some are ∞.
    const Real greatest = *std::max_element(deviations.begin(), deviations.end());
    std::vector<Real> weights;
    for (const Real deviation : deviations) {
        weights.push_back(deviation == greatest ? 1 : deviation / greatest);
    }
    // 08.8  Each pixel is to get its share weights[i]·left/sum, where `left` are the samples to
    // share and `sum` is the sum of the weights. A pixel whose share is less than 1 gets one sample all the
    // same: set its weight to 0. That leaves less for the others, so find `left` (total, less one for each
    // weight that is 0) and `sum` anew, until no share is less than 1. The whole parts of the shares are the
    // counts. Of the samples that remain, give one each to the pixels whose shares have the greatest
    // fractional parts, the first of equal ones.
    return todo("08.8");
}

}  // namespace rt
