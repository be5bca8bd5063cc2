// How large and how small the numbers of a scene may be.
#pragma once

#include "common/math/ray.hpp"
#include "common/math/vec.hpp"

#include <cmath>

namespace rt {

/// Coordinates, lengths, colours and the factors of transforms are at most this in size, in the world, ...
inline constexpr Real largest_number = 1e30;
/// ... and what has a size, such as a radius, is at least this. In metres: from a millionth of a billionth of
/// a proton to a thousand times what can be seen of the universe.
inline constexpr Real smallest_size = 1e-30;

// Between them nothing that the course computes leaves the range of double. A ray meets planes up to 2^53
// times as far away as they are; there its distance from a ball is squared, and multiplied by the square of
// its direction, which may have been stretched by a transform: (1e30 · 1e16 · 1e30)² · 1e60 = 1e212. Colours:
// of a light 1e30, divided by the square of a distance of rounding size, 1e-92, and by an attenuation of
// 1e-30, times a diffuse colour and a checker, 1e60, times what bounces and filters make of it, 1e30 each:
// 1e272.

/// A ball may be this much flatter than the angle (in radians, 1 at most) of a picture in perspective, and
/// its shortest half-axis may be this much shorter than the way to the eye in a parallel projection. Rounding
/// moves its rim by 4·2^-53 times as much: by a twentieth of a pixel in a picture of a thousand.
inline constexpr Real most_flattening = 1e11;

/// Numbers of a finish: a roughness, the index of refraction of a coat, the exponent of a lobe.
inline constexpr Interval roughness_range{0, 1}, coat_range{1, 4}, gloss_range{0, 1e8};

/// Whether the vector's coordinates are in range; false for NaN.
inline bool in_range(const Vec3& v) {
    return std::abs(v.x) <= largest_number && std::abs(v.y) <= largest_number &&
           std::abs(v.z) <= largest_number;
}

/// Whether a matrix's numbers are in range.
inline bool in_range(const Mat3& m) { return in_range(m[0]) && in_range(m[1]) && in_range(m[2]); }
inline bool in_range(const Mat4& m) { return in_range(Mat3(m)) && in_range(Vec3(m[3])); }

}  // namespace rt
