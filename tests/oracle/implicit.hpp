// The exact judge of lines and surfaces f = 0 where f is a polynomial: CGAL's exact numbers behind a plain
// header.
#pragma once

#include "common/math/vec.hpp"
#include "common/scene/formula.hpp"

#include <optional>

namespace rt::oracle {

/// What is true of f at start + λ·way, 0 ≤ λ ≤ 1. It *clearly* has a sign at λ where it is more than three
/// times `rounding` · (what f would be if all that it subtracts were added) away from 0.
struct LineTruth {
    int roots = 0;  ///< in (0, 1); those within 2⁻⁴⁰ of each other count as one
    bool has_hidden =
        false;  ///< not between all of them f clearly has a sign, or not before the first or after the last
    bool is_overlooked = false;  ///< f clearly has one sign and later the other, before `proposed`
    bool is_on = true;  ///< f is 0 within `slack` of `proposed`, or does not clearly have a sign there
};

/// f must be a polynomial: without roots, functions, and divisions but by constants. Where nothing is
/// proposed, the whole chord is before it.
LineTruth judge_line(const Formula& f, const Vec3& start, const Vec3& way, Real rounding,
                     std::optional<Real> proposed, Real slack);

/// What is true of f where start + λ·way is near the surface.
struct NearRoot {
    Real step = 0;       ///< Newton's, without rounding but of its result: how much λ is too little
    Real slope = 0;      ///< of f by λ
    Real bend = 0;       ///< of the slope by λ
    Real magnitude = 0;  ///< what f would be there if all that it subtracts were added
};
NearRoot near_root(const Formula& f, const Vec3& start, const Vec3& way, Real lambda);

/// The sign of f at start + λ·way.
int sign_on_line(const Formula& f, const Vec3& start, const Vec3& way, Real lambda);

}  // namespace rt::oracle
