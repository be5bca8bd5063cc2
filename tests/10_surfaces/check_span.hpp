// What the tests of convex solids share: a line's part inside, and how the question is written.
#pragma once

#include "chapters/10_surfaces/span.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <optional>
#include <string>

namespace rt::test {

template <class Shape>
std::string describe(const Shape& shape, const Ray& ray) {
    return show(shape) + "\n" + show(ray);
}

/// Checks both ends, each within its bound, and their faces.
inline void check_span(const std::optional<Span>& actual, const Span& expected, Real enter_bound,
                       Real leave_bound) {
    INFO("expected " << expected);
    INFO("actual   " << actual);
    REQUIRE(actual.has_value());
    CHECK(near(actual->enter, expected.enter, enter_bound));
    CHECK(near(actual->leave, expected.leave, leave_bound));
    CHECK(actual->enter_face == expected.enter_face);
    CHECK(actual->leave_face == expected.leave_face);
}

/// The same, within 4u of each end: slabs round them twice.
inline void check_span(const std::optional<Span>& actual, const Span& expected) {
    check_span(actual, expected, gamma(4) * std::abs(expected.enter), gamma(4) * std::abs(expected.leave));
}

inline void check_no_span(const std::optional<Span>& actual) {
    INFO("expected nothing, actual " << actual);
    CHECK_FALSE(actual.has_value());
}

}  // namespace rt::test
