// The exact judge of sums of products: rational numbers behind a plain header.
#pragma once

#include "common/math/vec.hpp"

#include <array>
#include <span>

namespace rt::oracle {

using Product = std::array<Real, 3>;  ///< the product of these three; all finite

/// Sign of the exact sum: −1, 0 or 1.
int sign_of_sum(std::span<const Product> products);

/// (mantissa · 2^exponent − sum) / |sum|, exact but for the last rounding; the sum must not be 0.
Real relative_error(std::span<const Product> products, Real mantissa, int exponent);

}  // namespace rt::oracle
