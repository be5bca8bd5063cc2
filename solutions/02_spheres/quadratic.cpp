// Real roots of a quadratic polynomial, without cancellation.
#include "chapters/02_spheres/quadratic.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Roots solve_quadratic(Real a, Real h, Real c, Real discriminant) {
    // [exercise 02.1] Return the real roots of a·t² + 2·h·t + c = 0 in ascending order, each with nearly all
    // of its digits. `discriminant` is h² − a·c: take it as given.
    if (discriminant < 0) return {};
    if (discriminant == 0) return {1, -h / a, -h / a};
    const Real q = -(h + std::copysign(std::sqrt(discriminant), h));
    const auto [t0, t1] = std::minmax({q / a, c / q});
    return {2, t0, t1};
    // [/exercise]
}

}  // namespace rt
