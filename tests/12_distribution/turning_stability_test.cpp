// Steps 12.21 and 12.22 on extreme cases: turns by almost nothing and by thousands of turns, far from their
// centre and far from the origin.
#include "chapters/12_distribution/motion.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/random_vectors.hpp"
#include "tests/12_distribution/turned.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <array>
#include <cmath>

using namespace rt;
using test::cases;
using test::Long;
using test::Long3;
using test::of_all_sizes;
using test::Random;

namespace {

/// Along an axis of the world, near one, or anywhere; of length 1 to some roundings.
Vec3 some_axis(Random& random) {
    const Vec3 any = random.direction();
    Vec3 axis(0);
    const int which = static_cast<int>(random.index(3));
    axis[which] = random.sign();
    switch (random.index(3)) {
        case 0:
            return axis;
        case 1:
            return unit(axis + random.magnitude(-17, -1) * any);
        default:
            return any;
    }
}

Spin some_spin(Random& random) {
    Spin spin;
    const Real size = random.magnitude(-20, 20);
    spin.center = random.index(4) == 0 ? Vec3(0) : size * random.in_cube();
    spin.axis = some_axis(random);
    switch (random.index(4)) {
        case 0:
            spin.angle = random.magnitude(-300, -1);
            break;
        case 1:
            spin.angle = random.magnitude(0, 8);
            break;
        case 2:  // near whole eighths
            spin.angle = static_cast<Real>(random.index(17)) * (pi / 4) * random.nudge();
            break;
        default:
            spin.angle = random.uniform(0, 7);
    }
    spin.angle *= random.sign();
    return spin;
}

/// As far from the centre as it is large, near the centre, or far outside.
Vec3 some_place(Random& random, const Vec3& center) {
    const Real size = random.magnitude(-20, 20), part = random.magnitude(-18, 18);
    const Vec3 aside = random.direction();
    switch (random.index(3)) {
        case 0:
            return size * aside;
        case 1:
            return center + part * length(center) * aside;
        default:
            return of_all_sizes(random, -20, 20);
    }
}

}  // namespace

TEST_CASE("rays that see turns of all kinds", "[12.21][stability]") {
    Random random(122101);
    for (int i = 0; i < cases(20'000); ++i) {
        const Spin spin = some_spin(random);
        Ray ray;
        ray.origin = some_place(random, spin.center);
        const Real size = random.magnitude(-30, 30);
        ray.direction = random.index(4) == 0 ? size * spin.axis : size * random.direction();
        ray.time = random.index(4) == 0 ? 1 : random.uniform(0, 1);
        INFO("the " << ray << " at time " << ray.time << ", a " << spin);
        const Ray seen = seen_while_turning(ray, spin);
        CHECK(seen.time == ray.time);
        const Long back = -Long(ray.time * spin.angle);
        const Long3 origin = test::long_turned(spin, back, ray.origin);
        const Long3 direction =
            test::long_turned(spin.axis, back, {ray.direction.x, ray.direction.y, ray.direction.z});
        const Real origin_bound = gamma(64) * (length(ray.origin) + length(spin.center)) + 1e-320;
        const Real direction_bound = gamma(64) * length(ray.direction) + 1e-320;
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<std::size_t>(axis);
            INFO("axis " << axis << ": origin " << seen.origin[axis] << ", expected "
                         << static_cast<Real>(origin[at]) << " +- " << origin_bound << "; direction "
                         << seen.direction[axis] << ", expected " << static_cast<Real>(direction[at])
                         << " +- " << direction_bound);
            CHECK(test::long_near(seen.origin[axis], origin[at], origin_bound));
            CHECK(test::long_near(seen.direction[axis], direction[at], direction_bound));
        }
    }
}

