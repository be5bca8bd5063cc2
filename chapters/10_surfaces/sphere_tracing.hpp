// Sphere tracing: how far away the surface is at least, and therefore how long a step may be.
#pragma once

#include "chapters/10_surfaces/implicit.hpp"

namespace rt {

/// A number that the gradient of f exceeds nowhere in the box, so that f changes by no more than that per
/// unit of length; infinity where no bound was found, as of sqrt(x) near 0. Given: the box is cut into 16³
/// parts, and f with its gradient enclosed in each.
Real lipschitz_bound(const Implicit& implicit);

/// [10.14] The first hit in [range.min, range.max] that sphere tracing comes upon (Hart 1996), or nothing.
/// From a point where f has a value, the surface is at least |f|/lipschitz away in every direction, so the
/// ray goes on by that much. It arrives where a step would be no longer than `tolerance`, a length, or would
/// not change λ; it leaves at the end of the chord, or where f has no value. A range that begins below 0
/// begins at 0.
///
/// If `lipschitz`, finite and > 0, is a bound, nothing is stepped over; but where the ray only passes near
/// the surface, there may be a hit that is none: f is within lipschitz·tolerance of 0 there. A ray that
/// begins on the surface hits it where it begins.
std::optional<Hit> sphere_trace(const Implicit& implicit, Real lipschitz, const Ray& ray, Interval range,
                                Real tolerance);

}  // namespace rt
