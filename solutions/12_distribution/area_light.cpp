// Lights with an extent: points of them that are chosen at random, evenly by area.
// The lesson uses the same letters: A for a light's area, d for the distance to a point of it, θ for the
// angle between the light's normal there and the way to the viewer.
#include "chapters/12_distribution/area_light.hpp"

#include "chapters/12_distribution/lens.hpp"
#include "common/math/axes.hpp"

#include <cmath>

namespace rt {

Real area(const QuadLight& light) { return length(cross(light.ab, light.ac)); }
Real area(const DiscLight& light) { return pi * light.radius * light.radius; }
Real area(const SphereLight& light) { return 4 * pi * light.radius * light.radius; }
Real area(const TriangleLight& light) { return length(cross(light.b - light.a, light.c - light.a)) / 2; }

LightPoint point_on(const QuadLight& light, const Vec2& random) {
    // [exercise 12.10] A uniform point of the parallelogram. The bright side is that of −(ab × ac).
    const Vec3 point = light.corner + random.x * light.ab + random.y * light.ac;
    return {point, unit(cross(light.ac, light.ab)), 1 / area(light)};
    // [/exercise]
}

LightPoint point_on(const DiscLight& light, const Vec2& random) {
    // [exercise 12.10] A uniform point of the disc. The given axes_around makes a frame of a unit normal.
    const Vec3 normal = unit(light.normal);
    const Mat3 axes = axes_around(normal);
    const Vec2 p = light.radius * disc_point(random);
    return {light.center + p.x * axes[0] + p.y * axes[1], normal, 1 / area(light)};
    // [/exercise]
}

LightPoint point_on(const SphereLight& light, const Vec2& random) {
    // [exercise 12.10] A uniform point of the sphere. The bright side is outside.
    const Real z = 1 - 2 * random.x, phi = 2 * pi * random.y;
    // Slices of equal thickness have equal areas (Archimedes).
    const Real flat = 2 * std::sqrt(random.x * (1 - random.x));  // √(1 − z²)
    const Vec3 normal = unit(Vec3(flat * std::cos(phi), flat * std::sin(phi), z));
    return {light.center + light.radius * normal, normal, 1 / area(light)};
    // [/exercise]
}

LightPoint point_on(const TriangleLight& light, const Vec2& random) {
    // [exercise 12.10] A uniform point of the triangle. From the bright side a, b, c run counterclockwise.
    const Vec3 ab = light.b - light.a, ac = light.c - light.a;
    const Real height = std::sqrt(random.x);
    // The area next to a grows with the square of the height; along the parallel to bc the point is uniform.
    const Vec3 point = light.a + height * ((1 - random.y) * ab + random.y * ac);
    return {point, unit(cross(ab, ac)), 1 / area(light)};
    // [/exercise]
}

Real per_steradian(const LightPoint& point, const Vec3& from) {
    // [exercise 12.10] The density by area, as a density per steradian seen from `from`.
    const Vec3 back = from - point.point;
    const Real d = length(back), along = dot(point.normal, back);
    if (!(along > 0)) return 0;
    return point.pdf * d * d / (along / d);
    // [/exercise]
}

std::optional<LightDirection> seen_from(const LightPoint& point, const Vec3& from) {
    const Real pdf = per_steradian(point, from);
    if (!(pdf > 0)) return std::nullopt;
    return aimed(point.point - from, pdf);
}

std::optional<LightDirection> toward(const DiscLight& light, const Vec3& from, const Vec2& random) {
    return seen_from(point_on(light, random), from);
}

}  // namespace rt
