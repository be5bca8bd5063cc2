// Filters that are a row of weights times a column of weights.
#pragma once

#include "common/math/vec.hpp"

#include <vector>

namespace rt {

/// One number a pixel, row by row from the top left.
struct Channel {
    int width = 0;
    int height = 0;
    std::vector<Real> values;
};

/// An odd number of weights, the middle one for the pixel itself.
using Weights = std::vector<Real>;

/// Each pixel's neighbours, weighted by `across[i] * down[j]` and summed up. Beyond an edge stands what is at
/// it.
Channel convolved(const Channel& channel, const Weights& across, const Weights& down);

/// exp(−x²/2s²) for the whole numbers x from −radius to radius.
Weights gaussian(Real standard_deviation, int radius);

/// Divided by their sum.
Weights normalized(Weights weights);

}  // namespace rt
