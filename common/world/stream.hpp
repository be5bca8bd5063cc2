// The random numbers of a sample: all that is random about it but its place in the pixel.
#pragma once

#include "common/math/mixed.hpp"
#include "common/world/ray_counts.hpp"
#include "common/world/world.hpp"

#include <cstdint>

namespace rt {

/// How the numbers of one dimension are spread over the samples of a pixel.
enum class Spread : std::uint8_t {
    Independent,  ///< at random, each without regard to the others
    Stratified,   ///< one at random in each of equal cells, in random order
    Fixed,        ///< in the middles of equal cells, in an order that all pixels share
    Sobol,        ///< scrambled Sobol' points, which neighbouring pixels share out between them
};

/// The random numbers of one sample of one pixel, in the order in which they are asked for. It is a plain
/// value, and to make one costs nothing but to write it down.
///
/// Number `dimension` is a function of seed, pixel, sample and dimension alone. Whoever asks cannot know how
/// it is made: those of one dimension may be independent, stratified over the samples of a pixel, or of low
/// discrepancy.
struct Stream {
    std::uint64_t seed = 0;       ///< of the picture, or of one of its passes
    std::int32_t x = 0, y = 0;    ///< the pixel
    std::uint32_t sample = 0;     ///< which of the pixel's
    std::uint32_t dimension = 0;  ///< how many of its numbers have been asked for
    std::uint32_t count = 1;      ///< how many samples the pixel has
    Spread spread = Spread::Independent;
};

/// The numbers of the first sample of the pixel (x, y).
inline Stream stream_of(const World& world, int x, int y) {
    return {.seed = world.sampling.seed, .x = x, .y = y};
}

/// Patterns of samples have sequences of their own (Random), made alike; their numbers are less than this.
inline constexpr std::uint64_t first_stream = std::uint64_t(1) << 63;

// Those of streams that are not independent; the next two functions ask for them.
Real spread_real(const Stream& stream);
Vec2 spread_point(const Stream& stream);

/// The next number, uniform in [0, 1).
inline Real next_real(Stream& stream) {
    ++ray_counts().random_numbers;
    if (stream.spread != Spread::Independent) {
        ++stream.dimension;
        return spread_real(stream);
    }
    const std::uint64_t pixel = std::uint64_t(std::uint32_t(stream.y)) << 32 | std::uint32_t(stream.x);
    const std::uint64_t key = mixed(mixed(mixed(0, stream.seed), pixel), first_stream + stream.sample);
    return real_of(mixed(key, ++stream.dimension));
}

/// The next point of the unit square [0, 1)², uniform: two numbers.
inline Vec2 next_point(Stream& stream) {
    if (stream.spread != Spread::Independent) {
        ray_counts().random_numbers += 2;
        stream.dimension += 2;
        return spread_point(stream);
    }
    const Real x = next_real(stream);
    return {x, next_real(stream)};
}

}  // namespace rt
