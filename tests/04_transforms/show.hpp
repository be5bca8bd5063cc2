// How the tests of this chapter compare matrices; how they print them stands in tests/show.hpp.
#pragma once

#include "tests/show.hpp"

#include <cmath>

namespace rt::test {

/// Greatest difference of two elements in the same place; infinite where one is not a number.
inline Real difference(const Mat4& a, const Mat4& b) {
    Real greatest = 0;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) {
            const Real d = std::abs(a[c][r] - b[c][r]);
            greatest = std::isnan(d) ? infinity : std::fmax(greatest, d);
        }
    return greatest;
}

}  // namespace rt::test
