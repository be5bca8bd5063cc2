// Rays, and the interval of a ray in which hits count.
#pragma once

#include "common/math/vec.hpp"

namespace rt {

/// Half-line of points `origin + t * direction`, t > 0.
///
/// `direction` need not be a unit vector; every t in the course is in units of |direction|. Its length is
/// from 1e-30 to 1e30: 1 where a ray goes through a scene, and compiled transforms stretch and shrink it no
/// more than that. Much shorter and longer ones may be answered wrongly, because squares leave the range of
/// Real.
/// `time` is the instant in the shutter interval [0, 1]; static scenes leave it 0.
struct Ray {
    Vec3 origin{0};
    Vec3 direction{0, 0, -1};
    Real time = 0;
};

/// Point on the ray at parameter `t`, in the space of the ray.
inline Vec3 point_at(const Ray& ray, Real t) { return ray.origin + t * ray.direction; }

/// The part (min, max] of a ray: min excluded, max included.
///
/// Including the end lets a hit at exactly the nearest distance so far be reported, so that the
/// order in the file, and not the order of testing, decides between equal distances.
struct Interval {
    Real min = 0;
    Real max = infinity;
};

/// Whether t lies in the interval; false for NaN.
constexpr bool contains(Interval range, Real t) { return range.min < t && t <= range.max; }

}  // namespace rt
