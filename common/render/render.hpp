// From a compiled world to a picture, on all cores.
#pragma once

#include "chapters/01_ray_casting/raycast.hpp"
#include "common/image/image.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace rt {

struct RenderOptions {
    int threads = 0;                     ///< 0: one a core
    std::function<void(Real)> progress;  ///< told the finished fraction, from any thread; may be empty
    /// Goes on with passes of new samples for about so long (wall clock). One whole pass at least is made.
    std::optional<double> seconds{};
    /// Goes on with passes of new samples until the estimated RMS error is at most this, or further samples
    /// make it hardly better. If `seconds` is given too, whichever comes first ends the picture. With either,
    /// the world's sampling.count is not used.
    std::optional<Real> error{};
    /// Whether a picture of a given number of samples estimates its error, which takes further samples.
    bool estimate = true;
    /// Colours the rays, if it is not null, instead of the function that suits the world's integrator.
    RayColor color = nullptr;
};

struct RenderResult {
    Image image;
    RayCounts rays;
    Real samples_per_pixel = 1;  ///< on average, with those that tell where adaptive ones go
    std::vector<int> counts;     ///< samples of each pixel, row by row, where they are adaptive; else empty
    /// Estimated root mean square error of all pixels and channels, linear, that comes from finite sampling,
    /// and from textures that are averaged over other places than samples stand for; nothing where there is
    /// one sample a pixel.
    std::optional<Real> rms_error;
    double seconds = 0;      ///< of the wall clock
    double cpu_seconds = 0;  ///< of all threads together
};

/// Renders the world in tiles. The image is the same to the bit for any number of threads (save where
/// `seconds` ends it). An exercise that is not started throws NotImplemented through here.
RenderResult render(const World& world, const RenderOptions& options = {});

}  // namespace rt
