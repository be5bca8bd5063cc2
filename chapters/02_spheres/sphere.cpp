// The sphere: hit or miss, where, and the surface there.
#include "chapters/02_spheres/sphere.hpp"

#include "common/math/error.hpp"
#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Roots intersections(const Sphere& sphere, const Ray& ray) {
    // 02.2  Return the roots of a·t² + 2·h·t + c = 0 for this line and this sphere. Compute the
    // discriminant from w, the vector from the centre to the point of the line nearest to it.
    return todo("02.2");
}

std::optional<Hit> intersect(const Sphere& sphere, const Ray& ray, Interval range) {
    // 02.3  Return a Hit with the smallest root in the range, or std::nullopt. Leave the Hit's
    // other fields as they are.
    return todo("02.3");
}

Surface surface_at(const Sphere& sphere, const Ray& ray, const Hit& hit) {
    Surface surface;
    // 02.4  Set the surface's normal, shading_normal and point. The vector from the centre to the
    // hit gives the normal; the point is where that normal, times the radius, ends.
    return todo("02.4");

    // Given. Where a ball is so small, and so far away, that rounding puts the hit onto its centre, the
    // vector from there to the hit has no direction. The ball is seen from where the ray comes.
    if (!(dot(surface.normal, surface.normal) > 0)) {
        surface.normal = surface.shading_normal = -normalize(ray.direction);
        surface.point = sphere.center + sphere.radius * surface.normal;
    }

    // How far rounding has moved the point from the sphere, an axis at a time, and what the next ray, which
    // starts here, may get wrong about its distance from the sphere; chapter 6 derives it.
    surface.error = gamma(10) * abs(sphere.radius * surface.normal) + gamma(2) * abs(surface.point);
    return surface;
}

Vec2 sphere_uv(const Vec3& normal) {
    // 02.4  u is the longitude atan2(z, x) as a part of a whole turn, v the latitude asin(y) from
    // pole to pole. Wrap negative u by adding 1; u stays below 1.
    return todo("02.4");
}

std::optional<Hit> closest_hit(std::span<const Sphere> spheres, const Ray& ray, Interval range) {
    // 02.5  Return the nearest hit of all, with `primitive` the index of its sphere; of equal
    // distances the lowest index wins.
    return todo("02.5");
}

bool any_hit(std::span<const Sphere> spheres, const Ray& ray, Interval range) {
    // 02.5  Return whether any sphere is hit in the range, and stop at the first that is.
    return todo("02.5");
}

}  // namespace rt
