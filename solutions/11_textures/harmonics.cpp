// Diffuse light from the sky by nine spherical harmonics (Ramamoorthi & Hanrahan 2001).
#include "chapters/11_textures/harmonics.hpp"

#include "chapters/11_textures/sky.hpp"

#include <cmath>
#include <optional>
#include <variant>

namespace rt {

std::array<Real, 9> harmonics(const Vec3& d) {
    // [exercise 11.6] Return the values at d of the nine harmonics that the contract lists, in that order.
    const Real c0 = std::sqrt(1 / pi) / 2, c1 = std::sqrt(3 / pi) / 2, c2 = std::sqrt(15 / pi) / 2;
    const Real along = std::sqrt(5 / pi) / 4 * (3 * d.z * d.z - 1);
    const Real across = c2 / 2 * (d.x - d.y) * (d.x + d.y);
    return {c0, c1 * d.y, c1 * d.z, c1 * d.x, c2 * d.x * d.y, c2 * d.y * d.z, along, c2 * d.x * d.z, across};
    // [/exercise]
}

SkyLight projected(const Image& picture) {
    // [exercise 11.6] For each of the nine harmonics, sum up what the pixels give.
    SkyLight light;
    const Real column = 2 * pi / picture.width, row = pi / picture.height;
    for (int j = 0; j < picture.height; ++j) {
        // Row 0 is at the top: its upper edge is the pole.
        const Real upper = pi / 2 - j * row, middle = upper - row / 2;
        const Real angle = column * (std::sin(upper) - std::sin(upper - row));
        for (int i = 0; i < picture.width; ++i) {
            const Real theta = (i + 0.5) * column, level = std::cos(middle);
            const auto y = harmonics({level * std::cos(theta), std::sin(middle), level * std::sin(theta)});
            for (std::size_t k = 0; k < 9; ++k) light.coefficients[k] += angle * y[k] * pixel(picture, i, j);
        }
    }
    return light;
    // [/exercise]
}

Vec3 irradiance(const SkyLight& light, const Vec3& normal) {
    // [exercise 11.6] Return how much light arrives, as far as the nine numbers know. No light is negative.
    const auto y = harmonics(normal);
    Vec3 sum = pi * y[0] * light.coefficients[0];
    for (std::size_t k = 1; k < 4; ++k) sum += 2 * pi / 3 * y[k] * light.coefficients[k];
    for (std::size_t k = 4; k < 9; ++k) sum += pi / 4 * y[k] * light.coefficients[k];
    return glm::max(sum, Vec3(0));
    // [/exercise]
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
