// The disc: a plane with a rim.
#include "chapters/10_surfaces/disc.hpp"

#include "chapters/01_ray_casting/plane.hpp"

#include <cmath>

namespace rt {

std::optional<Hit> intersect(const Disc& disc, const Ray& ray, Interval range) {
    // [exercise 10.3] Return a Hit where the ray meets the disc, if that is in the range; or nothing.
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
