// Motion blur: when light comes in, and how a ray sees what moves meanwhile.
// The lesson uses the same letters: o and c for how long the shutter opens and closes, A for all the light.
#include "chapters/12_distribution/motion.hpp"

#include "common/math/todo.hpp"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

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

}  // namespace rt
