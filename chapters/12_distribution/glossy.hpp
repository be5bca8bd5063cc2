// Glossy surfaces of two kinds that the successor course's scenes have: a lobe around the mirror's direction,
// and microfacets over a matte ground. Directions are as in chapter 11: unit vectors away from the surface,
// in a frame whose z axis is the normal; l to the light, v to the viewer.
// ε is the unit roundoff of `Real`.
#pragma once

#include "chapters/11_textures/lobe.hpp"
#include "common/math/vec.hpp"

#include <algorithm>
#include <optional>

namespace rt {

/// [12.16] A unit vector around `axis`, on its side, with the density (s + 1)/(2π)·cosˢ per sr, where s is
/// the exponent and cos that of the angle to the axis (Phong's lobe). s = 0 is even over the half of all
/// directions, s = 1 is Lambert's cosine, s = 1e8 all but the axis. axis: unit, any; exponent in [0, 1e8];
/// random in [0, 1)². Which numbers give which direction is left open. Never NaN.
Vec3 around_axis(const Vec3& axis, Real exponent, const Vec2& random);

/// [12.16] That density; 0 on the other side of the axis, for s = 0 as well. Both vectors are unit up to
/// rounding: so it is right to gamma(8)·(1 + s/cos), as a part of itself, where it is more than 1e-300.
Real around_axis_pdf(const Vec3& axis, Real exponent, const Vec3& direction);

/// A matte ground, and a lobe around the direction in which a mirror would see the light (Lafortune & Willems
/// 1994). It sends out no more light than it gets if diffuse + specular ≤ 1 in each channel; that is not
/// asked.
struct ModifiedPhong {
    Vec3 diffuse{0.5};   ///< each channel ≥ 0
    Vec3 specular{0.5};  ///< each channel ≥ 0
    Real exponent = 10;  ///< s in [0, 1e8]: how narrow the highlight is
};

/// A matte ground, and over it facets of GGX (Walter and others 2007). What the facets reflect is not taken
/// from the ground, so at grazing angles it may send out more light than it gets.
struct DiffuseGgx {
    Vec3 diffuse{0.5};     ///< each channel in [0, 1]
    Vec3 specular{0.5};    ///< each channel in [0, 1]: what a facet reflects that light meets straight
    Real roughness = 0.5;  ///< α itself, in [0, 1], and not its root as RoughMetal has it
};

/// α of a DiffuseGgx: its roughness, but at least that of the smoothest lobe. Given.
inline Real alpha_of(const DiffuseGgx& ggx) {
    return std::max(ggx.roughness, least_roughness * least_roughness);
}

/// Mean of the channels: how strong a colour counts in the choice between ground and highlight. Given.
inline Real mean_of(const Vec3& color) { return (color.x + color.y + color.z) / 3; }

/// [12.17] t, the part of the directions that `sample` draws in the highlight: what the specular has of
/// specular + diffuse, by their means; 0 if both are 0.
Real highlight_part(const ModifiedPhong& phong);

/// [12.17] The lobe f in 1/sr, without the cosine:
///   f = diffuse/π + specular·(s + 2)/(2π)·max(0, r·l)ˢ, r the mirror's direction (−v.x, −v.y, v.z);
/// 0 if either direction is not above the surface. Right to gamma(16)·(1 + s), as a part of itself, where r·l
/// is not in (0, 1e-8).
Vec3 evaluate(const ModifiedPhong& phong, const Vec3& to_light, const Vec3& to_viewer);

/// [12.17] The density of sample's directions per sr,
///   (1 − t)·l.z/π + t·(s + 1)/(2π)·max(0, r·l)ˢ;
/// 0 if either direction is not above the surface. As right as evaluate. What would be below the surface is
/// lost, so that its sum over all directions may be less than 1.
Real pdf(const ModifiedPhong& phong, const Vec3& to_light, const Vec3& to_viewer);

/// [12.17] With the probability t a direction around_axis r, else a cosine_direction around the normal; the
/// weight is that of both together, f·l.z/pdf. random.z chooses. Nothing if the viewer is not above the
/// surface, or the direction is not. In each channel the weight is at most
/// diffuse/(1 − t) + specular/t·(s + 2)/(s + 1), where a term is left out whose colour is 0.
std::optional<LobeSample> sample(const ModifiedPhong& phong, const Vec3& to_viewer, const Vec3& random);

/// [12.23] The same for microfacets, but at least ¼, because at grazing angles a facet reflects all, however
/// dark its specular is; 1 if both are 0.
Real highlight_part(const DiffuseGgx& ggx);

/// [12.23] The lobe f in 1/sr, without the cosine:
///   f = diffuse/π + F·D(h)·G₁(l)·G₁(v)/(4·l.z·v.z),  F = specular + (1 − specular)·(1 − l·h)⁵,
/// with chapter 11's D and G₁, of the α of alpha_of, and h between l and v; 0 if either direction is not
/// above the surface. Finite for cosines of 1e-8 and more. Right to gamma(32) + 16ε/(α·|l + v|), as a part of
/// the lobe of a white specular.
Vec3 evaluate(const DiffuseGgx& ggx, const Vec3& to_light, const Vec3& to_viewer);

/// [12.23] The density of sample's directions per sr, (1 − t)·l.z/π + t·D(h)·h.z/(4·l·h); 0 if either
/// direction is not above the surface. Right to gamma(32) + 16ε/(α·|l + v|) + 16ε/|l + v|², as a part of
/// itself, and not negative, where that is less than 1.
Real pdf(const DiffuseGgx& ggx, const Vec3& to_light, const Vec3& to_viewer);

/// [12.23] With the probability t light mirrored by a facet whose normal has the density D(h)·h.z, which is
/// at tan θ = α·√(a/(1 − a)) for a random number a; else a cosine_direction. The weight is f·l.z/pdf.
/// random.z chooses. Nothing if the viewer is not above the surface, or the direction is not. Weights are
/// finite for viewers with a cosine of 1e-6 and more.
std::optional<LobeSample> sample(const DiffuseGgx& ggx, const Vec3& to_viewer, const Vec3& random);

}  // namespace rt
