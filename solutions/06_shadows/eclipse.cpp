// How much of a round lamp a round thing hides: shadows with soft edges, without more rays.
// The lesson uses the same letters: a and b for the radii, d for the distance, α and β for half the angles.
#include "chapters/06_shadows/eclipse.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Real eclipsed(Real sun, Real moon, Real apart) {
    // [exercise 06.5] Which part of the sun's disc the moon's disc covers: none where they are beside each
    // other; all of it, or a part as large as the moon, where one lies within the other; and else the lens
    // that they share. The answer is a share of the sun's area.
    const Real a = sun, b = moon, d = apart;
    if (d >= a + b) return 0;
    if (d <= std::abs(a - b)) return b >= a ? 1 : b / a * (b / a);
    // The line through the two corners of the lens is x from the sun's centre, and d − x from the moon's.
    const Real x = (d * d + (a - b) * (a + b)) / (2 * d);
    const Real alpha = std::acos(std::clamp(x / a, Real(-1), Real(1)));
    const Real beta = std::acos(std::clamp((d - x) / b, Real(-1), Real(1)));
    const Real of_sun = a * a * (alpha - std::sin(alpha) * std::cos(alpha));
    const Real of_moon = b * b * (beta - std::sin(beta) * std::cos(beta));
    return std::clamp((of_sun + of_moon) / (pi * a * a), Real(0), Real(1));
    // [/exercise]
}

}  // namespace rt
