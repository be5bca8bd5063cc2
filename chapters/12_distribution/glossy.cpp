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
    // 12.16  cos of the angle is a^(1/(s + 1)) for a uniform a; the angle around the axis is
    // uniform. Two vectors across the axis make the frame: any axis, also z itself.
    return todo("12.16");
}

Real around_axis_pdf(const Vec3& axis, Real exponent, const Vec3& direction) {
    // 12.16  The density, on the axis' side.
    return todo("12.16");
}

namespace {

/// The mirror's direction of v. Given.
[[maybe_unused]] Vec3 mirrored(const Vec3& v) { return {-v.x, -v.y, v.z}; }

}  // namespace

Real highlight_part(const ModifiedPhong& phong) {
    // 12.17  specular/(specular + diffuse), by mean_of; 0 if both are 0.
    return todo("12.17");
}

Real highlight_part(const DiffuseGgx& ggx) {
    // 12.17  The same, but at least ¼, and 1 if both are 0.
    return todo("12.17");
}

Vec3 evaluate(const ModifiedPhong& phong, const Vec3& to_light, const Vec3& to_viewer) {
    // 12.17  diffuse/π and the highlight, whose factor is (s + 2)/(2π), or 0 below the surface.
    return todo("12.17");
}

Real pdf(const ModifiedPhong& phong, const Vec3& to_light, const Vec3& to_viewer) {
    // 12.17  Both ways of drawing a direction, each by its probability.
    return todo("12.17");
}

std::optional<LobeSample> sample(const ModifiedPhong& phong, const Vec3& to_viewer, const Vec3& random) {
    // 12.17  Choose by random.z, draw, and weigh by the density of both ways together.
    return todo("12.17");
}

Vec3 evaluate(const DiffuseGgx& ggx, const Vec3& to_light, const Vec3& to_viewer) {
    // 12.17  diffuse/π and F·D·G₁(l)·G₁(v)/(4·l.z·v.z), or 0 below the surface.
    return todo("12.17");
}

Real pdf(const DiffuseGgx& ggx, const Vec3& to_light, const Vec3& to_viewer) {
    // 12.17  The facets' density is D·h.z; mirrored onto directions it becomes 4·l·h times less.
    return todo("12.17");
}

std::optional<LobeSample> sample(const DiffuseGgx& ggx, const Vec3& to_viewer, const Vec3& random) {
    // 12.17  Choose by random.z: a facet around the normal that mirrors the viewer's ray, or the
    // ground. Weigh by the density of both ways together.
    return todo("12.17");
}

}  // namespace rt
