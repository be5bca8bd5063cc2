// A lens instead of a pinhole: points of its opening, rays through it, and how large the blur is; and a lens
// that leans.
#pragma once

#include "chapters/01_ray_casting/camera.hpp"
#include "common/scene/lens.hpp"

namespace rt {

/// [12.6] The point of the unit disc that the concentric map (Shirley & Chiu, A Low Distortion Map Between
/// Disk and Square, 1997) makes of `random`, a point of the unit square.
///
/// Squares around the middle of the unit square become circles around 0, as large in proportion, and each of
/// their sides becomes a quarter of the circle, evenly: (1, ½) becomes (1, 0), the corner (1, 1) becomes
/// (√½, √½), and (½, 1) becomes (0, 1). The middle itself becomes 0. All areas shrink by the same factor π/4,
/// so what was uniform in the square is uniform in the disc. Each coordinate is right to gamma(16).
Vec2 disc_point(const Vec2& random);

/// [12.6] The same for the regular polygon of `sides` ≥ 3 corners on the unit circle, one of them at the
/// angle `turn` (radians, counterclockwise from (1, 0)).
///
/// Where the disc's point is at radius r and angle φ, from 0 to 2π, the polygon's is r times the point of its
/// edge that one comes to, from the corner at `turn` counterclockwise, after φ/2π of the whole way around. So
/// circles become polygons, areas keep their proportion, and uniform stays uniform. Each coordinate is right
/// to gamma(64)·(1 + |turn|).
Vec2 polygon_point(int sides, Real turn, const Vec2& random);

/// [12.7] The ray through the point (x, y) of the picture that passes the lens at `on_lens`, a point of the
/// unit disc, x to the right and y upwards. Its time is 0.
///
/// The middle of the lens is where pixel_ray's ray starts. This ray starts beside it, by
/// lens.radius·(on_lens.x·u + on_lens.y·v), and is aimed at the point where pixel_ray's ray meets the plane
/// in focus, which is perpendicular to the view, lens.distance in front of the eye (Cook, Porter & Carpenter,
/// Distributed Ray Tracing, 1984). That holds for perspective and orthographic views. With a radius of 0 it
/// is pixel_ray's ray, to rounding. lens.distance may be infinite: the rays of one point of the picture are
/// then parallel.
///
/// The direction is a unit vector, and right to gamma(300)·(1 + a² + b²) in each coordinate, with a and b of
/// the picture's corner on the image plane at distance 1 (0 in an orthographic view), however far the eye is
/// from the world's origin, for lens.radius/lens.distance up to 1e8.
Ray lens_ray(const View& view, const Lens& lens, Real x, Real y, const Vec2& on_lens);

/// [12.7] The blur of a point that is `depth` > 0 away along the view: the radius, in world units, of the
/// disc in which the rays from the whole lens through that point meet the plane in focus, in a perspective
/// view. lens.radius is that of a round lens, or of the circle around a polygon; lens.distance is finite.
///
/// 0 in focus; a point infinitely far away has the blur lens.radius, and one nearer than half of
/// lens.distance a greater one, without limit. The relative error is at most gamma(6), near the focus, too.
Real blur_radius(const Lens& lens, Real depth);

/// A plane that is to be in focus, whichever way it leans.
struct FocusPlane {
    Vec3 point{0, 0, -1};  ///< any point of it
    Vec3 normal{0, 0, 1};  ///< across it, of any length but 0
};

/// [12.24] The ray of lens_ray through a lens of this radius, but with `plane` in focus, as in a camera whose
/// lens leans against its film (Scheimpflug 1904). It starts at the same point of the lens, and is aimed at
/// the point where pixel_ray's ray, from the middle of the lens, meets the plane. Where that is behind the
/// lens, rays part as if they came from there; where it is infinitely far away, they are parallel. The middle
/// of the lens is not in the plane.
///
/// The direction is a unit vector, and right to gamma(300)·(1 + a² + b²)·(1 + k) in each coordinate, with a
/// and b as in lens_ray. k is radius/h·(1 + D/h), where h is how far the middle of the lens is from the plane
/// and D how far it and plane.point are from the world's origin, together.
Ray tilted_lens_ray(const View& view, Real radius, const FocusPlane& plane, Real x, Real y,
                    const Vec2& on_lens);

}  // namespace rt
