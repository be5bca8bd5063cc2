// Convex solids as what their faces have in common, along one line.
#include "chapters/10_surfaces/span.hpp"

#include "common/math/todo.hpp"

#include <utility>

namespace rt {

std::optional<Span> slab(Real x, Real v, Real low, Real high) {
    // 10.1  Return the part of the line on which low ≤ x + t·v ≤ high, with face 0 at `low` and 1
    // at `high`, or nothing. Mind v = 0.
    return todo("10.1");
}

std::optional<Span> common_part(const Span& a, const Span& b) {
    // 10.1  Return what a and b have in common, with the faces that belong to its two ends, or
    // nothing.
    return todo("10.1");
}

std::optional<Hit> first_hit(const Span& span, Interval range) {
    // 10.1  Return a Hit at the first of the span's two ends that is in the range, with its face as
    // `element`, or nothing.
    return todo("10.1");
}

}  // namespace rt
