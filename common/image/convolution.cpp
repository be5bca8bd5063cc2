// Filters that are a row of weights times a column of weights.
#include "common/image/convolution.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rt {
namespace {

/// Along lines of `length` numbers that stand `stride` apart; line k begins at `k * next`.
void filter_lines(const std::vector<Real>& from, std::vector<Real>& to, int lines, int next, int length,
                  int stride, const Weights& weights) {
    const int radius = static_cast<int>(weights.size()) / 2;
    const auto at = [&](int line, int i) { return static_cast<std::size_t>(line * next + i * stride); };
    for (int line = 0; line < lines; ++line)
        for (int i = 0; i < length; ++i) {
            Real sum = 0;
            for (int k = -radius; k <= radius; ++k)
                sum += weights[static_cast<std::size_t>(k + radius)] *
                       from[at(line, std::clamp(i + k, 0, length - 1))];
            to[at(line, i)] = sum;
        }
}

}  // namespace

Channel convolved(const Channel& channel, const Weights& across, const Weights& down) {
    Channel half = channel, whole = channel;
    filter_lines(channel.values, half.values, channel.height, channel.width, channel.width, 1, across);
    filter_lines(half.values, whole.values, channel.width, 1, channel.height, channel.width, down);
    return whole;
}

Weights gaussian(Real standard_deviation, int radius) {
    Weights weights;
    for (int x = -radius; x <= radius; ++x)
        weights.push_back(std::exp(-x * x / (2 * standard_deviation * standard_deviation)));
    return weights;
}

Weights normalized(Weights weights) {
    const Real sum = std::accumulate(weights.begin(), weights.end(), Real(0));
    for (Real& weight : weights) weight /= sum;
    return weights;
}

}  // namespace rt
