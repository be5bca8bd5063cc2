// Bumps: shading normals of a surface that is rougher than its shape.
#include "chapters/11_textures/bump.hpp"

#include <cmath>

namespace rt {

Vec3 bumped(const Vec3& normal, const Vec3& height_gradient) {
    // [exercise 11.11] Return the unit normal of the surface that the heights make.
    const Vec3 along = height_gradient - dot(height_gradient, normal) * normal;
    return unit(normal - along);
    // [/exercise]
}

Vec3 bumped(const Vec3& normal, const Vec3& du, const Vec3& dv, Real dh_du, Real dh_dv) {
    // [exercise 11.11] The same, where you know how the height changes along du and dv, which are of any
    // length and at any angle. Where they span no plane, the normal stays.
    const Real a = size_of(du), b = size_of(dv);
    const Vec3 u = du / a, v = dv / b, across = cross(u, v);
    const Real sine = length(across);
    if (!(sine > 0x1p-50)) return normal;  // also if it is NaN, because du or dv is 0
    const Vec3 gradient = (dh_du / a * cross(v, across) + dh_dv / b * cross(across, u)) / (sine * sine);
    return bumped(normal, gradient);
    // [/exercise]
}

Vec3 from_normal_map(const Vec3& rgb, const Vec3& du, const Vec3& dv, const Vec3& normal) {
    const Vec3 parts = Real(2) * rgb - Real(1), direction = du / size_of(du);
    const Vec3 flat = direction - dot(direction, normal) * normal;
    if (!(length(flat) > 0x1p-50) || parts == Vec3(0)) return normal;
    const Vec3 tangent = normalize(flat), side = cross(normal, tangent);
    return unit(parts.x * tangent + parts.y * (dot(side, dv) < 0 ? -side : side) + parts.z * normal);
}

Vec3 kept_visible(const Vec3& shading_normal, const Vec3& geometric_normal, const Vec3& to_viewer) {
    // [exercise 11.11] Return the shading normal if shading can use it, or else the first one on the way to
    // the geometric normal that it can use. Both may be seen from behind.
    const Real height = dot(geometric_normal, to_viewer), turn = height < 0 ? -1 : 1;
    const Vec3 n = turn * shading_normal, g = turn * geometric_normal;
    // A good m, of any length, shows its front and mirrors the ray to 2 (m·v) m/(m·m) − v, high enough.
    const auto is_good = [&](const Vec3& m) {
        const Real toward = dot(m, to_viewer);
        return toward > 0 && 2 * toward * dot(m, g) >= (1 + least_rise) * std::abs(height) * dot(m, m);
    };
    if (height == 0) return geometric_normal;
    if (is_good(n)) return shading_normal;
    Real bad = 0, good = 1;
    for (int i = 0; i < 50; ++i) {
        const Real middle = (bad + good) / 2;
        (is_good(glm::mix(n, g, middle)) ? good : bad) = middle;
    }
    return turn * unit(glm::mix(n, g, good));
    // [/exercise]
}

}  // namespace rt
