// Steps 12.8 and 12.9: when light comes in, and how a ray sees what moves meanwhile.
#include "chapters/12_distribution/motion.hpp"

#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/chi_square.hpp"
#include "tests/support.hpp"
#include "tests/together.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rt;
using test::cases;
using test::near;
using test::Random;

namespace {

Shutter shutter_of(Real opening, Real closing) {
    Shutter shutter;
    shutter.opening = opening;
    shutter.closing = closing;
    return shutter;
}

void check_time(const Shutter& shutter, Real random, Real expected) {
    INFO("a shutter that opens during " << shutter.opening << " and closes during " << shutter.closing
                                        << ", when the part " << random << " of the light has come in");
    CHECK(near(shutter_time(shutter, random), expected, gamma(64)));
}

void check_seen(const Ray& ray, const Vec3& motion, const Vec3& origin) {
    INFO("the " << ray << " at time " << ray.time << ", motion " << motion);
    const Ray seen = seen_while_moving(ray, motion);
    CHECK(near(seen.origin, origin, gamma(2) * (size_of(ray.origin) + size_of(motion))));
    CHECK(seen.direction == ray.direction);
    CHECK(seen.time == ray.time);
}

/// Whether x is `expected` or one of the next numbers in the direction of `outwards`.
test::Told is_just_beyond(Real x, Real expected, Real outwards) {
    bool found = false;
    Real number = expected;
    for (int i = 0; i <= 4; ++i) {
        found = found || x == number;
        number = std::nextafter(number, outwards);
    }
    return test::or_say(found, test::show(x) + ", expected " + test::show(expected) + " or just beyond");
}

void check_bounds(const Bounds& box, const Vec3& motion, const Bounds& expected) {
    const Bounds all = bounds_while_moving(box, motion);
    INFO("the " << box << ", motion " << motion << ": a " << all << ", expected the " << expected
                << " or next to it, outwards");
    for (int axis = 0; axis < 3; ++axis) {
        INFO("axis " << axis << ", the lower face and then the upper");
        CHECK(is_just_beyond(all.low[axis], expected.low[axis], -infinity));
        CHECK(is_just_beyond(all.high[axis], expected.high[axis], infinity));
    }
}

bool is_inside(const Bounds& box, const Vec3& p, const Vec3& error) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(p[axis] >= box.low[axis] - error[axis] && p[axis] <= box.high[axis] + error[axis]))
            return false;
    return true;
}

}  // namespace

TEST_CASE("a shutter that takes a half to open and a quarter to close, by hand", "[12.8]") {
    // All the light is ¼ + ¼ + ⅛ = ⅝: two fifths come while it opens, two while it is open, one while it
    // closes.
    const Shutter shutter = shutter_of(0.5, 0.25);
    check_time(shutter, 0, 0);
    check_time(shutter, 0.1, 0.25);
    check_time(shutter, 0.4, 0.5);
    check_time(shutter, 0.6, 0.625);
    check_time(shutter, 0.8, 0.75);
    check_time(shutter, 0.95, 0.875);
}

TEST_CASE("a shutter that opens and closes at once sees all times alike", "[12.8]") {
    for (const Real random : {0.0, 0.125, 0.5, 0.75, 0.999}) check_time({}, random, random);
}

TEST_CASE("a shutter that only opens, only closes, or does both in equal halves", "[12.8]") {
    check_time(shutter_of(1, 0), 0, 0);
    check_time(shutter_of(1, 0), 0.25, 0.5);
    check_time(shutter_of(1, 0), 0.81, 0.9);
    check_time(shutter_of(0, 1), 0, 0);
    check_time(shutter_of(0, 1), 0.75, 0.5);
    check_time(shutter_of(0, 1), 0.36, 0.2);
    check_time(shutter_of(0.5, 0.5), 0.125, 0.25);
    check_time(shutter_of(0.5, 0.5), 0.5, 0.5);
    check_time(shutter_of(0.5, 0.5), 0.875, 0.75);
}

