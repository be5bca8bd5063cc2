// Directions to a light that is a sphere, evenly by solid angle.
// The lesson uses the same letters: r the sphere's radius, d the distance to its centre, M = 1 − cos of the
// cone's angle, and m = 1 − cos of the angle between the chosen direction and the cone's axis.
#include "chapters/12_distribution/sphere_light.hpp"

#include "common/math/axes.hpp"
#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Real solid_angle(const SphereLight& light, const Vec3& from) {
    // 12.11  The area that the cone cuts out of the unit sphere. The sine of the cone's angle is
    // r/d; do not subtract the cosine from 1, because it is 1 for a small sphere far away.
    return todo("12.11");
}

std::optional<LightDirection> toward(const SphereLight& light, const Vec3& from, const Vec2& random) {
    // 12.11  Equal areas of the unit sphere are equal steps of the cosine: of the way from 1 to the
    // cone's cosine go the part random.x. Then turn about the axis. The ray meets the sphere twice, and the
    // product of the two distances is (d − r)·(d + r): divide it by the greater one to have the lesser.
    return todo("12.11");
}

}  // namespace rt
