// Diffuse light from the sky by nine spherical harmonics (Ramamoorthi & Hanrahan 2001).
#include "chapters/11_textures/harmonics.hpp"

#include "chapters/11_textures/sky.hpp"

#include "common/math/todo.hpp"

#include <cmath>
#include <optional>
#include <variant>

namespace rt {

std::array<Real, 9> harmonics(const Vec3& d) {
    // 11.6  Return the values at d of the nine harmonics that the contract lists, in that order.
    return todo("11.6");
}

SkyLight projected(const Image& picture) {
    // 11.6  For each of the nine harmonics, sum up what the pixels give.
    return todo("11.6");
}

Vec3 irradiance(const SkyLight& light, const Vec3& normal) {
    // 11.6  Return how much light arrives, as far as the nine numbers know. No light is negative.
    return todo("11.6");
}

Vec3 sky_diffuse(const SkyLight& light, const Vec3& normal, const Vec3& diffuse) {
    return diffuse * irradiance(light, normal) / pi;
}

Image sky_picture(const Sky& sky, int width, int height) {
    Image picture = make_image(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const Vec2 uv{(i + 0.5) / width, 1 - (j + 0.5) / height};
            const std::optional<Vec3> direction = sky_direction(SkyMap::LatitudeLongitude, uv);
            if (direction) pixel(picture, i, j) = sky_radiance(sky, *direction);
        }
    return picture;
}

SkyLight sky_light(const Sky& sky) {
    const auto* shown = std::get_if<ImageSky>(&sky);
    if (!shown) return projected(sky_picture(sky, 32, 1024));
    // Without a turn the pixels of the map are what is summed, each of them once.
    const bool map = shown->map == SkyMap::LatitudeLongitude;
    const int height = shown->image->height;
    return projected(sky_picture(sky, map ? shown->image->width : 2 * height, height));
}

}  // namespace rt
