// Sphere tracing: how far away the surface is at least, and therefore how long a step may be.
#include "chapters/10_surfaces/sphere_tracing.hpp"

#include "common/scene/evaluate.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Real lipschitz_bound(const Implicit& implicit) {
    return lipschitz_bound(*implicit.f, implicit.box.low, implicit.box.high);
}

std::optional<Hit> sphere_trace(const Implicit& implicit, Real lipschitz, const Ray& ray, Interval range,
                                Real tolerance) {
    // [exercise 10.14] Walk along the part of the chord that is in the range and ahead, each step as long as
    // is safe, and return a Hit where you arrive; or nothing.
    const std::optional<Chord> part = chord(implicit.box, ray, {std::max(range.min, Real(0)), range.max});
    if (!part) return std::nullopt;
    const Real far = length(part->way);
    Real lambda = 0;
    while (lambda <= 1) {
        const Real distance = std::abs(value_at(*implicit.f, part->at(lambda))) / lipschitz;
        const Real next = lambda + distance / far;
        if (distance <= tolerance || next == lambda)
            return Hit{.t = part->t_at(lambda), .element = surface_face};
        lambda = next;
    }
    return std::nullopt;
    // [/exercise]
}

}  // namespace rt