TEST_CASE("ranges of arcs by almost nothing, by many turns, and that end near a peak", "[12.22][stability]") {
    Random random(122201);
    for (int i = 0; i < cases(20'000); ++i) {
        const Real size = random.magnitude(-100, 100), part = random.magnitude(-20, 20);
        const Real sign_x = random.sign(), sign_y = random.sign();
        const Real x = random.index(8) == 0 ? 0 : sign_x * size;
        const Real y = random.index(8) == 0 ? 0 : sign_y * size * part;
        Real angle = some_spin(random).angle;
        if (i % 3 == 0) angle = (std::atan2(y, x) + static_cast<Real>(random.index(5)) * pi) * random.nudge();
        INFO(x << "·cos θ + " << y << "·sin θ for θ from 0 to " << angle << ": the least, then the greatest");
        const Interval range = arc_range(x, y, angle);
        const Long bound = gamma(16) * (std::abs(x) + std::abs(y));
        // The range contains the ends, and each extreme that is surely on the way; it is no wider than that.
        const Long radius = std::sqrt(Long(x) * x + Long(y) * y), whole = 2 * std::numbers::pi_v<Long>;
        const Long first = std::atan2(Long(y), Long(x)),
                   end = x * std::cos(Long(angle)) + y * std::sin(Long(angle));
        const Long from = std::min<Long>(angle, 0), to = std::max<Long>(angle, 0);
        const auto met = [&](Long one, Long early) {
            return std::floor((to + early - one) / whole) >= std::ceil((from - early - one) / whole);
        };
        const auto expect = [&](Real answer, Long outer, Long at_ends, Long one) {
            // Within this of a peak the height differs by less than the bound.
            const bool surely = met(one, -1e-9L), perhaps = met(one, 1e-9L);
            const Long expected = perhaps ? outer : at_ends;
            INFO(answer << ", expected " << static_cast<Real>(expected) << " +- "
                        << static_cast<Real>(bound));
            if (surely || !perhaps) CHECK(test::long_near(answer, expected, bound));
            if (perhaps && !surely)
                CHECK((test::long_near(answer, outer, bound) || test::long_near(answer, at_ends, bound)));
        };
        expect(range.min, -radius, std::min<Long>(x, end), first + whole / 2);
        expect(range.max, radius, std::max<Long>(x, end), first);
    }
}

TEST_CASE("bounds of turns of all kinds contain the corners, and hardly more", "[12.22][stability]") {
    Random random(122202);
    for (int i = 0; i < cases(4'000); ++i) {
        const Spin spin = some_spin(random);
        const Vec3 one = some_place(random, spin.center), offset = of_all_sizes(random, -20, 20);
        const Bounds box{one, i % 4 == 0 ? one : one + glm::abs(offset)};
        const Bounds all = bounds_while_turning(box, spin);
        INFO("the " << box << ", a " << spin << ": a " << all);
        const Vec3 reach = glm::max(glm::abs(box.low - spin.center), glm::abs(box.high - spin.center));
        const Real r = length(reach), margin = gamma(256) * (length(spin.center) + r);
        for (int axis = 0; axis < 3; ++axis) {
            // The farthest out that any corner's coordinate gets: at peaks that are at θ or θ + π.
            Long low = infinity, high = -infinity;
            for (int corner = 0; corner < 8; ++corner) {
                const Vec3 p(corner % 2 == 0 ? box.low.x : box.high.x,
                             corner / 2 % 2 == 0 ? box.low.y : box.high.y,
                             corner < 4 ? box.low.z : box.high.z);
                const auto at = [&](Long angle) {
                    return test::long_turned(spin, angle, p)[static_cast<std::size_t>(axis)];
                };
                const Long quarter = std::numbers::pi_v<Long> / 2;
                const Long start = at(0), next = at(quarter), opposite = at(2 * quarter);
                const Long middle = (start + opposite) / 2;
                const Long peak = std::atan2(next - middle, start - middle);
                std::array<Long, 7> angles{0, spin.angle, 0, 0, 0, 0, 0};
                for (std::size_t k = 0; k < 5; ++k) {
                    const Long angle = peak + (static_cast<Long>(k) - 2) * 2 * quarter;
                    const bool passed =
                        spin.angle >= 0 ? angle > 0 && angle < spin.angle : angle < 0 && angle > spin.angle;
                    angles[k + 2] = passed ? angle : 0;
                }
                for (const Long angle : angles)
                    low = std::min(low, at(angle)), high = std::max(high, at(angle));
            }
            INFO("axis " << axis << ": corners from " << static_cast<Real>(low) << " to "
                         << static_cast<Real>(high) << "; at most " << margin << " larger");
            CHECK(all.low[axis] <= low);
            CHECK(all.high[axis] >= high);
            CHECK(all.low[axis] >= low - margin);
            CHECK(all.high[axis] <= high + margin);
        }
    }
}
