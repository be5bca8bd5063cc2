// Failing tests show values: numbers with the digits that tell them apart, vectors and hits as what they are.
#include "tests/show.hpp"

#include "tests/catch.hpp"
#include "tests/condition.hpp"

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
    CHECK(stringify(360848) == "360848");
    CHECK(stringify(std::size_t(360848)) == "360848");
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
    CHECK(stringify(std::optional<Hit>()) == "a miss");
    CHECK(stringify(std::optional<Vec3>()) == "nothing");
    CHECK(stringify(std::optional(Hit{.t = 4, .uv = Vec2(0.25, 0.5), .primitive = 3})) ==
          "hit of number 3 at t = 4, uv (0.25, 0.5)");
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
    CHECK(stringify(test::near(Vec3(1, 2, 3), {1, 2, 4.5}, 0x1p-50)) ==
          "(1, 2, 3), expected (1, 2, 4.5) +- 8.88e-16\nz is off by 1.5");
    CHECK(stringify(test::near(1, 1.5, 0)) == "1, expected 1.5\noff by 0.5");
    CHECK(stringify(test::near(1, 1, 0)) == "1, expected 1");
    CHECK(test::near(infinity, infinity, 0));
}

TEST_CASE("how far a value is off is told in units that mean something") {
    CHECK(test::off_by(3, 1.5) == "off by 1.5: 2 times too much");
    CHECK(test::off_by(0.5, 1.5) == "off by 1: 3 times too little");
    CHECK(test::off_by(-2, 2) == "off by 4: the sign is wrong");
    CHECK(test::off_by(std::nan(""), 2) == "not a number");
    CHECK(test::off_by(Vec3(1, -2, 3), Vec3(1, 2, 3)) == "the sign of y is wrong");
    CHECK(test::off_by(Vec3(-1, -2, 3), Vec3(1, 2, 3)) == "the sign of x and y is wrong");
    CHECK(test::off_by(Vec3(2, 4, 0), Vec3(1, 2, 0)) == "y is off by 2: 2 times too much");
    CHECK(test::off_by(Vec2(1, 4), Vec2(1, 2)) == "y is off by 2");
    CHECK(test::off_by(Vec3(1, 2, std::nan("")), Vec3(1, 2, 3)) == "z is not a number");
    const auto direction = [](const Vec3& actual) {
        return test::off_by(actual, Vec3(1, 0, 0), test::Kind::Direction);
    };
    CHECK(direction({1, 1, 0}) == "45° off, and of length 1.41, not 1");
    CHECK(direction({0, 1, 0}) == "90° off");
    CHECK(direction({-1, 0, 0}) == "the opposite way");
    CHECK(direction({2, 0, 0}) == "the right way, but of length 2, not 1");
    CHECK(test::off_by(Vec3(0.5, 0.5, 0.25), Vec3(0.5), test::Kind::Color) ==
          "the blue channel is off by 0.25");
}

TEST_CASE("a condition that failed is told in words: what came out, and what was expected") {
    CHECK(test::in_words("4 == 3") == "4, expected 3");
    CHECK(test::in_words("0.5\n<=\n1e-16") == "0.5, expected at most 1e-16");
    CHECK(test::in_words("5 < 5") == "5, expected less than 5");
    CHECK(test::in_words("0 >= 1") == "0, expected at least 1");
    CHECK(test::in_words("0 > 0") == "0, expected more than 0");
    CHECK(test::in_words("2 != 2") == "2, expected anything but 2");
    CHECK(test::in_words("0.1 == Approx( 0.25 )") == "0.1, expected about 0.25");
    CHECK(test::in_words("false == true") == "no, expected yes");
    CHECK(test::in_words("false") == "no, expected yes");
    CHECK(test::in_words("!true") == "yes, expected no");
    CHECK(test::in_words("false", "hit.has_value()") == "nothing, expected something");
    CHECK(test::in_words("!true", "!(hit.has_value())") == "something, expected nothing");
    CHECK(test::in_words("true == false", "a.has_value() == b.has_value()") == "something, expected nothing");
    CHECK(test::in_words("a miss") == "a miss, expected a hit");
    CHECK(test::in_words("nothing") == "nothing, expected something");
    CHECK(test::in_words("!hit of 0 at t = 3") == "hit of 0 at t = 3, expected a miss");
    CHECK(test::in_words("!(1, 0, 0)") == "(1, 0, 0), expected nothing");
    CHECK(test::in_words("(1, 2), expected (1, 3)") == "(1, 2), expected (1, 3)");
}

TEST_CASE("a condition may say itself what is wrong, and two searches whether they found the same") {
    CHECK(test::or_say(true, ""));
    CHECK_FALSE(test::or_say(false, "it is not 1 long"));
    CHECK(stringify(test::or_say(false, "it is not 1 long")) == "it is not 1 long");
    CHECK(test::same_hit(Hit{.t = 1, .primitive = 2}, Hit{.t = 1, .primitive = 2}));
    CHECK(test::same_hit(std::nullopt, std::nullopt));
    CHECK_FALSE(test::same_hit(Hit{.t = 1}, std::nullopt));
    CHECK_FALSE(test::same_hit(Hit{.t = 1, .primitive = 2}, Hit{.t = 1, .primitive = 3}));
    CHECK(stringify(test::same_hit(Hit{.t = 1, .primitive = 2}, std::nullopt)) ==
          "hit of number 2 at t = 1, expected a miss");
}

TEST_CASE("what stands beside a condition is shown in the same way") {
    CHECK((test::Text() << "at " << Vec2(0.1, 2) << ", t = " << 0.1 + 0.2 << ", sphere " << 3u << ' ' << true)
              .str() == "at (0.1, 2), t = 0.30000000000000004, sphere 3 1");
}
