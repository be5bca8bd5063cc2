// Motion blur: when light comes in, and how a ray sees what moves meanwhile.
// The lesson uses the same letters: o and c for how long the shutter opens and closes, A for all the light, θ
// for an angle, and r for how far the farthest corner is from the centre.
#include "chapters/12_distribution/motion.hpp"

#include "common/math/error.hpp"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {

Real shutter_time(const Shutter& shutter, Real random) {
    // [exercise 12.8] The time at which the part `random` of all the light has come in.
    const auto [o, c] = shutter;
    const Real A = 1 - o / 2 - c / 2, light = random * A;
    // While it opens, light = ½·t·t/o.
    if (light < o / 2) return std::sqrt(2 * o * light);
    // While it is open, light = o/2 + (t − o).
    if (light <= 1 - o / 2 - c) return light + o / 2;
    // While it closes, what is still to come is ½·(1 − t)·(1 − t)/c.
    return 1 - std::sqrt(2 * c * A * (1 - random));
    // [/exercise]
}

Ray seen_while_moving(const Ray& ray, const Vec3& motion) {
    // [exercise 12.9] The ray as the moving thing sees it.
    return {ray.origin - ray.time * motion, ray.direction, ray.time};
    // [/exercise]
}

Bounds bounds_while_moving(const Bounds& bounds, const Vec3& motion) {
    // [exercise 12.9] The box around all places of the box on its way, with faces that are certainly outside.
    if (glm::any(glm::greaterThan(bounds.low, bounds.high))) return bounds;
    // The face that the motion leads away from stays, the other one moves. Either sum may be rounded inwards.
    Bounds all{bounds.low + glm::min(motion, Vec3(0)), bounds.high + glm::max(motion, Vec3(0))};
    for (int axis = 0; axis < 3; ++axis) {
        all.low[axis] = std::nextafter(all.low[axis], -infinity);
        all.high[axis] = std::nextafter(all.high[axis], infinity);
    }
    return all;
    // [/exercise]
}

Ray seen_while_turning(const Ray& ray, const Spin& spin) {
    // [exercise 12.21] The ray as the turning thing sees it.
    const Real angle = ray.time * spin.angle, sine = std::sin(angle), lost = 1 - std::cos(angle);
    // Rodrigues' formula (04.2) for −angle, as what it adds to a vector: nothing at the angle 0, so all bits
    // stay.
    const auto added = [&](const Vec3& v) {
        const Vec3 side = cross(spin.axis, v);
        return lost * cross(spin.axis, side) - sine * side;
    };
    return {ray.origin + added(ray.origin - spin.center), ray.direction + added(ray.direction), ray.time};
    // [/exercise]
}

Interval arc_range(Real x, Real y, Real angle) {
    // [exercise 12.22] The least and the greatest value of x·cos θ + y·sin θ on the way from 0 to `angle`.
    if (angle < 0) return arc_range(x, -y, -angle);
    // A cosine curve as high as the radius. Peak and valley count if the arc comes to them, the ends always.
    const Real end = x * std::cos(angle) + y * std::sin(angle), radius = std::hypot(x, y);
    const Real direction = std::atan2(y, x), peak = direction < 0 ? direction + 2 * pi : direction;
    const Real valley = direction + pi;
    return {valley <= angle ? -radius : std::min(x, end), peak <= angle ? radius : std::max(x, end)};
    // [/exercise]
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
    // [exercise 12.22] The box around the arcs of all eight corners, with faces that are certainly outside.
    if (glm::any(glm::lessThan(bounds.high, bounds.low))) return bounds;
    Bounds all;
    Real r = 0;
    for (const Vec3& corner : corners_from(spin.center, bounds)) {
        r = std::max(r, length(corner));
        // `along` stays. The rest is across·cos θ + side·sin θ.
        const Vec3 along = dot(spin.axis, corner) * spin.axis, middle = spin.center + along;
        const Vec3 across = corner - along, side = cross(spin.axis, corner);
        for (int axis = 0; axis < 3; ++axis) {
            const Interval arc = arc_range(across[axis], side[axis], spin.angle);
            all.low[axis] = std::min(all.low[axis], middle[axis] + arc.min);
            all.high[axis] = std::max(all.high[axis], middle[axis] + arc.max);
        }
    }
    const Real rounding = gamma(64) * (length(spin.center) + r);
    return {all.low - rounding, all.high + rounding};
    // [/exercise]
}

}  // namespace rt
