// Steps 12.21 and 12.22: how a ray sees what turns while the shutter is open, and where that may be.
#include "chapters/12_distribution/motion.hpp"
#include "common/math/error.hpp"
#include "common/math/exact.hpp"
#include "tests/12_distribution/turned.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>

using namespace rt;
using test::cases;
using test::Long;
using test::Long3;
using test::near;
using test::Random;

namespace {

Spin spin_of(const Vec3& center, const Vec3& axis, Real angle) {
    Spin spin;
    spin.center = center, spin.axis = axis, spin.angle = angle;
    return spin;
}

const Vec3 z_axis(0, 0, 1);

void check_seen(const Ray& ray, const Spin& spin, const Vec3& origin, const Vec3& direction) {
    INFO("the " << ray << " at time " << ray.time << ", a " << spin);
    const Ray seen = seen_while_turning(ray, spin);
    CHECK(near(seen.origin, origin, gamma(64) * (length(ray.origin) + length(spin.center))));
    CHECK(near(seen.direction, direction, gamma(64) * length(ray.direction)));
    CHECK(seen.time == ray.time);
}

void check_arc(Real x, Real y, Real angle, Real least, Real greatest) {
    INFO(x << "·cos θ + " << y << "·sin θ for θ from 0 to " << angle << ": the least, then the greatest");
    const Interval range = arc_range(x, y, angle);
    CHECK(near(range.min, least, gamma(20) * (std::abs(x) + std::abs(y))));
    CHECK(near(range.max, greatest, gamma(20) * (std::abs(x) + std::abs(y))));
}

Real farthest_corner(const Bounds& box, const Vec3& from) {
    return length(glm::max(glm::abs(box.low - from), glm::abs(box.high - from)));
}

/// `expected` is rounded: what is farther in by less than that counts as there.
void check_bounds(const Bounds& box, const Spin& spin, const Bounds& expected) {
    const Bounds all = bounds_while_turning(box, spin);
    INFO("the " << box << ", a " << spin << ": a " << all << ", expected the " << expected
                << ", a little larger");
    const Real margin = gamma(256) * (length(spin.center) + farthest_corner(box, spin.center));
    for (int axis = 0; axis < 3; ++axis) {
        INFO("axis " << axis << "; at most " << margin << " larger");
        CHECK(all.low[axis] <= expected.low[axis] + margin / 64);
        CHECK(all.low[axis] >= expected.low[axis] - margin);
        CHECK(all.high[axis] >= expected.high[axis] - margin / 64);
        CHECK(all.high[axis] <= expected.high[axis] + margin);
    }
}

}  // namespace

TEST_CASE("after a quarter turn to the left, the ray comes from a quarter to the right, by hand", "[12.21]") {
    // About the line x = 1, y = 0, upwards. The origin is 2 to the right of it.
    const Spin quarter = spin_of({1, 0, 0}, z_axis, pi / 2);
    check_seen({{3, 0, 5}, {0, 1, 0}, 1}, quarter, {1, -2, 5}, {1, 0, 0});
    check_seen({{1, 4, 5}, {-3, 0, -2}, 1}, quarter, {5, 0, 5}, {0, 3, -2});
    // A third of three quarters is a quarter, and two of the other way are the same as one this way thrice.
    check_seen({{3, 0, 5}, {0, 1, 0}, Real(1) / 3}, spin_of({1, 0, 0}, z_axis, 3 * pi / 2), {1, -2, 5},
               {1, 0, 0});
    check_seen({{3, 0, 5}, {0, 1, 0}, 1}, spin_of({1, 0, 0}, z_axis, -pi / 2), {1, 2, 5}, {-1, 0, 0});
    check_seen({{3, 0, 5}, {0, 1, 0}, 0.5}, spin_of({1, 0, 0}, -z_axis, pi), {1, 2, 5}, {-1, 0, 0});
}

TEST_CASE("a third of a turn about the diagonal changes the axes round", "[12.21]") {
    // The thing's x axis goes to where y was, y to z, z to x; so the ray's goes the other way.
    const Spin third = spin_of({0, 0, 0}, Vec3(1, 1, 1) / std::sqrt(Real(3)), 2 * pi / 3);
    check_seen({{1, 2, 3}, {0, 0, -4}, 1}, third, {2, 3, 1}, {0, -4, 0});
    check_seen({{5, 0, 0}, {1, 1, 0}, 1}, third, {0, 0, 5}, {1, 0, 1});
}

