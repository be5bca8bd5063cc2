// The sphere: hit or miss, where, and the surface there.
#include "chapters/02_spheres/sphere.hpp"

#include "common/math/error.hpp"
#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Roots intersections(const Sphere& sphere, const Ray& ray) {
    // 02.2  Return both t at which the line of the ray meets the sphere, even where the sphere is
    // many millions of its radii away. The direction may have any length.
    return todo("02.2");
}

std::optional<Hit> intersect(const Sphere& sphere, const Ray& ray, Interval range) {
    // 02.3  Return a Hit with the smallest root in the range, or std::nullopt if no root is in it.
    // Leave the Hit's other fields as they are.
    return todo("02.3");
}

Surface surface_at(const Sphere& sphere, const Ray& ray, const Hit& hit) {
    Surface surface;
    // 02.4  Set the surface's normal, which points outwards and has length 1; its shading_normal,
    // which is the same here; and its point, which is on the sphere up to the last bits.
    return todo("02.4");

    // Given. Where a ball is so small, and so far away, that rounding puts the hit onto its centre, the
    // vector from there to the hit has no direction. The normal then points back along the ray.
    if (!(dot(surface.normal, surface.normal) > 0)) {
        surface.normal = surface.shading_normal = -normalize(ray.direction);
        surface.point = sphere.center + sphere.radius * surface.normal;
    }

    // How far rounding may have moved the point from the sphere, axis by axis, and what the next ray, which
    // starts here, may get wrong about its distance from the sphere; chapter 6 derives it.
    surface.error = gamma(10) * abs(sphere.radius * surface.normal) + gamma(2) * abs(surface.point);
    return surface;
}

Vec2 sphere_uv(const Vec3& normal) {
    // 02.4  Return the longitude and the latitude of the point with this normal, as the header
    // defines them: u from 0 to less than 1, v from 0 at the south pole to 1 at the north pole.
    return todo("02.4");
}

std::optional<Hit> closest_hit(std::span<const Sphere> spheres, const Ray& ray, Interval range) {
    // 02.5  Return the nearest hit of the ray with all the spheres, and the index of the sphere in
    // its `primitive`. Of equal distances the lowest index wins.
    return todo("02.5");
}

bool any_hit(std::span<const Sphere> spheres, const Ray& ray, Interval range) {
    // 02.5  Return whether any sphere is hit in the range, and stop at the first that is.
    return todo("02.5");
}

}  // namespace rt
