// Intersections in interval arithmetic: CGAL's Interval_nt behind a plain header.
// An interval holds the exact value whatever was rounded on the way; where it can't decide, it says so.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"

namespace rt::oracle {

enum class Decision { Miss, Hit, Unknown };

/// What is certain of a hit.
struct Enclosure {
    Decision decision = Decision::Miss;
    Real low = 0, high = 0;  ///< where it is not a miss, the exact t lies between; may be infinite
};

/// The smaller root of the line of the ray with the sphere, by the formulas of chapter 2.
Enclosure enclose_sphere(const Sphere& sphere, const Ray& ray);

/// Where the line of the ray meets the triangle, by signed volumes.
Enclosure enclose_triangle(const Triangle& triangle, const Ray& ray);

}  // namespace rt::oracle
