// The box along the axes: three slabs.
// ε is the unit roundoff of `Real`.
#pragma once

#include "chapters/10_surfaces/span.hpp"
#include "common/scene/shapes.hpp"
#include "common/world/bounds.hpp"

namespace rt {

/// [10.2] The part of the ray's line that is inside the box, or nothing (Kay & Kajiya 1986). The faces across
/// axis a (0, 1, 2 for x, y, z) are 2a, at `low`, and 2a + 1, at `high`. Where the line enters or leaves by
/// several faces at once, the one of the first axis.
///
/// The box is closed: a line in a face, along an edge or through a corner meets it, but rounding decides
/// where an entry and an exit differ by less than 4ε of themselves. Boxes that share a face leave no gap.
std::optional<Span> inside(const Box& box, const Ray& ray);

/// Nearest hit with the box's surface in (range.min, range.max], or nothing. `Hit::element` is the face.
/// Given.
std::optional<Hit> intersect(const Box& box, const Ray& ray, Interval range);

/// [10.2] The surface at a hit: the point, moved onto its face, and the face's outward unit normal. The error
/// is 0: the point is on the face to the bit, and so a ray that leaves it cannot meet the face again.
Surface surface_at(const Box& box, const Ray& ray, const Hit& hit);

/// The box itself. Given.
Bounds bounds_of(const Box& box);

}  // namespace rt
