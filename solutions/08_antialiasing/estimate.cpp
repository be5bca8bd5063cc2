// How wrong a mean of samples is, and where more samples help most.
#include "chapters/08_antialiasing/estimate.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace rt {

Estimate estimate(std::span<const Vec3> values) {
    // [exercise 08.9] The mean of the n values, and its standard error √(s²/n) with the unbiased variance s²,
    // each channel by itself. Fewer than two values say nothing about the error, which is then ∞; the mean of
    // no values is black. Both must keep their digits where the values are nearly equal.
    const auto n = static_cast<Real>(values.size());
    if (values.empty()) return {Vec3(0), Vec3(infinity)};
    if (values.size() == 1) return {values[0], Vec3(infinity)};
    Vec3 mean(0);
    for (const Vec3& value : values) mean += value;
    mean /= n;
    Vec3 sum(0), squares(0);
    for (const Vec3& value : values) {
        const Vec3 d = value - mean;
        sum += d;
        squares += d * d;
    }
    const Vec3 variance = glm::max((squares - sum * sum / n) / (n - 1), Vec3(0));
    return {mean + sum / n, glm::sqrt(variance / n)};
    // [/exercise]
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
    // [exercise 08.10] The shares of the pixels are in proportion to their `weights` and sum to `total`, but
    // none is below 1: a pixel whose share would be less gets 1, and the others share what is then left.
    Real left = 0, sum = 0;
    for (bool settled = false; !settled;) {
        settled = true;
        left = static_cast<Real>(total - std::count(weights.begin(), weights.end(), Real(0)));
        sum = std::accumulate(weights.begin(), weights.end(), Real(0));
        for (Real& weight : weights) {
            if (weight == 0 || weight * left >= sum) continue;
            weight = 0;
            settled = false;
        }
    }
    for (Real& weight : weights) weight = weight == 0 ? 1 : weight * left / sum;
    return weights;
    // [/exercise]
}

std::vector<int> whole_counts(std::span<const Real> shares, long long total) {
    // [exercise 08.11] Give each pixel the whole part of its share. Of the samples that then remain of
    // `total`, give one each to the pixels whose shares have the greatest fractional parts, the first of
    // equal ones.
    std::vector<int> counts;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        counts.push_back(static_cast<int>(std::min(shares[i], Real(std::numeric_limits<int>::max() - 1))));
        order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return shares[a] - counts[a] > shares[b] - counts[b];
    });
    long long left = total - std::accumulate(counts.begin(), counts.end(), 0LL);
    for (auto i = order.begin(); left > 0 && i != order.end(); --left) ++counts[*i++];
    return counts;
    // [/exercise]
}

std::vector<int> sample_counts(std::span<const Real> deviations, long long total) {
    // Of fewer samples than pixels each pixel gets one all the same.
    if (total <= static_cast<long long>(deviations.size())) return std::vector<int>(deviations.size(), 1);
    return whole_counts(sample_shares(deviations, total), total);
}

}  // namespace rt
