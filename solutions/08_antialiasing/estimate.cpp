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
    // [exercise 08.7] Fewer than two values say nothing of the error: return their mean (black for none) and
    // the standard error ∞. Else m is the sum divided by n. In a second pass, with d = value − m, sum up d
    // and d·d, each channel for itself. On paper Σd is 0. In floating point Σd/n is the rounding error of m:
    // add it to m, and take it out of the squares: s² = (Σd² − (Σd)²/n)/(n − 1), never below 0. The standard
    // error is √(s²/n).
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
    // [exercise 08.8] Each pixel is to get its share weights[i]·left/sum, where `left` are the samples to
    // share and `sum` is the sum of the weights. A pixel whose share is less than 1 gets one sample all the
    // same: set its weight to 0. That leaves less for the others, so find `left` (total, less one for each
    // weight that is 0) and `sum` anew, until no share is less than 1. The whole parts of the shares are the
    // counts. Of the samples that remain, give one each to the pixels whose shares have the greatest
    // fractional parts, the first of equal ones.
    long long left = total;
    Real sum = 0;
    for (bool settled = false; !settled;) {
        settled = true;
        left = total - std::count(weights.begin(), weights.end(), Real(0));
        sum = std::accumulate(weights.begin(), weights.end(), Real(0));
        for (Real& weight : weights) {
            if (weight == 0 || weight * static_cast<Real>(left) >= sum) continue;
            weight = 0;
            settled = false;
        }
    }
    std::vector<Real> fractions(pixels, 0);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (weights[i] == 0) continue;
        const Real share = weights[i] * static_cast<Real>(left) / sum;
        counts[i] = static_cast<int>(std::min(share, Real(std::numeric_limits<int>::max() - 1)));
        fractions[i] = share - counts[i];
        order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return fractions[a] > fractions[b]; });
    const long long spent = std::accumulate(counts.begin(), counts.end(), 0LL);
    for (long long i = 0; i < total - spent && !order.empty(); ++i)
        ++counts[order[static_cast<std::size_t>(i) % order.size()]];
    return counts;
    // [/exercise]
}

}  // namespace rt
