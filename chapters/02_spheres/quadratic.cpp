// Real roots of a quadratic polynomial, without cancellation.
#include "chapters/02_spheres/quadratic.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Roots solve_quadratic(Real a, Real h, Real c, Real discriminant) {
    // 02.1  Return the real roots of a·t² + 2·h·t + c = 0 in ascending order, each with nearly all
    // of its digits. `discriminant` is h² − a·c: take it as given.
    return todo("02.1");
}

}  // namespace rt
