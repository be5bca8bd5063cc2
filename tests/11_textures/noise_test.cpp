// Steps 11.7 and 11.10: Perlin's improved noise, and its gradient.
#include "chapters/11_textures/noise.hpp"
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

// Noise is between -1 and 1 and its gradient of size 3, so their errors are measured in u itself. A value of
// fade, in whichever form, is right to 200u. A weight is a product of three of them, and the eight corners'
// words are at most 2: 8 * 3/4 * 200u * 2 = 2400u. In the gradient fade's derivative, right to 500u and at
// most 15/8, stands in the place of one of the three.
constexpr Real fade_bound = 200 * unit_roundoff;
constexpr Real noise_bound = 2500 * unit_roundoff;
constexpr Real gradient_bound = 25000 * unit_roundoff;

void check_noise(const Vec3& p, Real expected) {
    INFO("noise at " << p);
    CHECK(test::near(noise(p), expected, noise_bound));
}

void check_gradient(const Vec3& p, const Vec3& expected) {
    INFO("gradient of the noise at " << p);
    CHECK(test::near(noise_gradient(p), expected, gradient_bound));
}

void check_cell(const Vec3& p, const std::array<int, 3>& corner, const Vec3& offset) {
    const LatticeCell cell = lattice_cell(p);
    INFO("cell of " << p << ": corner " << cell.corner[0] << ", " << cell.corner[1] << ", " << cell.corner[2]
                    << ", expected " << corner[0] << ", " << corner[1] << ", " << corner[2]);
    CHECK(cell.corner == corner);
    INFO("offset");
    CHECK(test::near(cell.offset, offset, unit_roundoff));
}

struct Known {
    Vec3 p;
    Real value;
    Vec3 gradient;
};

// By Perlin's published program in exact fractions, its derivatives by the rules for sums and products.
const std::vector<Known> known{
    {{-0.09765625, 0.7197265625, -0.09765625},
     -0.34274272986723386,
     {0.8389376933989675, 0.6187611693459399, -0.00961513199792582}},
    {{-0.62890625, -0.05078125, 0.59375},
     -0.2981420058583853,
     {1.3712158164584147, 0.17541466879761325, 0.4505068412772558}},
    {{-0.109375, -0.81640625, 0.26171875},
     0.016103526700944386,
     {0.009613787863381618, -0.5933328617265661, 0.3663640379191615}},
    {{3.8603515625, 1.23046875, 1.19921875},
     0.07446983080579152,
     {0.7022418659685481, 0.3346252084376706, 0.4406395952017098}},
    {{-3.87890625, -3.5, -2.484375},
     -0.2322892345253024,
     {0.2537887655841309, 0.8474793984445714, 0.5595825503948266}},
    {{19.9228515625, -34.73828125, 68.48046875},
     -0.18263198601395328,
     {0.4380637079046324, 1.1198914995041407, 1.2546255260106147}},
    {{-53.2646484375, -0.05078125, -83.00390625},
     0.04741031570790571,
     {0.0033223424658852837, -1.0286675273975208, 0.9990530603786862}},
    {{-133.11328125, 297.421875, 124.6884765625},
     -0.07213554475704431,
     {0.6515356850261944, -1.0228282608016805, -1.1200798223003483}},
    {{154.79296875, -126.578125, 37.890625},
     0.13771715911341995,
     {1.119009413297295, 1.0791644449480622, -0.4881104827651251}},
    {{-199.2021484375, -226.96875, 694.625},
     0.31824200095335275,
     {-0.4701906532015397, 0.4200250676500123, -0.14017488523636581}},
    {{-5729.96875, -600.25390625, -2051.515625},
     0.5451918256710572,
     {0.28987092512109414, -0.9886349805313298, -0.28326114687620707}},
    {{1324.828125, 5570.2197265625, -3262.1396484375},
     0.03287957909795732,
     {0.38779285196144325, 0.5016385636454037, 0.9495515953867072}},
    {{-334828.7490234375, 516081.03125, -730807.06640625},
     0.0216367763097842,
     {-0.1376858138477868, -1.0225176234541522, -0.8173367253218263}},
    {{-797907.375, -70120.3115234375, -644643.75390625},
     0.062338688286866055,
     {-0.27694296839887667, -0.07655101608255782, -1.0224030968590059}},
    {{3.14, 42, 7}, 0.13691995878400012, {0.9171158335999998, -0.9559994111999999, -0.022000294400000054}},
};

}  // namespace

TEST_CASE("fade is 0, 1/2 and 1 at 0, 1/2 and 1", "[11.7]") {
    const auto check_fade = [](Real t, Real expected, Real bound) {
        INFO("6t^5 - 15t^4 + 10t^3 at t = " << t);
        CHECK(test::near(fade(t), expected, bound));
    };
    check_fade(0, 0, 0);
    check_fade(0.5, 0.5, fade_bound);
    check_fade(1, 1, fade_bound);
    check_fade(0.25, 0.103515625, fade_bound);  // 10/64 - 15/256 + 6/1024
}

TEST_CASE("the cell of a point is below it on every axis", "[11.7]") {
    check_cell({1.25, 2.5, 3.75}, {1, 2, 3}, {0.25, 0.5, 0.75});
    check_cell({4, 5, 6}, {4, 5, 6}, {0, 0, 0});
    check_cell({0.5, 255.5, 100}, {0, 255, 100}, {0.5, 0.5, 0});
}

