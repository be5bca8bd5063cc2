// Convex solids as what their faces have in common, along one line.
#include "chapters/10_surfaces/span.hpp"

#include "common/math/todo.hpp"

#include <utility>

namespace rt {

std::optional<Span> slab(Real x, Real v, Real low, Real high) {
    // 10.1  Return the t between those where x + t·v is `low` and where it is `high`, with the
    // faces 0 for low and 1 for high. Divide only if v is not 0.
    return todo("10.1");
}

std::optional<Span> common_part(const Span& a, const Span& b) {
    // 10.1  Return the span from the later entry to the earlier exit, each with its face, or
    // nothing if it would end before it begins.
    return todo("10.1");
}

std::optional<Hit> first_hit(const Span& span, Interval range) {
    // 10.1  Return a Hit with the first of the span's two ends that is in the range, and with its
    // face as `element`; or nothing.
    return todo("10.1");
}

}  // namespace rt
