// Perlin's improved noise: a function of space that looks random, is smooth, and has features of one size.
// ε is the unit roundoff of `Real`.
#pragma once

#include "common/math/vec.hpp"

#include <array>
#include <cstdint>

namespace rt {

/// The numbers from 0 to 255 in Perlin's order (2002), from which the lattice's gradients are drawn. Given.
inline constexpr std::array<std::uint8_t, 256> noise_permutation{
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103, 30,
    69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,  197, 62,
    94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174, 20,  125, 136,
    171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231, 83,  111, 229, 122,
    60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143, 54,  65,  25,  63,  161,
    1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196, 135, 130, 116, 188, 159, 86,
    164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124, 123, 5,   202, 38,  147, 118, 126,
    255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,  182, 189, 28,  42,  223, 183, 170, 213,
    119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101, 155, 167, 43,  172, 9,   129, 22,  39,  253,
    19,  98,  108, 110, 79,  113, 224, 232, 178, 185, 112, 104, 218, 246, 97,  228, 251, 34,  242, 193,
    238, 210, 144, 12,  191, 179, 162, 241, 81,  51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,
    181, 199, 106, 157, 184, 84,  204, 176, 115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,
    222, 114, 67,  29,  24,  72,  243, 141, 128, 195, 78,  66,  215, 61,  156, 180};

/// Where a point is in the lattice of whole numbers.
struct LatticeCell {
    std::array<int, 3> corner{};  ///< the cell's lowest corner, each coordinate modulo 256: 0 to 255
    Vec3 offset{0};               ///< from that corner to the point, each coordinate in [0, 1]
};

/// The gradient of the noise at a point of the lattice: one of the 12 vectors from the centre of a cube of
/// side 2 to the middles of its edges. Whole numbers of any size and sign are good; those that differ by 256
/// have the same gradient. Given.
Vec3 lattice_gradient(int i, int j, int k);

/// [11.7] The smooth step from 0 to 1: 6t^5 - 15t^4 + 10t^3 for t in [0, 1], to 200ε. Its first two
/// derivatives are 0 at both ends (Perlin 2002).
Real fade(Real t);

/// [11.7] The cell that p is in, for any finite p. corner + offset is p but for a multiple of 256, and for
/// 2^-53 in each coordinate: a p just below a whole number may have the offset 1. From 2^53 on every p is
/// whole.
LatticeCell lattice_cell(const Vec3& p);

/// [11.7] Perlin's improved noise (2002) at p. Each corner of p's cell says what its lattice_gradient would
/// make of the way from the corner to p; the mean of the eight is weighted along each axis by fade. So it is
/// 0 at the points of the lattice, and repeats after 256 along each axis. For any finite p; in [-1.04, 1.04];
/// to 2500ε.
Real noise(const Vec3& p);

/// [11.10] The gradient of noise at p: its derivatives by x, y and z, by formula and not by differences. At a
/// point of the lattice it is the lattice_gradient. For any finite p; to 25000ε.
Vec3 noise_gradient(const Vec3& p);

/// The sum of |noise(2^i p)|/2^i for i from 0 to octaves - 1 (Perlin 1985): creases at every size, as smoke
/// and marble have them. At least 0, less than 2.08; 0 without octaves. For any finite p; where 2^i p is not
/// finite nothing is added. Given.
Real turbulence(const Vec3& p, int octaves);

}  // namespace rt
