// The disc: a plane with a rim.
#include "chapters/10_surfaces/disc.hpp"

#include "chapters/01_ray_casting/plane.hpp"

#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

std::optional<Hit> intersect(const Disc& disc, const Ray& ray, Interval range) {
    // 10.3  Return a Hit where the ray meets the disc, if that is in the range; or nothing.
    return todo("10.3");
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
