// The numbers that a pixel's samples are made from: stratified, and paired at random.
#include "chapters/12_distribution/samples.hpp"

#include "common/math/mixed.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rt {
namespace {

/// Uniform in [low, high), by 64 random bits; low if the sum is rounded up to high. Given.
[[maybe_unused]] Real between(Real low, Real high, std::uint64_t bits) {
    const Real x = low + real_of(bits) * (high - low);
    return x < high ? x : low;
}

}  // namespace

std::uint32_t permuted(std::uint32_t index, std::uint32_t count, std::uint64_t key) {
    // [exercise 12.1] The place of `index` in the order of `key`, a permutation of 0 … count − 1.
    if (count == 1) return 0;
    const std::uint32_t mask = ~std::uint32_t(0) >> std::countl_zero(count - 1);
    const int bits = static_cast<int>(std::bit_width(mask));
    const std::uint64_t own = stirred(key);
    std::uint32_t reached = index;
    do {
        for (std::uint64_t round = 0; round < 8; ++round) {
            // To undo them: subtract; multiply by the inverse, which odd numbers have modulo a power of two;
            // and the upper bits, which are still there, tell what was done to those below.
            const std::uint64_t word = mixed(own, round);
            reached += static_cast<std::uint32_t>(word);
            reached = reached * static_cast<std::uint32_t>(word >> 32 | 1) & mask;
            // By 1 at least and by bits − 1 at most.
            reached ^= reached >> (1 + static_cast<int>(word >> 58) * (bits - 1) / 64);
        }
        // The way from `index` leads back to it at the latest: a permutation consists of rings.
    } while (reached >= count);
    return reached;
    // [/exercise]
}

Stratum stratum(std::uint32_t index, std::uint32_t count) {
    // The same as in 08.2: row j of r holds the parts from floor(j·count/r) on. Part `index` is in the last
    // row that begins with it or before.
    const auto rows = static_cast<std::uint64_t>(std::sqrt(static_cast<Real>(count)));
    const std::uint64_t row = ((index + std::uint64_t(1)) * rows - 1) / count;
    const std::uint64_t first = row * count / rows, last = (row + 1) * count / rows;
    const Real columns = static_cast<Real>(last - first), i = static_cast<Real>(index - first), all = count;
    return {{i / columns, static_cast<Real>(first) / all},
            {(i + 1) / columns, static_cast<Real>(last) / all}};
}

Real stratified_number(std::uint32_t index, std::uint32_t count, std::uint64_t key) {
    // [exercise 12.2] A number that is uniform in the part of [0, 1) that this sample has, and independent of
    // which part that is.
    const Real part = permuted(index, count, key), all = count;
    return between(part / all, (part + 1) / all, mixed(mixed(stirred(key), 100), index));
    // [/exercise]
}

Vec2 stratified_point(std::uint32_t index, std::uint32_t count, std::uint64_t key) {
    // [exercise 12.2] Likewise a point of the stratum that this sample has; its two coordinates are
    // independent of each other.
    const std::uint64_t own = stirred(key);
    const auto [low, high] = stratum(permuted(index, count, key), count);
    return {between(low.x, high.x, mixed(mixed(own, 101), index)),
            between(low.y, high.y, mixed(mixed(own, 102), index))};
    // [/exercise]
}

}  // namespace rt
