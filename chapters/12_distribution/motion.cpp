// Motion blur: when light comes in, and how a ray sees what moves meanwhile.
// The lesson uses the same letters: o and c for how long the shutter opens and closes, A for all the light, θ
// for an angle, and r for how far the farthest corner is from the center.
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
    // 12.8  Draw how far the shutter is open over time: the light until a time is the area of the
    // trapezoid to the left of it. Find the whole area and how much of it is asked for; then, in which of the
    // three parts that much is reached, and when.
    return todo("12.8");
}

Ray seen_while_moving(const Ray& ray, const Vec3& motion) {
    // 12.9  Where the thing is at ray.time, it has moved by a part of `motion`. Move the ray's
    // origin as far in the opposite direction.
    return todo("12.9");
}

Bounds bounds_while_moving(const Bounds& bounds, const Vec3& motion) {
    // 12.9  The box at time 0, the box at time 1, and all between them. Along each axis one of the
    // two faces stays where it is, and the other is moved. Move each face to the next number outwards
    // (std::nextafter), because a sum may have been rounded inwards. Leave an empty box alone.
    return todo("12.9");
}

Ray seen_while_turning(const Ray& ray, const Spin& spin) {
    // 12.21  Where the thing is at ray.time, it has turned by a part of the angle. Turn the ray's
    // origin, as seen from the center, and its direction back by as much: by Rodrigues' formula, step 04.2.
    // Written as what is added to a vector, the turn by nothing adds nothing, and all bits stay.
    return todo("12.21");
}

Interval arc_range(Real x, Real y, Real angle) {
    // 12.22  Over θ this is a cosine curve. How high does it go, and at which angle between 0 and
    // 2π? Where is it lowest? What is not reached before `angle` does not count, but the two ends do. A turn
    // the other way is the mirror image of this one: −y for y.
    return todo("12.22");
}

namespace {

/// The eight corners of a box, as seen from the center. Given.
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
    // 12.22  Each corner turns on an arc, center + along + across·cos θ + side·sin θ, where `along`
    // is the part of the corner along the axis, which stays. Join the ranges of all arcs, coordinate by
    // coordinate. At last move the faces outwards by gamma(64) of |center| + r: that is more than all that
    // was rounded. Leave an empty box alone.
    return todo("12.22");
}

}  // namespace rt
