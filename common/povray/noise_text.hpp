// Perlin's improved noise in POV-Ray's functions.
#pragma once

#include "common/povray/writer.hpp"

namespace rt::povray {

/// Declares `Noise(x, y, z)`.
void write_noise(Writer& out);

/// Declares `NoiseSlope(x, y, z, ax, ay, az)`, the derivative of the noise along a vector; after
/// `write_noise`.
void write_noise_slope(Writer& out);

}  // namespace rt::povray
