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
    // 10.14  Walk along the part of the chord that is in the range and ahead, each step as long as
    // is safe, and return a Hit where you arrive; or nothing.
    return todo("10.14");
}

}  // namespace rt
