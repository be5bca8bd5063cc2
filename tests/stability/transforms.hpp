// Families of extreme cases for chapter 4, and their judges.
// A family makes any number of cases from a seed; answers are collected first and judged together.
//
// The condition number of the element (i, j) of M·M⁻¹ is κ = (|M||M⁻¹|)ᵢⱼ, that of M⁻¹·M likewise: moving the
// elements of a factor by a relative ε moves the product by at most κ·ε. κ does not grow when a row of M is
// multiplied by 1e15 together with the column of M⁻¹ that this divides, as ‖M‖‖M⁻¹‖ does; where it is small,
// the demand is the harder. Demands: |MM⁻¹ − I| ≤ 8uκ and |M⁻¹M − I| ≤ 8uκ, element by element and to first
// order (uκ·uκ is added), the translation likewise; a singular matrix has no inverse, an invertible one has,
// unless moving its elements by 8 ulp of the greatest in their row could make it singular; and no answer is
// NaN or infinite.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/hit.hpp"
#include "common/world/world.hpp"
#include "tests/stability/verdict.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rt::stability {

struct MatrixFamily {
    const char* name;
    const char* condition;  ///< what κ is like here
    std::vector<Mat4> (*make)(std::size_t count, std::uint64_t seed);
};

/// All the families; any prefix of a family's cases is the same for every count.
std::span<const MatrixFamily> matrix_families();

/// Judges inverses.
Verdict judge(std::span<const Mat4> cases, std::span<const std::optional<Mat4>> answers);

/// A normal and a tangent at right angles, exactly, and a map for both.
struct NormalCase {
    Transform transform;
    Vec3 normal, tangent;
};

/// From the matrices of a family, which must not be singular; their inverses are exact, rounded.
std::vector<NormalCase> normal_cases(const MatrixFamily& family, std::size_t count, std::uint64_t seed);

/// Judges unit normals n′ of images: with κ = |n|ᵀ|M⁻¹||M||τ| / (|M⁻ᵀn||Mτ|), the cosine of the angle between
/// n′ and Mτ is at most 8uκ (and 8u, for the rounding of n′ alone), and n′ is a unit vector to 8u.
Verdict judge(std::span<const NormalCase> cases, std::span<const Vec3> answers);

/// A ray and an ellipsoid.
struct EllipsoidCase {
    Ellipsoid ellipsoid;
    Ray ray;
};

struct EllipsoidFamily {
    const char* name;
    const char* condition;
    std::vector<EllipsoidCase> (*make)(std::size_t count, std::uint64_t seed);
};

std::span<const EllipsoidFamily> ellipsoid_families();

/// Judges the hit for the range (0, infinity]: with E = |M⁻¹|(|o| + |t||d| + |m|), m the translation of M,
/// and the local unit normal n and direction d′, the condition number of t is κ = (|E| + 1)/(|t||n·d′|). Hit
/// or miss is right unless moving the data by 4 ulp would change it, and |Δt| ≤ 8κu|t|.
Verdict judge(std::span<const EllipsoidCase> cases, std::span<const std::optional<Hit>> answers);

}  // namespace rt::stability
