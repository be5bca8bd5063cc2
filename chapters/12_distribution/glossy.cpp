// Glossy surfaces of two kinds that the successor course's scenes have: a lobe around the mirror's direction,
// and microfacets over a matte ground.
#include "chapters/12_distribution/glossy.hpp"

#include "chapters/11_textures/matte.hpp"
#include "chapters/11_textures/microfacet.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// (1 − cosine)⁵, what Schlick's term has of what is missing to white. Given.
[[maybe_unused]] Real schlick_part(Real cosine) {
    const Real m = std::clamp(1 - cosine, Real(0), Real(1));
    return m * m * m * m * m;
}

}  // namespace

Vec3 around_axis(const Vec3& axis, Real exponent, const Vec2& random) {
    // 12.16  A direction of Phong's lobe around any axis.
    return todo("12.16");
}

Real around_axis_pdf(const Vec3& axis, Real exponent, const Vec3& direction) {
    // 12.16  The density of around_axis in this direction.
    return todo("12.16");
}

namespace {

/// The mirror's direction of v. Given.
[[maybe_unused]] Vec3 mirrored(const Vec3& v) { return {-v.x, -v.y, v.z}; }

}  // namespace

Real highlight_part(const ModifiedPhong& phong) {
    // 12.17  The probability with which `sample` draws in the highlight.
    return todo("12.17");
}

Vec3 evaluate(const ModifiedPhong& phong, const Vec3& to_light, const Vec3& to_viewer) {
    // 12.17  The lobe: ground and highlight.
    return todo("12.17");
}

Real pdf(const ModifiedPhong& phong, const Vec3& to_light, const Vec3& to_viewer) {
    // 12.17  The density of the directions that `sample` draws, both of its ways together.
    return todo("12.17");
}

std::optional<LobeSample> sample(const ModifiedPhong& phong, const Vec3& to_viewer, const Vec3& random) {
    // 12.17  A direction from the highlight or from the ground, and its weight.
    return todo("12.17");
}

Real highlight_part(const DiffuseGgx& ggx) {
    // 12.23  The probability with which `sample` draws a facet.
    return todo("12.23");
}

Vec3 evaluate(const DiffuseGgx& ggx, const Vec3& to_light, const Vec3& to_viewer) {
    // 12.23  The lobe: ground and facets.
    return todo("12.23");
}

Real pdf(const DiffuseGgx& ggx, const Vec3& to_light, const Vec3& to_viewer) {
    // 12.23  The density of the directions that `sample` draws, both of its ways together.
    return todo("12.23");
}

std::optional<LobeSample> sample(const DiffuseGgx& ggx, const Vec3& to_viewer, const Vec3& random) {
    // 12.23  A direction that a facet mirrors, or one from the ground, and its weight.
    return todo("12.23");
}

}  // namespace rt
