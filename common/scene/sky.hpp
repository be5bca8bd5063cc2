// What is seen where a ray meets nothing.
// To add a kind of sky: its struct here and in `Sky`, and what it shows in a direction in `sky_radiance`
// (chapters/11_textures/sky.hpp).
#pragma once

#include "common/image/image.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <variant>

namespace rt {

/// How a picture of all directions is laid out. `sky_uv` has the formulas.
enum class SkyMap {
    LatitudeLongitude,  ///< a map of the world: across the longitude, up the latitude
    MirrorBall,         ///< a photograph of a mirrored ball, from +z
    Angular             ///< a light probe: from the middle outwards, the angle from −z
};

/// The same light from everywhere.
struct ConstantSky {
    Vec3 color{0};
};

/// Colours straight up, on the horizon and straight down, mixed by the direction's y.
struct GradientSky {
    Vec3 zenith{0};
    Vec3 horizon{0};
    Vec3 nadir{0};
};

/// The cosine and sine of an angle, worked out once.
struct Turn {
    Real cosine = 1, sine = 0;
};
inline Turn turn_by(Real angle) { return {std::cos(angle), std::sin(angle)}; }

/// A picture of at least one pixel, turned about the y axis, counterclockwise as seen from above.
struct ImageSky {
    std::shared_ptr<const Image> image;
    SkyMap map = SkyMap::LatitudeLongitude;
    Turn turn{};
};

using Sky = std::variant<ConstantSky, GradientSky, ImageSky>;

/// What a sky's light comes to where it is diffuse: its first nine spherical harmonics, of a channel each, in
/// the order of `harmonics` (chapters/11_textures/harmonics.hpp).
struct SkyLight {
    std::array<Vec3, 9> coefficients{};
};

}  // namespace rt
