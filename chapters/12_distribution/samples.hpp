// The numbers that a pixel's samples are made from, in one dimension or two at a time: stratified, and paired
// at random (Cook, Porter & Carpenter, Distributed ray tracing, 1984).
#pragma once

#include "chapters/08_antialiasing/samples.hpp"
#include "common/math/vec.hpp"

#include <cstdint>

namespace rt {

// `index` is the number of one of a pixel's `count` samples: index < count, and count is at least 1 and may
// be as great as 2^32 − 1. `key` says for what the number is used: each pixel and each thing that is drawn at
// random there, such as the place on the lens, has a key of its own. All 64 bits of it matter.

/// [12.1] The place of `index` in a random order of 0, 1, …, count − 1. For each key it is a permutation:
/// different indices have different places, all of them below `count`.
///
/// Taken over the keys, an index is at each place equally often, and two indices are at each pair of places
/// equally often; different keys, also neighbouring ones such as 5 and 6, are independent. So well as two
/// thousand keys can show. It takes a time that does not grow with count, in the mean over the indices, and
/// no memory: a permutation of the numbers below a power of two, repeated until the place is below count
/// (Black & Rogaway 2002, Kensler 2013).
std::uint32_t permuted(std::uint32_t index, std::uint32_t count, std::uint64_t key);

/// The part of the unit square that is number `index` of strata(count) (08.2), to the bit, without the
/// others. Given.
Stratum stratum(std::uint32_t index, std::uint32_t count);

/// [12.2] The number of sample `index` in one dimension, in [0, 1). Of the samples 0 … count − 1 exactly one
/// is in each of the parts from k/count to (k + 1)/count, uniform in it, wherever the others are in theirs.
/// Which one it is, is permuted by the key. (A sample on the border of two parts may be rounded onto it.)
///
/// Different keys are independent of each other. What the same key gives to stratified_point is not.
Real stratified_number(std::uint32_t index, std::uint32_t count, std::uint64_t key);

/// [12.2] The point of sample `index` in the unit square [0, 1)²: likewise exactly one of the samples is in
/// each of the strata(count), uniform in it in both coordinates.
Vec2 stratified_point(std::uint32_t index, std::uint32_t count, std::uint64_t key);

}  // namespace rt
