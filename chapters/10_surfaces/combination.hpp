// Solids made of solids: constructive solid geometry, one line at a time.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/bounds.hpp"
#include "common/world/hit.hpp"
#include "common/world/shapes.hpp"

#include <optional>
#include <span>
#include <vector>

namespace rt {

/// [10.15] Whether a point is inside of two solids as one, given whether it is inside of each: of at least
/// one of them (union), of both (intersection), of the first but not of the second (difference).
bool is_inside(SetOperation operation, bool in_a, bool in_b);

/// [10.15] Where a line crosses the surface of two solids as one, given where it crosses each (Roth 1982).
///
/// All three lists are ascending in t, and alternate: the line enters by the first hit, leaves by the second,
/// and so on. It may enter at −infinity and leave at infinity. Each hit is one of a or b, as it is there.
///
/// What happens at one t happens at once, so that solids that only touch have nothing in common, two
/// that share a face are one without a wall between, and what is thinner than nothing is gone. Of two faces
/// in one place, a's is the one that is met, unless the line only touches a there. A list may have two equal
/// t where the line touches its solid.
std::vector<Hit> combine(SetOperation operation, std::span<const Hit> a, std::span<const Hit> b);

/// Where the line of the ray crosses the combination's surface, as for `combine`. `Hit::element` counts
/// through the elements of all parts. Given.
std::vector<Hit> crossings(const Combination& combination, const Ray& ray);

/// Nearest hit with the combination's surface in (range.min, range.max], or nothing. Given.
std::optional<Hit> intersect(const Combination& combination, const Ray& ray, Interval range);

/// The surface at a hit: the part's, turned inside out where the part is taken away. Given.
Surface surface_at(const Combination& combination, const Ray& ray, const Hit& hit);

/// A box around the combination, wider by more than its rounding. Given.
Bounds bounds_of(const Combination& combination);

}  // namespace rt
