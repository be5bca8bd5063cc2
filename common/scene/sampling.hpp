// How a scene's pixels are sampled: how many rays, where they lie, and how their colours are weighed.
#pragma once

#include "common/math/vec.hpp"

#include <cstdint>

namespace rt {

/// Where the samples of a pixel lie.
enum class Sampler {
    Regular,    ///< in the middles of equal cells
    Random,     ///< anywhere, independent of each other
    Jittered,   ///< anywhere in equal cells, one in each
    Poisson,    ///< anywhere, but no two near each other
    Trapezoid,  ///< on the corners of cells: POV-Ray's method 2
    Centered,   ///< regular, and one more in the middle: POV-Ray's method 1
    Sobol,      ///< scrambled points of a sequence that fills the square evenly, however many
};

/// Whether each pixel has samples of its own, by chance.
constexpr bool is_random(Sampler sampler) {
    return sampler == Sampler::Random || sampler == Sampler::Jittered || sampler == Sampler::Poisson ||
           sampler == Sampler::Sobol;
}

/// How much a sample counts for a pixel, by its place relative to the pixel's centre.
enum class FilterKind { Box, Tent, Gaussian, Mitchell };

/// A filter that is separable: a function of x times the same function of y.
struct Filter {
    FilterKind kind = FilterKind::Box;
    Real radius = 0.5;  ///< in pixels; the weight is 0 where |x| or |y| is greater
};

/// Whether a pixel takes the mean of its own samples, also of those on its edge, and of no others.
inline bool takes_its_own(const Filter& filter) {
    return filter.kind == FilterKind::Box && filter.radius == 0.5;
}

/// All that a scene says of the samples of its pixels.
struct Sampling {
    int count = 1;  ///< samples a pixel, the mean number where they are adaptive; one is at the centre
    Sampler sampler = Sampler::Jittered;
    bool adaptive = false;  ///< spends more samples where the colours of a pixel differ more
    Filter filter;
    std::uint64_t seed = 0;
};

}  // namespace rt
