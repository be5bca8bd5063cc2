// The disc: a plane with a rim.
#include "chapters/10_surfaces/disc.hpp"

#include "chapters/01_ray_casting/plane.hpp"

#include <cmath>

namespace rt {

std::optional<Hit> intersect(const Disc& disc, const Ray& ray, Interval range) {
    // [exercise 10.3] Where does the ray meet the plane of the disc? Return a Hit with that t if it is in the
    // range, and if the point there is no farther than the radius from the centre.
    const Vec3 f = ray.origin - disc.center;
    const Real slope = dot(disc.normal, ray.direction);
    if (slope == 0) return std::nullopt;
    const Real t = -dot(disc.normal, f) / slope;
    if (!contains(range, t)) return std::nullopt;
    const Vec3 q = f + t * ray.direction;
    if (dot(q, q) > disc.radius * disc.radius) return std::nullopt;
    return Hit{.t = t};
    // [/exercise]
}

Surface surface_at(const Disc& disc, const Ray& ray, const Hit& hit) {
    return surface_at(Plane{disc.center, disc.normal}, ray, hit);
}

Bounds bounds_of(const Disc& disc) {
    const Vec3 n = normalize(disc.normal);
    Vec3 reach(0);
    for (int i = 0; i < 3; ++i) reach[i] = disc.radius * std::hypot(n[(i + 1) % 3], n[(i + 2) % 3]);
    return {disc.center - reach, disc.center + reach};
}

}  // namespace rt
