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
    // 11.15  The normal, turned upwards where the facet mirrors below the surface. Is each
    // direction on the side of the facet on which it is of the surface?
    return todo("11.15");
}

Real pdf(const RoughGlass& glass, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.15  The density of visible facets without their v·h, times the part that goes this way,
    // times how much denser facets are than directions: 1/4 where mirrored, and where let through
    // n_l²·|l·h|·|v·h|/s².
    return todo("11.15");
}

Vec3 evaluate(const RoughGlass& glass, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.15  color·pdf·G₁(l)/|l.z|, or 0 where there is no facet.
    return todo("11.15");
}

std::optional<LobeSample> sample(const RoughGlass& glass, const Vec3& to_viewer, const Vec3& random) {
    // 11.15  A facet that the viewer sees; from below it is one that is seen from the direction
    // opposite to his. It mirrors or lets through, as random.z decides; pdf says 0 if that leads to the wrong
    // side.
    return todo("11.15");
}

}  // namespace rt
