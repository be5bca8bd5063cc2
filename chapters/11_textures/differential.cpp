// Ray differentials: how a ray changes from one pixel to the next.
// The lesson uses the same letters: p for a point on the ray, d for its direction, n for a normal, and dp,
// dd, dn for how these change.
#include "chapters/11_textures/differential.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

RayDifferential camera_differential(const View& view, Real x, Real y) {
    // 11.12  Say how pixel_ray changes with x and with y, in an orthographic view and in
    // perspective.
    return todo("11.12");
}

RayDifferential transferred(const RayDifferential& differential, const Ray& ray, Real t, const Vec3& normal) {
    // 11.12  How far from yours does the neighbouring ray meet the tangent plane? Divide by no
    // cosine that is smaller in size than least_cosine.
    return todo("11.12");
}

NormalChange normal_change(const RayDifferential& at_surface, const Vec3& normal, Real curvature) {
    // 11.13  How does the unit normal tilt when the point moves, to the right and down?
    return todo("11.13");
}

RayDifferential reflected(const RayDifferential& at_surface, const Vec3& d, const Vec3& n,
                          const NormalChange& change) {
    // 11.13  How does the mirrored ray change? d and n both do.
    return todo("11.13");
}

RayDifferential refracted(const RayDifferential& at_surface, const Vec3& d, const Vec3& n,
                          const NormalChange& change, Real eta) {
    // 11.13  How does the refracted ray change? d, n and the cosines do. Divide by no cosₜ that is
    // less than least_cosine.
    return todo("11.13");
}

}  // namespace rt
