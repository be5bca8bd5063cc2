// Numbers as colours.
#pragma once

#include "common/image/image.hpp"

namespace rt {

/// The colour of a number from 0 to 1 in the map Magma (Smith & van der Walt 2015): from black by violet and
/// orange to a pale yellow, as evenly bright as it rises, so that it reads the same on paper, and to those
/// who see few colours. Numbers outside are clamped, NaN is 0. Linear light.
Vec3 magma(Real value);

}  // namespace rt
