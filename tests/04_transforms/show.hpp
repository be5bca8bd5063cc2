// How matrices and vectors are written in the messages of this chapter's tests, and how they are compared.
#pragma once

#include "common/math/vec.hpp"

#include <cmath>
#include <sstream>
#include <string>

namespace rt::test {

inline std::string show(const Vec3& v) {
    std::ostringstream out;
    out.precision(17);
    out << '(' << v.x << ", " << v.y << ", " << v.z << ')';
    return out.str();
}

/// Row by row, as on paper.
inline std::string show(const Mat4& m) {
    std::ostringstream out;
    out.precision(17);
    for (int r = 0; r < 4; ++r)
        out << "\n  | " << m[0][r] << "  " << m[1][r] << "  " << m[2][r] << "  " << m[3][r] << " |";
    return out.str();
}

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
