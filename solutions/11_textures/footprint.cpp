// The footprint of a pixel on a texture, and the mean of the texture over it.
#include "chapters/11_textures/footprint.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Footprint footprint(const Vec3& du, const Vec3& dv, const Vec3& dp_dx, const Vec3& dp_dy) {
    // [exercise 11.14] For either dp, find a and b for which a·du + b·dv is nearest to it. Return a footprint
    // of 0 where the sine of the angle between du and dv is less than least_sine.
    const Vec3 n = cross(du, dv);
    const Real n2 = dot(n, n);
    if (!(n2 > least_sine * least_sine * dot(du, du) * dot(dv, dv))) return {};
    const auto seen = [&](const Vec3& dp) {
        return Vec2(dot(cross(dp, dv), n) / n2, dot(cross(du, dp), n) / n2);
    };
    return {seen(dp_dx), seen(dp_dy)};
    // [/exercise]
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
    // [exercise 11.14] Return the mean over the ellipse by probes along its major axis. How wide are they,
    // how many are there, and how much does each weigh?
    const Vec2 size(map.levels.front().width, map.levels.front().height);
    const Ellipse seen = ellipse(footprint, size);
    const int pairs = (most_probes - 1) / 2;
    const Real width = std::max({seen.minor, seen.major / (2 * pairs + 1), Real(1)});
    const Real ratio = std::max(seen.major / width, Real(1));
    Vec3 weighted(0);
    for (int k = -pairs; k <= pairs; ++k) {
        const Real weight = std::clamp((ratio + 1) / 2 - std::abs(k), Real(0), Real(1));
        if (weight == 0) continue;
        const Vec2 place = uv + k * width * seen.along / size;
        weighted += weight * trilinear(map, place, width_of(map, width), wrap);
    }
    return weighted / ratio;
    // [/exercise]
}

}  // namespace rt
