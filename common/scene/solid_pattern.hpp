// Patterns in space: two colours that change places from point to point.
#pragma once

#include "common/math/vec.hpp"

namespace rt {

/// What a pattern in space looks like, one unit its size; chapters/11_textures/pattern.hpp says each exactly.
enum class PatternKind { Stripes, Rings, Gradient, Marble, Wood, Cellular };

/// Two colours, mixed by the value of a pattern, which is between 0 and 1. The pattern's own space is the
/// world's, divided by its size.
struct SolidPattern {
    PatternKind kind = PatternKind::Stripes;
    Real size = 1;   ///< of one stripe, ring, cell, ... in world units; greater than 0
    Vec3 first{1};   ///< where the value is 0
    Vec3 second{0};  ///< where it is 1
    friend bool operator==(const SolidPattern&, const SolidPattern&) = default;
};

}  // namespace rt
