// Steps 11.7 and 11.10: noise at places where numbers run out of digits.
#include "chapters/11_textures/noise.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <vector>

using namespace rt;
using test::cases;
using test::Random;

namespace {

// As in noise_test.cpp.
constexpr Real noise_bound = 2500 * unit_roundoff;
constexpr Real gradient_bound = 25000 * unit_roundoff;

struct Known {
    Vec3 p;
    Real value;
    Vec3 gradient;
};

// By Perlin's published program in exact fractions.
const std::vector<Known> known{
    {{1073268.875, 1073569.25, 1103525.75},
     -0.21702026529237628,
     {0.6389851095154881, -0.5039635761640966, -1.1526450421661139}},
    {{-1063846.75, -1103725.375, -1048637.5},
     -0.43879324197769165,
     {-0.8712031841278076, -0.0010704994201660156, -0.7305424064397812}},
    {{2147523512.0, 2147511266.3125, 2147535326.1875},
     0.20548365957142778,
     {0.9424522893714311, -0.01888648920430569, 1.1592086554628622}},
    {{-2147489167.25, -2147511598.875, -2147517500.0},
     -0.14063683152198792,
     {0.010158061981201172, -1.3174946308135986, 0.9856094121932983}},
    {{4295010412.5625, 4295017912.125, 4294977032.125},
     0.2532700209370522,
     {0.8741638453747669, -0.39057727155857336, 0.2973623923822579}},
    {{-4294994655.4375, -4294969328.6875, -4295016015.875},
     0.15919182160305567,
     {-0.9396999325230342, 0.48015622247269585, 0.7070993572706813}},
    {{1099511644451.9375, 1099511645567.75, 1099511651739.25},
     -0.26678603170466886,
     {-0.9717677029693732, 1.626307356158577, -0.05227668805491703}},
    {{-1099511668514.4375, -1099511660478.375, -1099511648547.375},
     -0.4556881124274188,
     {-1.5381265361752696, 1.223514095679306, 0.029434639324477985}},
    {{35184372139715.94, 35184372099120.81, 35184372095045.19},
     -0.23934452755081348,
     {0.9263172762075419, 0.32709567445468135, -0.5050114687263263}},
    {{-35184372103125.06, -35184372122278.44, -35184372140161.5},
     -0.19379954300279678,
     {0.36710128822232946, -0.8796795908419881, 1.2988376222984357}},
    {{281474976765813.94, 281474976749117.3, 281474976719670.25},
     0.5000427280169073,
     {-0.571332704721982, 1.116917406430396, 0.3515739064053225}},
    {{-281474976740592.94, -281474976720373.5, -281474976738495.4},
     -0.16859413408383261,
     {0.6754815786844119, -0.8613873990689171, -0.8948388004791923}},
};

}  // namespace

TEST_CASE("noise far from the origin has all its digits", "[11.7][stability]") {
    for (const Known& at : known) {
        INFO("at " << at.p);
        CHECK(test::near(noise(at.p), at.value, noise_bound));
    }
}

TEST_CASE("the gradient of the noise far from the origin has all its digits", "[11.10][stability]") {
    for (const Known& at : known) {
        INFO("at " << at.p);
        CHECK(test::near(noise_gradient(at.p), at.gradient, gradient_bound));
    }
}

TEST_CASE("cells are right for coordinates of every size", "[11.7][stability]") {
    Random random(11411);
    for (int i = 0; i < cases(20000); ++i) {
        const Vec3 p = random.magnitude(-20, 30) * random.in_cube();
        const LatticeCell cell = lattice_cell(p);
        INFO("cell of " << p << ": corner " << cell.corner[0] << ", " << cell.corner[1] << ", "
                        << cell.corner[2] << ", offset " << cell.offset);
        for (int axis = 0; axis < 3; ++axis) {
            const int corner = cell.corner[static_cast<std::size_t>(axis)];
            CHECK((corner >= 0 && corner <= 255));
            CHECK((cell.offset[axis] >= 0 && cell.offset[axis] <= 1));
            // What is left of p, but for turns of 256: fmod is exact.
            const Real left = std::fmod(p[axis] - cell.offset[axis] - corner, Real(256));
            const Real off = std::min(std::abs(left), 256 - std::abs(left));
            // The subtraction above rounds numbers of the size of p + 256.
            CHECK(off <= 4 * unit_roundoff * (std::abs(p[axis]) + 256));
        }
    }
}

namespace {

/// A point so far away that all its coordinates are whole numbers.
Vec3 beyond_2_53(Random& random) {
    const Real x = random.sign(), y = random.sign(), z = random.sign();
    return 0x1p53 / 0.5 * random.magnitude(0, 290) * Vec3(x, y, z);
}

}  // namespace

TEST_CASE("from 2^53 on every point is of the lattice", "[11.7][stability]") {
    Random random(11412);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 p = beyond_2_53(random);
        INFO("noise at " << p);
        CHECK(test::near(noise(p), 0, 0));
    }
}

TEST_CASE("the gradient of the noise is finite from 2^53 on", "[11.10][stability]") {
    Random random(11415);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 p = beyond_2_53(random);
        INFO("gradient of the noise at " << p);
        CHECK(test::is_finite(noise_gradient(p)));
    }
}

TEST_CASE("noise beside the lattice tends to 0 from both sides", "[11.7][stability]") {
    Random random(11413);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 away = random.magnitude(-300, -17) * random.in_cube();
        INFO("noise at " << away);
        CHECK(test::near(noise(away), 0, noise_bound));
    }
}

TEST_CASE("the gradient beside the lattice tends to the lattice's from both sides", "[11.10][stability]") {
    Random random(11416);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 away = random.magnitude(-300, -17) * random.in_cube();
        INFO("gradient of the noise at " << away);
        CHECK(test::near(noise_gradient(away), {1, 0, 1}, gradient_bound));
    }
}

TEST_CASE("turbulence is finite and not negative everywhere", "[11.7][stability]") {
    Random random(11414);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 p = random.magnitude(-300, 307) * random.in_cube();
        const int octaves = static_cast<int>(random.index(20));
        INFO("turbulence of " << octaves << " octaves at " << p << " is " << turbulence(p, octaves));
        CHECK((turbulence(p, octaves) >= 0 && turbulence(p, octaves) < 2.08));
    }
}
