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
    // 08.9  The mean of the n values, and its standard error √(s²/n) with the unbiased variance s²,
    // each channel by itself. Fewer than two values say nothing about the error, which is then ∞; the mean of
    // no values is black. Both must keep their digits where the values are nearly equal.
    return todo("08.9");
}

std::vector<Real> sample_shares(std::span<const Real> deviations, long long total) {
    if (deviations.empty()) return {};
    // Relative to the greatest, no deviation is too large or too small to compute with; this is also right
    // where all of them are 0, and where some are ∞.
    const Real greatest = *std::max_element(deviations.begin(), deviations.end());
    std::vector<Real> weights;
    for (const Real deviation : deviations) {
        weights.push_back(deviation == greatest ? 1 : deviation / greatest);
    }
    // 08.10  The shares of the pixels are in proportion to their `weights` and sum to `total`, but
    // none is below 1: a pixel whose share would be less gets 1, and the others share what is then left.
    return todo("08.10");
}

std::vector<int> whole_counts(std::span<const Real> shares, long long total) {
    // 08.11  Give each pixel the whole part of its share. Of the samples that then remain of
    // `total`, give one each to the pixels whose shares have the greatest fractional parts, the first of
    // equal ones.
    return todo("08.11");
}

std::vector<int> sample_counts(std::span<const Real> deviations, long long total) {
    // Of fewer samples than pixels each pixel gets one all the same.
    if (total <= static_cast<long long>(deviations.size())) return std::vector<int>(deviations.size(), 1);
    return whole_counts(sample_shares(deviations, total), total);
}

}  // namespace rt
