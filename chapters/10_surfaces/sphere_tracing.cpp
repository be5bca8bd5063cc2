// Sphere tracing: how far away the surface is at least, and therefore how long a step may be.
#include "chapters/10_surfaces/sphere_tracing.hpp"

#include "common/math/todo.hpp"
#include "common/scene/evaluate.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Real lipschitz_bound(const Implicit& implicit) {
    return lipschitz_bound(*implicit.f, implicit.box.low, implicit.box.high);
}

std::optional<Hit> sphere_trace(const Implicit& implicit, Real lipschitz, const Ray& ray, Interval range,
                                Real tolerance) {
    // 10.10  Take the chord of the part of the range that is ahead. At λ = 0 begin to walk: |f|
    // there, over lipschitz, is how far the surface is away at least; divided by the length of `way`, it is a
    // step of λ. If that is no longer than the tolerance, or if adding it to λ changes nothing, you have
    // arrived: return a Hit with the chord's t at λ. Beyond λ = 1 there is nothing.
    return todo("10.10");
}

}  // namespace rt
