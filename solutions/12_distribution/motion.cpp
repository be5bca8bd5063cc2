// Motion blur: when light comes in, and how a ray sees what moves meanwhile.
// The lesson uses the same letters: o and c for how long the shutter opens and closes, A for all the light.
#include "chapters/12_distribution/motion.hpp"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <cmath>

namespace rt {

Real shutter_time(const Shutter& shutter, Real random) {
    // [exercise 12.8] Draw how far the shutter is open over time: the light until a time is the area of the
    // trapezoid to the left of it. Find the whole area and how much of it is asked for; then, in which of the
    // three parts that much is reached, and when.
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
    // [exercise 12.9] Where the thing is at ray.time, it has moved by a part of `motion`. Move the ray's
    // origin as far in the opposite direction.
    return {ray.origin - ray.time * motion, ray.direction, ray.time};
    // [/exercise]
}

Bounds bounds_while_moving(const Bounds& bounds, const Vec3& motion) {
    // [exercise 12.9] The box at time 0, the box at time 1, and all between them. Along each axis one of the
    // two faces stays where it is, and the other is moved. Move each face to the next number outwards
    // (std::nextafter), because a sum may have been rounded inwards. Leave an empty box alone.
    if (glm::any(glm::greaterThan(bounds.low, bounds.high))) return bounds;
    Bounds all{bounds.low + glm::min(motion, Vec3(0)), bounds.high + glm::max(motion, Vec3(0))};
    for (int axis = 0; axis < 3; ++axis) {
        all.low[axis] = std::nextafter(all.low[axis], -infinity);
        all.high[axis] = std::nextafter(all.high[axis], infinity);
    }
    return all;
    // [/exercise]
}

}  // namespace rt
