// Diffuse light from the sky by nine spherical harmonics (Ramamoorthi & Hanrahan 2001).
// ε is the unit roundoff of `Real`.
#pragma once

#include "common/image/image.hpp"
#include "common/scene/sky.hpp"

#include <array>

namespace rt {

/// [11.6] The first nine real spherical harmonics at the unit vector d = (x, y, z), in the order Y₀₀; Y₁₋₁,
/// Y₁₀, Y₁₁; Y₂₋₂, Y₂₋₁, Y₂₀, Y₂₁, Y₂₂:
///   ½√(1/π);  ½√(3/π)·y, ½√(3/π)·z, ½√(3/π)·x;
///   ½√(15/π)·xy, ½√(15/π)·yz, ¼√(5/π)·(3z² − 1), ½√(15/π)·xz, ¼√(15/π)·(x² − y²).
/// The integral over the sphere of the product of two of them is 1 if they are the same, and else 0. Within
/// 16ε.
std::array<Real, 9> harmonics(const Vec3& d);

/// [11.6] The coefficients of a sky that is given as a picture in SkyMap::LatitudeLongitude of at least one
/// pixel: coefficient i is the sum over the pixels of radiance times harmonic i in the middle of the pixel
/// times the solid angle of the pixel. That is exact: Δθ·(sin φ₁ − sin φ₀) between the latitudes φ₀ and φ₁,
/// so that the angles of all pixels sum up to 4π, whatever their number. Within (n + 32)u of 4π times the
/// greatest radiance, for n pixels.
SkyLight projected(const Image& picture);

/// [11.6] The irradiance E at a surface with this unit normal from the sky with these coefficients, radiance
/// times steradian: a sky of radiance 1 gives π. The sum over i of A·Lᵢ·Yᵢ(normal), with A = π for the first,
/// 2π/3 for the next three and π/4 for the last five; 0 in a channel where that is negative. Within 32ε of
/// the sum of the terms' sizes.
///
/// It is exact for skies that are polynomials of degree 2 in (x, y, z), and for one that is bright above a
/// horizon and black below it. For any sky without negative light it differs from the integral by at most
/// 3/32 of ∫L dω, which is the most that a single point of light can make.
Vec3 irradiance(const SkyLight& light, const Vec3& normal);

/// What a diffuse surface reflects of the sky: kd·E/π. In the integrators of this course diffuse light is
/// kd·(n·l)·light, without 1/π: a lamp of light 1 straight above makes a white surface 1. With E/π for light,
/// so does a sky of radiance 1. Given.
Vec3 sky_diffuse(const SkyLight& light, const Vec3& normal, const Vec3& diffuse);

/// The sky as a picture in SkyMap::LatitudeLongitude: what is seen in the directions of the pixels' middles.
/// Width and height are at least 1. Given.
Image sky_picture(const Sky& sky, int width, int height);

/// The coefficients of any sky: those of its picture, which has as many rows as the sky's own picture, and
/// otherwise 32 × 1024 pixels. Given.
SkyLight sky_light(const Sky& sky);

}  // namespace rt
