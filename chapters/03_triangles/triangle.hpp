// Triangles: barycentric coordinates, the watertight test, smooth normals.
#pragma once

#include "common/scene/hit.hpp"
#include "common/scene/shapes.hpp"
#include "common/scene/world.hpp"

#include <optional>
#include <span>

namespace rt {

/// The unit vector in the direction of `v`, whatever its length (1e-300 and 1e300 too); zero for zero. Given.
Vec3 unit_vector(const Vec3& v);

/// [03.3] The unit normal, (b − a) × (c − a) normalised: corners in counterclockwise order are seen from the
/// side it points to. Edges of any length: they are made unit vectors before they are multiplied. Zero for a
/// triangle without area, which is one where the sine of the angle at a is at most 8u: rounding leaves that
/// much of parallel edges.
Vec3 unit_normal(const Triangle& triangle);

/// [03.3] Weights (a, b, c) with a + b + c = 1 that make `point`, a point of the triangle's plane, the
/// weighted sum of the corners. The point is inside where no weight is negative. Nothing for a triangle
/// without area.
std::optional<Vec3> barycentric(const Triangle& triangle, const Vec3& point);

/// [03.4] Twice the signed area of the triangle (0, p, q): p.x·q.y − p.y·q.x, positive where the turn from p
/// to q is counterclockwise. The sign is exact and the relative error at most 3u, also where the products
/// nearly cancel (short of underflow; Dekker 1971), and edge_function(q, p) = −edge_function(p, q) to the
/// bit.
Real edge_function(const Vec2& p, const Vec2& q);

/// All that the watertight test needs of a ray.
struct ShearedRay {
    Vec3 origin{0};
    /// Renames the coordinates, so that the direction's greatest one becomes z, and shears the others so that
    /// the direction's x and y become 0: to this map the ray is the z axis.
    Mat3 to_z_axis{1};
    Real direction_z = 1;  ///< the direction's greatest coordinate, with its sign
};

/// [03.4] The ray for the watertight test: worked out once a ray, not once a triangle.
ShearedRay shear(const Ray& ray);

/// [03.4] Hit of the ray with the triangle in (range.min, range.max], or nothing; both sides count.
///
/// Watertight: a ray that passes between two triangles that share an edge hits at least one of them
/// (Woop, Benthin & Wald 2013). A point on an edge or corner is hit; a triangle seen edge-on, or without
/// area (`unit_normal` zero), is missed. `Hit::uv` are the weights of b and c. `t` is in units of
/// |ray.direction|.
std::optional<Hit> intersect(const Triangle& triangle, const ShearedRay& ray, Interval range);

/// The same for a ray that is not sheared yet. Given.
std::optional<Hit> intersect(const Triangle& triangle, const Ray& ray, Interval range);

/// [03.5] The surface at a hit of a flat triangle: the point as weighted sum of the corners, the unit
/// normal (b − a) × (c − a) normalised; uv = Hit::uv.
Surface surface_at(const Triangle& triangle, const Ray& ray, const Hit& hit);

/// [03.5] The unit normal interpolated at the weights `uv` of the corners b and c. The normals at the corners
/// are weighed as they are: who compiles a scene makes those of the file unit vectors, once. `flat` where the
/// sum vanishes.
Vec3 interpolate(const TriangleNormals& normals, const Vec2& uv, const Vec3& flat);

/// [03.5] The texture coordinates interpolated at the weights `uv` of the corners b and c.
Vec2 interpolate(const TriangleUvs& uvs, const Vec2& uv);

/// [03.6] Nearest of the hits with all the triangles, or nothing: to the bit what `intersect` says of each.
/// What depends only on the ray is computed once. `Hit::primitive` is the triangle's index; of equal
/// distances the lowest index wins.
std::optional<Hit> closest_hit(std::span<const Triangle> triangles, const Ray& ray, Interval range);

/// [03.6] Whether any triangle is hit in the range; stops at the first.
bool any_hit(std::span<const Triangle> triangles, const Ray& ray, Interval range);

}  // namespace rt
