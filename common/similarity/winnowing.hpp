// Winnowing: a few fingerprints that stand for a whole text (Schleimer, Wilkerson & Aiken 2003).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// A hash of each `length` neighbours, by the place of the first: none where there are fewer kinds. Rolling
/// (Karp & Rabin 1987): a step takes one out and one in.
std::vector<std::uint64_t> hashes_of_grams(std::span<const std::uint16_t> kinds, std::size_t length);

/// The places of the hashes that are kept: of any `window` neighbours the least, and of equal ones the last;
/// of fewer neighbours the least of all. In ascending order, each once.
///
/// So two texts that have `window` + `length` - 1 kinds in common, one behind the other, keep one and the
/// same gram of these, wherever they stand in the two.
std::vector<std::size_t> winnowed(std::span<const std::uint64_t> hashes, std::size_t window);

}  // namespace rt
