// Convex solids as what their faces have in common, along one line.
#include "chapters/10_surfaces/span.hpp"

#include <utility>

namespace rt {

std::optional<Span> slab(Real x, Real v, Real low, Real high) {
    // [exercise 10.1] Return the part of the line on which low ≤ x + t·v ≤ high, with face 0 at `low` and 1
    // at `high`, or nothing. Mind v = 0.
    if (v == 0) return low <= x && x <= high ? std::optional(Span{}) : std::nullopt;
    const Span up{(low - x) / v, (high - x) / v, 0, 1};
    return v > 0 ? up : Span{up.leave, up.enter, 1, 0};
    // [/exercise]
}

std::optional<Span> common_part(const Span& a, const Span& b) {
    // [exercise 10.1] Return what a and b have in common, with the faces that belong to its two ends, or
    // nothing.
    Span both = a;
    if (b.enter > a.enter) both.enter = b.enter, both.enter_face = b.enter_face;
    if (b.leave < a.leave) both.leave = b.leave, both.leave_face = b.leave_face;
    return both.enter <= both.leave ? std::optional(both) : std::nullopt;
    // [/exercise]
}

std::optional<Hit> first_hit(const Span& span, Interval range) {
    // [exercise 10.1] Return a Hit at the first of the span's two ends that is in the range, with its face as
    // `element`, or nothing.
    if (contains(range, span.enter)) return Hit{.t = span.enter, .element = span.enter_face};
    if (contains(range, span.leave)) return Hit{.t = span.leave, .element = span.leave_face};
    return std::nullopt;
    // [/exercise]
}

}  // namespace rt
