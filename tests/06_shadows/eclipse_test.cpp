// Step 06.5, which is optional: how much of a round lamp a round thing hides.
#include "chapters/06_shadows/eclipse.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>

using namespace rt;
using namespace rt::test;

namespace {

void check_eclipse(Real sun, Real moon, Real apart, Real part, Real bound) {
    INFO("a sun of radius " << sun << ", a moon of radius " << moon << ", their centres " << apart
                            << " apart: the part of the sun that is hidden");
    CHECK(near(eclipsed(sun, moon, apart), part, bound));
}

/// The part of the sun's points, on a grid of equal squares, that lie in the moon.
Real counted(Real sun, Real moon, Real apart) {
    constexpr int side = 400;
    int in_sun = 0, in_both = 0;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const Vec2 p = sun * (Vec2(2 * i + 1, 2 * k + 1) / Real(side) - Real(1));
            if (length(p) > sun) continue;
            ++in_sun;
            if (length(p - Vec2(apart, 0)) <= moon) ++in_both;
        }
    return static_cast<Real>(in_both) / in_sun;
}

}  // namespace

TEST_CASE("by hand: equal discs, each through the other's centre, hide 2/3 - sqrt(3)/(2 pi)", "[06.5]") {
    check_eclipse(1, 1, 1, 0.39100222, 1e-8);
    check_eclipse(5, 5, 5, 0.39100222, 1e-8);
}

TEST_CASE("discs of 3 and 4 that are 5 apart: each edge meets the other at a right angle", "[06.5]") {
    // Two sectors, less the kite of the radii: 9·acos(0.6) + 16·acos(0.8) − 12.
    check_eclipse(3, 4, 5, 6.6416747027 / (9 * pi), 1e-8);
    check_eclipse(4, 3, 5, 6.6416747027 / (16 * pi), 1e-8);
}

TEST_CASE("nothing is hidden where the discs are beside each other", "[06.5]") {
    check_eclipse(1, 2, 3.5, 0, 0);
    check_eclipse(2, 1, 100, 0, 0);
    check_eclipse(0.25, 0.5, 0.75, 0, 0);
}

TEST_CASE("a moon at least as large hides all of the sun, a smaller one leaves a ring", "[06.5]") {
    check_eclipse(1, 2, 0.5, 1, 0);
    check_eclipse(1, 1, 0, 1, 0);
    check_eclipse(2, 1, 0, 0.25, 1e-15);
    check_eclipse(4, 1, 2.5, 0.0625, 1e-15);
}

TEST_CASE("more than half of the moon's disc lies in the sun", "[06.5]") {
    // The corners of the lens are beyond the moon's centre: the angle there is greater than a right one.
    check_eclipse(2, 1, 1.5, counted(2, 1, 1.5), 0.003);
    check_eclipse(1, 2, 1.5, counted(1, 2, 1.5), 0.003);
}

TEST_CASE("the part of the sun is what counting points finds", "[06.5]") {
    Random random(65);
    for (int i = 0; i < cases(60); ++i) {
        const Real sun = random.uniform(0.5, 2), moon = random.uniform(0.5, 2);
        const Real apart = random.uniform(0, sun + moon);
        INFO("a sun of radius " << sun << ", a moon of radius " << moon << ", their centres " << apart
                                << " apart: the part of the sun that is hidden");
        REQUIRE(near(eclipsed(sun, moon, apart), counted(sun, moon, apart), 0.004));
    }
}

TEST_CASE("from one end of an eclipse to the other the answer is in [0, 1] and never grows", "[06.5]") {
    Random random(66);
    for (int i = 0; i < cases(2'000); ++i) {
        const Real scale = random.magnitude(-12, 12);
        const Real sun = scale * random.uniform(0.5, 2), moon = scale * random.magnitude(-2, 2);
        Real before = 1;
        for (int k = 0; k <= 40; ++k) {
            const Real apart = (sun + moon) * k / 40;
            const Real part = eclipsed(sun, moon, apart);
            INFO("a sun of radius "
                 << sun << ", a moon of radius " << moon << ", their centres " << apart
                 << " apart: the part that is hidden, in [0, 1] and at most that before it, " << before);
            REQUIRE(part >= 0);
            REQUIRE(part <= before + 1e-7);
            before = part;
        }
    }
}

TEST_CASE("where the discs only just touch, rounding makes neither NaN nor more than all", "[06.5]") {
    Random random(67);
    for (int i = 0; i < cases(5'000); ++i) {
        const Real sun = random.magnitude(-1, 1), moon = random.magnitude(-1, 1);
        const Real outside = sun + moon, inside = std::abs(sun - moon);
        const Real whole = std::min(Real(1), moon / sun * (moon / sun));
        for (int steps = 1; steps <= 3; ++steps) {
            const Real share = 1 - steps * 0x1p-52;
            const auto check = [&](Real apart, Real part) {
                INFO("a sun of radius " << sun << ", a moon of radius " << moon << ", their centres " << apart
                                        << " apart: the part of the sun that is hidden, from 0 to 1");
                const Real hidden = eclipsed(sun, moon, apart);
                REQUIRE(hidden >= 0);
                REQUIRE(hidden <= 1);
                REQUIRE(near(hidden, part, 1e-4));
            };
            check(outside * share, 0);
            check(inside / share, whole);
        }
    }
}
