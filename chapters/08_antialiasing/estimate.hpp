// How wrong a mean of samples is, and where more samples help most.
#pragma once

#include "common/math/vec.hpp"

#include <span>
#include <vector>

namespace rt {

/// A mean and how far it may be off.
struct Estimate {
    Vec3 mean{0};
    Vec3 standard_error{0};  ///< of the mean, per channel; ∞ for fewer than two values
};

/// [08.7] Mean of independent estimates of the same colour, and its standard error s/√n, where s² is the
/// unbiased sample variance, found in a second pass over the values so that nothing cancels. The values must
/// be independent: single samples of a stratified pattern are not, whole patterns are.
Estimate estimate(std::span<const Vec3> values);

/// [08.8] How many samples each pixel gets where `total` are to be spent and deviation[i] ≥ 0 is the standard
/// deviation of one sample in pixel i: in proportion to the deviations (Neyman 1934), at least one each, and
/// all `total` spent, or one a pixel if that is more. Where the shares are not whole the greatest remainders
/// are rounded up, the first of equal ones. All the same, give or take one, where all deviations are 0.
std::vector<int> sample_counts(std::span<const Real> deviations, long long total);

}  // namespace rt
