// Families of extreme cases for chapter 2, and their judge.
// A family makes any number of cases from a seed; answers are collected first and judged together.
//
// The condition number of a root t, with f = origin − centre and n the unit normal at the hit, is
//     κ = (|f| + |t||d| + r) / (|t| |n·d|):
// moving the data f, d and r by a relative ε moves t by at most κ·ε·|t|. Demands: hit or miss is right unless
// moving the data by 4 ulp (8u) would change the answer, and |Δt| ≤ 8κu|t|.
#pragma once

#include "chapters/02_spheres/quadratic.hpp"
#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"
#include "common/world/hit.hpp"
#include "tests/stability/verdict.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rt::stability {

struct SphereCase {
    Sphere sphere;
    Ray ray;
};

struct SphereFamily {
    const char* name;
    const char* condition;  ///< what κ is like here
    std::vector<SphereCase> (*make)(std::size_t count, std::uint64_t seed);
};

/// All the families; any prefix of a family's cases is the same for every count.
std::span<const SphereFamily> sphere_families();

/// Judges both roots of the line (`intersections`).
Verdict judge(std::span<const SphereCase> cases, std::span<const Roots> answers);

/// Judges the nearest hit for the range (0, infinity] (`intersect`).
Verdict judge(std::span<const SphereCase> cases, std::span<const std::optional<Hit>> answers);

/// a·t² + 2·h·t + c with its discriminant h² − a·c, computed exactly and rounded once.
struct QuadraticCase {
    Real a = 1, h = 0, c = 0, discriminant = 0;
};

/// Coefficients of all sizes, with roots up to 1e16 times apart; κ is 1, because the discriminant is data.
std::vector<QuadraticCase> quadratic_cases(std::size_t count, std::uint64_t seed);

/// Judges both roots: |Δt| ≤ 4u|t| (½ + 1 for the root of the rounded discriminant, 1 for the sum, 1 for the
/// quotient, rounded up).
Verdict judge(std::span<const QuadraticCase> cases, std::span<const Roots> answers);

}  // namespace rt::stability
