// Random vectors for tests of extreme cases.
#pragma once

#include "tests/support.hpp"

namespace rt::test {

/// A vector whose coordinates have sizes of their own; some are 0.
inline Vec3 of_all_sizes(Random& random, Real least, Real greatest) {
    Vec3 v;
    for (int axis = 0; axis < 3; ++axis) {
        const Real size = random.magnitude(least, greatest);
        v[axis] = random.index(6) == 0 ? 0 : random.sign() * size;
    }
    return v;
}

}  // namespace rt::test
