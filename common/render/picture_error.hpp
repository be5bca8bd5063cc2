// How wrong a picture of many samples a pixel probably is.
#pragma once

#include "common/render/passes.hpp"

#include <optional>

namespace rt {

/// Root mean square errors, of all pixels and channels.
struct PictureError {
    Real sampling = 0;   ///< of finite samples: what other ones would change
    Real averaging = 0;  ///< of textures that are averaged over more or less than a sample stands for
    Real whole() const;
};

/// From now on some pixels tell in every pass what the averaging of textures changes, if any are averaged.
void watch_averaging(SampledPicture& picture);

/// The error of the mean of the passes, from the variance between them, and from what averaging changes in
/// watched pixels; nothing where no pixel has two.
std::optional<PictureError> error_of_passes(const SampledPicture& picture);

/// The error of a picture that is one pass, from second patterns in some places; counts their rays as the
/// picture's.
PictureError error_by_probes(SampledPicture& picture, const Patterns& patterns);

}  // namespace rt
