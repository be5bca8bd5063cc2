// Walking through a grid along a ray, cell by cell, and asking the shapes on the way.
#pragma once

#include "chapters/09_grids/build.hpp"
#include "common/world/hit.hpp"

#include <optional>
#include <span>
#include <vector>

namespace rt {

/// One cell on the way of a ray.
struct CellVisit {
    Cells cell{0};
    Interval t;  ///< the part of the ray in the cell
};

/// [09.6] The cells along the ray in order, from the first that it is in within `range` and the box
/// (Amanatides & Woo 1987). The boundary number i of an axis is at t₀ + i·Δ, one multiplication and not i
/// additions; the loop ends at the last cell of an axis, so that it takes at most cells.x + cells.y + cells.z
/// steps whatever the numbers. The visits' intervals join without gaps, and the place of the ray in each is
/// in the cell up to the grid's margin.
std::vector<CellVisit> cells_along(const GridShape& shape, const Ray& ray, Interval range);

/// [09.7] Nearest hit with the shapes in (range.min, range.max], or nothing: to the bit (short of
/// underflow, in scenes smaller than about 1e-80) that of asking them all in order, found by asking each
/// shape at most once and only those in the cells up to the hit. `Hit::primitive` is the index into `shapes`;
/// of equal distances the lowest wins. `mailbox` has room for all the shapes or grows; rays that start beyond
/// the grid's reach, or have a coordinate that is not finite, ask all.
std::optional<Hit> closest_hit(const Grid& grid, std::span<const Sphere> shapes, const Ray& ray,
                               Interval range, Mailbox& mailbox);
std::optional<Hit> closest_hit(const Grid& grid, std::span<const Triangle> shapes, const Ray& ray,
                               Interval range, Mailbox& mailbox);
std::optional<Hit> closest_hit(const Grid& grid, std::span<const Polygon> shapes, const Ray& ray,
                               Interval range, Mailbox& mailbox);
std::optional<Hit> closest_hit(const Grid& grid, std::span<const Ellipsoid> shapes, const Ray& ray,
                               Interval range, Mailbox& mailbox);
std::optional<Hit> closest_hit(const Grid& grid, std::span<const Instance> shapes,
                               std::span<const SharedMesh> meshes, const Ray& ray, Interval range,
                               Mailbox& mailbox);

/// [09.8] Whether any shape is hit in the range: stops at the first hit, wherever on the ray it is.
bool any_hit(const Grid& grid, std::span<const Sphere> shapes, const Ray& ray, Interval range,
             Mailbox& mailbox);
bool any_hit(const Grid& grid, std::span<const Triangle> shapes, const Ray& ray, Interval range,
             Mailbox& mailbox);
bool any_hit(const Grid& grid, std::span<const Polygon> shapes, const Ray& ray, Interval range,
             Mailbox& mailbox);
bool any_hit(const Grid& grid, std::span<const Ellipsoid> shapes, const Ray& ray, Interval range,
             Mailbox& mailbox);
bool any_hit(const Grid& grid, std::span<const Instance> shapes, std::span<const SharedMesh> meshes,
             const Ray& ray, Interval range, Mailbox& mailbox);

/// Appends a hit for each shape that is hit in the range, its nearest there, in no particular order. Every
/// shape in the cells along the range is asked, so the range should be short. Given.
void append_hits(const Grid& grid, std::span<const Sphere> shapes, const Ray& ray, Interval range,
                 Mailbox& mailbox, std::vector<Hit>& hits);
void append_hits(const Grid& grid, std::span<const Triangle> shapes, const Ray& ray, Interval range,
                 Mailbox& mailbox, std::vector<Hit>& hits);
void append_hits(const Grid& grid, std::span<const Polygon> shapes, const Ray& ray, Interval range,
                 Mailbox& mailbox, std::vector<Hit>& hits);
void append_hits(const Grid& grid, std::span<const Ellipsoid> shapes, const Ray& ray, Interval range,
                 Mailbox& mailbox, std::vector<Hit>& hits);
void append_hits(const Grid& grid, std::span<const Instance> shapes, std::span<const SharedMesh> meshes,
                 const Ray& ray, Interval range, Mailbox& mailbox, std::vector<Hit>& hits);

/// What a ray asked on its way, for tests and figures.
struct WalkCounts {
    std::uint64_t cells = 0;   ///< cells entered
    std::uint64_t shapes = 0;  ///< shapes asked
};

/// The calling thread's counts so far. Given.
WalkCounts& walk_counts();

}  // namespace rt
