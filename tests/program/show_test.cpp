// Failing tests show values: numbers with the digits that tell them apart, vectors and hits as what they are.
#include "tests/show.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <limits>

using namespace rt;
using Catch::Detail::stringify;

namespace {

/// What a failed CHECK says of its condition.
template <class Left, class Right>
std::string as_condition(const Left& left, const Right& right) {
    return stringify(left) + " <= " + stringify(right);
}

}  // namespace

TEST_CASE("two different numbers never look alike") {
    CHECK(stringify(0.1) == "0.1");
    CHECK(stringify(-0.0) == "-0");
    CHECK(stringify(2.0) == "2");
    CHECK(as_condition(1e-20, 4 * 0x1p-53) == "1e-20 <= 4.440892098500626e-16");
    CHECK(stringify(infinity) == "inf");
    for (const Real x : {1.0, 0.1, 1e8, 1e-300, 0x1p-1074})
        CHECK(stringify(x) != stringify(std::nextafter(x, infinity)));
}

TEST_CASE("values of the course are shown as what they hold, alone and in one another") {
    CHECK(stringify(Vec2(1, 2.5)) == "(1, 2.5)");
    CHECK(stringify(Vec3(1, 2.5, -3)) == "(1, 2.5, -3)");
    CHECK(stringify(Vec4(1, 2, 3, 4)) == "(1, 2, 3, 4)");
    CHECK(stringify(Cells(1, 2, 3)) == "(1, 2, 3)");
    CHECK(stringify(Mat3(1)) == "\n  | 1 0 0 |\n  | 0 1 0 |\n  | 0 0 1 |");
    Mat4 moved(1);
    moved[3] = {5, 6, 7, 1};
    CHECK(stringify(moved) == "\n  | 1 0 0 5 |\n  | 0 1 0 6 |\n  | 0 0 1 7 |\n  | 0 0 0 1 |");
    CHECK(stringify(Interval{0.5, infinity}) == "(0.5, inf]");
    CHECK(stringify(std::optional<Hit>()) == "nothing");
    CHECK(stringify(std::optional(Hit{.t = 4, .uv = Vec2(0.25, 0.5), .primitive = 3})) ==
          "hit of 3 at t = 4, uv (0.25, 0.5)");
    CHECK(stringify(std::variant<Sphere, Plane>(Sphere{{1, 2, 3}, 4})) ==
          "sphere around (1, 2, 3) of radius 4");
    CHECK(stringify(Roots{2, 1, 3}) == "2 roots: t0 = 1, t1 = 3");
    CHECK(stringify(std::vector<Vec2>{{1, 2}, {3, 4}}) == "{ (1, 2), (3, 4) }");
    CHECK(stringify(std::vector<CellVisit>{{{1, 2, 3}, {0, 1}}}) == "{ cell (1, 2, 3) in (0, 1] }");
    CHECK(stringify(Bounds{{0, 0, 0}, {1, 2, 3}}) == "box from (0, 0, 0) to (1, 2, 3)");
}

TEST_CASE("a comparison within a bound shows both sides and the bound") {
    CHECK(test::near(Vec3(1, 2, 3), {1, 2, 3}, 0));
    CHECK(test::near(1, 1 + 0x1p-52, 0x1p-52));
    CHECK_FALSE(test::near(Vec3(1, 2, std::nan("")), {1, 2, 3}, infinity));
    CHECK_FALSE(test::near(std::nan(""), 1, infinity));
    CHECK(stringify(test::near(Vec3(1, 2, 3), {1, 2, 4}, 1e-15)) == "(1, 2, 3), expected (1, 2, 4) +- 1e-15");
    CHECK(stringify(test::near(1, 2, 0)) == "1, expected 2");
}

TEST_CASE("what stands beside a condition is shown in the same way") {
    CHECK((test::Text() << "at " << Vec2(0.1, 2) << ", t = " << 0.1 + 0.2 << ", sphere " << 3u << ' ' << true)
              .str() == "at (0.1, 2), t = 0.30000000000000004, sphere 3 1");
}
