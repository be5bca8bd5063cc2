// Bumps: shading normals of a surface that is rougher than its shape.
#include "chapters/11_textures/bump.hpp"

#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Vec3 bumped(const Vec3& normal, const Vec3& height_gradient) {
    // 11.11  Return the unit normal of the surface that the heights make.
    return todo("11.11");
}

Vec3 bumped(const Vec3& normal, const Vec3& du, const Vec3& dv, Real dh_du, Real dh_dv) {
    // 11.11  The same, where you know how the height changes along du and dv, which are of any
    // length and at any angle. Where they span no plane, the normal stays.
    return todo("11.11");
}

Vec3 from_normal_map(const Vec3& rgb, const Vec3& du, const Vec3& dv, const Vec3& normal) {
    const Vec3 parts = Real(2) * rgb - Real(1), direction = du / size_of(du);
    const Vec3 flat = direction - dot(direction, normal) * normal;
    if (!(length(flat) > 0x1p-50) || parts == Vec3(0)) return normal;
    const Vec3 tangent = normalize(flat), side = cross(normal, tangent);
    return unit(parts.x * tangent + parts.y * (dot(side, dv) < 0 ? -side : side) + parts.z * normal);
}

Vec3 kept_visible(const Vec3& shading_normal, const Vec3& geometric_normal, const Vec3& to_viewer) {
    // 11.11  Return the shading normal if shading can use it, or else the first one on the way to
    // the geometric normal that it can use. Both may be seen from behind.
    return todo("11.11");
}

}  // namespace rt
