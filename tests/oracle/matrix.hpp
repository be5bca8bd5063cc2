// The exact judge of affine maps: CGAL's exact numbers behind a plain header.
// Every input must be finite; nothing is rounded until an answer is handed out.
#pragma once

#include "common/math/vec.hpp"

namespace rt::oracle {

/// The facts about the linear part of an affine matrix M and a proposed inverse X of it, and about the
/// translation. Numbers are rounded at the end only.
struct InverseTruth {
    bool singular = false;  ///< the determinant is exactly zero; then everything else stays as it is here
    Mat3 inverse{0};        ///< the exact inverse, each element rounded once or twice
    Mat3 right{0};          ///< M·X − I
    Mat3 left{0};           ///< X·M − I
    Vec3 translation{0};    ///< M's linear part times X's translation, plus M's translation
};

InverseTruth judge_inverse(const Mat4& m, const Mat4& proposed);

/// normal · (linear part of m · tangent), rounded once.
Real judge_normal(const Mat4& m, const Vec3& normal, const Vec3& tangent);

}  // namespace rt::oracle
