// The patterns of samples that the pixels of a picture have, pass by pass.
#pragma once

#include "chapters/08_antialiasing/samples.hpp"

#include <cstdint>
#include <vector>

namespace rt {

// Passes whose samples must be independent have different numbers. Those of a picture are 0, 1, 2, ...
inline constexpr std::uint64_t probe_pass = std::uint64_t(1) << 40;    ///< tells how wrong the others are
inline constexpr std::uint64_t pilot_pass = std::uint64_t(1) << 41;    ///< looks where samples are needed
inline constexpr std::uint64_t pattern_pass = std::uint64_t(1) << 42;  ///< makes patterns that pixels share
inline constexpr std::uint64_t choice_pass = std::uint64_t(1) << 43;   ///< chooses the places of probes

/// The patterns of all pixels.
struct Patterns {
    Sampler sampler;
    int count;                           ///< samples a pixel
    std::vector<PoissonDisk> poisson{};  ///< of `count` samples each, shared by the pixels
};

Patterns patterns_for(const World& world, Sampler sampler, int count);

/// The pattern of one pixel in one pass; `samples` are as many as patterns.count unless the picture is
/// adaptive. Patterns without anything random are moved at random in all passes but number 0. Adds the random
/// numbers that it draws to ray_counts().
std::vector<PixelSample> pattern_of(const World& world, const Patterns& patterns, int x, int y,
                                    std::uint64_t pass, int samples);

/// The random numbers of the first sample of a pixel in a pass, for all but its place; the pixel has
/// `samples`.
Stream stream_of(const World& world, const Patterns& patterns, int x, int y, std::uint64_t pass, int samples);

}  // namespace rt
