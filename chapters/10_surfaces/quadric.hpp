// Quadrics in a box: given. Ellipsoids, paraboloids, hyperboloids, cones and cylinders of any section.
// ε is the unit roundoff of `Real`.
#pragma once

#include "chapters/10_surfaces/chord.hpp"
#include "common/scene/shapes.hpp"
#include "common/world/bounds.hpp"

#include <vector>

namespace rt {

/// Nearest hit with the quadric in (range.min, range.max], within the box, or nothing; a range that begins
/// below 0 begins at 0. `Hit::element` is `surface_face`, 6.
///
/// The answer is the exact one of a line moved by 4ε·(|origin| + the box's greatest coordinate), and of a
/// quadric each of whose coefficients is moved by 96ε of itself. The equation is set up in the chord, not at
/// the eye; its discriminant is −a times the value at the point where the line is nearest to the surface, or
/// deepest inside, because h² − a·c would lose what is small beside the chord.
std::optional<Hit> intersect(const Quadric& quadric, const Ray& ray, Interval range);

/// The parts of the line where the polynomial is ≤ 0 in the box, in order: one or two. Faces as of an
/// Implicit.
std::vector<Span> inside(const Quadric& quadric, const Ray& ray);

/// The surface at a hit: the point, moved onto the surface; the unit normal along the gradient, to where the
/// polynomial increases. At the tip of a cone, where there is none, it is against the ray.
Surface surface_at(const Quadric& quadric, const Ray& ray, const Hit& hit);

/// The box.
Bounds bounds_of(const Quadric& quadric);

}  // namespace rt
