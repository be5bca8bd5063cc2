// From a compiled world to a picture, on all cores.
#pragma once

#include "common/image/image.hpp"
#include "common/scene/query.hpp"

#include <functional>

namespace rt {

struct RenderOptions {
    int threads = 0;                     ///< 0: one a core
    std::function<void(Real)> progress;  ///< told the finished fraction, from any thread; may be empty
};

struct RenderResult {
    Image image;
    RayCounts rays;
    double seconds = 0;      ///< of the wall clock
    double cpu_seconds = 0;  ///< of all threads together
};

/// Renders the world in tiles. The image is the same to the bit for any number of threads.
/// An exercise that is not started throws NotImplemented through here.
RenderResult render(const World& world, const RenderOptions& options = {});

}  // namespace rt
