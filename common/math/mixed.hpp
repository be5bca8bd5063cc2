// Bits that are a function of numbers and look like nothing else: what random numbers are made of.
#pragma once

#include "common/math/vec.hpp"

#include <cstdint>

namespace rt {

/// All 64 bits of `state` stirred into one another: the finalizer of splitmix64 (Steele, Lea & Flood 2014).
constexpr std::uint64_t stirred(std::uint64_t state) {
    state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9u;
    state = (state ^ (state >> 27)) * 0x94d049bb133111ebu;
    return state ^ (state >> 31);
}

/// `state` with one more value mixed in.
constexpr std::uint64_t mixed(std::uint64_t state, std::uint64_t value) {
    return stirred(state + value + 0x9e3779b97f4a7c15u);
}

/// Random bits as a number in [0, 1): one of the multiples of 2^-53.
constexpr Real real_of(std::uint64_t bits) { return static_cast<Real>(bits >> 11) * 0x1p-53; }

}  // namespace rt
