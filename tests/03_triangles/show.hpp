// How the tests of this chapter print points: with all digits, so that a failing case can be repeated.
#pragma once

#include "chapters/03_triangles/triangle.hpp"

#include <sstream>

namespace rt::test {

inline std::string show(const Vec2& v) {
    std::ostringstream text;
    text.precision(17);
    text << "(" << v.x << ", " << v.y << ")";
    return text.str();
}

inline std::string show(const Vec3& v) {
    std::ostringstream text;
    text.precision(17);
    text << "(" << v.x << ", " << v.y << ", " << v.z << ")";
    return text.str();
}

inline std::string show(const Triangle& t) { return show(t.a) + ", " + show(t.b) + ", " + show(t.c); }

inline std::string show(const Ray& ray) { return show(ray.origin) + " + t " + show(ray.direction); }

}  // namespace rt::test
