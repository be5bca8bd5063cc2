// The numbers of an 8-bit picture from light, and back.
#pragma once

#include "common/image/image.hpp"

#include <cstdint>

namespace rt {

/// Light in [0, 1] to the number that a display wants, in [0, 1]; values outside are clamped,
/// NaN becomes 0.
Real encode(Real linear, Encoding encoding);

/// Inverse of `encode` on [0, 1].
Real decode(Real encoded, Encoding encoding);

/// The byte round(255 · encode(linear)).
std::uint8_t encode_byte(Real linear, Encoding encoding);

}  // namespace rt
