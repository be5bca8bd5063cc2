// Families of extreme cases for chapter 10's quartics and tori, and their judge.
//
// Demands. Quartics: positive, and not positive, where the answer says so, of some polynomial whose
// coefficients are within 8u (4 ulp) of the given ones, and |p(t)| ≤ 16u·Σ|aᵢtⁱ|. Tori: all that is said to
// be inside is inside of the torus whose tube is thicker by η, and all that is said to be outside is outside
// of the one whose tube is thinner by η, but for 8u|t| in t. With f = origin − centre, η is 8u|f| + 40u(R +
// r).
//
// Why 40: the way to the point near the torus is rounded 2 times, in units of u|f|. What follows is in units
// of u(R + r): the point at the base 3, its square 4, the axis and what is along and across it 5; the
// coefficients 5, and Horner's rule 8; and since F = Q² − P is up to 4 times the square of what it is made
// of, some of that is doubled.
#pragma once

#include "chapters/10_surfaces/torus.hpp"
#include "common/math/ray.hpp"
#include "common/world/hit.hpp"
#include "tests/stability/verdict.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rt::stability {

struct PolynomialCase {
    Polynomial polynomial;
    Real low, high;
};

struct PolynomialFamily {
    const char* name;
    std::vector<PolynomialCase> (*make)(std::size_t count, std::uint64_t seed);
};

struct TorusCase {
    Torus torus;
    Ray ray;
};

struct TorusFamily {
    const char* name;
    std::vector<TorusCase> (*make)(std::size_t count, std::uint64_t seed);
};

/// All the families; any prefix of a family's cases is the same for every count.
std::span<const PolynomialFamily> polynomial_families();
std::span<const TorusFamily> torus_families();

Verdict judge(std::span<const PolynomialCase> cases, std::span<const SignChanges> answers);

/// Judges what is inside of the whole line (`inside`).
Verdict judge(std::span<const TorusCase> cases, std::span<const TorusSpans> answers);

}  // namespace rt::stability

namespace rt::naive {

/// Closed formulas, by Cardano and Ferrari, with their constant 1e-9 for 0 (Schwarze, Cubic and quartic
/// roots, in A. S. Glassner (ed.), Graphics Gems, 1990); those roots that are between low and high.
SignChanges sign_changes(const Polynomial& p, Real low, Real high);

/// The quartic expanded at the ray's origin, and these formulas.
TorusSpans inside(const Torus& torus, const Ray& ray);

/// The quartic of a line with a unit direction, as a polynomial in t (Hanrahan 1989).
Polynomial torus_quartic(const Torus& torus, const Ray& ray);

/// The roots of that between places beyond the torus, by any method, as the ray's t.
SignChanges crossings_from_the_eye(const Torus& torus, const Ray& ray,
                                   SignChanges (*solve)(const Polynomial&, Real low, Real high));

}  // namespace rt::naive
