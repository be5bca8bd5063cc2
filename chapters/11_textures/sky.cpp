// What is seen in a direction: skies of one colour, of three, and of pictures of all directions.
#include "chapters/11_textures/sky.hpp"

#include "chapters/11_textures/image_texture.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Vec2 sky_uv(SkyMap map, const Vec3& direction) {
    // 11.4  Where does a picture of this layout show the direction? The direction may have any
    // length, and every angle must be right, however close to the poles, the middle or the rim.
    return todo("11.4");
}

std::optional<Vec3> sky_direction(SkyMap map, const Vec2& uv) {
    // 11.5  Which unit direction does the picture show at uv? It is nothing outside of the disc.
    return todo("11.5");
}

Vec3 gradient_color(const GradientSky& sky, const Vec3& direction) {
    // 11.4  Which mixture of the horizon's colour with another is seen at the direction's height?
    return todo("11.4");
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
