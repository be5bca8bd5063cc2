// Directions to a light that is a sphere, evenly by solid angle.
// The lesson uses the same letters: r the sphere's radius, d the distance to its centre, M = 1 − cos of the
// cone's angle, and m = 1 − cos of the angle between the chosen direction and the cone's axis.
#include "chapters/12_distribution/sphere_light.hpp"

#include "common/math/axes.hpp"
#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Real solid_angle(const SphereLight& light, const Vec3& from) {
    // 12.11  The solid angle of the cone in which the sphere is seen, with all its digits even
    // for a star.
    return todo("12.11");
}

std::optional<LightDirection> toward(const SphereLight& light, const Vec3& from, const Vec2& random) {
    // 12.11  A uniform direction in that cone, and the distance to where its ray enters the sphere.
    return todo("12.11");
}

}  // namespace rt
