// Ray differentials: how a ray changes from one pixel to the next.
// The lesson uses the same letters: p for a point on the ray, d for its direction, n for a normal, and dp,
// dd, dn for how these change.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/view.hpp"

namespace rt {

/// How a ray changes from pixel to pixel, to first order (Igehy, Tracing Ray Differentials, 1999): the
/// derivatives of its origin and its direction by the pixel coordinates x and y of chapter 1. One more in x
/// is the next pixel to the right, one more in y the next pixel DOWN the picture. World units per pixel.
struct RayDifferential {
    Vec3 origin_dx{0};
    Vec3 origin_dy{0};
    Vec3 direction_dx{0};
    Vec3 direction_dy{0};
};

/// How the unit normal changes where the neighbouring rays meet the surface, per pixel to the right and down.
struct NormalChange {
    Vec3 dx{0};
    Vec3 dy{0};
};

/// The least size of a cosine that is divided by. The derivatives of a ray that grazes a surface are without
/// bound, but whoever asks wants a large number, not an infinite one: a smaller cosine counts as this one.
inline constexpr Real least_cosine = 0x1p-20;

/// [11.12] How pixel_ray(view, x, y) changes. Perspective: the origin stays, and the change of the direction
/// is that of the unit vector, so it is perpendicular to the direction. Orthographic: the direction stays,
/// and the origin moves.
///
/// With k = 2·half_height/height, the size of a pixel on the image plane, each coordinate is right to
/// gamma(16)·k.
RayDifferential camera_differential(const View& view, Real x, Real y);

/// [11.12] The differential where the ray meets a surface, at point_at(ray, t): the change of the origin is
/// that of the point in which the neighbouring ray meets the tangent plane there; the change of the direction
/// stays. ray.direction and `normal` are unit vectors, the normal on either side. t is finite and may be
/// negative: behind a mirror, say, where its rays seem to come from.
///
/// Each coordinate is right to gamma(16)·(|dp| + |t|·|dd|)/|cos|, where cos = direction · normal, dp and dd
/// are what comes in, and |cos| is at least `least_cosine`. Of rays that graze the surface more than that,
/// down to cos = 0 where the neighbours may never meet the plane, the answer is only promised to be finite,
/// never NaN, if |dp|, |dd| and |t| are no more than 1e100.
RayDifferential transferred(const RayDifferential& differential, const Ray& ray, Real t, const Vec3& normal);

/// [11.13] How the unit normal changes when the point moves as `at_surface` says (as `transferred` returns
/// it): dn = curvature · (dp − (dp·n)n), in x and in y. For a sphere of radius r the curvature is 1/r where
/// `normal` points away from the centre, and −1/r where it was turned towards it. It is 0 for all that is
/// flat: planes, discs, boxes, triangles. For a sphere and for flat things this is right.
///
/// Other shapes curve more along one direction than along another. For them one number is an estimate: take
/// the mean of the two principal curvatures, such as 1/(2r) for a cylinder, whose true values are 1/r around
/// it and 0 along it. That a smooth triangle's shading normal changes is left out likewise. Only the width of
/// a texture's filter depends on the error. Right to gamma(8)·|curvature|·|dp|.
NormalChange normal_change(const RayDifferential& at_surface, const Vec3& normal, Real curvature);

/// [11.13] The differential of the mirrored ray, whose direction is reflect(d, n) = d − 2(d·n)n. `at_surface`
/// is the incoming ray's, transferred to the surface; d, n: unit; `change`: of n. The origin's change stays.
/// Right to gamma(24)·(|dd| + |dn|).
RayDifferential reflected(const RayDifferential& at_surface, const Vec3& d, const Vec3& n,
                          const NormalChange& change);

/// [11.13] The differential of the refracted ray, whose direction is refract(d, n, eta) of chapter 7. d:
/// unit; n: unit, against d (d·n ≤ 0); `change`: of that n; eta = ior before / ior behind. Where reflection
/// is total there is no refracted ray, and this must not be asked. The origin's change stays.
///
/// With cosₜ the cosine of the refracted ray, right to gamma(16)·(1 + eta)⁴·(|dd| + |dn|)/cosₜ³, where cosₜ
/// is at least `least_cosine`; where it is smaller, the answer is only promised to be finite.
RayDifferential refracted(const RayDifferential& at_surface, const Vec3& d, const Vec3& n,
                          const NormalChange& change, Real eta);

}  // namespace rt
