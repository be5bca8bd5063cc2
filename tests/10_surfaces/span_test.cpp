// Step 10.1: where a line is between two planes, and what several such parts have in common.
#include "chapters/10_surfaces/span.hpp"
#include "tests/10_surfaces/check_span.hpp"

using namespace rt;
using test::cases;
using test::check_no_span;
using test::check_span;
using test::Random;

namespace {

void check_everywhere(const std::optional<Span>& actual) {
    INFO("expected the whole line, actual " << actual);
    REQUIRE(actual.has_value());
    CHECK(actual->enter == -infinity);
    CHECK(actual->leave == infinity);
}

}  // namespace

// ----------------------------------------------------------------------------------------------- slab

TEST_CASE("the worked example: between the planes of x from 1 to 2, of y from 0.5 to 1.5", "[10.1]") {
    // The ray from (−1, −1) along (2, 1), and the box from (1, −½) to (3, ½).
    const std::optional<Span> x = slab(-1, 2, 1, 3), y = slab(-1, 1, -0.5, 0.5);
    check_span(x, {1, 2, 0, 1});
    check_span(y, {0.5, 1.5, 0, 1});
    check_span(common_part(*x, *y), {1, 1.5, 0, 1});
}

TEST_CASE("a line that climbs by 2 from -1 is between 0 and 3 from t = 0.5 to 2", "[10.1]") {
    check_span(slab(-1, 2, 0, 3), {0.5, 2, 0, 1});
}

TEST_CASE("a line that goes down enters by the high plane and leaves by the low one", "[10.1]") {
    check_span(slab(5, -2, 1, 3), {1, 2, 1, 0});
}

TEST_CASE("a line that starts between the planes has entered before t = 0", "[10.1]") {
    check_span(slab(2, 1, 0, 3), {-2, 1, 0, 1});
    check_span(slab(2, -0.5, 0, 3), {-2, 4, 1, 0});
}

TEST_CASE("a line along the planes is between them everywhere or nowhere", "[10.1]") {
    for (const Real v : {0.0, -0.0}) {
        INFO("v = " << v);
        check_everywhere(slab(2, v, 1, 3));
        check_no_span(slab(0.5, v, 1, 3));
        check_no_span(slab(3.5, v, 1, 3));
    }
}

TEST_CASE("a line in one of the planes counts as between them", "[10.1]") {
    for (const Real v : {0.0, -0.0}) {
        INFO("v = " << v);
        check_everywhere(slab(1, v, 1, 3));
        check_everywhere(slab(3, v, 1, 3));
    }
}

TEST_CASE("slabs that share a plane share an end to the bit", "[10.1]") {
    Random random(10101);
    for (int i = 0; i < cases(20000); ++i) {
        const Real x = random.uniform(-10, 10), v = random.sign() * random.magnitude(-3, 3);
        const Real middle = random.uniform(-10, 10), low = middle - 1, high = middle + 2;
        const auto below = slab(x, v, low, middle), above = slab(x, v, middle, high);
        INFO("x = " << x << ", v = " << v << ", planes at " << low << ", " << middle << " and " << high);
        INFO("below: " << below << "\nabove: " << above);
        REQUIRE(below.has_value());
        REQUIRE(above.has_value());
        const auto& first = v > 0 ? below : above;
        const auto& second = v > 0 ? above : below;
        CHECK(first->leave == second->enter);
        CHECK(first->enter <= first->leave);
    }
}

// ---------------------------------------------------------------------------------------- common_part

TEST_CASE("two spans have in common what is from the later entry to the earlier exit", "[10.1]") {
    check_span(common_part({1, 4, 10, 11}, {2, 7, 20, 21}), {2, 4, 20, 11});
    check_span(common_part({2, 7, 20, 21}, {1, 4, 10, 11}), {2, 4, 20, 11});
    check_span(common_part({1, 9, 10, 11}, {2, 3, 20, 21}), {2, 3, 20, 21});
    check_span(common_part({2, 3, 20, 21}, {1, 9, 10, 11}), {2, 3, 20, 21});
}

TEST_CASE("spans that are apart have nothing in common", "[10.1]") {
    check_no_span(common_part({1, 2, 0, 0}, {3, 4, 0, 0}));
    check_no_span(common_part({3, 4, 0, 0}, {1, 2, 0, 0}));
}

TEST_CASE("spans that touch have a point in common", "[10.1]") {
    check_span(common_part({1, 2, 10, 11}, {2, 4, 20, 21}), {2, 2, 20, 11});
}

TEST_CASE("the whole line changes nothing", "[10.1]") {
    check_span(common_part({}, {1, 2, 10, 11}), {1, 2, 10, 11});
    check_span(common_part({1, 2, 10, 11}, {}), {1, 2, 10, 11});
    check_everywhere(common_part({}, {}));
}

TEST_CASE("of equal ends the first span's face stays", "[10.1]") {
    check_span(common_part({1, 2, 10, 11}, {1, 2, 20, 21}), {1, 2, 10, 11});
    check_span(common_part({1, 2, 10, 11}, {1, 3, 20, 21}), {1, 2, 10, 11});
    check_span(common_part({1, 3, 10, 11}, {1, 2, 20, 21}), {1, 2, 10, 21});
}

// ------------------------------------------------------------------------------------------- first_hit

namespace {

void check_first(const Span& span, Interval range, std::optional<Real> t, std::uint32_t face) {
    const std::optional<Hit> hit = first_hit(span, range);
    INFO(span << ", range " << range << "; expected " << (t ? "t = " + test::show(*t) : "nothing")
              << ", actual " << hit);
    REQUIRE(hit.has_value() == t.has_value());
    if (!t) return;
    CHECK(hit->t == *t);
    CHECK(hit->element == face);
}

}  // namespace

TEST_CASE("from outside the entry is hit, from inside the exit", "[10.1]") {
    check_first({2, 5, 7, 8}, {0, infinity}, 2.0, 7);
    check_first({-2, 5, 7, 8}, {0, infinity}, 5.0, 8);
}

TEST_CASE("a solid behind the ray is missed", "[10.1]") { check_first({-5, -2, 7, 8}, {0, infinity}, {}, 0); }

TEST_CASE("the range's start is excluded and its end included", "[10.1]") {
    check_first({2, 5, 7, 8}, {2, infinity}, 5.0, 8);
    check_first({2, 5, 7, 8}, {0, 2}, 2.0, 7);
    check_first({2, 5, 7, 8}, {0, 1.5}, {}, 0);
    check_first({2, 5, 7, 8}, {3, 4}, {}, 0);
    check_first({2, 5, 7, 8}, {3, 5}, 5.0, 8);
}
