// Helpers for all tests: how many cases, where things are, messages of errors, and reproducible random
// numbers.
#pragma once

#include "common/math/error.hpp"
#include "common/math/input_error.hpp"
#include "common/math/ray.hpp"

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace rt::test {

/// Number of random cases to run: `full` in `course test`, a tenth of it (at least 1) in quick runs and in a
/// student's check.
int cases(int full);

/// Given by --seed; every Random depends on it. 0 for the cases that everybody knows.
inline std::uint64_t case_seed = 0;

/// What a test may demand of its random cases themselves, such as how many of them are hits: of those that
/// everybody knows what they give, of others only what chance does not deny.
inline int demanded(int of_known_cases, int of_others) { return case_seed == 0 ? of_known_cases : of_others; }

/// How a call ended that gave no answer: "crashed", "timed out" or "too much memory"; empty if none did in
/// this test. Only the autograder's judges, whose calls are answered by another process, live to say so.
extern std::string stopped;

/// The clock for what functions under test take, in seconds: the wall clock's, or where another process
/// answers the calls, what the functions have taken there so far.
extern double (*running_seconds)();

/// Where test programs may write: a directory that exists, inside the build directory.
std::string scratch_directory();

/// The repository's root.
std::string repository();

/// The message of the InputError that `action` throws; empty where it throws none.
template <class Action>
std::string error_of(Action action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// All that is in front of a ray.
inline constexpr Interval ahead{0, infinity};

inline bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Random numbers from a fixed seed, so that a failing case fails again.
struct Random {
    explicit Random(std::uint64_t number) : engine(number + case_seed * 0x9e3779b97f4a7c15) {}
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
    /// A unit vector perpendicular to `v`, up to rounding; in no direction more often than in another.
    Vec3 perpendicular_to(const Vec3& v) { return glm::normalize(glm::cross(v, direction())); }
    /// Whole number in [0, count).
    std::size_t index(std::size_t count) { return static_cast<std::size_t>(engine() % count); }
    /// 1 or -1.
    Real sign() { return index(2) == 0 ? -1 : 1; }
    /// 1, or up to 80 ulps more or less.
    Real nudge() { return 1 + std::floor(uniform(-80, 81)) * 2 * unit_roundoff; }
};

/// A ray to the target, from `distance` away in any direction; its t there is from a half to 2.
inline Ray towards(Random& random, const Vec3& target, Real distance) {
    const Vec3 origin = target - distance * random.direction();
    return {origin, (target - origin) * (random.uniform(0.5, 2) / distance)};
}

/// What `make(random)` returns, `count` times.
template <class Make>
auto many(std::size_t count, std::uint64_t seed, Make make) {
    Random random(seed);
    std::vector<decltype(make(random))> made;
    made.reserve(count);
    for (std::size_t i = 0; i < count; ++i) made.push_back(make(random));
    return made;
}

}  // namespace rt::test
