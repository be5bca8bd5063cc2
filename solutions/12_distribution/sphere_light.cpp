// Directions to a light that is a sphere, evenly by solid angle.
// The lesson uses the same letters: r the sphere's radius, d the distance to its centre, M = 1 − cos of the
// cone's angle, and m = 1 − cos of the angle between the chosen direction and the cone's axis.
#include "chapters/12_distribution/sphere_light.hpp"

#include "common/math/axes.hpp"

#include <cmath>

namespace rt {

Real solid_angle(const SphereLight& light, const Vec3& from) {
    // [exercise 12.11] The solid angle of the cone in which the sphere is seen, with all its digits even
    // for a star.
    const Real d = length(light.center - from), r = light.radius;
    if (!(d > r)) return 0;
    const Real cosine = std::sqrt((d - r) * (d + r)) / d, sine = r / d;
    // sin² = 1 − cos² = (1 − cos)·(1 + cos)
    return 2 * pi * sine * sine / (1 + cosine);
    // [/exercise]
}

std::optional<LightDirection> toward(const SphereLight& light, const Vec3& from, const Vec2& random) {
    // [exercise 12.11] A uniform direction in that cone, and the distance to where its ray enters the sphere.
    const Real omega = solid_angle(light, from);
    if (!(omega > 0)) return std::nullopt;
    // Equal areas of the unit sphere are equal steps of the cosine.
    const Vec3 to_center = light.center - from;
    const Real d = length(to_center), r = light.radius, M = omega / (2 * pi);
    const Real m = random.x * M, phi = 2 * pi * random.y, cosine = 1 - m;
    const Real sine = std::sqrt(m * (2 - m));
    const Vec3 local(sine * std::cos(phi), sine * std::sin(phi), cosine);
    // From the middle of the chord to its ends it is √(r² − d²·sine²), which is d times this:
    const Real chord = std::sqrt(M * (1 - random.x) * (cosine + (1 - M)));
    const Real distance = (d - r) * (d + r) / (d * (cosine + chord));
    return LightDirection{unit(axes_around(to_center / d) * local), distance, 1 / omega};
    // [/exercise]
}

}  // namespace rt
