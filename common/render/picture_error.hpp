// How wrong a picture of many samples a pixel probably is.
#pragma once

#include "common/render/passes.hpp"

#include <optional>

namespace rt {

/// The root mean square error of the mean of the passes, from the variance between them; nothing where no
/// pixel has two.
std::optional<Real> error_of_passes(const SampledPicture& picture);

/// The root mean square error of a picture that is one pass, from second patterns in some places; counts
/// their rays as the picture's.
Real error_by_probes(SampledPicture& picture, const Patterns& patterns);

}  // namespace rt
