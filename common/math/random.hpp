// Random numbers that are a function of where they are used: pixel, sample, dimension and seed.
#pragma once

#include "common/math/mixed.hpp"
#include "common/math/vec.hpp"

#include <cstdint>

namespace rt {

/// A sequence of random numbers. It is a plain value: two equal ones go on with the same numbers, and the
/// numbers depend on nothing else, neither on the thread nor on the time. Functions that need random numbers
/// are handed one.
struct Random {
    std::uint64_t key = 0;        ///< which sequence
    std::uint64_t dimension = 0;  ///< how many numbers of it are used up
};

/// The sequence of one sample (or of one pattern of samples) of one pixel.
constexpr Random random_for(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample) {
    return {mixed(mixed(mixed(0, seed), pixel), sample), 0};
}

/// 64 random bits.
constexpr std::uint64_t random_bits(Random& random) { return mixed(random.key, ++random.dimension); }

/// Uniform in [0, 1): one of the multiples of 2^-53.
constexpr Real random_real(Random& random) { return real_of(random_bits(random)); }

/// A point of the unit square [0, 1)², uniform.
constexpr Vec2 random_point(Random& random) {
    const Real x = random_real(random);
    return {x, random_real(random)};
}

/// Whole number in [0, count), each equally likely up to count · 2^-53; count > 0.
constexpr std::uint64_t random_index(Random& random, std::uint64_t count) {
    return static_cast<std::uint64_t>(random_real(random) * static_cast<Real>(count));
}

}  // namespace rt
