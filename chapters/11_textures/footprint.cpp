// The footprint of a pixel on a texture, and the mean of the texture over it.
#include "chapters/11_textures/footprint.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Footprint footprint(const Vec3& du, const Vec3& dv, const Vec3& dp_dx, const Vec3& dp_dy) {
    // 11.14  For either dp, find a and b for which a·du + b·dv is nearest to it. Return a footprint
    // of 0 where the sine of the angle between du and dv is less than least_sine.
    return todo("11.14");
}

Ellipse ellipse(const Footprint& footprint, const Vec2& size) {
    const Real longest = std::max(size.x, size.y);
    const Vec2 whole_x = footprint.dx, whole_y = footprint.dy;
    const Real scale =
        std::max({std::abs(whole_x.x), std::abs(whole_x.y), std::abs(whole_y.x), std::abs(whole_y.y)});
    if (!(scale > 0)) return {};
    // Of a picture with the sides 1 and less, so that squares do not overflow.
    const Vec2 sides = size / longest, x = whole_x / scale * sides, y = whole_y / scale * sides;
    // The products of (dx dy) with its transpose; half the angle diagonalises them.
    const Real uu = x.x * x.x + y.x * y.x, uv = x.x * x.y + y.x * y.y, vv = x.y * x.y + y.y * y.y;
    const Real angle = std::atan2(2 * uv, uu - vv) / 2;
    const Real major = std::sqrt((uu + vv + std::hypot(uu - vv, 2 * uv)) / 2);
    if (!(major > 0)) return {};
    // Their product is the area, which does not cancel as the difference of squares does.
    const Real minor = std::abs(x.x * y.y - x.y * y.x) / major;
    const auto in_texels = [&](Real axis) { return std::min(scale * axis, Real(64)) * longest; };
    return {{std::cos(angle), std::sin(angle)}, in_texels(major), in_texels(minor)};
}

Real width_of(const MipMap& map, Real texels) {
    const Image& finest = map.levels.front();
    return texels / std::max(finest.width, finest.height);
}

Vec3 anisotropic(const MipMap& map, const Vec2& uv, const Footprint& footprint, Wrap wrap, int most_probes) {
    // 11.14  Return the mean over the ellipse by probes along its major axis. How wide are they,
    // how many are there, and how much does each weigh?
    return todo("11.14");
}

}  // namespace rt
