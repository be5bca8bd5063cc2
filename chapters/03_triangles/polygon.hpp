// Planar polygons: hit the plane, then look inside.
// u is the unit roundoff of `Real`.
#pragma once

#include "common/scene/shapes.hpp"
#include "common/world/hit.hpp"

#include <optional>
#include <span>

namespace rt {

/// [03.1] The plane through a polygon's first vertex, its normal by Newell's method (Sutherland, Sproull &
/// Schumacker 1974): not a unit vector, its length is twice the area; counterclockwise vertices are seen
/// from the side it points to. Zero for a polygon without area.
Plane supporting_plane(std::span<const Vec3> vertices);

/// [03.2] The axis (0, 1, 2 for x, y, z) along which a polygon with this normal has the largest shadow:
/// that of the greatest |component|, the first of equal ones.
int dominant_axis(const Vec3& normal);

/// [03.2] The point without its coordinate `axis`; the two that remain, in cyclic order
/// (axis x leaves (y, z), y leaves (z, x), z leaves (x, y)).
Vec2 project(const Vec3& point, int axis);

/// [03.2] Whether the point is inside the polygon by the even-odd rule, crossings counted along +x
/// (Shimrat 1962; each edge owns its lower end, so that a vertex is never counted twice). Polygons that
/// share an edge and lie on its two sides never both contain a point, nor both leave it out.
bool point_in_polygon(std::span<const Vec2> polygon, const Vec2& point);

/// The supporting plane; where the polygon is so thin that rounding might have tilted it, the normal is that
/// of exact arithmetic, and as long as it happens to be. Zero for a polygon without area, exactly. Given.
Plane plane_of(std::span<const Vec3> vertices);

/// Where the ray meets that plane, in (range.min, range.max]; nothing where it is parallel to it, or the
/// polygon has no area. The t of a ray that grazes vertices beside their plane is moved into the box around
/// them. Given.
std::optional<Hit> hit_plane(const Polygon& polygon, const Ray& ray, Interval range);

/// Whether rounding may decide if (0, 0) is inside the outline: where a corner is not surely higher or lower,
/// or an edge not surely to the left or right. `size` bounds the coordinates, which are off by less than 8u ·
/// size. Given.
bool is_close(std::span<const Vec2> outline, Real size);

/// [03.10] Hit of the ray with the polygon in (range.min, range.max], or nothing. Both sides count; a polygon
/// without area is missed.
///
/// `t` is that of `hit_plane`. Whether the ray passes inside is decided exactly, by the even-odd rule, on
/// what the ray sees of the vertices as they are given: polygons that share an edge, and are seen on its two
/// sides, are never both hit there, nor both missed.
std::optional<Hit> intersect(const Polygon& polygon, const Ray& ray, Interval range);

/// The surface at a hit; both normals are that of the plane. Given.
Surface surface_at(const Polygon& polygon, const Ray& ray, const Hit& hit);

}  // namespace rt
