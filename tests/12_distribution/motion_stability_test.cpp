// Steps 12.8 and 12.9 on extreme cases: shutters that open in an instant or never stay open, and boxes and
// motions of all sizes.
#include "chapters/12_distribution/motion.hpp"

#include "common/math/error.hpp"
#include "common/math/exact.hpp"
#include "tests/12_distribution/random_vectors.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>

using namespace rt;
using test::cases;
using test::near;
using test::of_all_sizes;
using test::Random;

namespace {

using Long = long double;

Shutter some_shutter(Random& random) {
    Shutter shutter;
    switch (random.index(4)) {
        case 0:  // never open but for a moment
            shutter.opening = random.index(2) == 0 ? random.uniform(0, 1) : random.magnitude(-20, 0);
            shutter.closing = 1 - shutter.opening;
            break;
        case 1:
            shutter.opening = random.magnitude(-310, -0.31);
            shutter.closing = random.magnitude(-310, -0.31);
            break;
        case 2:
            shutter.closing = random.magnitude(-20, 0);
            break;
        default:
            shutter.opening = random.uniform(0, 0.5);
            shutter.closing = random.uniform(0, 0.5);
    }
    if (random.index(2) == 0) std::swap(shutter.opening, shutter.closing);
    return shutter;
}

/// The part of the light that has come in until t: from the trapezoid's rise, its top, and its fall, each
/// from its width and its mean height.
Long light_until(const Shutter& shutter, Real t) {
    const Long o = shutter.opening, c = shutter.closing, fall = 1 - c;
    const Long rise = std::min<Long>(t, o), top = std::clamp<Long>(t, o, fall) - o;
    const Long after = std::max<Long>(t - fall, 0);
    Long light = top;
    if (rise > 0) light += rise * (rise / o) / 2;
    if (after > 0) light += after * (1 + (1 - Long(t)) / c) / 2;
    return light / ((1 + (fall - o)) / 2);
}

Real some_part(Random& random) {
    switch (random.index(4)) {
        case 0:
            return random.magnitude(-310, 0) * 0.999;
        case 1:
            return 1 - random.magnitude(-15.9, 0) * 0.999;
        case 2:
            return random.index(2) == 0 ? 0 : 1 - 0x1p-53;
        default:
            return random.uniform(0, 1);
    }
}

/// Sign of a + b − c, exactly.
int sign_of_rest(Real a, Real b, Real c) {
    ExactSum sum;
    sum.add(a, 1);
    sum.add(b, 1);
    sum.subtract(c, 1);
    return sum.sign();
}

Real stepped(Real x, Real towards, int steps) {
    for (int i = 0; i < steps; ++i) x = std::nextafter(x, towards);
    return x;
}

}  // namespace

TEST_CASE("times of shutters of all kinds, from the first light to the last", "[12.8][stability]") {
    Random random(128001);
    for (int i = 0; i < cases(30'000); ++i) {
        const Shutter shutter = some_shutter(random);
        const Real number = some_part(random), t = shutter_time(shutter, number);
        INFO("a shutter that opens during " << shutter.opening << " and closes during " << shutter.closing
                                            << ", random number " << number << ", time " << t
                                            << "; the light until then");
        CHECK(t >= 0);
        CHECK(t <= 1);
        CHECK(near(static_cast<Real>(light_until(shutter, t)), number, gamma(32)));
    }
}

TEST_CASE("the ray's origin for motions of all sizes, by exact sums", "[12.9][stability]") {
    Random random(129001);
    for (int i = 0; i < cases(10'000); ++i) {
        Ray ray;
        ray.origin = of_all_sizes(random, -100, 100);
        ray.direction = random.magnitude(-20, 20) * random.direction();
        ray.time = some_part(random);
        // Half of them take the origin nearly to 0.
        const Vec3 motion = i % 2 == 0 ? of_all_sizes(random, -100, 100)
                                       : ray.origin / std::max(ray.time, 1e-100) * random.nudge();
        INFO("the " << ray << " at time " << ray.time << ", motion " << motion);
        const Ray seen = seen_while_moving(ray, motion);
        CHECK(seen.direction == ray.direction);
        CHECK(seen.time == ray.time);
        for (int axis = 0; axis < 3; ++axis) {
            // origin − time·motion − seen is between −bound and bound.
            const Real bound = gamma(2) * (std::abs(ray.origin[axis]) + std::abs(motion[axis])) + 1e-320;
            const auto off = [&](Real by) {
                ExactSum sum;
                sum.add(ray.origin[axis], 1);
                sum.subtract(ray.time, motion[axis]);
                sum.subtract(seen.origin[axis], 1);
                sum.add(by, 1);
                return sum.sign();
            };
            INFO("axis " << axis << ", from " << seen.origin[axis] << ", allowed error " << bound);
            CHECK(off(bound) >= 0);
            CHECK(off(-bound) <= 0);
        }
    }
}

TEST_CASE("bounds contain all places, and hardly more, by exact sums", "[12.9][stability]") {
    Random random(129002);
    for (int i = 0; i < cases(10'000); ++i) {
        const Real greatest = i % 4 == 0 ? 308.2 : i % 4 == 1 ? -300 : 10;
        const Vec3 corner = of_all_sizes(random, greatest - 23, greatest);
        const Vec3 other = i % 3 == 0 ? corner : of_all_sizes(random, greatest - 23, greatest);
        const Bounds box{glm::min(corner, other), glm::max(corner, other)};
        const Vec3 motion =
            i % 5 == 0 ? -corner * random.nudge() : of_all_sizes(random, greatest - 23, greatest);
        const Bounds all = bounds_while_moving(box, motion);
        INFO("the " << box << ", motion " << motion << ": a " << all);
        for (int axis = 0; axis < 3; ++axis) {
            INFO("axis " << axis);
            const Real low = box.low[axis], high = box.high[axis], m = motion[axis];
            // At time 0 and at time 1; between them is between.
            CHECK(all.low[axis] <= low);
            CHECK(all.high[axis] >= high);
            if (std::isfinite(all.low[axis])) CHECK(sign_of_rest(low, m, all.low[axis]) >= 0);
            if (std::isfinite(all.high[axis])) CHECK(sign_of_rest(high, m, all.high[axis]) <= 0);
            // Five numbers further in something is outside.
            const Real tight_low = stepped(all.low[axis], infinity, 5);
            const Real tight_high = stepped(all.high[axis], -infinity, 5);
            CHECK(sign_of_rest(low, std::min(m, Real(0)), tight_low) < 0);
            CHECK(sign_of_rest(high, std::max(m, Real(0)), tight_high) > 0);
        }
    }
}
