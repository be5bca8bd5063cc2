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

/// [08.9] Mean of independent estimates of the same colour, and its standard error s/√n, where s² is the
/// unbiased sample variance, found in a second pass over the values so that nothing cancels. The values must
/// be independent: single samples of a stratified pattern are not, whole patterns are.
Estimate estimate(std::span<const Vec3> values);

/// [08.10] What part of `total` samples each pixel is to have, where deviation[i] ≥ 0 is the standard
/// deviation of one sample in pixel i: in proportion to the deviations (Neyman 1934), but no share is less
/// than 1. The shares sum to `total`, which is greater than the number of pixels. All shares are the same
/// where all deviations are 0; deviations that are ∞ share alike, and leave 1 to each of the others.
std::vector<Real> sample_shares(std::span<const Real> deviations, long long total);

/// [08.11] Whole numbers that sum to `total`, of shares ≥ 0 that do: each share rounded down, or, where its
/// fractional part is among the greatest, up; of equal ones the first.
std::vector<int> whole_counts(std::span<const Real> shares, long long total);

/// How many samples each pixel gets where `total` are to be spent: its share as a whole number, or one if
/// `total` is not more than one a pixel. Given.
std::vector<int> sample_counts(std::span<const Real> deviations, long long total);

}  // namespace rt
