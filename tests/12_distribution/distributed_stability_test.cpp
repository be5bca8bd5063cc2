// Steps 12.19 and 12.20 in extreme cases: grazing branches, lobes of all widths, and all that is random at
// once.
#include "chapters/12_distribution/distributed.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/distributed_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <array>
#include <cmath>

using namespace rt;
using test::cases;
using test::Random;
using test::stream_number;
using test::world_with;

TEST_CASE("grazing branches and lobes of any width: unit vectors on their side", "[12.19][stability]") {
    constexpr std::array<Real, 7> numbers{0, 1e-300, 1e-9, 0.3, 0.5, 1 - 1e-9, 1 - 0x1p-53};
    Random random(12196);
    int kept = 0;
    for (int i = 0; i < cases(20000); ++i) {
        const Vec3 normal = random.direction(), along = random.perpendicular_to(normal);
        const Real height = random.sign() * random.magnitude(-17, 0);
        Branch branch;
        branch.ray.direction = normalize(along + height * normal);
        const Surface surface{.point = Vec3(0), .normal = normal, .shading_normal = normal};
        const Real exponent = random.index(9) == 0 ? 0 : random.magnitude(-9, 8);
        const Real x = numbers[random.index(7)], y = random.index(2) ? random.uniform(0, 1) : numbers[0];
        INFO(branch << ", normal " << normal << ", exponent " << exponent << ", random numbers "
                    << Vec2(x, y));
        const auto turned = spread(branch, surface, exponent, {x, y});
        if (!turned) continue;
        ++kept;
        const Vec3& found = turned->ray.direction;
        INFO(*turned);
        const bool sound = std::abs(length(found) - 1) <= gamma(16);
        if (!sound) REQUIRE(sound);
        // Two vectors that rounding has turned are on one side, up to that.
        const Real before = dot(branch.ray.direction, normal), after = dot(found, normal);
        const bool one_side = before * after > 0 || std::min(std::abs(before), std::abs(after)) <= gamma(16);
        if (!one_side) REQUIRE(one_side);
    }
    CHECK(kept > test::demanded(cases(20000) / 4, 0));
}

TEST_CASE("with all that is random at once light is a number and not negative", "[12.20][stability]") {
    const World world = world_with(
        "maxdepth 5\nskyGradient .2 .3 .9  .8 .8 .8  .1 .1 .1\nlightchoice one\nlightsamples 2\n"
        "quadLight -1 4 -1  0 0 2  2 0 0  5 4 3\nsphereLight 2 0 2  .25  9 9 9\n"
        "discLight -3 1 0  1 0 0  1  2 2 2\ntriangleLight 3 0 -2  3 2 -2  2 1 -3  7 7 7\n"
        "point 0 9 0  .5 .5 .5\nattenuation 1 0 .1\npoint 1 3 1  1 1 1\n"
        "diffuse .5 .4 .3\nspecular .3 .3 .3\nshininess 20\ngloss 3\nplane 0 -1 0  0 1 0\n"
        "gloss 1000\nmotion 1 .5 -2\nsphere -1.5 0 -1  1\nmotion 0 0 0\n"
        "diffuse 0 0 0\ntransmission .9 1 .8\nior 1.5\nfresnel exact\nabsorption .1 0 .2\ntranslucency 40\n"
        "sphere 1 0 0  1\ngloss 0\ntranslucency 0\nmotion .1 0 .1\nbox -1 -1 1  0 .5 1.5\n");
    Random random(12202);
    for (int i = 0; i < cases(3000); ++i) {
        const Ray ray{3.0 * random.in_cube() + Vec3(0, 2, 0), random.direction(), random.uniform(0, 1)};
        Stream stream = stream_number(1223, i);
        const Vec3 found = distributed(world, ray, stream);
        INFO(ray << " at time " << ray.time << ": " << found);
        const bool sound = test::is_finite(found) && glm::all(glm::greaterThanEqual(found, Vec3(0)));
        if (!sound) REQUIRE(sound);
    }
}
