// Rough glass: facets that mirror a part of the light and let the rest through.
#include "chapters/11_textures/rough_glass.hpp"

#include "chapters/07_recursion/optics.hpp"
#include "chapters/11_textures/microfacet.hpp"

#include "common/math/todo.hpp"

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
    // 11.18  Return the facet's normal, turned upwards. Is each direction on the same side of the
    // facet as of the surface?
    return todo("11.18");
}

Real pdf(const RoughGlass& glass, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.18  Return the density of directions that visible facets mirror or bend to v; 0 where
    // there is no facet.
    return todo("11.18");
}

Vec3 evaluate(const RoughGlass& glass, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.18  Return the lobe; 0 where there is no facet.
    return todo("11.18");
}

std::optional<LobeSample> sample(const RoughGlass& glass, const Vec3& to_viewer, const Vec3& random) {
    // 11.19  Draw a facet that the viewer sees, from whichever side; let random.z decide
    // whether it mirrors or lets through. Return nothing where the light is on the wrong side.
    return todo("11.19");
}

}  // namespace rt
