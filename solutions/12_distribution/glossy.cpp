// Glossy surfaces of two kinds that the successor course's scenes have: a lobe around the mirror's direction,
// and microfacets over a matte ground.
#include "chapters/12_distribution/glossy.hpp"

#include "chapters/11_textures/matte.hpp"
#include "chapters/11_textures/microfacet.hpp"

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
    // [exercise 12.16] A direction of Phong's lobe around any axis.
    const Vec3 other = std::abs(axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 across = normalize(cross(other, axis)), along = cross(axis, across);
    // cos^(s + 1) is uniform.
    // 1 − random.x is never 0. By the logarithm sin² = 1 − cos² keeps its digits, however narrow the lobe.
    const Real logarithm = std::log1p(-random.x) / (exponent + 1), phi = 2 * pi * random.y;
    const Real cosine = std::exp(logarithm), sine = std::sqrt(-std::expm1(2 * logarithm));
    return cosine * axis + sine * (std::cos(phi) * across + std::sin(phi) * along);
    // [/exercise]
}

Real around_axis_pdf(const Vec3& axis, Real exponent, const Vec3& direction) {
    // [exercise 12.16] The density of around_axis in this direction.
    const Real cosine = dot(axis, direction);
    // Asked before: the power of 0 with the exponent 0 is 1.
    if (!(cosine > 0)) return 0;
    return (exponent + 1) / (2 * pi) * std::pow(cosine, exponent);
    // [/exercise]
}

namespace {

/// The mirror's direction of v. Given.
[[maybe_unused]] Vec3 mirrored(const Vec3& v) { return {-v.x, -v.y, v.z}; }

}  // namespace

Real highlight_part(const ModifiedPhong& phong) {
    // [exercise 12.17] The probability with which `sample` draws in the highlight.
    const Real specular = mean_of(phong.specular), all = specular + mean_of(phong.diffuse);
    return all > 0 ? specular / all : 0;
    // [/exercise]
}

Vec3 evaluate(const ModifiedPhong& phong, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 12.17] The lobe: ground and highlight.
    if (!(to_light.z > 0) || !(to_viewer.z > 0)) return Vec3(0);
    const Real power = phong.exponent;
    // The density of around_axis has the right power; it begins with s + 1.
    const Real density = around_axis_pdf(mirrored(to_viewer), power, to_light);
    const Real highlight = density * ((power + 2) / (power + 1));
    return phong.diffuse / pi + phong.specular * highlight;
    // [/exercise]
}

Real pdf(const ModifiedPhong& phong, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 12.17] The density of the directions that `sample` draws, both of its ways together.
    if (!(to_light.z > 0) || !(to_viewer.z > 0)) return 0;
    const Real t = highlight_part(phong);
    return (1 - t) * to_light.z / pi + t * around_axis_pdf(mirrored(to_viewer), phong.exponent, to_light);
    // [/exercise]
}

std::optional<LobeSample> sample(const ModifiedPhong& phong, const Vec3& to_viewer, const Vec3& random) {
    // [exercise 12.17] A direction from the highlight or from the ground, and its weight.
    if (!(to_viewer.z > 0)) return std::nullopt;
    const bool in_highlight = random.z < highlight_part(phong);
    const Vec3 to_light = in_highlight
                              ? around_axis(mirrored(to_viewer), phong.exponent, {random.x, random.y})
                              : cosine_direction(random.x, random.y);
    const Real density = pdf(phong, to_light, to_viewer);
    // Below the surface it is 0.
    if (!(density > 0)) return std::nullopt;
    return LobeSample{to_light, evaluate(phong, to_light, to_viewer) * (to_light.z / density), density};
    // [/exercise]
}

Real highlight_part(const DiffuseGgx& ggx) {
    // [exercise 12.23] The probability with which `sample` draws a facet.
    const Real highlight = mean_of(ggx.specular), both = highlight + mean_of(ggx.diffuse);
    return both > 0 ? std::max(highlight / both, Real(0.25)) : 1;
    // [/exercise]
}

Vec3 evaluate(const DiffuseGgx& ggx, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 12.23] The lobe: ground and facets.
    if (!(to_light.z > 0) || !(to_viewer.z > 0)) return Vec3(0);
    const Real alpha = alpha_of(ggx);
    const Vec3 h = normalize(to_light + to_viewer);
    const Vec3 fresnel = ggx.specular + (Vec3(1) - ggx.specular) * schlick_part(dot(to_light, h));
    // Each G₁ by its own cosine: no product of two small numbers is divided by.
    const Real seen = smith_g1(alpha, to_light) / to_light.z * (smith_g1(alpha, to_viewer) / to_viewer.z);
    return ggx.diffuse / pi + fresnel * (ggx_density(alpha, h) * seen / 4);
    // [/exercise]
}

Real pdf(const DiffuseGgx& ggx, const Vec3& to_light, const Vec3& to_viewer) {
    // [exercise 12.23] The density of the directions that `sample` draws, both of its ways together.
    if (!(to_light.z > 0) || !(to_viewer.z > 0)) return 0;
    const Vec3 both = to_light + to_viewer, h = normalize(both);
    const Real facets = ggx_density(alpha_of(ggx), h) * h.z, t = highlight_part(ggx);
    // l·h is |l + v|/2: the dot product would lose it where both graze on opposite sides.
    return (1 - t) * to_light.z / pi + t * facets / (2 * length(both));
    // [/exercise]
}

std::optional<LobeSample> sample(const DiffuseGgx& ggx, const Vec3& to_viewer, const Vec3& random) {
    // [exercise 12.23] A direction that a facet mirrors, or one from the ground, and its weight.
    const Real slope = alpha_of(ggx) * std::sqrt(random.x / (1 - random.x)), phi = 2 * pi * random.y;
    const Vec3 h = normalize(Vec3(slope * std::cos(phi), slope * std::sin(phi), 1));
    const bool by_facet = random.z < highlight_part(ggx);
    const Vec3 to_light =
        by_facet ? normalize(2 * dot(to_viewer, h) * h - to_viewer) : cosine_direction(random.x, random.y);
    const Real density = pdf(ggx, to_light, to_viewer);
    // 0 if either direction is below the surface.
    if (!(density > 0)) return std::nullopt;
    return LobeSample{to_light, evaluate(ggx, to_light, to_viewer) * (to_light.z / density), density};
    // [/exercise]
}

}  // namespace rt
