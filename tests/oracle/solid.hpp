// The exact judge of lines, discs and cones: CGAL's exact numbers behind a plain header.
// Every input must be finite but the part of a line; nothing is rounded until an answer is handed out.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"

namespace rt::oracle {

/// How far the surface of a solid is moved outward (inward where negative) before it is asked about: `across`
/// its axis and `along` it.
struct Growth {
    Real across = 0, along = 0;
};

/// Whether some point of the line with part.min ≤ t ≤ part.max is in the solid, which is closed. Both ends
/// may be infinite. What has shrunk to nothing is not met.
bool meets(const Cone& cone, const Ray& ray, Interval part, Growth growth = {});

/// Where the line crosses the plane of a disc.
struct DiscTruth {
    bool crosses = false;  ///< it is not parallel to the plane
    Real t = 0;            ///< there, rounded
    Real error = 0;        ///< `proposed` minus the exact t, rounded
    Real distance = 0;     ///< of that point from the centre, rounded
    Real slope = 0;        ///< what the line gains along the normal with each t, rounded
};

DiscTruth judge_disc(const Disc& disc, const Ray& ray, Real proposed);

}  // namespace rt::oracle
