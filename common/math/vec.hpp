// Vectors and matrices of the whole course: GLM's, over one scalar type.
// `Real` is defined here and nowhere else.
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rt {

/// The scalar of every length, angle, colour and parameter.
using Real = double;

using Vec2 = glm::vec<2, Real, glm::defaultp>;
using Vec3 = glm::vec<3, Real, glm::defaultp>;
using Vec4 = glm::vec<4, Real, glm::defaultp>;

/// Column-major, as in GLM: `m[column][row]`, points are columns, `m * p` transforms p.
using Mat3 = glm::mat<3, 3, Real, glm::defaultp>;
using Mat4 = glm::mat<4, 4, Real, glm::defaultp>;

inline constexpr Real infinity = std::numeric_limits<Real>::infinity();
inline constexpr Real pi = std::numbers::pi_v<Real>;

/// Degrees, as files write angles, to radians, as code computes with them.
constexpr Real radians(Real degrees) { return degrees * (pi / 180); }

/// The greatest of the coordinates.
inline Real max_component(const Vec3& v) { return std::max({v.x, v.y, v.z}); }

/// The greatest of the coordinates' sizes.
inline Real size_of(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The vector times a power of two, so that its greatest coordinate is in [1, 2) in size; 0 stays 0. It then
/// has the same direction to the bit, and its square neither overflows nor vanishes.
inline Vec3 near_one(const Vec3& v) {
    const Real size = size_of(v);
    if (!(size > 0) || !std::isfinite(size)) return v;
    const int exponent = -std::ilogb(size);
    if (exponent < std::numeric_limits<Real>::max_exponent) return std::ldexp(Real(1), exponent) * v;
    return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

/// The vector with length 1, however short or long it is; not for 0.
inline Vec3 unit(const Vec3& v) { return glm::normalize(v / size_of(v)); }

/// Some vector that is perpendicular to v and not 0, unless v is.
inline Vec3 any_across(const Vec3& v) {
    return glm::cross(v, std::abs(v.x) < std::abs(v.y) ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
}

}  // namespace rt
