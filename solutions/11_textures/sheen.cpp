// Velvet: fibres that stand up, and shine at the horizon.
#include "chapters/11_textures/sheen.hpp"

#include "chapters/07_recursion/optics.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Real velvet_density(Real sigma, const Vec3& h) {
    // [exercise 11.20] Return D, which is 0 where the facet lies flat.
    const Real flat = h.x * h.x + h.y * h.y, variance = sigma * sigma;
    const Real exponent = h.z * h.z / (flat * variance);
    // Written so that a NaN, of 0/0, takes this way out too. exp(−745) is the last that is not 0.
    if (!(h.z >= 0) || !(exponent < 745)) return 0;
    return std::exp(-exponent) / (pi * variance * flat * flat);
    // [/exercise]
}

Real cavity_g1(const Vec3& w, const Vec3& h) {
    // [exercise 11.20] Return the part of the facet that its partner does not hide from w.
    return std::min(2 * h.z * w.z / dot(w, h), Real(1));
    // [/exercise]
}

Vec3 evaluate(const Velvet& velvet, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 11.20] Return the lobe of velvet, or 0 if one of the directions is not above the surface.
    if (!(to_light.z > 0) || !(to_viewer.z > 0)) return Vec3(0);
    const Vec3 h = normalize(to_light + to_viewer);
    const Real hidden = std::min(cavity_g1(to_light, h), cavity_g1(to_viewer, h));
    return velvet.color * (velvet_density(velvet_spread(velvet), h) * hidden / to_light.z / to_viewer.z / 4);
    // [/exercise]
}

Real pdf(const Velvet& velvet, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 11.20] Return the density of directions that visible facets mirror to v; 0 as in evaluate.
    if (!(to_light.z > 0) || !(to_viewer.z > 0)) return 0;
    const Vec3 h = normalize(to_light + to_viewer);
    return velvet_density(velvet_spread(velvet), h) * cavity_g1(to_viewer, h) / to_viewer.z / 4;
    // [/exercise]
}

std::optional<LobeSample> sample(const Velvet& velvet, const Vec3& to_viewer, const Vec3& random) {
    // [exercise 11.21] Draw a facet with the density D·cosθ, let random.z choose it or its partner as the
    // viewer sees them, and return the light that the chosen one mirrors there.
    if (!(to_viewer.z > 0)) return std::nullopt;
    const Real sigma = velvet_spread(velvet), phi = 2 * pi * random.y;
    const Real cotangent = sigma * std::sqrt(-std::log1p(-random.x));
    const Real sine = 1 / std::hypot(Real(1), cotangent);
    Vec3 h(sine * std::cos(phi), sine * std::sin(phi), sine * cotangent);
    const Vec3 partner(-h.x, -h.y, h.z);
    const Real first = std::max(dot(to_viewer, h), Real(0));
    const Real second = std::max(dot(to_viewer, partner), Real(0));
    if (random.z * (first + second) >= first) h = partner;
    const Vec3 to_light = reflect(-to_viewer, h);
    const Real density = pdf(velvet, to_light, to_viewer);
    if (!(density > 0)) return std::nullopt;
    const Real left = std::min(cavity_g1(to_light, h) / cavity_g1(to_viewer, h), Real(1));
    return LobeSample{to_light, velvet.color * left, density};
    // [/exercise]
}

}  // namespace rt
