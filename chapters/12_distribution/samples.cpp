// The numbers that a pixel's samples are made from: stratified, and paired at random.
#include "chapters/12_distribution/samples.hpp"

#include "common/math/mixed.hpp"
#include "common/math/todo.hpp"

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
    // 12.1  The place of `index` in the order of `key`, a permutation of 0 … count − 1.
    return todo("12.1");
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
    // 12.2  A number that is uniform in the part of [0, 1) that this sample has, and independent of
    // which part that is.
    return todo("12.2");
}

Vec2 stratified_point(std::uint32_t index, std::uint32_t count, std::uint64_t key) {
    // 12.2  Likewise a point of the stratum that this sample has; its two coordinates are
    // independent of each other.
    return todo("12.2");
}

}  // namespace rt