TEST_CASE("what lies on the axis stays, and along it", "[12.21]") {
    const Spin spin = spin_of({1, 2, 3}, {0.6, 0, 0.8}, 2.5);
    check_seen({{7, 2, 11}, {-3, 0, -4}, 0.75}, spin, {7, 2, 11}, {-3, 0, -4});
    check_seen({{1, 2, 3}, {0.6, 0, 0.8}, 1}, spin, {1, 2, 3}, {0.6, 0, 0.8});
}

TEST_CASE("two turns and a half are half a turn", "[12.21]") {
    const Spin turns = spin_of({1, 0, 0}, z_axis, 5 * pi);
    check_seen({{3, 1, 5}, {0, 1, 2}, 1}, turns, {-1, -1, 5}, {0, -1, 2});
    check_seen({{3, 1, 5}, {0, 1, 2}, 0.4}, turns, {3, 1, 5}, {0, 1, 2});
}

TEST_CASE("at time 0, and without an angle, it is the ray itself to the bit", "[12.21]") {
    const Ray early{{0.1, 0.2, 0.3}, {1, 2, 3}, 0}, later{{0.1, 0.2, 0.3}, {1, 2, 3}, 0.7};
    const auto same = [](const Ray& ray, const Spin& spin) {
        INFO("the " << ray << " at time " << ray.time << ", a " << spin);
        const Ray seen = seen_while_turning(ray, spin);
        CHECK(seen.origin == ray.origin);
        CHECK(seen.direction == ray.direction);
        CHECK(seen.time == ray.time);
    };
    same(early, spin_of({1e5, -3, 7}, {0.6, 0, 0.8}, 20));
    same(later, spin_of({1e5, -3, 7}, {0.6, 0, 0.8}, 0));
}

