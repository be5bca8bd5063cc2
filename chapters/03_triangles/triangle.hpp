// Triangles: barycentric coordinates, the watertight test, smooth normals.
// u is the unit roundoff of `Real`.
#pragma once

#include "common/scene/shapes.hpp"
#include "common/world/hit.hpp"
#include "common/world/search.hpp"
#include "common/world/world.hpp"

#include <optional>
#include <span>

namespace rt {

/// The unit vector in the direction of `v`, whatever its length (1e-300 and 1e300 too); zero for zero. Given.
Vec3 unit_vector(const Vec3& v);

/// [03.3] The unit normal, (b − a) × (c − a) normalised: corners in counterclockwise order are seen from the
/// side it points to. Edges of any length; within 128u of the exact direction for any shape, needles and
/// slivers too, and whichever corner comes first. Zero for a triangle without area, which is one whose
/// corners lie exactly on one line.
Vec3 unit_normal(const Triangle& triangle);

/// [03.3] Weights (a, b, c) with a + b + c = 1 that make `point`, a point of the triangle's plane, the
/// weighted sum of the corners. The point is inside where no weight is negative. Nothing for a triangle
/// without area.
std::optional<Vec3> barycentric(const Triangle& triangle, const Vec3& point);

/// All that the watertight test needs of a ray.
struct ShearedRay {
    Ray ray;
    int x = 0, y = 1, z = 2;  ///< the axes, renamed in cyclic order so that the direction's greatest one is z
    Vec2 slope = Vec2(0);     ///< the direction's x and y over its z: how fast it drifts aside; at most 1
};

/// [03.4] The ray for the watertight test: worked out once a ray, not once a triangle.
ShearedRay shear(const Ray& ray);

/// What a search among triangles works out once a ray. Given.
inline ShearedRay prepared(ShapeTag<Triangle>, const Ray& ray) { return shear(ray); }

/// [03.4] The point as the ray sees it: measured from the ray's origin, its coordinates renamed, and sheared
/// so that the ray itself is the z axis: (x − slope.x·z, y − slope.y·z, z).
Vec3 seen(const ShearedRay& ray, const Vec3& point);

/// [03.5] Twice the signed area of the triangle (0, p, q): p.x·q.y − p.y·q.x, positive where the turn from p
/// to q is counterclockwise. The sign is exact and the relative error at most 3u, also where the products
/// nearly cancel (short of underflow; Jeannerod 2016), and edge_function(q, p) = −edge_function(p, q) to the
/// bit.
Real edge_function(const Vec2& p, const Vec2& q);

/// [03.6] The hit with a triangle whose corners the ray sees at a, b and c, if it lies in (range.min,
/// range.max]. The ray is known to pass through the triangle and sees it from one of its sides: the edge
/// functions of (c, b), (a, c) and (b, a) have the same sign, or are zero, but not all. Over their sum they
/// are the weights of the corners; `Hit::uv` are those of b and c. `t` is the weighted mean of the corners'
/// z, in units of |ray.direction|.
std::optional<Hit> hit_of_seen(const ShearedRay& ray, const Vec3& a, const Vec3& b, const Vec3& c,
                               Interval range);

/// [03.7] Hit of the ray with the triangle in (range.min, range.max], or nothing; both sides count.
///
/// Whether the ray's line passes through the triangle is decided exactly, on the numbers as they are given,
/// by the signs of the three volumes that the direction spans with the edges: a filter (Woop, Benthin & Wald
/// 2013, with an error bound) and, where it cannot tell, exact arithmetic. So edges and corners are hit,
/// triangles that share an edge leave no gap, and the order of the corners changes nothing. A triangle seen
/// edge-on, or without area (`unit_normal` zero), is missed. `Hit::uv` are the weights of b and c. `t` is in
/// units of |ray.direction|; for its error see tests/stability/triangles.hpp.
std::optional<Hit> intersect(const Triangle& triangle, const ShearedRay& ray, Interval range);

/// The hit by exact arithmetic alone, as slow as it is sure: a microsecond or two. Given.
std::optional<Hit> intersect_exactly(const Triangle& triangle, const Ray& ray, Interval range);

/// The same for a ray that is not sheared yet. Given.
std::optional<Hit> intersect(const Triangle& triangle, const Ray& ray, Interval range);

/// [03.8] The surface at a hit of a flat triangle: the point as weighted sum of the corners, the unit
/// normal (b − a) × (c − a) normalised; uv = Hit::uv.
Surface surface_at(const Triangle& triangle, const Ray& ray, const Hit& hit);

/// [03.8] The unit normal interpolated at the weights `uv` of the corners b and c. The normals at the corners
/// are weighed as they are: who compiles a scene makes those of the file unit vectors, once. `flat` where the
/// sum vanishes.
Vec3 interpolate(const TriangleNormals& normals, const Vec2& uv, const Vec3& flat);

/// [03.8] The texture coordinates interpolated at the weights `uv` of the corners b and c.
Vec2 interpolate(const TriangleUvs& uvs, const Vec2& uv);

/// [03.9] Nearest of the hits with all the triangles, or nothing: to the bit what `intersect` says of each.
/// What depends only on the ray is computed once. `Hit::primitive` is the triangle's index; of equal
/// distances the lowest index wins.
std::optional<Hit> closest_hit(std::span<const Triangle> triangles, const Ray& ray, Interval range);

/// [03.9] Whether any triangle is hit in the range; stops at the first.
bool any_hit(std::span<const Triangle> triangles, const Ray& ray, Interval range);

/// [03.11] The solid angle of the triangle seen from a point that does not lie on it: the area of its shadow
/// on the unit sphere around the point, at most 2π (Van Oosterom & Strackee 1983). Positive where the point
/// is behind the triangle, so that it sees the corners go round clockwise, negative in front of it. In
/// triangles of any size; right to some roundings of 2π, and of the corners as the point sees them.
Real solid_angle(const Triangle& triangle, const Vec3& from);

/// [03.11] How often the triangles go round the point: the sum of their solid angles over 4π (Jacobson, Kavan
/// & Sorkine-Hornung 2013). Of a closed mesh whose fronts look outward it is 1 inside and 0 outside; of one
/// with holes something between.
Real winding_number(std::span<const Triangle> triangles, const Vec3& point);

}  // namespace rt
