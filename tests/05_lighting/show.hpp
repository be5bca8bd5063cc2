// How failing tests of chapters 5 and 6 show what went in and what came out.
#pragma once

#include "chapters/05_lighting/lighting.hpp"

#include <cmath>
#include <cstdio>
#include <string>

namespace rt::test {

/// Every digit that tells the number from its neighbours.
inline std::string show(Real x) {
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.17g", x);
    return digits;
}

inline std::string show(const Vec3& v) { return "(" + show(v.x) + ", " + show(v.y) + ", " + show(v.z) + ")"; }

inline std::string show(const PointLight& light) {
    return "point light at " + show(light.position) + ", colour " + show(light.color) + ", attenuation " +
           show(light.attenuation);
}

inline std::string show(const LightSample& sample) {
    return "direction " + show(sample.direction) + ", distance " + show(sample.distance) + ", colour " +
           show(sample.color);
}

inline bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Whether each coordinate of `actual` is within `bound` of that of `expected`; false for NaN.
inline bool near(const Vec3& actual, const Vec3& expected, Real bound) {
    for (int i = 0; i < 3; ++i) {
        if (!(std::abs(actual[i] - expected[i]) <= bound)) return false;
    }
    return true;
}

}  // namespace rt::test
