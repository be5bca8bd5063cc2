// Helpers for all tests: how many cases, and reproducible random numbers.
#pragma once

#include "common/math/ray.hpp"

#include <cmath>
#include <cstdint>

#include <random>
#include <string>

namespace rt::test {

/// Number of random cases to run: `full` in `course test`, a tenth of it (at least 1) in quick runs and in a
/// student's check.
int cases(int full);

/// Where test programs may write: a directory that exists, inside the build directory.
std::string scratch_directory();

/// The repository's root.
std::string repository();

/// Random numbers from a fixed seed, so that a failing case fails again.
struct Random {
    explicit Random(std::uint64_t seed) : engine(seed) {}
    std::mt19937_64 engine;

    /// Uniform in [low, high).
    Real uniform(Real low, Real high) {
        return low + (high - low) * static_cast<Real>(engine() >> 11) * 0x1p-53;
    }
    /// 10 to a power that is uniform in [low, high): covers orders of magnitude evenly.
    Real magnitude(Real low_exponent, Real high_exponent) {
        return std::pow(Real(10), uniform(low_exponent, high_exponent));
    }
    /// Each coordinate uniform in [-1, 1).
    Vec3 in_cube() {
        const Real x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
        return {x, y, z};
    }
    /// Uniform on the unit sphere (Archimedes: z is uniform), up to rounding.
    Vec3 direction() {
        const Real z = uniform(-1, 1), phi = uniform(0, 2 * pi), r = std::sqrt(1 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }
    /// Whole number in [0, count).
    std::size_t index(std::size_t count) { return static_cast<std::size_t>(engine() % count); }
};

}  // namespace rt::test
