// Patterns in space.
#include "chapters/11_textures/pattern.hpp"

#include "chapters/11_textures/cells.hpp"
#include "chapters/11_textures/noise.hpp"

#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Real stripe_value(const Vec3& q) {
    // 11.8  Return 0 or 1: is x in an even or an odd one of the slices between whole numbers?
    return todo("11.8");
}

Real ring_value(const Vec3& q) {
    // 11.8  The same of the distance from the y axis.
    return todo("11.8");
}

Real gradient_value(const Vec3& q) {
    // 11.8  How far is y above the whole number below it?
    return todo("11.8");
}

Real marble_value(const Vec3& q) {
    // 11.8  (1 + sin(pi * s))/2 with s = x + 4 * turbulence(q/4, 6), right also where x is huge.
    return todo("11.8");
}

Real wood_value(const Vec3& q) {
    // 11.8  How far is the distance from the y axis, and twice the noise at q/8, above the whole
    // number below their sum?
    return todo("11.8");
}

Real pattern_value(PatternKind kind, const Vec3& q) {
    switch (kind) {
        case PatternKind::Stripes:
            return stripe_value(q);
        case PatternKind::Rings:
            return ring_value(q);
        case PatternKind::Gradient:
            return gradient_value(q);
        case PatternKind::Marble:
            return marble_value(q);
        case PatternKind::Wood:
            return wood_value(q);
        case PatternKind::Cellular: {
            const CellDistances distances = cell_distances(q);
            return std::min(Real(1), 2 * (distances.second - distances.first));
        }
    }
    return 0;
}

Vec3 pattern_color(const SolidPattern& pattern, const Vec3& point) {
    // 11.8  Return the two colours, mixed by the pattern's value at the point.
    return todo("11.8");
}

}  // namespace rt
