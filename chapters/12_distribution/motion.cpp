// Motion blur: when light comes in, and how a ray sees what moves meanwhile.
// The lesson uses the same letters: o and c for how long the shutter opens and closes, A for all the light, θ
// for an angle, and r for how far the farthest corner is from the centre.
#include "chapters/12_distribution/motion.hpp"

#include "common/math/error.hpp"
#include "common/math/todo.hpp"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {

Real shutter_time(const Shutter& shutter, Real random) {
    // 12.8  The time at which the part `random` of all the light has come in.
    return todo("12.8");
}

Ray seen_while_moving(const Ray& ray, const Vec3& motion) {
    // 12.9  The ray as the moving thing sees it.
    return todo("12.9");
}

Bounds bounds_while_moving(const Bounds& bounds, const Vec3& motion) {
    // 12.9  The box around all places of the box on its way, with faces that are certainly outside.
    return todo("12.9");
}

Ray seen_while_turning(const Ray& ray, const Spin& spin) {
    // 12.21  The ray as the turning thing sees it.
    return todo("12.21");
}

Interval arc_range(Real x, Real y, Real angle) {
    // 12.22  The least and the greatest value of x·cos θ + y·sin θ on the way from 0 to `angle`.
    return todo("12.22");
}

namespace {

/// The eight corners of a box, as seen from the centre. Given.
[[maybe_unused]] std::array<Vec3, 8> corners_from(const Vec3& center, const Bounds& bounds) {
    std::array<Vec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
        const bool right = (i & 1) != 0, upper = (i & 2) != 0, front = (i & 4) != 0;
        corners[i] = Vec3(right ? bounds.high.x : bounds.low.x, upper ? bounds.high.y : bounds.low.y,
                          front ? bounds.high.z : bounds.low.z) -
                     center;
    }
    return corners;
}

}  // namespace

Bounds bounds_while_turning(const Bounds& bounds, const Spin& spin) {
    // 12.22  The box around the arcs of all eight corners, with faces that are certainly outside.
    return todo("12.22");
}

}  // namespace rt
