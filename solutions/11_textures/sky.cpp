// What is seen in a direction: skies of one colour, of three, and of pictures of all directions.
#include "chapters/11_textures/sky.hpp"

#include "chapters/11_textures/image_texture.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Vec2 sky_uv(SkyMap map, const Vec3& direction) {
    // [exercise 11.4] Where does a picture of this layout show the direction? The direction may have any
    // length, and every angle must be right, however close to the poles, the middle or the rim.
    const Vec3 d = near_one(direction);
    if (map == SkyMap::LatitudeLongitude) {
        const Real turns = std::atan2(d.z, d.x) / (2 * pi);
        return {turns < 0 ? turns + 1 : turns, 0.5 + std::atan2(d.y, std::hypot(d.x, d.z)) / pi};
    }
    // Not the cosine's inverse: near its ends the cosine has lost the angle. The tangent keeps it.
    const Real s = std::hypot(d.x, d.y);
    const Real r = map == SkyMap::MirrorBall ? std::sin(std::atan2(s, d.z) / 2) : std::atan2(s, -d.z) / pi;
    const Vec2 outward = s > 0 ? Vec2(d.x, d.y) / s : Vec2(1, 0);
    return 0.5 + 0.5 * r * outward;
    // [/exercise]
}

std::optional<Vec3> sky_direction(SkyMap map, const Vec2& uv) {
    // [exercise 11.5] Which unit direction does the picture show at uv? It is nothing outside of the disc.
    if (map == SkyMap::LatitudeLongitude) {
        const Real longitude = 2 * pi * uv.x, latitude = pi * (uv.y - 0.5);
        const Real level = std::cos(latitude);
        return Vec3(level * std::cos(longitude), std::sin(latitude), level * std::sin(longitude));
    }
    const Vec2 p = 2.0 * uv - 1.0;
    const Real r = std::hypot(p.x, p.y);
    if (r > 1) return std::nullopt;
    if (map == SkyMap::MirrorBall) {
        // The ball's normal is (p, n), and the mirrored direction is 2n·normal − z.
        const Real n = std::sqrt((1 - r) * (1 + r));
        return Vec3(2 * n * p.x, 2 * n * p.y, 1 - 2 * r * r);
    }
    const Vec2 outward = r > 0 ? p / r : Vec2(1, 0);
    return Vec3(std::sin(pi * r) * outward, -std::cos(pi * r));
    // [/exercise]
}

Vec3 gradient_color(const GradientSky& sky, const Vec3& direction) {
    // [exercise 11.4] Which mixture of the horizon's colour with another is seen at the direction's height?
    const Real y = unit(direction).y;
    return glm::mix(sky.horizon, y > 0 ? sky.zenith : sky.nadir, std::abs(y));
    // [/exercise]
}

Vec3 turned(const Vec3& direction, const Turn& turn) {
    const auto& [c, s] = turn;
    // + 0 makes 0 of −0, so that straight up has one longitude, 0, whatever the angle.
    return {c * direction.x - s * direction.z + 0.0, direction.y, s * direction.x + c * direction.z + 0.0};
}

Vec3 sky_texel(const Image& image, const Vec2& uv, bool around) {
    // NaN is not greater than anything.
    const auto inside = [](Real x, Real low, Real high) { return x > low ? std::min(x, high) : low; };
    // Up to the middles of the outer rows, beyond which a picture that repeats goes on at the other pole.
    const Real outer = 0.5 / image.height;
    const Vec2 at(inside(uv.x, 0, 1), inside(uv.y, outer, 1 - outer));
    return bilinear(image, at, around ? Wrap::Repeat : Wrap::Clamp);
}

namespace {

Vec3 seen(const ConstantSky& sky, const Vec3&) { return sky.color; }

Vec3 seen(const GradientSky& sky, const Vec3& direction) { return gradient_color(sky, direction); }

Vec3 seen(const ImageSky& sky, const Vec3& direction) {
    const Vec2 uv = sky_uv(sky.map, turned(near_one(direction), sky.turn));
    return sky_texel(*sky.image, uv, sky.map == SkyMap::LatitudeLongitude);
}

}  // namespace

Vec3 sky_radiance(const Sky& sky, const Vec3& direction) {
    return std::visit([&](const auto& kind) { return seen(kind, direction); }, sky);
}

}  // namespace rt
