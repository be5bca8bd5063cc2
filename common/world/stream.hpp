// The random numbers of a sample: all that is random about it but its place in the pixel.
#pragma once

#include "common/math/mixed.hpp"
#include "common/world/ray_counts.hpp"
#include "common/world/world.hpp"

#include <cstdint>

namespace rt {

/// The random numbers of one sample of one pixel, in the order in which they are asked for. It is a plain
/// value, and to make one costs nothing but to write it down.
///
/// Number `dimension` is a function of seed, pixel, sample and dimension alone. Whoever asks cannot know how
/// it is made: here all are independent, but those of one dimension may as well be stratified over the
/// samples of a pixel, or be of low discrepancy.
struct Stream {
    std::uint64_t seed = 0;       ///< of the picture, or of one of its passes
    std::int32_t x = 0, y = 0;    ///< the pixel
    std::uint32_t sample = 0;     ///< which of the pixel's
    std::uint32_t dimension = 0;  ///< how many of its numbers have been asked for
};

/// The numbers of the first sample of the pixel (x, y).
inline Stream stream_of(const World& world, int x, int y) {
    return {.seed = world.sampling.seed, .x = x, .y = y};
}

/// Patterns of samples have sequences of their own (Random), made alike; their numbers are less than this.
inline constexpr std::uint64_t first_stream = std::uint64_t(1) << 63;

/// The next number, uniform in [0, 1).
inline Real next_real(Stream& stream) {
    ++ray_counts().random_numbers;
    const std::uint64_t pixel = std::uint64_t(std::uint32_t(stream.y)) << 32 | std::uint32_t(stream.x);
    const std::uint64_t key = mixed(mixed(mixed(0, stream.seed), pixel), first_stream + stream.sample);
    return real_of(mixed(key, ++stream.dimension));
}

/// The next point of the unit square [0, 1)², uniform: two numbers.
inline Vec2 next_point(Stream& stream) {
    const Real x = next_real(stream);
    return {x, next_real(stream)};
}

}  // namespace rt
