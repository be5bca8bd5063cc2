// Formulas as POV-Ray writes them: as a function, or multiplied out for its `polynomial`.
#pragma once

#include "common/scene/formula.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>

namespace rt::povray {

/// As the body of a `function`.
std::string function_of(const Formula& f);

/// Coefficients by the exponents of x, y and z; those that are 0 are left out.
using PolynomialTerms = std::map<std::array<int, 3>, Real>;

/// The degree up to which POV-Ray solves polynomials.
inline constexpr int greatest_degree = 35;

/// The terms of f, multiplied out; nothing where f has a function in it, is divided by more than a number,
/// has a negative power, or a degree greater than that.
std::optional<PolynomialTerms> terms_of(const Formula& f);

int degree_of(const PolynomialTerms& terms);

}  // namespace rt::povray
