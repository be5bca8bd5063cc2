// Patterns in space.
#include "chapters/11_textures/pattern.hpp"

#include "chapters/11_textures/cells.hpp"
#include "chapters/11_textures/noise.hpp"

#include <cmath>

namespace rt {

Real stripe_value(const Vec3& q) {
    // [exercise 11.8] Return 0 or 1: is x in an even or an odd one of the slices between whole numbers?
    return std::fmod(std::floor(q.x), 2) == 0 ? 0 : 1;
    // [/exercise]
}

Real ring_value(const Vec3& q) {
    // [exercise 11.8] The same of the distance from the y axis.
    return stripe_value({std::hypot(q.x, q.z), 0, 0});
    // [/exercise]
}

Real gradient_value(const Vec3& q) {
    // [exercise 11.8] How far is y above the whole number below it?
    return q.y - std::floor(q.y);
    // [/exercise]
}

Real marble_value(const Vec3& q) {
    // [exercise 11.8] (1 + sin(pi * s))/2 with s = x + 4 * turbulence(q/4, 6), right also where x is huge.
    const Real x = std::fmod(q.x, 2);
    return (1 + std::sin(pi * (x + 4 * turbulence(q / Real(4), 6)))) / 2;
    // [/exercise]
}

Real wood_value(const Vec3& q) {
    // [exercise 11.8] How far is the distance from the y axis, and twice the noise at q/8, above the whole
    // number below their sum?
    const Real ring = std::hypot(q.x, q.z) + 2 * noise(q / Real(8));
    return ring - std::floor(ring);
    // [/exercise]
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
    // [exercise 11.8] Return the two colours, mixed by the pattern's value at the point.
    const Real value = pattern_value(pattern.kind, point / pattern.size);
    return (1 - value) * pattern.first + value * pattern.second;
    // [/exercise]
}

}  // namespace rt
