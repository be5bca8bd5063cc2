// Matte surfaces: Lambert's, and rough ones, which look flatter.
#include "chapters/11_textures/matte.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Vec3 evaluate(const Matte& matte, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 11.15] Return Fujii's lobe, or 0 if one of the directions is not above the surface.
    if (!(to_light.z > 0) || !(to_viewer.z > 0)) return Vec3(0);
    const Real sigma = matte.roughness;
    const Real s = to_light.x * to_viewer.x + to_light.y * to_viewer.y;
    const Real t = s > 0 ? s / std::max(to_light.z, to_viewer.z) : s;
    // σ and −s are at most 1, but for a rounding.
    return matte.color * (std::max(1 + sigma * t, Real(0)) / (pi + sigma * (3 * pi - 4) / 6));
    // [/exercise]
}

Real oren_nayar_1994(Real sigma, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 11.15] Return the lobe of 1994. It needs no angles: what is sin α · tan β · cos Δφ in terms
    // of s?
    if (!(to_light.z > 0) || !(to_viewer.z > 0)) return 0;
    // α and β are the two angles in some order, so sin α · sin β · cos Δφ = s. What is left is 1/cos β, of
    // the smaller angle, so of the greater cosine.
    const Real s = to_light.x * to_viewer.x + to_light.y * to_viewer.y;
    const Real variance = sigma * sigma;
    const Real a = 1 - variance / (2 * (variance + 0.33)), b = 0.45 * variance / (variance + 0.09);
    return (a + b * std::max(s, Real(0)) / std::max(to_light.z, to_viewer.z)) / pi;
    // [/exercise]
}

Vec3 cosine_direction(Real a, Real b) {
    // [exercise 11.15] Lift a point of the unit disc onto the hemisphere.
    const Real r = std::sqrt(a), phi = 2 * pi * b;
    return {r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - a)};
    // [/exercise]
}

Real pdf(const Matte&, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 11.15] The density of cosine_direction, where both directions are above the surface.
    return to_light.z > 0 && to_viewer.z > 0 ? to_light.z / pi : 0;
    // [/exercise]
}

std::optional<LobeSample> sample(const Matte& matte, const Vec3& to_viewer, const Vec3& random) {
    // [exercise 11.15] Return a direction, how much light from there counts, and the density. Which factors
    // of the weight cancel?
    if (!(to_viewer.z > 0)) return std::nullopt;
    const Vec3 to_light = cosine_direction(random.x, random.y);
    return LobeSample{to_light, pi * evaluate(matte, to_light, to_viewer), to_light.z / pi};
    // [/exercise]
}

}  // namespace rt
