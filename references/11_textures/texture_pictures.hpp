// The pictures that the scenes of chapter 11 lay on things: made here, so that none is anybody else's.
#pragma once

#include "chapters/11_textures/noise.hpp"
#include "common/image/image.hpp"
#include "common/math/mixed.hpp"

#include <algorithm>
#include <cmath>

namespace rt::figures {

/// A picture of this size from the colour at each (u, v), v upwards.
template <class ColorAt>
Image picture_from(int width, int height, ColorAt color_at) {
    Image image = make_image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            pixel(image, x, y) = color_at((x + 0.5) / width, 1 - (y + 0.5) / height);
    return image;
}

/// Eight by eight squares that say where they are: redder to the right, greener upwards; an F in the middle,
/// which shows what is mirrored and what is upside down.
inline Image map_picture() {
    return picture_from(256, 256, [](Real u, Real v) {
        const auto inside = [&](Real u0, Real u1, Real v0, Real v1) {
            return u >= u0 && u < u1 && v >= v0 && v < v1;
        };
        if (inside(0.4, 0.47, 0.3, 0.7) || inside(0.4, 0.62, 0.63, 0.7) || inside(0.4, 0.57, 0.48, 0.55))
            return Vec3(0.02, 0.03, 0.08);
        const bool is_odd = (static_cast<int>(8 * u) + static_cast<int>(8 * v)) % 2 != 0;
        const Vec3 color(0.15 + 0.75 * u, 0.15 + 0.75 * v, 0.35);
        return is_odd ? color : 0.45 * color + Vec3(0.5);
    });
}

/// Bricks, each of its own red, every other row moved by half a brick. It can be repeated.
inline Image bricks_picture() {
    return picture_from(256, 256, [](Real u, Real v) {
        const Real row = std::floor(8 * v), along = 4 * u + (std::fmod(row, 2) == 0 ? 0 : 0.5);
        const Real across = 8 * v - row, within = along - std::floor(along);
        const bool is_mortar = across < 0.12 || within < 0.06;
        if (is_mortar) return Vec3(0.45, 0.43, 0.4);
        const auto number = static_cast<std::uint64_t>(row) * 4 + static_cast<std::uint64_t>(along) % 4;
        const Real shade = 0.7 + 0.3 * real_of(mixed(11, number));
        const Real grain = 0.08 * noise(Vec3(40 * u, 40 * v, 0));
        return Vec3(0.5, 0.16, 0.1) * (shade + grain);
    });
}

/// Land and sea of noise on a globe, with white poles.
inline Image earth_picture() {
    return picture_from(512, 256, [](Real u, Real v) {
        const Real longitude = 2 * pi * u, latitude = pi * (v - 0.5);
        const Vec3 p(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                     std::cos(latitude) * std::sin(longitude));
        Real height = 0;
        for (int octave = 0; octave < 6; ++octave)
            height += noise(std::ldexp(1.7, octave) * p + Vec3(3.1, 0.4, 7.7)) / std::ldexp(1.0, octave);
        if (std::abs(p.y) + 0.12 * height > 0.93) return Vec3(0.85, 0.88, 0.9);
        if (height < 0.02)
            return Vec3(0.03, 0.1, 0.25) + Vec3(0.02, 0.08, 0.1) * std::max(height + 0.4, Real(0));
        const Real dry = std::clamp(height * 1.6, Real(0), Real(1));
        return glm::mix(Vec3(0.08, 0.2, 0.05), Vec3(0.45, 0.33, 0.18), dry);
    });
}

/// The sky of an evening, in latitude and longitude: a bright west, and ground that is nearly dark. No value
/// is over 1, so that a file of 16 bits has it.
inline Image sunset_picture() {
    return picture_from(256, 128, [](Real u, Real v) {
        const Real longitude = 2 * pi * u, latitude = pi * (v - 0.5);
        const Vec3 d(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                     std::cos(latitude) * std::sin(longitude));
        if (d.y < 0)
            return glm::mix(Vec3(0.1, 0.09, 0.08), Vec3(0.03, 0.03, 0.035), std::min(-4 * d.y, Real(1)));
        const Vec3 sun = normalize(Vec3(0.8, 0.18, -0.6));
        const Real near_sun = std::max(dot(d, sun), Real(0));
        const Vec3 blue = glm::mix(Vec3(0.45, 0.4, 0.4), Vec3(0.08, 0.14, 0.35), std::sqrt(d.y));
        const Vec3 glow =
            Vec3(0.5, 0.25, 0.1) * std::pow(near_sun, Real(8)) + Vec3(0.3) * std::pow(near_sun, Real(200));
        const Real clouds = std::max(turbulence(Vec3(3, 9, 3) * d + Vec3(5, 0, 2), 5) - 0.55, Real(0));
        return glm::min(blue + glow + clouds * Vec3(0.5, 0.38, 0.35), Vec3(0.999));
    });
}

}  // namespace rt::figures
