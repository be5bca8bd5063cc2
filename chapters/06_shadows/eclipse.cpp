// How much of a round lamp a round thing hides: shadows with soft edges, without more rays.
// The lesson uses the same letters: a and b for the radii, d for the distance, α and β for half the angles.
#include "chapters/06_shadows/eclipse.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Real eclipsed(Real sun, Real moon, Real apart) {
    // 06.5  Which part of the sun's disc the moon's disc covers: none where they are beside each
    // other; all of it, or a part as large as the moon, where one lies within the other; and else the lens
    // that they share. The answer is a share of the sun's area.
    return todo("06.5");
}

}  // namespace rt
