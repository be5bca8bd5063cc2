// Families of extreme cases for chapter 10's implicit surfaces and quadrics, and their judge.
//
// Demands. The answer is judged on the chord that the course computes (chapters/10_surfaces/chord.hpp), whose
// start and way are taken as exact. f *clearly* has a sign where it is more than three times β away from 0.
// An answer is wrong where f clearly has one sign and later clearly the other, before the hit, or if there is
// none, on the whole chord; and where at the hit f clearly has a sign, and does not change it there. β is
// what rounding may make of f: with n operations, and 2 for each coordinate, 8nu of the sum of all sizes;
// since an operation on enclosures moves either end by 4u of itself at most: by its own rounding, and by what
// makes it certain. (For a quadric 32u of what f would be if nothing were subtracted; three times that is
// what its contract allows its coefficients.)
#pragma once

#include "tests/stability/solids.hpp"

#include <string>
#include <string_view>

namespace rt::stability {

std::span<const SolidFamily<Implicit>> implicit_families();
std::span<const SolidFamily<Quadric>> quadric_families();

/// Judges the nearest hit for the range (0, infinity].
Verdict judge(std::span<const SolidCase<Implicit>> cases, std::span<const std::optional<Hit>> answers);
Verdict judge(std::span<const SolidCase<Quadric>> cases, std::span<const std::optional<Hit>> answers);

/// A surface as the exact judge sees it: a polynomial, and β over the sum of all sizes.
struct JudgedPolynomial {
    Formula f;
    Real rounding = 0;
};
JudgedPolynomial polynomial_of(const Implicit& implicit);
JudgedPolynomial polynomial_of(const Quadric& quadric);

/// The surfaces that everybody knows: the heart, Barth's sextic, ... In boxes around the origin.
struct KnownSurface {
    const char* name;
    const char* expression;
    Real reach;  ///< of its box
};
std::span<const KnownSurface> known_surfaces();
Implicit surface(const KnownSurface& known);

/// The first of them whose name begins like this.
Implicit surface_named(std::string_view name);

/// The surface where an expression is 0, in a cube that reaches from −reach to reach.
Implicit surface_of(const std::string& expression, Real reach);

/// The heart in a box that fits it: that makes a small Lipschitz bound, which is good for sphere tracing.
Implicit tight_heart();

}  // namespace rt::stability

namespace rt::naive {

/// A hundred equal steps through the box, points and values as they come, and bisection where the sign
/// changes.
std::optional<Hit> intersect(const Implicit& implicit, const Ray& ray, Interval range);

/// The same with as many steps as are asked for.
std::optional<Hit> march(const Implicit& implicit, const Ray& ray, Interval range, int steps);

/// The quadratic from the eye, by h² − a·c.
std::optional<Hit> intersect(const Quadric& quadric, const Ray& ray, Interval range);

}  // namespace rt::naive
