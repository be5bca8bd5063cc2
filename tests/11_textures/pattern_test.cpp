// Step 11.8: patterns in space.
#include "chapters/11_textures/pattern.hpp"

#include "chapters/11_textures/cells.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rt;
using test::cases;
using test::Random;

namespace {

// Turbulence is right to twice 2500u, the four of it and s to 20000u, and the sine changes by pi/2 at most
// for 1.
constexpr Real marble_bound = 40000 * unit_roundoff;

/// The noise's error, twice, and a few roundings of numbers of the size of the distance.
Real wood_bound(const Vec3& q) { return 4 * unit_roundoff * (2500 + std::abs(q.x) + std::abs(q.z)); }

void check_stripe(const Vec3& q, Real expected) {
    INFO("stripes at " << q);
    CHECK(test::near(stripe_value(q), expected, 0));
}

void check_ring(const Vec3& q, Real expected) {
    INFO("rings at " << q);
    CHECK(test::near(ring_value(q), expected, 0));
}

void check_gradient(const Vec3& q, Real expected) {
    INFO("gradient at " << q);
    CHECK(test::near(gradient_value(q), expected, 2 * unit_roundoff));
}

void check_marble(const Vec3& q, Real expected) {
    INFO("marble at " << q);
    CHECK(test::near(marble_value(q), expected, marble_bound));
}

void check_wood(const Vec3& q, Real expected) {
    INFO("wood at " << q);
    CHECK(test::near(wood_value(q), expected, wood_bound(q)));
}

void check_color(const SolidPattern& pattern, const Vec3& point, const Vec3& expected, Real bound) {
    INFO("pattern of size " << pattern.size << " from " << pattern.first << " to " << pattern.second << " at "
                            << point);
    CHECK(test::near(pattern_color(pattern, point), expected, bound));
}

const Vec3 red(1, 0.25, 0), blue(0, 0.5, 0.75);

struct Known {
    Vec3 q;
    Real value;
};

// By Perlin's published program in exact fractions, the sine and the root with 50 digits.
const std::vector<Known> known_marble{
    {{0.25, 0.484375, 0.59375}, 0.32355506861308714},
    {{2.65625, 1.4375, 2.53125}, 0.4711542455951391},
    {{-2.828125, -0.203125, 2.65625}, 0.9000742790659769},
    {{2.984375, 8.015625, -7.734375}, 0.2551430453052707},
    {{-0.625, -5.0625, 0.875}, 0.9748518565539818},
    {{4.4375, -29.21875, -17.0}, 0.9981666891458745},
    {{-44.109375, 83.265625, 53.140625}, 0.31999243034299296},
    {{-68.078125, 59.421875, -72.25}, 0.22715596887599585},
    {{234.90625, -746.59375, -996.453125}, 0.6326702768493561},
    {{742.8125, -581.09375, -569.03125}, 0.14456025872170458},
};

const std::vector<Known> known_wood{
    {{0.25, 0.484375, 0.59375}, 0.8561421645574061},
    {{2.65625, 1.4375, 2.53125}, 0.09050429506003817},
    {{-2.828125, -0.203125, 2.65625}, 0.7889014783331778},
    {{2.984375, 8.015625, -7.734375}, 0.8473712746844411},
    {{-0.625, -5.0625, 0.875}, 0.7090726417526696},
    {{4.4375, -29.21875, -17.0}, 0.459328437065502},
    {{-44.109375, 83.265625, 53.140625}, 0.5550702785877953},
    {{-68.078125, 59.421875, -72.25}, 0.8194959820202842},
    {{234.90625, -746.59375, -996.453125}, 0.6682616952581443},
    {{742.8125, -581.09375, -569.03125}, 0.3025343911056772},
};

}  // namespace

TEST_CASE("stripes are one unit thick", "[11.8]") {
    check_stripe({0.5, 7.5, 7.5}, 0);
    check_stripe({1.5, 0, 0}, 1);
    check_stripe({2.5, 1.5, 0}, 0);
}

TEST_CASE("stripes go on evenly below 0", "[11.8]") {
    check_stripe({-0.5, 0, 0}, 1);
    check_stripe({-1.5, 0, 0}, 0);
    check_stripe({-2.5, 0, 0}, 1);
}

TEST_CASE("a point between two stripes belongs to the upper one", "[11.8]") {
    check_stripe({0, 0, 0}, 0);
    check_stripe({1, 0, 0}, 1);
    check_stripe({2, 0, 0}, 0);
    check_stripe({-1, 0, 0}, 1);
}

TEST_CASE("rings are shells around the y axis", "[11.8]") {
    check_ring({0, 5.5, 0}, 0);
    check_ring({0.5, 1.5, 0.5}, 0);  // 0.707
    check_ring({1, 0, 1}, 1);        // 1.414
    check_ring({-1, 0, 1}, 1);
    check_ring({2, 0, -1}, 0);   // 2.236
    check_ring({3, 9.5, 4}, 1);  // 5
}

