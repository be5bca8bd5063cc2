// Where a point of a shape lies on a texture, and how the surface runs there.
// ε is the unit roundoff of `Real`.
#pragma once

#include "common/scene/shapes.hpp"
#include "common/world/hit.hpp"
#include "common/world/world.hpp"

#include <array>
#include <cstdint>

namespace rt {

/// A point of a surface as a texture sees it. `uv` says where on the texture it lies; `du` and `dv` say how
/// the point moves, in the shape's own space, for each unit of u and of v: ∂p/∂u and ∂p/∂v. They are tangent
/// to the surface, but neither unit vectors nor, on a cone or triangle, always perpendicular. Both have a
/// length of 0 where they are not known.
///
/// du × dv is along the normal that points outwards on planes, discs, boxes, caps and tori: there the image
/// can be read from outside. It is against it on spheres and on the sides of cones, whose u runs as POV-Ray's
/// and as step 02.4 does: to the left, seen from outside with the axis up.
struct TexturePoint {
    Vec2 uv{0};
    Vec3 du{0}, dv{0};
};

/// Two unit vectors in a plane, perpendicular to each other.
struct PlaneAxes {
    Vec3 u{1, 0, 0}, v{0, 1, 0};
};

/// The axes of a texture on a plane with this normal n, of any length but 0: u along (n.z + n.y², −n.x·n.y,
/// −n.x), where n is made a unit vector, and v = n × u. Given.
///
/// An image on a wall stands upright, v = (0, 1, 0), seen from the side that the normal points to; on a
/// floor, n = (0, 1, 0), it lies with u along +x and v along −z; on a ceiling with u along +x and v along +z.
/// Between these the axes turn smoothly. No rule can be continuous everywhere: where this one is not, the
/// normal is about (0, ±0.786, −0.618).
PlaneAxes plane_axes(const Vec3& normal);

/// atan2(y, x)/2π wrapped to [0, 1): which part of a whole turn leads from (1, 0) to (x, y). 0 or ½ for (0,
/// 0). Given.
Real part_of_turn(Real y, Real x);

/// The sum of the corners' (u, v), each times its weight; the weights add up to 1. With the weights of a
/// point on the triangle, it is right there; with those of its image on the screen, it is the famous mistake.
/// Given.
Vec2 affine_uv(const std::array<Vec2, 3>& uvs, const Vec3& weights);

/// [11.1] The (u, v) of the point of a triangle that is seen at `screen_weights`, the weights of the corners'
/// images on the screen, which are not negative and add up to 1. `depths` are the corners' distances from the
/// eye along the viewing direction, from 1e-100 to 1e100. u/depth, v/depth and 1/depth are linear on the
/// screen (Blinn, Hyperbolic Interpolation, 1992). Within 16ε of the corners' greatest |u| and |v|.
Vec2 perspective_uv(const std::array<Vec2, 3>& uvs, const Vec3& depths, const Vec3& screen_weights);

// A point of each shape. `p` is on the surface but for rounding, in the shape's own space, and `element` is
// the hit's. Never NaN. What depends on the direction in which p lies, as seen from the centre or the axis,
// is as right as that direction: wrong by 16ε(|p| + |the shape's coordinates|)/(the distance from there), as
// an angle. For the rest lengths are within 64ε of their size.

/// [11.1] uv is `sphere_uv` of the direction n from the centre to p: u in [0, 1), v in [0, 1]. A whole u is a
/// turn about the y axis, from x towards z; a whole v half a turn, from the south pole to the north pole. At
/// a pole du is 0, u is one of those that are right there, and dv is that meridian's. A p that is the centre
/// to the bit, as rounding makes it of a tiny ball far away, is taken to be at (0, ½).
TexturePoint texture_point(const Sphere& sphere, const Vec3& p, std::uint32_t element);

/// u and v are distances from plane.point along `plane_axes`, in units of length. Given.
TexturePoint texture_point(const Plane& plane, const Vec3& p, std::uint32_t element);

/// The square around the disc, with sides along `plane_axes`, is [0, 1]². Given.
TexturePoint texture_point(const Disc& disc, const Vec3& p, std::uint32_t element);

/// Each face, 2a at `low` or 2a + 1 at `high` across axis a, shows the whole of [0, 1]², seen from outside,
/// with the `plane_axes` of its outward normal. So u and v run along +z and +y on face 0 (−x), −z and +y on 1
/// (+x), +x and +z on 2 (−y), +x and −z on 3 (+y), −x and +y on 4 (−z), +x and +y on 5 (+z). Given.
TexturePoint texture_point(const Box& box, const Vec3& p, std::uint32_t element);

/// [11.1] The side. v is 0 at the end a and 1 at the end b, and never beyond. u, in [0, 1), is the part of a
/// turn about the axis from the direction of plane_axes(b − a).u, first towards −plane_axes(b − a).v. For an
/// axis along +y these are x and z, as in POV-Ray's cylindrical map. At an apex du is 0, and u is one of
/// those that are right there.
TexturePoint texture_point(const OpenCone& open, const Vec3& p, std::uint32_t element);

/// Element 0 is the side, as of an open cone; 1, at a, and 2, at b, are discs whose normals point outwards. A
/// cap of radius 0 has uv = (½, ½) and no tangents. Given.
TexturePoint texture_point(const Cone& cone, const Vec3& p, std::uint32_t element);

/// As POV-Ray's uv_mapping of a torus with the axis +y: u = ½ − atan2(z, x)/2π around the axis, v = ½ + the
/// angle around the ring, from outside up, as a part of a turn; both wrapped to [0, 1). So (½, ½) is
/// outermost, at +x. For other axes x and z are plane_axes(axis).u and −plane_axes(axis).v. Where the hole is
/// closed to a point, du is 0. Given.
TexturePoint texture_point(const Torus& torus, const Vec3& p, std::uint32_t element);

/// The first vertex is at (0, 0), the second at (1, 0) and the last at (0, 1): so a parallelogram shows the
/// whole picture, and what is stretched or turned takes its picture along. Where the sine of the corner
/// between these three is less than `least_corner` there are no coordinates: uv is (0, 0), without tangents.
/// uv is within 64ε/sine of |p − the first vertex|/(the shorter of the two edges). Given.
TexturePoint texture_point(const Polygon& polygon, const Vec3& p, std::uint32_t element);
inline constexpr Real least_corner = 0x1p-20;

/// uv is that of a ball around the origin of the shape's own space, through p: its longitude and latitude as
/// seen from there, at a pole and at the origin as of a ball. du and dv are the ball's, moved along the
/// radius into the surface, whose normal is the gradient; of `element`s below `surface_face` that of the box.
/// Both are 0 where there is no normal, or the radius runs in the surface: where the sine of the angle
/// between the two is less than `least_corner`. Given.
TexturePoint texture_point(const Implicit& implicit, const Vec3& p, std::uint32_t element);
TexturePoint texture_point(const Quadric& quadric, const Vec3& p, std::uint32_t element);

// Who needs nothing but uv asks these: the same as of `texture_point`, to the bit, without what its tangents
// cost. Of other shapes they cost next to nothing. Given, but for [11.1] the side of a cone.
Vec2 texture_uv(const Sphere& sphere, const Vec3& p, std::uint32_t element);
Vec2 texture_uv(const OpenCone& open, const Vec3& p, std::uint32_t element);
Vec2 texture_uv(const Cone& cone, const Vec3& p, std::uint32_t element);
Vec2 texture_uv(const Torus& torus, const Vec3& p, std::uint32_t element);
Vec2 texture_uv(const Implicit& implicit, const Vec3& p, std::uint32_t element);
Vec2 texture_uv(const Quadric& quadric, const Vec3& p, std::uint32_t element);

/// The point of a triangle with these weights of b and c, as in Hit::uv. du and dv are the two vectors of its
/// plane for which each edge is (its change of u)·du + (its change of v)·dv; both 0 if the corners' uvs lie
/// on one line, exactly, or so nearly that these vectors would be too great for a Real. Given.
TexturePoint texture_point(const Triangle& triangle, const TriangleUvs& uvs, const Vec2& weights);

}  // namespace rt
