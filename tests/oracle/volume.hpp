// The exact judge of rays and bounding volumes: CGAL's exact numbers behind a plain header.
// Every input must be finite but the range of a ray; nothing is rounded.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/bounding_volumes.hpp"

#include <optional>

namespace rt::oracle {

/// The facts about a ray and a volume, and about what is proposed for the part of the ray inside.
struct PartTruth {
    bool inside = false;    ///< some t of the closed range has its exact point in the volume
    bool lost = false;      ///< some such t is not in what is proposed
    bool too_much = false;  ///< an end of what is proposed has its exact point outside of the larger volume
};

PartTruth judge_part(const BoundingSphere& sphere, const BoundingSphere& larger, const Ray& ray,
                     Interval range, std::optional<Interval> proposed);
PartTruth judge_part(const OrientedBox& box, const OrientedBox& larger, const Ray& ray, Interval range,
                     std::optional<Interval> proposed);
PartTruth judge_part(const BoundingEllipsoid& ellipsoid, const BoundingEllipsoid& larger, const Ray& ray,
                     Interval range, std::optional<Interval> proposed);

}  // namespace rt::oracle
