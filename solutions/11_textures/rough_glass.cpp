// Rough glass: facets that mirror a part of the light and let the rest through.
#include "chapters/11_textures/rough_glass.hpp"

#include "chapters/07_recursion/optics.hpp"
#include "chapters/11_textures/microfacet.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// The index of refraction on the side where w is. Given.
[[maybe_unused]] Real ior_at(const RoughGlass& glass, const Vec3& w) { return w.z > 0 ? 1 : glass.ior; }

/// The part of the light that a facet mirrors to v, where `cosine` = |v·h|. Given.
[[maybe_unused]] Real mirrored_part(const RoughGlass& glass, const Vec3& v, Real cosine) {
    return fresnel(std::min(cosine, Real(1)), v.z > 0 ? 1 / glass.ior : glass.ior);
}

/// G₁ on either side. Given.
[[maybe_unused]] Real seen_part(const RoughGlass& glass, const Vec3& w) {
    return smith_g1(ggx_alpha(glass.roughness), {w.x, w.y, std::abs(w.z)});
}

}  // namespace

std::optional<Vec3> glass_facet(const RoughGlass& glass, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 11.18] Return the facet's normal, turned upwards. Is each direction on the same side of the
    // facet as of the surface?
    const bool mirrors = to_light.z * to_viewer.z > 0;
    const Vec3 sum = mirrors ? to_light + to_viewer
                             : ior_at(glass, to_light) * to_light + ior_at(glass, to_viewer) * to_viewer;
    // The glass below is the denser side: only against the sum is the facet's outside up.
    const Vec3 h = normalize(mirrors && to_viewer.z > 0 ? sum : -sum);
    const bool sides_agree = dot(to_light, h) * to_light.z > 0 && dot(to_viewer, h) * to_viewer.z > 0;
    if (!(h.z > 0) || !sides_agree) return std::nullopt;
    return h;
    // [/exercise]
}

Real pdf(const RoughGlass& glass, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 11.18] Return the density of directions that visible facets mirror or bend to v; 0 where
    // there is no facet.
    const std::optional<Vec3> h = glass_facet(glass, to_light, to_viewer);
    if (!h) return 0;
    const Real facets = ggx_density(ggx_alpha(glass.roughness), *h) * seen_part(glass, to_viewer);
    const Real cos_l = std::abs(dot(to_light, *h)), cos_v = std::abs(dot(to_viewer, *h));
    const Real mirrored = mirrored_part(glass, to_viewer, cos_v);
    if (to_light.z * to_viewer.z > 0) return facets / std::abs(to_viewer.z) * mirrored / 4;
    const Real n_l = ior_at(glass, to_light);
    const Real s = length(n_l * to_light + ior_at(glass, to_viewer) * to_viewer) / n_l;
    return facets / std::abs(to_viewer.z) * (1 - mirrored) * cos_l * cos_v / (s * s);
    // [/exercise]
}

Vec3 evaluate(const RoughGlass& glass, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 11.18] Return the lobe; 0 where there is no facet.
    const Real density = pdf(glass, to_light, to_viewer);
    if (!(density > 0)) return Vec3(0);
    return glass.color * (density * (seen_part(glass, to_light) / std::abs(to_light.z)));
    // [/exercise]
}

std::optional<LobeSample> sample(const RoughGlass& glass, const Vec3& to_viewer, const Vec3& random) {
    // [exercise 11.19] Draw a facet that the viewer sees, from whichever side; let random.z decide
    // whether it mirrors or lets through. Return nothing where the light is on the wrong side.
    if (to_viewer.z == 0) return std::nullopt;
    const Real side = to_viewer.z > 0 ? 1 : -1;
    const Vec3 h = side * visible_normal(ggx_alpha(glass.roughness), side * to_viewer, random.x, random.y);
    const bool mirrors = random.z < mirrored_part(glass, to_viewer, std::max(dot(to_viewer, h), Real(0)));
    std::optional<Vec3> to_light = normalize(reflect(-to_viewer, h));
    if (!mirrors) to_light = refract(-to_viewer, h, side > 0 ? 1 / glass.ior : glass.ior);
    if (!to_light || (to_light->z * to_viewer.z > 0) != mirrors) return std::nullopt;
    const Real density = pdf(glass, *to_light, to_viewer);
    if (!(density > 0)) return std::nullopt;
    return LobeSample{*to_light, glass.color * seen_part(glass, *to_light), density};
    // [/exercise]
}

}  // namespace rt
