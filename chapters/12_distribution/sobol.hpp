// The Sobol' sequence (1967), scrambled (Owen 1995): points that are stratified in many ways at once.
#pragma once

#include "common/math/vec.hpp"

#include <array>
#include <cstdint>

namespace rt {

// Coordinates are 32-bit fractions: the number b stands for b·2^-32 in [0, 1). Its highest bit is the half
// that it is in, the next one the quarter of it, and so on. An interval from j/2^k to (j + 1)/2^k, whose
// numbers share their first k bits, is called binary.

/// How many dimensions have direction numbers here.
inline constexpr std::uint32_t sobol_dimensions = 16;

/// The direction numbers of a dimension, which is less than sobol_dimensions, as 32-bit fractions: the one
/// for bit 0 of the index, its lowest, first. By Joe & Kuo, Constructing Sobol sequences with better
/// two-dimensional projections, 2008 (their table new-joe-kuo-6.21201). Given.
std::array<std::uint32_t, 32> sobol_directions(std::uint32_t dimension);

/// [12.3] The coordinate of point `index` of the Sobol' sequence in a dimension, which is less than
/// sobol_dimensions, as a 32-bit fraction: the exclusive or of the direction numbers of those bits that are 1
/// in the index. The sequence is in its own order, without Gray code, and begins with 0.
std::uint32_t sobol_bits(std::uint32_t index, std::uint32_t dimension);

/// [12.4] Owen's scrambling of a 32-bit fraction. Each of its bits is flipped or stays, as a coin says that
/// depends on the key and on the bits above this one, and on nothing else: neither on the bit itself nor on
/// those below. So for each key it is a permutation of the fractions, and of the binary intervals of each
/// width.
///
/// Each coin is fair, each two of the first three (that of the first bit, and those of the second after a 0
/// and after a 1) are independent, and so are those of different keys, of which all 64 bits matter: so well
/// as two thousand keys can show. (Either a hash of the bits above gives each coin, and all are independent;
/// or sums and products of the reversed bits give all of them at once, as Laine & Karras 2011 and Burley
/// 2020, and they nearly are.)
std::uint32_t owen_scrambled(std::uint32_t bits, std::uint64_t key);

/// [12.5] Point `index` of a scrambled and shuffled Sobol' sequence in the unit square [0, 1)² (Burley,
/// Practical hash-based Owen scrambling, 2020): dimensions 0 and 1 of the point whose number is the index
/// scrambled, each scrambled, too, by coins of its own. Multiples of 2^-32.
///
/// The index is scrambled as it is, by coins from its highest bit down. So any 2^k points that begin at an
/// index which is a multiple of 2^k are 2^k successive points of the Sobol' sequence in another order: one of
/// them is in each of the 2^k rectangles of 2^-a by 2^-b, a + b = k, for every a (a (0, k, 2)-net in base 2).
/// Each point is uniform, taken over the keys, and different keys are independent.
Vec2 sobol_point(std::uint32_t index, std::uint64_t key);

/// [12.5] The first index of the pixel (x, y), where all pixels of a picture share one sequence, `count`
/// points each: a multiple of count. x and y count modulo 4096. count is a power of two, 256 at most.
///
/// Each square of 2^k by 2^k pixels whose corner has multiples of 2^k as coordinates shares 4^k·count
/// successive indices, the first of them a multiple of 4^k·count (Z-order). So not only the samples of a
/// pixel are a net, but also those of the square together: what one pixel has too much, its neighbours have
/// too little. The order of the four quarters of each square is random by the key: for each square each of
/// the 24 orders equally often, whatever it is in other squares (Ahmed & Wonka 2020).
std::uint32_t pixel_start(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint64_t key);

}  // namespace rt