TEST_CASE("the gradient begins again at each whole number", "[11.8]") {
    check_gradient({0.5, 0.25, 0.5}, 0.25);
    check_gradient({0, 1.75, 0}, 0.75);
    check_gradient({0, 3, 0}, 0);
    check_gradient({0, -0.25, 0}, 0.75);
    check_gradient({0, -2, 0}, 0);
}

TEST_CASE("marble where the turbulence is 0 is a wave along x", "[11.8]") {
    check_marble({0, 4, 8}, 0.5);  // sin(0)
    check_marble({4, 0, 0}, 0.5);  // sin(4 pi)
    check_marble({-4, 8, 0}, 0.5);
}

TEST_CASE("marble at (1, 0, 0) is as computed by hand", "[11.8]") {
    // q/4 = (1/4, 0, 0): the first octave is 0.146484375, all others 0. s = 1 + 4 * 0.146484375 = 1.5859375.
    check_marble({1, 0, 0}, 0.018111967102280066);
}

TEST_CASE("marble far from the origin still has its waves", "[11.8]") {
    check_marble({0x1p52, 0, 0}, 0.5);
    check_marble({0x1p41 + 1, 0, 0}, 0.018111967102280066);
}

TEST_CASE("marble is that of a computation with 50 digits", "[11.8]") {
    for (const Known& at : known_marble) check_marble(at.q, at.value);
}

TEST_CASE("wood at (2, 0, 0) is as computed by hand", "[11.8]") {
    check_wood({2, 0, 0}, 0.29296875);  // 2 + 2 * 0.146484375, the noise at (1/4, 0, 0)
    check_wood({0, 8, 0}, 0);           // on the axis, at a point of the lattice
}

TEST_CASE("wood is that of a computation with 50 digits", "[11.8]") {
    for (const Known& at : known_wood) check_wood(at.q, at.value);
}

TEST_CASE("the colours of a pattern are those of its ends, to the bit", "[11.8]") {
    const SolidPattern stripes{PatternKind::Stripes, 1, {0.1, 1e10, 1e-3}, {0.3, 0.7, 0.9}};
    check_color(stripes, {0.5, 0, 0}, {0.1, 1e10, 1e-3}, 0);
    check_color(stripes, {1.5, 0, 0}, {0.3, 0.7, 0.9}, 0);
}

TEST_CASE("a pattern's colours are mixed in proportion", "[11.8]") {
    const SolidPattern gradient{PatternKind::Gradient, 1, red, blue};
    check_color(gradient, {0, 0.25, 0}, {0.75, 0.3125, 0.1875}, gamma(4));
    check_color(gradient, {0, 0.5, 0}, {0.5, 0.375, 0.375}, gamma(4));
}

TEST_CASE("a pattern's size is that of one stripe", "[11.8]") {
    const SolidPattern stripes{PatternKind::Stripes, 4, red, blue};
    check_color(stripes, {3, 0, 0}, red, 0);
    check_color(stripes, {5, 0, 0}, blue, 0);
    check_color({PatternKind::Gradient, 4, red, blue}, {0, 1, 0}, {0.75, 0.3125, 0.1875}, gamma(4));
    check_color({PatternKind::Rings, 0.5, red, blue}, {0, 0, 0.75}, blue, 0);
}

TEST_CASE("values of stripes, rings and gradients at random places", "[11.8]") {
    Random random(11501);
    for (int i = 0; i < cases(5000); ++i) {
        // A whole number, and clearly more than it.
        const int whole = static_cast<int>(random.index(2000)) - 1000;
        const Real part = random.uniform(0.001, 0.999);
        const Real odd = (whole + 1000) % 2;
        const Vec3 q = Real(100) * random.in_cube();
        check_stripe({whole + part, q.y, q.z}, odd);
        const Real radius = std::abs(whole) + part, turn = random.uniform(0, 2 * pi);
        check_ring({radius * std::cos(turn), q.y, radius * std::sin(turn)}, odd);
        INFO("whole number " << whole << " and " << part);
        // The sum of the two was rounded.
        CHECK(test::near(gradient_value({q.x, whole + part, q.z}), part, 1024 * unit_roundoff));
    }
}

TEST_CASE("the pattern of cells is dark on the walls", "[11.9]") {
    // Twice the difference of the two distances, wherever one looks.
    Random random(11502);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 q = Real(50) * random.in_cube();
        const CellDistances distances = cell_distances(q);
        const Real expected = std::min(Real(1), (distances.second - distances.first) * 2);
        INFO("cells at " << q);
        CHECK(test::near(pattern_value(PatternKind::Cellular, q), expected, gamma(4)));
    }
}
