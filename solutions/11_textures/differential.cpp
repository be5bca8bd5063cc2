// Ray differentials: how a ray changes from one pixel to the next.
// The lesson uses the same letters: p for a point on the ray, d for its direction, n for a normal, and dp,
// dd, dn for how these change.
#include "chapters/11_textures/differential.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

RayDifferential camera_differential(const View& view, Real x, Real y) {
    // [exercise 11.12] Say how pixel_ray changes with x and with y, in an orthographic view and in
    // perspective.
    const auto& [u, v, w] = view.frame;
    const Real k = 2 * view.half_height / view.height;
    if (view.projection == Projection::Orthographic) return {.origin_dx = k * u, .origin_dy = -k * v};
    const Real a = k * (x - view.width / 2.0), b = k * (view.height / 2.0 - y);
    const Vec3 g = a * u + b * v - w;
    const Real size = length(g);
    const Vec3 d = g / size;
    // A unit vector cannot grow: what dg has along d is lost.
    const auto of_unit = [&](const Vec3& dg) { return (dg - dot(dg, d) * d) / size; };
    return {.direction_dx = of_unit(k * u), .direction_dy = of_unit(-k * v)};
    // [/exercise]
}

RayDifferential transferred(const RayDifferential& differential, const Ray& ray, Real t, const Vec3& normal) {
    // [exercise 11.12] How far from yours does the neighbouring ray meet the tangent plane? Divide by no
    // cosine that is smaller in size than least_cosine.
    const Real cosine = dot(ray.direction, normal);
    const Real divisor = std::copysign(std::max(std::abs(cosine), least_cosine), cosine);
    const auto on_plane = [&](const Vec3& dp, const Vec3& dd) {
        const Vec3 moved = dp + t * dd;
        const Real dt = -dot(moved, normal) / divisor;
        return moved + dt * ray.direction;
    };
    return {on_plane(differential.origin_dx, differential.direction_dx),
            on_plane(differential.origin_dy, differential.direction_dy), differential.direction_dx,
            differential.direction_dy};
    // [/exercise]
}

NormalChange normal_change(const RayDifferential& at_surface, const Vec3& normal, Real curvature) {
    // [exercise 11.13] How does the unit normal tilt when the point moves, to the right and down?
    const auto tilt = [&](const Vec3& dp) { return curvature * (dp - dot(dp, normal) * normal); };
    return {tilt(at_surface.origin_dx), tilt(at_surface.origin_dy)};
    // [/exercise]
}

RayDifferential reflected(const RayDifferential& at_surface, const Vec3& d, const Vec3& n,
                          const NormalChange& change) {
    // [exercise 11.13] How does the mirrored ray change? d and n both do.
    const auto mirrored = [&](const Vec3& dd, const Vec3& dn) {
        const Real d_cosine = dot(dd, n) + dot(d, dn);
        return dd - 2 * dot(d, n) * dn - 2 * d_cosine * n;
    };
    return {at_surface.origin_dx, at_surface.origin_dy, mirrored(at_surface.direction_dx, change.dx),
            mirrored(at_surface.direction_dy, change.dy)};
    // [/exercise]
}

RayDifferential refracted(const RayDifferential& at_surface, const Vec3& d, const Vec3& n,
                          const NormalChange& change, Real eta) {
    // [exercise 11.13] How does the refracted ray change? d, n and the cosines do. Divide by no cosₜ that is
    // less than least_cosine.
    const Real cos_i = -dot(d, n);
    const Real cos_t =
        std::sqrt(std::max((1 - eta) * (1 + eta) + eta * cos_i * eta * cos_i, least_cosine * least_cosine));
    const Real mu = eta * cos_i - cos_t;
    const auto bent = [&](const Vec3& dd, const Vec3& dn) {
        const Real d_cos_i = -(dot(dd, n) + dot(d, dn));
        const Real d_mu = eta * (1 - eta * cos_i / cos_t) * d_cos_i;
        return eta * dd + d_mu * n + mu * dn;
    };
    return {at_surface.origin_dx, at_surface.origin_dy, bent(at_surface.direction_dx, change.dx),
            bent(at_surface.direction_dy, change.dy)};
    // [/exercise]
}

}  // namespace rt