TEST_CASE("what a ray hits of a turning thing is where that was at time 0", "[12.21]") {
    Random random(12211);
    for (int i = 0; i < cases(10'000); ++i) {
        const Vec3 axis = random.direction();
        const Vec3 center = random.magnitude(-2, 2) * random.in_cube();
        const Spin spin = spin_of(center, axis, random.uniform(-20, 20));
        // A point at time 0, where that is at a time, and a ray to it, at t = 1.
        const Vec3 point = center + random.magnitude(-2, 2) * random.direction();
        Ray ray;
        ray.time = i % 10 == 0 ? 1 : random.uniform(0, 1);
        const Long3 there = test::long_turned(spin, Long(ray.time) * spin.angle, point);
        const Vec3 place(static_cast<Real>(there[0]), static_cast<Real>(there[1]),
                         static_cast<Real>(there[2]));
        ray.direction = random.magnitude(-1, 2) * random.direction();
        ray.origin = place - ray.direction;
        INFO("the " << ray << " at time " << ray.time << ", at t = 1; a " << spin);
        const Ray seen = seen_while_turning(ray, spin);
        const Real rounding = gamma(256) * (length(ray.origin) + length(ray.direction) + length(center));
        CHECK(near(point_at(seen, 1), point, rounding));
    }
}

TEST_CASE("a quarter of the circle, from any of its ends, by hand", "[12.22]") {
    check_arc(1, 0, pi / 2, 0, 1);
    check_arc(0, 1, pi / 2, 0, 1);
    check_arc(-1, 0, pi / 2, -1, 0);
    check_arc(0, -1, pi / 2, -1, 0);
    // From 3, at 53.1 degrees over 5, to 4.
    check_arc(3, 4, pi / 2, 3, 5);
    check_arc(-3, 4, pi / 2, -3, 4);
    check_arc(-3, -4, pi / 2, -5, -3);
    check_arc(3, -4, pi / 2, -4, 3);
}

TEST_CASE("an arc the other way", "[12.22]") {
    check_arc(3, 4, -pi / 2, -4, 3);
    check_arc(3, -4, -pi / 2, 3, 5);
    check_arc(0, 1, -pi / 2, -1, 0);
}

TEST_CASE("arcs of nothing, of half a turn, and of more than one", "[12.22]") {
    check_arc(3, 4, 0, 3, 3);
    check_arc(3, 4, pi, -3, 5);
    check_arc(3, -4, pi, -5, 3);
    check_arc(3, -4, 2 * pi, -5, 5);
    check_arc(-3, 4, -50, -5, 5);
    check_arc(0, 0, 1, 0, 0);
    check_arc(-7, 0, 3 * pi, -7, 7);
}

TEST_CASE("ranges of random arcs, by where the peaks and the valleys are", "[12.22]") {
    Random random(12221);
    for (int i = 0; i < cases(20'000); ++i) {
        const Real size = random.magnitude(-5, 5), around = random.uniform(-4, 4);
        const Real x = size * std::cos(around), y = size * std::sin(around);
        const Real angle = i % 2 == 0 ? random.uniform(-7, 7) : random.sign() * random.magnitude(-6, 3);
        INFO(x << "·cos θ + " << y << "·sin θ for θ from 0 to " << angle << ": the least, then the greatest");
        // Peaks stand at `first` plus whole turns, valleys half a turn later. The range of θ is [from, to].
        const Long first = std::atan2(Long(y), Long(x)), whole = 2 * std::numbers::pi_v<Long>;
        const Long from = std::min<Long>(angle, 0), to = std::max<Long>(angle, 0);
        const auto met = [&](Long one) {
            return std::floor((to - one) / whole) >= std::ceil((from - one) / whole);
        };
        const Long end = x * std::cos(Long(angle)) + y * std::sin(Long(angle));
        const Long radius = std::sqrt(Long(x) * x + Long(y) * y);
        Long least = std::min<Long>(x, end), greatest = std::max<Long>(x, end);
        if (met(first)) greatest = radius;
        if (met(first + whole / 2)) least = -radius;
        const Interval range = arc_range(x, y, angle);
        CHECK(near(range.min, static_cast<Real>(least), gamma(18) * (std::abs(x) + std::abs(y))));
        CHECK(near(range.max, static_cast<Real>(greatest), gamma(18) * (std::abs(x) + std::abs(y))));
    }
}

TEST_CASE("bounds of a point that makes a quarter turn, by hand", "[12.22]") {
    // From (3, 4) over (0, 5) to (−4, 3).
    const Bounds point{{3, 4, 1}, {3, 4, 1}};
    check_bounds(point, spin_of({0, 0, 0}, z_axis, pi / 2), {{-4, 3, 1}, {3, 5, 1}});
    check_bounds(point, spin_of({0, 0, 7}, z_axis, -pi / 2), {{3, -3, 1}, {5, 4, 1}});
    check_bounds(point, spin_of({0, 0, 0}, z_axis, 0), point);
    // About the line through (3, 0): over (−1, 0).
    check_bounds(point, spin_of({3, 0, 0}, z_axis, pi), {{-1, -4, 1}, {3, 4, 1}});
}

TEST_CASE("bounds of a bar that turns, by hand", "[12.22]") {
    const Bounds bar{{0, -1, 0}, {4, 1, 2}};
    // A quarter about its end: from the right, and with the corner √17 away, up.
    check_bounds(bar, spin_of({0, 0, 0}, z_axis, pi / 2), {{-1, -1, 0}, {std::sqrt(17.), std::sqrt(17.), 2}});
    // All the way about its middle, and how far its corners are from that.
    const Real r = std::sqrt(5.);
    check_bounds(bar, spin_of({2, 0, 0}, z_axis, 20), {{2 - r, -r, 0}, {2 + r, r, 2}});
    // About the line along its lower edge.
    check_bounds(bar, spin_of({0, -1, 0}, {1, 0, 0}, pi / 2), {{0, -3, 0}, {4, 1, std::sqrt(8.)}});
}

TEST_CASE("bounds of a turn about a slanting axis, by hand", "[12.22]") {
    // The circle of (1, 0, 0) about the diagonal goes through (0, 1, 0) and (0, 0, 1), around (⅓, ⅓, ⅓).
    const Vec3 diagonal = Vec3(1, 1, 1) / std::sqrt(Real(3));
    const Bounds point{{1, 0, 0}, {1, 0, 0}};
    check_bounds(point, spin_of({0, 0, 0}, diagonal, 2 * pi),
                 {Vec3(Real(-1) / 3, Real(-1) / 3, Real(-1) / 3), {1, 1, 1}});
    // A third of it: z is least at half of that, and from x to y all of x + y + z = 1.
    check_bounds(point, spin_of({0, 0, 0}, diagonal, 2 * pi / 3), {{0, 0, Real(-1) / 3}, {1, 1, 0}});
}

TEST_CASE("bounds of a turn are rounded outwards", "[12.22]") {
    // What turns all around with (a, b) reaches r with r·r = a·a + b·b, which no Real need be.
    for (const Real a : {1, 2, 3, 4, 5, 6, 7, 8, 9})
        for (const Real b : {1, 2, 3, 5, 7, 11}) {
            const Bounds all = bounds_while_turning({{a, b, 0}, {a, b, 0}}, spin_of({0, 0, 0}, z_axis, 7));
            INFO("(" << a << ", " << b << ", 0) turns all around the z axis: a " << all);
            for (const Real reach : {all.high.x, all.high.y, all.low.x, all.low.y}) {
                ExactSum sum;
                sum.add(reach, reach);
                sum.subtract(a, a);
                sum.subtract(b, b);
                INFO("a face at " << reach << " must not cut off anything of the circle");
                CHECK(sum.sign() >= 0);
            }
        }
}

TEST_CASE("empty bounds stay as they are, whatever turns", "[12.22]") {
    const auto same = [](const Bounds& box, const Spin& spin) {
        const Bounds all = bounds_while_turning(box, spin);
        INFO("the " << box << ", a " << spin << ": a " << all);
        CHECK(all.low == box.low);
        CHECK(all.high == box.high);
    };
    same({}, spin_of({1, 2, 3}, z_axis, 1));
    same({{0, 3, 0}, {1, 2, 1}}, spin_of({0, 0, 0}, z_axis, pi));
}

TEST_CASE("bounds contain what turns at all times, and hardly more than the corners' arcs", "[12.22]") {
    Random random(12222);
    for (int i = 0; i < cases(500); ++i) {
        const Vec3 middle = random.magnitude(-2, 2) * random.in_cube();
        const Vec3 half = random.magnitude(-2, 2) * glm::abs(random.in_cube());
        const Bounds box{middle - half, middle + half};
        const Vec3 axis = random.direction(), center = random.magnitude(-2, 2) * random.in_cube();
        const Spin spin = spin_of(center, axis, random.sign() * random.magnitude(-2, 1));
        const Bounds all = bounds_while_turning(box, spin);
        INFO("the " << box << ", a " << spin << ": a " << all);
        const Real r = farthest_corner(box, center);
        std::array<Long, 3> low, high;
        low.fill(infinity), high.fill(-infinity);
        const int steps = 200;
        for (int corner = 0; corner < 8; ++corner)
            for (int k = 0; k <= steps; ++k) {
                const Vec3 p(corner % 2 == 0 ? box.low.x : box.high.x,
                             corner / 2 % 2 == 0 ? box.low.y : box.high.y,
                             corner < 4 ? box.low.z : box.high.z);
                const Long3 place = test::long_turned(spin, Long(spin.angle) * k / steps, p);
                for (std::size_t axis_of = 0; axis_of < 3; ++axis_of) {
                    low[axis_of] = std::min(low[axis_of], place[axis_of]);
                    high[axis_of] = std::max(high[axis_of], place[axis_of]);
                }
            }
        // Between two of the places an arc goes no farther out than its height above its chord.
        const Real step = std::abs(spin.angle) / steps;
        const Real margin = r * step * step / 8 + gamma(256) * (length(center) + r);
        for (int side = 0; side < 3; ++side) {
            const auto at = static_cast<std::size_t>(side);
            INFO("axis " << side << ": places from " << static_cast<Real>(low[at]) << " to "
                         << static_cast<Real>(high[at]));
            CHECK(all.low[side] <= low[at]);
            CHECK(all.high[side] >= high[at]);
            CHECK(all.low[side] >= low[at] - margin);
            CHECK(all.high[side] <= high[at] + margin);
        }
    }
}
