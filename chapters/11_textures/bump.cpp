// Bumps: shading normals of a surface that is rougher than its shape.
#include "chapters/11_textures/bump.hpp"

#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Vec3 bumped(const Vec3& normal, const Vec3& height_gradient) {
    // 11.7  Take from the normal what the gradient has along the surface; unit.
    return todo("11.7");
}

Vec3 bumped(const Vec3& normal, const Vec3& du, const Vec3& dv, Real dh_du, Real dh_dv) {
    // 11.7  Which vector in the plane of du and dv has the products dh_du and dh_dv with them? It
    // is the gradient. du and dv are of any length and at any angle; where they span no plane, the normal
    // stays.
    return todo("11.7");
}

Vec3 from_normal_map(const Vec3& rgb, const Vec3& du, const Vec3& dv, const Vec3& normal) {
    const Vec3 parts = Real(2) * rgb - Real(1), direction = du / size_of(du);
    const Vec3 flat = direction - dot(direction, normal) * normal;
    if (!(length(flat) > 0x1p-50) || parts == Vec3(0)) return normal;
    const Vec3 tangent = normalize(flat), side = cross(normal, tangent);
    return unit(parts.x * tangent + parts.y * (dot(side, dv) < 0 ? -side : side) + parts.z * normal);
}

Vec3 kept_visible(const Vec3& shading_normal, const Vec3& geometric_normal, const Vec3& to_viewer) {
    // 11.7  Turn both normals to the side where the viewer is as seen from the geometric one, g. A
    // normal m of any length is good if m.v > 0 and the mirrored ray, 2 (m.v) m/(m.m) - v, has a product of
    // at least least_rise * (g.v) with g. If the shading normal is not good, halve the way to g, where the
    // normal is good, again and again. Turn what you have found back.
    return todo("11.7");
}

}  // namespace rt