TEST_CASE("times come as often as light does", "[12.8]") {
    // 40 classes of equal area under the trapezoid; false alarms once in a million for all shutters together.
    Random random(12801);
    for (const Shutter& shutter : {shutter_of(0, 0), shutter_of(0.5, 0.25), shutter_of(0.3, 0.7),
                                   shutter_of(0, 0.4), shutter_of(0.9, 0)}) {
        const auto open = [&](Real t) {
            const Real rising = shutter.opening > 0 ? t / shutter.opening : 1;
            const Real falling = shutter.closing > 0 ? (1 - t) / shutter.closing : 1;
            return std::min({rising, falling, Real(1)});
        };
        // Summed up in small steps, each from its middle: exact in all but the two that have a bend.
        const int steps = 20'000;
        std::vector<Real> until(steps + 1);
        for (std::size_t k = 0; k < steps; ++k)
            until[k + 1] = until[k] + open((static_cast<Real>(k) + 0.5) / steps);
        std::vector<int> counts(40);
        const auto numbers = test::many(static_cast<std::size_t>(cases(40'000)), random.engine(),
                                        [](Random& own) { return own.uniform(0, 1); });
        const std::vector<Real> times =
            test::answers(numbers, [&](Real number) { return shutter_time(shutter, number); });
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const Real t = times[i];
            if (!(t >= 0 && t <= 1))
                FAIL("a shutter that opens during " << shutter.opening << " and closes during "
                                                    << shutter.closing << ", random number " << numbers[i]
                                                    << ": time " << t);
            const Real at = t * steps, part = at - std::floor(at);
            const auto k = static_cast<std::size_t>(std::min(std::floor(at), Real(steps - 1)));
            const Real light = until[k] + part * (until[k + 1] - until[k]);
            ++counts[static_cast<std::size_t>(std::min(40 * light / until.back(), Real(39)))];
        }
        INFO("a shutter that opens during " << shutter.opening << " and closes during " << shutter.closing
                                            << ", times in 40 classes of equally much light");
        CHECK(test::chi_square(counts) < test::chi_square_limit(counts.size()));
    }
}

TEST_CASE("at time ¼ a thing has moved by a quarter, and its rays come from as far back", "[12.9]") {
    Ray ray{{1, 2, 3}, {0, 0, -1}, 0.25};
    check_seen(ray, {4, 0, 0}, {0, 2, 3});
    check_seen(ray, {0, -8, 2}, {1, 4, 2.5});
    ray.time = 1;
    check_seen(ray, {4, 0, 0}, {-3, 2, 3});
    // A direction of any length stays what it is.
    ray.direction = {0.5, 6, -7};
    check_seen(ray, {4, 1, 1}, {-3, 1, 2});
}

TEST_CASE("at time 0, and without motion, it is the ray itself", "[12.9]") {
    const Ray early{{0.1, 0.2, 0.3}, {1, 2, 3}, 0}, later{{0.1, 0.2, 0.3}, {1, 2, 3}, 0.7};
    {
        INFO("at time 0, a thing that moves by (1e10, -3, 7): the origin of the ray that it sees");
        CHECK(seen_while_moving(early, {1e10, -3, 7}).origin == early.origin);
    }
    INFO("at time 0.7, a thing that does not move: the origin of the ray that it sees");
    CHECK(seen_while_moving(later, {0, 0, 0}).origin == later.origin);
    INFO("and its time");
    CHECK(seen_while_moving(later, {0, 0, 0}).time == 0.7);
}

TEST_CASE("bounds of a box that moves to the right and down, by hand", "[12.9]") {
    const Bounds box{{0, 0, 0}, {1, 2, 3}};
    check_bounds(box, {4, -1, 0}, {{0, -1, 0}, {5, 2, 3}});
    check_bounds(box, {-4, 0.5, 10}, {{-4, 0, 0}, {1, 2.5, 13}});
    check_bounds(box, {0, 0, 0}, box);
    check_bounds({{1, 1, 1}, {1, 1, 1}}, {1, 1, -1}, {{1, 1, 0}, {2, 2, 1}});
}

TEST_CASE("bounds are rounded outwards", "[12.9]") {
    // 1 − 1e-20 is rounded to 1, but a part of the box is below.
    const Bounds box{{1, 1, 1}, {2, 2, 2}};
    const Bounds left = bounds_while_moving(box, Vec3(-1e-20)), right = bounds_while_moving(box, Vec3(1e-20));
    INFO("the " << box << " moved by ∓1e-20 along all axes: " << left << " and " << right);
    for (int axis = 0; axis < 3; ++axis) {
        INFO("axis " << axis);
        CHECK(left.low[axis] < 1);
        CHECK(right.high[axis] > 2);
    }
}

TEST_CASE("empty bounds stay as they are, infinite ones infinite", "[12.9]") {
    const auto same = [](const Bounds& box, const Vec3& motion) {
        const Bounds all = bounds_while_moving(box, motion);
        INFO("the " << box << ", motion " << motion << ": a " << all);
        CHECK(all.low == box.low);
        CHECK(all.high == box.high);
    };
    same({}, {1, -2, 3});
    same({}, {0, 0, 0});
    // Empty along one axis is empty; moved along that axis, it still is.
    same({{0, 3, 0}, {1, 2, 1}}, {1, 5, 1});
    same({{0, 3, 0}, {1, 2, 1}}, {1, -5, 1});
    same({Vec3(-infinity), Vec3(infinity)}, {1, -2, 1e300});
    const Bounds half = bounds_while_moving({{0, 0, -infinity}, {1, infinity, 1}}, {0, -3, 5});
    INFO("a box that is endless upwards and backwards, moved: " << half);
    CHECK(half.high.y == infinity);
    CHECK(half.low.z == -infinity);
    CHECK(near(half.low.y, -3, gamma(8)));
    CHECK(near(half.high.z, 6, gamma(16)));
}

TEST_CASE("what a ray hits of a moving ball is where the ball was, inside the bounds", "[12.9]") {
    Random random(12901);
    for (int i = 0; i < cases(10'000); ++i) {
        const Vec3 center = random.magnitude(-2, 2) * random.in_cube();
        const Vec3 motion = random.magnitude(-3, 3) * random.in_cube();
        const Real radius = random.magnitude(-2, 1);
        // A point of the ball at time 0, where that is at a time, and a ray to it, at t = 1.
        const Vec3 on_ball = center + radius * random.direction();
        Ray ray;
        ray.time = i % 10 == 0 ? 1 : random.uniform(0, 1);
        const Vec3 place = on_ball + ray.time * motion;
        ray.direction = random.magnitude(-1, 2) * random.direction();
        ray.origin = place - ray.direction;
        INFO("a ball around " << center << " of radius " << radius << ", motion " << motion << ", the " << ray
                              << " at time " << ray.time << ", at t = 1");
        const Vec3 rounding =
            gamma(16) * (glm::abs(ray.origin) + glm::abs(ray.direction) + glm::abs(motion) + size_of(center));
        const Ray seen = seen_while_moving(ray, motion);
        for (int axis = 0; axis < 3; ++axis) {
            INFO("axis " << axis);
            CHECK(near(point_at(seen, 1)[axis], on_ball[axis], rounding[axis]));
        }
        const Bounds ball{center - radius, center + radius}, all = bounds_while_moving(ball, motion);
        INFO("the " << all << " around all its places");
        CHECK(is_inside(all, point_at(ray, 1), rounding + gamma(16) * radius));
    }
}
