// Families of extreme cases for chapter 3, and their judges.
// A family makes any number of cases from a seed; answers are collected first and judged together.
//
// The condition number of the parameter t where a ray meets a triangle with normal n is
//     κ = (max |corner − origin| + |t||d|)·|n| / (|t||n·d|):
// moving the corners by ε times their distance from the origin, and d by a relative ε, moves t by at most
// κ·ε·|t|. Demands: whether the line of the ray passes through the triangle is decided as exact arithmetic
// does on the given numbers, edges and corners included; |Δt| ≤ 8κu|t|; no triangle without area is hit.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"
#include "common/world/hit.hpp"
#include "tests/stability/verdict.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rt::stability {

// --------------------------------------------------------------------------------- single triangles

struct TriangleCase {
    Triangle triangle;
    Ray ray;
};

struct TriangleFamily {
    const char* name;
    const char* condition;  ///< what κ is like here
    std::vector<TriangleCase> (*make)(std::size_t count, std::uint64_t seed);
    bool at_edges = false;  ///< whether the rays pass exactly through edges and corners
};

/// One of the families: two corners close together, every order of the corners in turn.
std::vector<TriangleCase> needles(std::size_t count, std::uint64_t seed);

/// All the families; any prefix of a family's cases is the same for every count.
std::span<const TriangleFamily> triangle_families();

/// Judges the hit for the range (0, infinity] (`intersect`): t and both weights.
Verdict judge(std::span<const TriangleCase> cases, std::span<const std::optional<Hit>> answers);

// --------------------------------------------------------------------------- surfaces without holes

/// Some triangles that form a surface, one after the other in a list of cases, all with the same ray. Where
/// the ray passes through a shared edge or corner, one, some or all of the triangles there may be hit;
/// merged, they count as one crossing.
struct Bundle {
    std::size_t first = 0;  ///< index of the first case
    std::size_t count = 0;  ///< how many
    bool odd = false;       ///< whether the merged crossings are odd in number; there is at least one anyway
};

struct Bundles {
    std::vector<TriangleCase> cases;
    std::vector<Bundle> bundles;
};

struct SurfaceFamily {
    const char* name;
    std::size_t triangles;  ///< cases a ray
    Bundles (*make)(std::size_t rays, std::uint64_t seed);
};

/// Closed convex meshes and fans, with rays aimed exactly at edges and corners, and an ulp beside them. The
/// truth is known by construction.
std::span<const SurfaceFamily> surface_families();

/// Judges the hits of all cases of all bundles: at least one hit a bundle, and odd or even as it has to be
/// after hits of triangles that share a corner, face the same way and lie at the same t (within 8κu|t|) are
/// merged. Verdict::cases counts rays.
Verdict judge(const Bundles& bundles, std::span<const std::optional<Hit>> answers);

// ----------------------------------------------------------------------------------------- tiles of polygons

/// Polygons that share edges and cover a piece of a plane, up to the rounding of their corners, and a ray at
/// a shared edge or corner.
struct TilesCase {
    std::vector<Polygon> tiles;
    Ray ray;
};

std::vector<TilesCase> tiles_cases(std::size_t count, std::uint64_t seed);

/// How many of the tiles the ray hits, by some intersection with a polygon.
std::size_t tiles_hit(const TilesCase& item,
                      std::optional<Hit> (*intersect)(const Polygon&, const Ray&, Interval));

/// Judges how many of the tiles are hit: exactly one.
Verdict judge(std::span<const TilesCase> cases, std::span<const std::size_t> answers);

// ------------------------------------------------------------------------------------------------ normals

/// Judges unit normals of the families' triangles: within 128u of the exact direction, and zero exactly where
/// there is no area.
Verdict judge_normals(std::span<const TriangleCase> cases, std::span<const Vec3> answers);

// -------------------------------------------------------------------------- weights, signs, polygons

/// A point of a triangle's plane with known weights.
struct WeightCase {
    Triangle triangle;
    Vec3 point;
    Vec3 weights;
};

/// Triangles on a grid so fine that points with weights in sixteenths are exact; slivers of aspect up to
/// 2^27. κ, that of a weight, is the longest edge over the lowest height.
std::vector<WeightCase> weight_cases(std::size_t count, std::uint64_t seed);

/// Ways to compute weights. From areas they are right to 8κu. Dot products (Ericson 2005) square what
/// rounding amplifies: 8κ²u, and where that is 1 or more, anything may come out, "no area" too.
enum class WeightsFrom { Areas, DotProducts };

/// Judges barycentric coordinates: every weight is as right as those of the method are.
Verdict judge(std::span<const WeightCase> cases, std::span<const std::optional<Vec3>> answers,
              WeightsFrom method = WeightsFrom::Areas);

/// Vectors nearly along the same line, or exactly.
struct TurnCase {
    Vec2 p, q;
};
std::vector<TurnCase> turn_cases(std::size_t count, std::uint64_t seed);

/// Judges p.x·q.y − p.y·q.x: the sign is exact.
Verdict judge(std::span<const TurnCase> cases, std::span<const Real> answers);

/// A polygon cut in two by a straight line between two of its corners, and a point; often on an edge or
/// corner.
struct OutlineCase {
    std::vector<Vec2> whole, left, right;
    Vec2 point;
};
struct OutlineAnswer {
    bool whole = false, left = false, right = false;
};
std::vector<OutlineCase> outline_cases(std::size_t count, std::uint64_t seed);

/// Judges a point-in-polygon test: exact off the boundary (coordinates are so short that nothing rounds, half
/// of the time; else 4 ulp of the size beside it are not judged), and the point is in exactly as many of the
/// two parts, modulo 2, as it is in the whole.
Verdict judge(std::span<const OutlineCase> cases, std::span<const OutlineAnswer> answers);

}  // namespace rt::stability
