// The footprint of a pixel on a texture, and the mean of the texture over it.
#pragma once

#include "chapters/11_textures/mip_map.hpp"
#include "common/scene/textures.hpp"

namespace rt {

/// How (u, v) changes from pixel to pixel: to the right (dx) and down the picture (dy). The two span the
/// parallelogram of the texture that one pixel sees.
struct Footprint {
    Vec2 dx{0};
    Vec2 dy{0};
};

/// The least sine of the angle between two tangents for which they count as two directions.
inline constexpr Real least_sine = 0x1p-20;

/// [11.14] The footprint where the surface runs along `du` = ∂p/∂u and `dv` = ∂p/∂v, and the point moves by
/// `dp_dx` and `dp_dy` from pixel to pixel: the changes of u and v for which a·du + b·dv is as near to dp as
/// possible (least squares). What dp has perpendicular to both tangents does not count.
///
/// A tangent is 0, or from 1e-70 to 1e30 long; |dp| is no more than 1e30. Where one of them is 0, or the sine
/// of the angle between them is less than `least_sine`, the texture has no size here, and the footprint is 0,
/// never NaN; within a factor of 2 of that sine either answer is right. Else u's change is right to
/// gamma(32)·|dp|/(|du|·sin³), and v's to the same with |dv|, where sin is that of the angle.
Footprint footprint(const Vec3& du, const Vec3& dv, const Vec3& dp_dx, const Vec3& dp_dy);

/// The ellipse that a footprint makes of the circle with the diameter of a pixel: its axes from end to end,
/// in texels of the finest level.
struct Ellipse {
    Vec2 along{1, 0};  ///< unit vector along the major axis
    Real major = 0;    ///< length of the longest axis
    Real minor = 0;    ///< and of the shortest, perpendicular to it
};

/// The ellipse of a footprint on a texture of size.x × size.y texels. For a parallelogram with right angles
/// the axes are its sides; in general they are the singular values of (dx dy). No axis is longer than 64
/// times the texture, where there is nothing to be seen but its mean. Given.
Ellipse ellipse(const Footprint& footprint, const Vec2& size);

/// The `width` to which `trilinear` filters `texels` texels of the finest level. Given.
Real width_of(const MipMap& map, Real texels);

/// [11.14] The mean of the texture over the footprint around uv, by probes along the ellipse's major axis (as
/// graphics hardware does, and Feline: McCormack, Perry, Farkas & Jouppi 1999). `most_probes`: from 1 to 64.
///
/// The width w of all probes is the minor axis; but at least 1 texel, below which nothing gets sharper, and
/// at least major/m, where m is the greatest odd number up to most_probes, so that they suffice. Probe k, for
/// k from −(m − 1)/2 to (m − 1)/2, is a `trilinear` lookup k·w along the major axis from uv. With the ratio
/// r = major/w, or 1 if that is less, it weighs as much of [k − ½, k + ½] as is in [−r/2, r/2]: the inner
/// probes 1, the outermost two a part of that, and those beyond 0. The weights add up to r, by which the sum
/// is divided.
///
/// So a constant texture gives its constant, and a linear one its value at uv, wherever trilinear does. The
/// result is continuous in the footprint: a new pair of probes begins with the weight 0. It costs at most
/// most_probes lookups; r rounded up to the next odd number, to be exact. A probe with the weight 0 need not
/// be looked up. uv and the footprint are finite. With `size` the texture's larger side in texels, it is
/// right to gamma(32)·(64 + (1 + |u| + |v|)·size) times the greatest value, and to what trilinear promises.
Vec3 anisotropic(const MipMap& map, const Vec2& uv, const Footprint& footprint, Wrap wrap, int most_probes);

}  // namespace rt
