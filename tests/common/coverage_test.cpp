// The exact means that the tests of sampling are measured against are exact.
#include "tests/stability/coverage.hpp"

#include "tests/catch.hpp"
#include "tests/support.hpp"

using namespace rt;
using namespace rt::test;

namespace {

const Vec2 zero(0), one(1);

/// Absolute error allowed where coverage.hpp promises 1e-13.
bool equal(Real a, Real b) { return std::abs(a - b) <= 1e-13; }

/// Mean over the unit square of the values at the middles of n × n cells.
template <class Shape>
Real counted(const Shape& shape, int n) {
    Real sum = 0;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) sum += value(shape, {(i + 0.5) / n, (j + 0.5) / n});
    }
    return sum / n / n;
}

/// Whether the mean is that of the four parts left and right, above and below of a point.
template <class Shape>
bool adds_up(const Shape& shape, const Vec2& p) {
    const auto part = [&](const Vec2& low, const Vec2& high) {
        return (high.x - low.x) * (high.y - low.y) * mean(shape, low, high);
    };
    return equal(mean(shape, zero, one),
                 part(zero, p) + part({p.x, 0}, {1, p.y}) + part({0, p.y}, {p.x, 1}) + part(p, one));
}

}  // namespace

TEST_CASE("coverage of half-planes, as on squared paper") {
    CHECK(mean(HalfPlane{{1, 0}, 0.25}, zero, one) == 0.25);
    CHECK(mean(HalfPlane{{-1, 0}, -0.25}, zero, one) == 0.75);
    CHECK(mean(HalfPlane{{0, 2}, 1}, zero, one) == 0.5);
    CHECK(mean(HalfPlane{{1, 1}, 1}, zero, one) == 0.5);
    CHECK(mean(HalfPlane{{1, 1}, 0.5}, zero, one) == 0.125);
    CHECK(mean(HalfPlane{{1, 1}, 2.5}, zero, one) == 1);
    CHECK(mean(HalfPlane{{1, 1}, -1}, zero, one) == 0);
    CHECK(mean(HalfPlane{{1, 0}, 3}, {2, 5}, {6, 6}) == 0.25);
}

TEST_CASE("coverage of disks, by the area of circles, halves and quarters of them") {
    CHECK(equal(mean(Disk{{0.5, 0.5}, 0.25}, zero, one), pi / 16));
    CHECK(equal(mean(Disk{{0, 0.5}, 0.5}, zero, one), pi / 8));
    CHECK(equal(mean(Disk{{1, 1}, 0.5}, zero, one), pi / 16));
    CHECK(equal(mean(Disk{{0.5, 0.5}, 1}, zero, one), 1));
    CHECK(equal(mean(Disk{{3, 0.5}, 1}, zero, one), 0));
    // A circle through the middles of a square's sides touches it: the square has 4/π of its area.
    CHECK(equal(mean(Disk{{0.5, 0.5}, 0.5}, zero, one), pi / 4));
}

TEST_CASE("a zone plate of frequency 0 is white, and one of small frequency nearly a paraboloid") {
    CHECK(equal(mean(ZonePlate{{3, 4}, 0}, zero, one), 1));
    // (1 + cos s)/2 = 1 − s²/4 + ..., and the mean of (x² + y²)² over the unit square is 28/45.
    CHECK(equal(mean(ZonePlate{zero, 1e-4}, zero, one), 1 - 1e-8 / 4 * 28 / 45));
}

TEST_CASE("exact means add up, and are what counting finds") {
    Random random(801);
    for (int i = 0; i < cases(200); ++i) {
        const Vec2 p(random.uniform(0.1, 0.9), random.uniform(0.1, 0.9));
        const Vec2 q(random.uniform(-1, 2), random.uniform(-1, 2));
        const Real angle = random.uniform(0, 2 * pi), radius = random.uniform(0.1, 2);
        const Vec2 n(std::cos(angle), std::sin(angle));
        const HalfPlane plane{n, dot(n, p)};
        const Disk disk{q, radius};
        const ZonePlate plate{q, random.uniform(0, 20)};
        CAPTURE(p.x, p.y, q.x, q.y, angle, radius, plate.frequency);
        CHECK(adds_up(plane, p));
        CHECK(adds_up(disk, p));
        CHECK(adds_up(plate, p));
        // An edge passes through at most 2 · 100 + 1 cells, a circle through twice as many (it enters no row
        // or column more than twice), and each of them is wrong by less than the cell.
        CHECK(std::abs(mean(plane, zero, one) - counted(plane, 100)) < 201. / 10'000);
        CHECK(std::abs(mean(disk, zero, one) - counted(disk, 100)) < 402. / 10'000);
        // The error of the midpoint rule is h²/24 times the sum of the second derivatives, whose greatest is
        // below (2 f d)² + 2 f for each axis with d at most 2√2: here below 2 · 13,000 · 1e-4/24 for f = 20.
        CHECK(std::abs(mean(plate, zero, one) - counted(plate, 100)) < 0.11);
    }
}

TEST_CASE("the mean of a zone plate is what Richardson's extrapolation of counting finds") {
    const ZonePlate plate{{0.3, -0.2}, 7};
    const Real coarse = counted(plate, 200), fine = counted(plate, 400);
    // The midpoint rule's error is c₂h² + c₄h⁴ + ...; what is left is of order (7 · 3/200)⁴/100.
    CHECK(std::abs(mean(plate, zero, one) - (4 * fine - coarse) / 3) < 1e-6);
}
