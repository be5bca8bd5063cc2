// The sphere: hit or miss, where, and the surface there.
#include "chapters/02_spheres/sphere.hpp"

#include "common/math/error.hpp"

#include <cmath>

namespace rt {

Roots intersections(const Sphere& sphere, const Ray& ray) {
    // [exercise 02.2] Return both t at which the line of the ray meets the sphere, even where the sphere is
    // many millions of its radii away. The direction may have any length.
    const Vec3& d = ray.direction;
    const Vec3 f = ray.origin - sphere.center;
    const Real a = dot(d, d);
    const Real h = dot(f, d);
    const Vec3 w = f - (h / a) * d;
    const Real r2 = sphere.radius * sphere.radius;
    const Real discriminant = a * (r2 - dot(w, w));
    // Most rays miss most spheres: nothing more is computed for those.
    if (discriminant < 0) return {};
    return solve_quadratic(a, h, dot(f, f) - r2, discriminant);
    // [/exercise]
}

std::optional<Hit> intersect(const Sphere& sphere, const Ray& ray, Interval range) {
    // [exercise 02.3] Return a Hit with the smallest root in the range, or std::nullopt if no root is in it.
    // Leave the Hit's other fields as they are.
    const Roots roots = intersections(sphere, ray);
    if (roots.count == 0) return std::nullopt;
    if (contains(range, roots.t0)) return Hit{.t = roots.t0};
    if (contains(range, roots.t1)) return Hit{.t = roots.t1};
    return std::nullopt;
    // [/exercise]
}

Surface surface_at(const Sphere& sphere, const Ray& ray, const Hit& hit) {
    Surface surface;
    // [exercise 02.4] Set the surface's normal, which points outwards and has length 1; its shading_normal,
    // which is the same here; and its point, which is on the sphere up to the last bits.
    const Vec3 f = ray.origin - sphere.center;
    const Vec3 n = normalize(f + hit.t * ray.direction);
    surface.normal = n;
    surface.shading_normal = n;
    surface.point = sphere.center + sphere.radius * n;
    // [/exercise]

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
    // [exercise 02.4] Return the longitude and the latitude of the point with this normal, as the header
    // defines them: u from 0 to less than 1, v from 0 at the south pole to 1 at the north pole.
    const Real turn = std::atan2(normal.z, normal.x) / (2 * pi);
    const Real wrapped = turn < 0 ? turn + 1 : turn;
    // A tiny negative turn plus 1 is rounded to 1.
    return {wrapped < 1 ? wrapped : 0, 0.5 + std::asin(normal.y) / pi};
    // [/exercise]
}

std::optional<Hit> closest_hit(std::span<const Sphere> spheres, const Ray& ray, Interval range) {
    // [exercise 02.5] Return the nearest hit of the ray with all the spheres, and the index of the sphere in
    // its `primitive`. Of equal distances the lowest index wins.
    std::optional<Hit> closest;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const std::optional<Hit> hit = intersect(spheres[i], ray, range);
        // `range` ends at the nearest hit so far and includes it: a tie is not nearer.
        if (!hit || (closest && hit->t == closest->t)) continue;
        closest = hit;
        closest->primitive = static_cast<std::uint32_t>(i);
        range.max = hit->t;
    }
    return closest;
    // [/exercise]
}

bool any_hit(std::span<const Sphere> spheres, const Ray& ray, Interval range) {
    // [exercise 02.5] Return whether any sphere is hit in the range, and stop at the first that is.
    for (const Sphere& sphere : spheres)
        if (intersect(sphere, ray, range)) return true;
    return false;
    // [/exercise]
}

}  // namespace rt
