// Small helpers of the tests of chapters 5 and 6; how they print values stands in tests/show.hpp.
#pragma once

#include "tests/show.hpp"

#include <cmath>

namespace rt::test {

inline bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace rt::test
