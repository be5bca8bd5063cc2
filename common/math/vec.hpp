// Vectors and matrices of the whole course: GLM's, over one scalar type.
// `Real` is defined here and nowhere else.
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

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

}  // namespace rt
