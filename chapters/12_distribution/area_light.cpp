// Lights with an extent: points of them that are chosen at random, evenly by area.
// The lesson uses the same letters: A for a light's area, d for the distance to a point of it, θ for the
// angle between the light's normal there and the way to the viewer.
#include "chapters/12_distribution/area_light.hpp"

#include "chapters/12_distribution/lens.hpp"
#include "common/math/axes.hpp"
#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Real area(const QuadLight& light) { return length(cross(light.ab, light.ac)); }
Real area(const DiscLight& light) { return pi * light.radius * light.radius; }
Real area(const SphereLight& light) { return 4 * pi * light.radius * light.radius; }
Real area(const TriangleLight& light) { return length(cross(light.b - light.a, light.c - light.a)) / 2; }

LightPoint point_on(const QuadLight& light, const Vec2& random) {
    // 12.10  A uniform point of the parallelogram. The bright side is that of −(ab × ac).
    return todo("12.10");
}

LightPoint point_on(const DiscLight& light, const Vec2& random) {
    // 12.10  A uniform point of the disc. The given axes_around makes a frame of a unit normal.
    return todo("12.10");
}

LightPoint point_on(const SphereLight& light, const Vec2& random) {
    // 12.10  A uniform point of the sphere. The bright side is outside.
    return todo("12.10");
}

LightPoint point_on(const TriangleLight& light, const Vec2& random) {
    // 12.10  A uniform point of the triangle. From the bright side a, b, c run counterclockwise.
    return todo("12.10");
}

Real per_steradian(const LightPoint& point, const Vec3& from) {
    // 12.10  The density by area, as a density per steradian seen from `from`.
    return todo("12.10");
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
