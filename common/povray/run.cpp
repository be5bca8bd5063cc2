// POV-Ray's options that take the samples of a scene's sampler.
#include "common/povray/run.hpp"

#include "common/scene/snapshot.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rt {
namespace {

int root_of(int n) { return static_cast<int>(std::sqrt(static_cast<Real>(n)) + 0.5); }

std::vector<std::string> antialiasing(int method, int depth) {
    return {fmt::format("+AM{}", method), "+A0.0", fmt::format("+R{}", depth), "-J"};
}

}  // namespace

PovrayRun povray_run(const Scene& scene) {
    const Sampling& sampling = scene.sampling;
    const bool box = takes_its_own(sampling.filter);
    const int count = sampling.count;
    if (scene.visibility == Visibility::Rasterize) return {};
    if (const int snapshots = snapshot_count(scene); snapshots > 1)
        return {.options = {}, .filter = true, .exact = shares_samples(scene), .frames = snapshots};
    if (count == 1) return {1, {}, !box, true};
    switch (sampling.sampler) {
        case Sampler::Regular:
            if (const int side = root_of(count); side * side == count) return {side, {}, true, true};
            break;
        case Sampler::Trapezoid:
            // Its recursion halves the pixel `depth` − 1 times.
            for (int depth = 1; box && depth <= 4; ++depth)
                if (const int side = (1 << (depth - 1)) + 1; side * side == count)
                    return {1, antialiasing(2, depth), false, true};
            break;
        case Sampler::Centered:
            if (const int side = root_of(count - 1); box && side * side == count - 1)
                return {1, antialiasing(1, side), false, true};
            break;
        case Sampler::Random:
        case Sampler::Jittered:
        case Sampler::Poisson:
        case Sampler::Sobol:
            break;
    }
    return {8, antialiasing(1, 2), true, false};
}

}  // namespace rt
