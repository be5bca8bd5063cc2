// How failing tests of chapter 1 show what went in and what came out.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"
#include "common/scene/view.hpp"

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

inline std::string show(const Ray& ray) {
    return "ray from " + show(ray.origin) + " along " + show(ray.direction);
}

inline std::string show(const Plane& plane) {
    return "plane through " + show(plane.point) + " with normal " + show(plane.normal);
}

inline std::string show(const CameraFrame& frame) {
    return "u = " + show(frame.u) + "\nv = " + show(frame.v) + "\nw = " + show(frame.w);
}

/// Whether each coordinate of `actual` is within `bound` of that of `expected`; false for NaN.
inline bool near(const Vec3& actual, const Vec3& expected, Real bound) {
    for (int i = 0; i < 3; ++i) {
        if (!(glm::abs(actual[i] - expected[i]) <= bound)) return false;
    }
    return true;
}

}  // namespace rt::test