TEST_CASE("cells repeat after 256, also below 0", "[11.7]") {
    check_cell({256.5, 257.25, 1000}, {0, 1, 232}, {0.5, 0.25, 0});
    check_cell({-0.25, -1, -1.25}, {255, 255, 254}, {0.75, 0, 0.75});
    check_cell({-256, -256.5, -512.25}, {0, 255, 255}, {0, 0.5, 0.75});
}

TEST_CASE("noise between two corners is as computed by hand", "[11.7]") {
    // The gradients at 0, 1 and 2 on the x axis are (1, 0, 1), (1, 0, -1) and (-1, -1, 0).
    check_noise({0.25, 0, 0}, 0.146484375);  // 0.896484375 * 1/4 - 0.103515625 * 3/4
    check_noise({0.5, 0, 0}, 0);             // the two cancel
    check_noise({1.5, 0, 0}, 0.5);           // both say 1/2
}

TEST_CASE("noise is 0 at the points of the lattice", "[11.7]") {
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y)
            for (int z = 254; z <= 258; ++z) {
                INFO("noise at " << Vec3(x, y, z));
                CHECK(test::near(noise({x, y, z}), 0, 0));
            }
}

TEST_CASE("noise is that of Perlin's program", "[11.7]") {
    for (const Known& at : known) check_noise(at.p, at.value);
}

TEST_CASE("noise repeats after 256 along each axis", "[11.7]") {
    Random random(11401);
    for (int i = 0; i < cases(2000); ++i) {
        // Sixteenths of a whole number stay what they are when 256 is added.
        const Vec3 p = glm::floor(Real(16 * 300) * random.in_cube()) / Real(16);
        Vec3 shift(0);
        shift[static_cast<int>(random.index(3))] = 256 * random.sign();
        INFO("at " << p << " and at " << p + shift);
        CHECK(test::near(noise(p + shift), noise(p), 2 * noise_bound));
    }
}

TEST_CASE("the gradient at a point of the lattice is the one of the lattice", "[11.10]") {
    check_gradient({0, 0, 0}, {1, 0, 1});
    check_gradient({1, 0, 0}, {1, 0, -1});
    check_gradient({2, 0, 0}, {-1, -1, 0});
    for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j) check_gradient({i, j, 7}, lattice_gradient(i, j, 7));
}

TEST_CASE("the gradient between two corners is as computed by hand", "[11.10]") {
    // With u for fade: (1 - u) * 1 + u * 1 + u' * (-3/4 - 1/4), where u' = 30/256 - 60/64 + 30/16
    // = 1.0546875; along z it is (1 - u) * 1 + u * (-1).
    check_gradient({0.25, 0, 0}, {-0.0546875, 0, 0.79296875});
}

TEST_CASE("the gradient is that of Perlin's noise by exact fractions", "[11.10]") {
    for (const Known& at : known) check_gradient(at.p, at.gradient);
}

TEST_CASE("the gradient is what differences of the noise tend to", "[11.10]") {
    Random random(11402);
    const Real step = 0x1p-17;
    // The third derivatives are at most 60 * 2 * 2 for fade's and less for the others, so the difference is
    // within 240/6 * step^2 of the derivative, but for the noise's own error, divided by 2 * step.
    const Real bound = 40 * step * step + noise_bound / step;
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 p = Real(200) * random.in_cube();
        Vec3 differences(0);
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 before = p, after = p;
            before[axis] -= step, after[axis] += step;
            differences[axis] = (noise(after) - noise(before)) / (after[axis] - before[axis]);
        }
        INFO("gradient of the noise at " << p << ", expected the quotient of differences");
        CHECK(test::near(noise_gradient(p), differences, bound));
    }
}

namespace {

/// Calls `check(before, after, gap)` for points just before and just after the sides of cells.
template <class Check>
void across_sides(std::uint64_t seed, Check check) {
    Random random(seed);
    const Real gap = 0x1p-30;
    for (int i = 0; i < cases(5000); ++i) {
        Vec3 p = Real(100) * random.in_cube();
        const int axis = static_cast<int>(random.index(3));
        p[axis] = std::round(p[axis]);
        Vec3 before = p, after = p;
        before[axis] -= gap, after[axis] += gap;
        INFO("just before and just after the side of a cell at " << p);
        check(before, after, gap);
    }
}

}  // namespace

TEST_CASE("noise goes on smoothly from cell to cell", "[11.7]") {
    across_sides(11403, [](const Vec3& before, const Vec3& after, Real gap) {
        // The gradient is of size 4 at most.
        CHECK(test::near(noise(after), noise(before), 8 * gap + 2 * noise_bound));
    });
}

TEST_CASE("the gradient of the noise goes on smoothly from cell to cell", "[11.10]") {
    across_sides(11404, [](const Vec3& before, const Vec3& after, Real gap) {
        // It changes by 30 a unit at most.
        CHECK(test::near(noise_gradient(after), noise_gradient(before), 60 * gap + 2 * gradient_bound));
    });
}

TEST_CASE("turbulence is the sum of the sizes of the octaves", "[11.7]") {
    const Vec3 p(0.25, 0, 0);
    // Octaves: 0.146484375 at 1/4, 0 at 1/2, 0 at 1, and so on.
    INFO("turbulence at " << p << ", whose first octave is 0.146484375 and the second 0");
    CHECK(test::near(turbulence(p, 0), 0, 0));
    CHECK(test::near(turbulence(p, 1), 0.146484375, noise_bound));
    CHECK(test::near(turbulence(p, 4), 0.146484375, 2 * noise_bound));
}
