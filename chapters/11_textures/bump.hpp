// Bumps: shading normals of a surface that is rougher than its shape.
// ε is the unit roundoff of `Real`.
#pragma once

#include "common/math/vec.hpp"

namespace rt {

/// How far a mirrored ray must rise, in parts of how far the viewer stands above the surface: kept_visible.
inline constexpr Real least_rise = 0x1p-6;

/// [11.11] The unit normal of the surface, were its points moved along `normal` by a small height that varies
/// in space: normal - (what the gradient has along the surface). (Perlin 1985, after Blinn 1978.)
///
/// `normal` is unit. Where the gradient is 0, or along the normal, it stays what it is, up to rounding. To
/// 16ε(1 + |height_gradient|); not NaN for a gradient up to 1e300 in size.
Vec3 bumped(const Vec3& normal, const Vec3& height_gradient);

/// [11.11] The same, where the height is known along the surface only: du and dv are how the point moves with
/// two texture coordinates, dh_du and dh_dv how the height does (Blinn 1978). du and dv lie in the surface,
/// or nearly; their lengths, their order and the angle between them do not matter.
///
/// To 64ε/sin^2 of the angle between du and dv, times 1 + |gradient|. `normal` itself if they are parallel as
/// far as rounding can tell, the sine below 2^-50, or if one of them is 0. du and dv are at most 1e100 in
/// size and, if they are not 0, at least 1e-100; so are the heights. All four times the same power of two
/// give the same bits.
Vec3 bumped(const Vec3& normal, const Vec3& du, const Vec3& dv, Real dh_du, Real dh_dv);

/// The unit normal that a pixel of a normal map says: 2 rgb - 1 are its parts along du, along dv and along
/// `normal`. The first is taken perpendicular to the normal, and the second to both, on the side of dv.
/// `normal` itself where du is 0 or along the normal, or rgb is 1/2 throughout. Given.
Vec3 from_normal_map(const Vec3& rgb, const Vec3& du, const Vec3& dv, const Vec3& normal);

/// [11.11] A shading normal that shading can use: one that the viewer sees from the front, and that does not
/// mirror the viewer's ray into the surface. All three are unit vectors. With c the size of
/// dot(geometric_normal, to_viewer):
///   - the result is unit, and on the viewer's side if the geometric normal is, else on the far side: its
///     product with to_viewer has the same sign, and a size of at least c/2, up to 64ε;
///   - the ray that is mirrored about it rises from the surface: with the geometric normal, turned to the
///     viewer, it has a product of at least least_rise * c, up to 64ε.
/// A shading normal with these properties is returned as it is. Of one without them it is the first with them
/// on the way to the geometric normal, straight and then made unit, to 1e-6; where the two are more than 150
/// degrees apart, any on that way. If c is 0 it is the geometric normal. (For the same purpose, and in other
/// ways, Keller et al. 2017.)
Vec3 kept_visible(const Vec3& shading_normal, const Vec3& geometric_normal, const Vec3& to_viewer);

}  // namespace rt
