// Rounding error: the unit roundoff and the bounds that grow from it.
// Every tolerance of the renderer is derived from these; there is no absolute epsilon.
#pragma once

#include "common/math/vec.hpp"

namespace rt {

/// Unit roundoff u of Real: the greatest relative error of one rounded operation, 2^-53.
inline constexpr Real unit_roundoff = std::numeric_limits<Real>::epsilon() / 2;

/// Bound n·u / (1 − n·u) of the relative error that n rounded operations in a row can build up
/// (Higham, Accuracy and Stability of Numerical Algorithms, 2002, lemma 3.1).
constexpr Real gamma(int n) { return n * unit_roundoff / (1 - n * unit_roundoff); }

}  // namespace rt
