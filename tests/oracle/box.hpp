// The exact judge of rays, boxes and cells: CGAL's exact numbers behind a plain header.
// Every input must be finite but the range of a ray; nothing is rounded until an answer is handed out.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/grid.hpp"

#include <optional>
#include <vector>

namespace rt::oracle {

/// The facts about a ray and a closed box, and about what is proposed for the part of the ray inside.
struct ClipTruth {
    bool inside = false;  ///< some t of the closed range has its exact point in the box
    Real near = 0;        ///< the first such t and the last, rounded; where there is none, they are the last
    Real far = 0;         ///< entry into a pair of planes and the first exit, if all pairs are met
    bool lost = false;    ///< some such t is not in what is proposed
    /// How far what is proposed begins before the exact `near` and ends after `far`, whichever is more, in
    /// units of u times the greater of |near| and |far|. Where nothing is inside, how far `near` is after
    /// `far`. 0 where nothing is proposed.
    Real excess = 0;
};

ClipTruth judge_clip(const Bounds& box, const Ray& ray, Interval range, std::optional<Interval> proposed);

/// The cells that the ray is in, exactly.
struct WalkTruth {
    std::vector<Cells> cells;
    /// The least distance between two t at which the ray comes to a boundary or to an end of the part, in
    /// units of the greatest |t| of a boundary; or of a ray along boundaries from one of them, in units of
    /// the greatest coordinate. 0 for a tie.
    Real least_gap = 0;
};

/// The cells along the part of the ray, from boundaries low + i · (high − low)/cells that are not rounded.
/// The ray is in the cell ahead of it where it is on a boundary.
WalkTruth judge_walk(const GridShape& shape, const Ray& ray, Interval part);

/// How far the exact point of the ray at t is outside the cell, along the axis in which it is farthest; 0
/// inside.
Real distance_from_cell(const GridShape& shape, const Cells& cell, const Ray& ray, Real t);

}  // namespace rt::oracle
