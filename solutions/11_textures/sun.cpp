// The sun of a sky's picture as a lamp: a challenge, which nothing else needs.
#include "chapters/11_textures/sun.hpp"

#include <cmath>

namespace rt {

SkyAndSun without_sun(const Image& picture, Real most) {
    // [exercise 11.23] Cut off what is too bright, and gather it: how much light is it, and from where?
    SkyAndSun parts{.sky = picture};
    Vec3 toward(0);
    const Real width = 2 * pi / picture.width, height = pi / picture.height;
    for (int j = 0; j < picture.height; ++j) {
        const Real top = pi / 2 - j * height, latitude = top - height / 2;
        const Real angle = width * (std::sin(top) - std::sin(top - height));
        for (int i = 0; i < picture.width; ++i) {
            const Vec3 excess = glm::max(pixel(picture, i, j) - most, Vec3(0));
            const Real longitude = (i + 0.5) * width, level = std::cos(latitude);
            const Vec3 at(level * std::cos(longitude), std::sin(latitude), level * std::sin(longitude));
            pixel(parts.sky, i, j) -= excess;
            parts.light += angle / pi * excess;
            toward += angle * (excess.x + excess.y + excess.z) * at;
        }
    }
    if (length(toward) > 0) parts.to_sun = normalize(toward);
    return parts;
    // [/exercise]
}

}  // namespace rt
