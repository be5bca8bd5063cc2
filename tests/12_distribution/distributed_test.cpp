// Steps 12.19 and 12.20: rays that spread, and the tree of rays that ask at random.
#include "chapters/12_distribution/distributed.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/distributed_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <optional>
#include <string>

using namespace rt;
using test::cases;
using test::mean_of_samples;
using test::near;
using test::near_color;
using test::Random;
using test::stream_number;
using test::world_with;

namespace {

Vec2 any_point(Random& random) {
    const Real x = random.uniform(0, 1);
    return {x, random.uniform(0, 1)};
}

/// A floor, seen from above or from below.
const Surface level{.point = Vec3(0), .normal = {0, 1, 0}, .shading_normal = {0, 1, 0}};

/// A branch at 60 degrees from straight up, or from straight down.
Branch slanted(Real side) {
    Branch branch;
    branch.ray = {{1, 2, 3}, {std::sqrt(0.75), 0.5 * side, 0}, 0.25};
    branch.weight = {0.5, 0.25, 0.125};
    branch.depth = 3;
    branch.kind = side > 0 ? RayKind::Reflection : RayKind::Refraction;
    branch.media = {{7, 1}, {4, 2}};
    return branch;
}

/// Straight down onto a floor from a half above it.
const Ray down{{0, 0.5, 0}, {0, -1, 0}};
const Ray forward{{0, 0, 5}, {0, 0, -1}};

Ray at_time(Ray ray, Real time) {
    ray.time = time;
    return ray;
}

/// The radiance for the first numbers of a stream.
Vec3 seen(const World& world, const Ray& ray, int index = 0) {
    Stream stream = stream_number(1220, index);
    return distributed(world, ray, stream);
}

/// Whether the mean of the red channel is `expected`.
void check_mean(const World& world, const Ray& ray, Real expected, int count = cases(20000)) {
    const auto found = mean_of_samples(count, [&](int i) { return seen(world, ray, i).x; });
    INFO("the mean of " << count << " samples of the " << ray << "; the bound is six standard errors");
    CHECK(near(found.value, expected, found.bound));
}

/// How many random numbers one ray uses up.
std::uint32_t numbers_for(const World& world, const Ray& ray) {
    Stream stream = stream_number(1221, 0);
    distributed(world, ray, stream);
    return stream.dimension;
}

/// 1/π times the irradiance of a parallel rectangle of radiance 1 whose corner is straight above, a wide and
/// b deep at the height 1: the view factor that handbooks of heat transfer have.
Real corner_factor(Real a, Real b) {
    const Real p = std::hypot(1, a), q = std::hypot(1, b);
    return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2 * pi);
}

// Square lamps of side 2: one 1 above the floor that shines down, one at z = 9 that shines forward.
const std::string lamp_above = "quadLight -1 1 -1  0 0 2  2 0 0  1 1 1\n";
const std::string lamp_behind = "quadLight -1 -1 9  2 0 0  0 2 0  100 50 25\n";
const std::string matte_thing = "transmission 0 0 0\nspecular 0 0 0\ndiffuse 1 1 1\nsphere 99 0 0  1\n";
const std::string floor_of = "plane 0 0 0  0 1 0\n";

}  // namespace

// 12.19 --------------------------------------------------------------------------------------------------

TEST_CASE("branches spread around their own direction, above and below the surface", "[12.19]") {
    // cos^10⁸ is less than 10⁻²¹ at an angle of 1/1000.
    Random random(12191);
    for (const Real side : {1, -1})
        for (int i = 0; i < cases(200); ++i) {
            const Branch branch = slanted(side);
            const Vec2 numbers = any_point(random);
            const auto turned = spread(branch, level, 1e8, numbers);
            INFO(branch << ", exponent 10^8, random numbers " << numbers);
            REQUIRE(turned.has_value());
            REQUIRE(near(turned->ray.direction, branch.ray.direction, 1e-3));
            REQUIRE(near(length(turned->ray.direction), 1, gamma(16)));
        }
}

TEST_CASE("a spread branch keeps all but its direction", "[12.19]") {
    for (const Real side : {1, -1}) {
        const Branch branch = slanted(side);
        const auto turned = spread(branch, level, 1e8, {0.25, 0.5});
        INFO(branch << ", exponent 10^8: so narrow a lobe does not reach the surface");
        REQUIRE(turned.has_value());
        CHECK(turned->weight == Vec3(0.5, 0.25, 0.125));
        CHECK(turned->depth == 3);
        CHECK(turned->kind == branch.kind);
        CHECK(turned->ray.origin == Vec3(1, 2, 3));
        CHECK(turned->ray.time == 0.25);
        REQUIRE(turned->media.size() == 2);
        CHECK(turned->media[0].object == 7);
        CHECK(turned->media[1].object == 4);
        CHECK(turned->media[1].material == 2);
    }
}

TEST_CASE("what would go through the surface is lost, and nothing else", "[12.19]") {
    // Lambert's cosine around an axis 60 degrees from the normal: (1 + cos 60°)/2 of it is above the surface.
    for (const Vec3& normal : {Vec3(0, 1, 0), Vec3(0, -1, 0)})
        for (const Real side : {1, -1}) {
            const Branch branch = slanted(side);
            const Surface surface{.point = Vec3(0), .normal = normal, .shading_normal = normal};
            Random random(12192);
            INFO(branch << ", 60 degrees from the normal " << normal << ", exponent 1: 3 of 4 are kept");
            std::optional<Branch> turned_over;
            const auto kept = mean_of_samples(cases(20000), [&](int) -> Real {
                const auto turned = spread(branch, surface, 1, any_point(random));
                if (turned && !(turned->ray.direction.y * side > 0)) turned_over = turned;
                return turned ? 1 : 0;
            });
            if (turned_over) FAIL("turned to the other side: " << *turned_over);
            CHECK(near(kept.value, 0.75, kept.bound));
        }
}

TEST_CASE("the flat surface decides what is lost, not the shading normal", "[12.19]") {
    // The shading normal leans so far that it would let half of the lobe through and keep out the other half.
    Surface smooth = level;
    smooth.shading_normal = {1, 0, 0};
    Branch up = slanted(1);
    up.ray.direction = {0, 1, 0};
    Random random(12193);
    for (int i = 0; i < cases(200); ++i) {
        const Vec2 numbers = any_point(random);
        INFO(
            "branch straight up, exponent 1: on a level surface with the shading normal (1, 0, 0) nothing is "
            "lost; random numbers "
            << numbers);
        const auto turned = spread(up, smooth, 1, numbers);
        REQUIRE(turned.has_value());
        REQUIRE(turned->ray.direction.y > 0);
    }
}

TEST_CASE("the exponent says how far branches spread", "[12.19]") {
    // The mean cosine of the density (s + 1)/(2 pi)·cos^s is (s + 1)/(s + 2).
    Branch up = slanted(1);
    up.ray.direction = {0, 1, 0};
    for (const Real exponent : {0.5, 1.0, 8.0, 98.0}) {
        Random random(12194);
        const auto cosine = mean_of_samples(cases(20000), [&](int) -> Real {
            const auto turned = spread(up, level, exponent, any_point(random));
            return turned ? turned->ray.direction.y : 0;
        });
        INFO("mean cosine to a branch straight up, exponent " << exponent);
        CHECK(near(cosine.value, (exponent + 1) / (exponent + 2), cosine.bound));
    }
}

// 12.20 --------------------------------------------------------------------------------------------------

TEST_CASE("a lamp shows its radiance, and black from behind", "[12.20]") {
    const World world = world_with(
        "background 9 9 9\ndiffuse 1 1 1\nplane 0 0 -99  0 0 1\n"
        "quadLight -1 -1 0  0 2 0  2 0 0  3 2 1\n");
    const RayCounts before = ray_counts();
    INFO("a lamp that shines (3, 2, 1), seen from its front");
    CHECK(near_color(seen(world, forward), {3, 2, 1}, gamma(8)));
    INFO("the lamp's back");
    CHECK(near_color(seen(world, {{0, 0, -5}, {0, 0, 1}}), Vec3(0), 0));
    INFO("no shadow ray leaves a lamp: the path ends there");
    CHECK(ray_counts().shadow == before.shadow);
    CHECK(numbers_for(world, forward) == 0);
}

TEST_CASE("without anything random it is the radiance of chapter 7", "[12.20]") {
    const World world = world_with(
        "maxdepth 4\nskyGradient .2 .3 .9  .8 .8 .8  .1 .1 .1\n"
        "point 3 5 4  .8 .7 .6\ndirectional -1 2 1  .3 .3 .4\n"
        "diffuse .5 .4 .3\nspecular .3 .3 .3\nshininess 20\nemission .05 0 0\nplane 0 -1 0  0 1 0\n"
        "emission 0 0 0\nsphere -1.5 0 -1  1\n"
        "diffuse 0 0 0\nspecular 0 0 0\ntransmission .9 1 .8\nior 1.5\nfresnel exact\nabsorption .1 0 .2\n"
        "sphere 1 0 0  1\n");
    Random random(12201);
    for (int i = 0; i < cases(500); ++i) {
        const Vec3 origin(random.uniform(-1, 1), random.uniform(-0.5, 1), 5);
        const Vec3 target(random.uniform(-3, 3), random.uniform(-2, 2), 0);
        const Ray ray{origin, normalize(target - origin)};
        const RayCounts start = ray_counts();
        const Vec3 expected = radiance(world, ray);
        const RayCounts middle = ray_counts();
        Stream stream = stream_number(1222, i);
        const Vec3 found = distributed(world, ray, stream);
        const RayCounts end = ray_counts();
        INFO(ray << " into a world without area lights, gloss and motion: first what `radiance` says");
        // At most 31 rays, each with one term of some ten factors, added in any order.
        REQUIRE(near(found, expected, gamma(256) * (1 + max_component(expected))));
        REQUIRE(stream.dimension == 0);
        REQUIRE(end.reflection - middle.reflection == middle.reflection - start.reflection);
        REQUIRE(end.refraction - middle.refraction == middle.refraction - start.refraction);
    }
}

TEST_CASE("glass shows a lamp with the weight of its mirrored ray, and what is behind it", "[12.20]") {
    // Glass mirrors 0.04 straight ahead: 0.04·(100, 50, 25), and 0.96 of the white behind.
    const World world =
        world_with("background 1 1 1\ntransmission 1 1 1\nior 1.5\nfresnel exact\nplane 0 0 0  0 0 1\n" +
                   lamp_behind + matte_thing);
    INFO(
        "glass mirrors 0.04 of a lamp that shines (100, 50, 25), and lets 0.96 of the white behind it "
        "through");
    CHECK(near_color(seen(world, forward), {4.96, 2.96, 1.96}, gamma(128)));
}

TEST_CASE("a lamp in glass that absorbs is dimmed on its way", "[12.20]") {
    const World world = world_with(
        "transmission 1 1 1\nior 1.5\nabsorption .5 1 2\nsphere 0 0 0  3\nsphereLight 0 0 0  1  1 1 1\n" +
        matte_thing);
    INFO(
        "a lamp of radius 1 in a ball of glass of radius 3 that absorbs (0.5, 1, 2): 2 of glass are between");
    CHECK(near_color(seen(world, forward), {std::exp(-1.0), std::exp(-2.0), std::exp(-4.0)}, gamma(128)));
}

TEST_CASE("what moves stands in the light for a part of the time", "[12.20]") {
    // A ball of radius 1, halfway to the lamp, that moves 8 to the right.
    const World world =
        world_with("diffuse 1 1 1\n" + floor_of + "motion 8 0 0\nsphere 0 5 0  1\npoint 0 10 0  1 1 1\n");
    INFO("a floor straight below a ball that is in the way of a lamp at time 0, and goes away");
    for (const Real time : {0.0, 0.0625, 0.25, 0.5}) {
        INFO("at time " << time << ", when it has moved by " << 8 * time << " of its radius");
        CHECK(near_color(seen(world, at_time(down, time)), Vec3(time < 0.125 ? 0 : 1), gamma(64)));
    }
}

TEST_CASE("a mirror shows what moves where it is at the time of the ray", "[12.20]") {
    const World world = world_with(
        "specular 1 1 1\nplane 0 0 0  0 0 1\nspecular 0 0 0\nemission 1 .5 .25\nmotion 8 0 0\n"
        "sphere 0 0 9  1\n");
    for (const Real time : {0.0, 0.0625, 0.5}) {
        INFO("a mirror straight across from a glowing ball of radius 1 that has moved by " << 8 * time);
        CHECK(near_color(seen(world, at_time(forward, time)), time < 0.125 ? Vec3(1, 0.5, 0.25) : Vec3(0),
                         gamma(64)));
    }
}

TEST_CASE("a bar that moves past covers a pixel for a quarter of the time", "[12.20]") {
    // 1 wide, it moves by 4: at x = 2 it comes at time 1/4 and goes at 1/2.
    const World world = world_with("emission 1 1 1\nmotion 4 0 0\nbox 0 -1 0  1 1 1\n");
    const Ray ray{{2, 0, 5}, {0, 0, -1}};
    for (const Real time : {0.1, 0.24, 0.26, 0.4, 0.49, 0.51, 0.9}) {
        INFO("at time " << time << ", of a bar that is there from 1/4 to 1/2");
        CHECK(near_color(seen(world, at_time(ray, time)), Vec3(time > 0.25 && time < 0.5 ? 1 : 0), 0));
    }
    int covered = 0;
    for (int i = 0; i < 64; ++i) covered += seen(world, at_time(ray, (i + 0.5) / 64)).x > 0;
    INFO("of 64 times, one in the middle of each 64th");
    CHECK(covered == 16);
}

TEST_CASE("a floor under a square lamp", "[12.20]") {
    // Four squares of side 1 at the height 1 that meet above the point; about 0.554.
    const World world = world_with("diffuse 1 1 1\n" + floor_of + lamp_above);
    INFO("diffuse 1, radiance 1: four times the factor of a square whose corner is straight above");
    check_mean(world, down, 4 * corner_factor(1, 1));
}

TEST_CASE("an edge hides just the part of a lamp that is behind it", "[12.20]") {
    // A board halfway up, without an end on the left: from below, its edge at x hides the lamp up to 2x.
    for (const char* sampling : {"angle", "area"})
        for (const Real edge : {-0.25, 0.0, 0.25}) {
            const std::string at = std::to_string(edge);
            const World world = world_with(
                "diffuse 1 1 1\n" + floor_of + "vertex -9 .5 -9\nvertex " + at + " .5 -9\nvertex " + at +
                " .5 9\nvertex -9 .5 9\npolygon 0 1 2 3\nlightsampling " + sampling + "\n" + lamp_above);
            const Real to_edge = std::copysign(corner_factor(std::abs(2 * edge), 1), edge);
            const Ray under{{0, 0.25, 0}, {0, -1, 0}};
            INFO("diffuse 1, a lamp of radiance 1 from x = -1 to 1, hidden up to x = "
                 << 2 * edge << "; lightsampling " << sampling);
            check_mean(world, under, 2 * (corner_factor(1, 1) - to_edge), cases(8000));
        }
}

TEST_CASE("a glossy mirror shows the mean over its lobe", "[12.20]") {
    // A white disc that is seen within 60 degrees: 1 - cos^(s+1) of the lobe meets it.
    for (const int exponent : {1, 2}) {
        const World world =
            world_with("specular 1 1 1\ngloss " + std::to_string(exponent) + "\n" + floor_of +
                       "specular 0 0 0\nemission 1 1 1\ndisc 0 1 0  0 1 0  1.7320508075688772\n");
        INFO("a mirror below a white disc in the dark, within 60 degrees; gloss " << exponent);
        check_mean(world, down, 1 - std::pow(0.5, exponent + 1));
    }
}

TEST_CASE("a glossy mirror loses what would go through it", "[12.20]") {
    // As in 12.19: at 60 degrees, with exponent 1, a quarter.
    const World world = world_with("background 1 1 1\nspecular 1 1 1\ngloss 1\n" + floor_of);
    INFO("a mirror with gloss 1 under a white sky, seen at 60 degrees from its normal");
    check_mean(world, {{0, 1, 0}, {std::sqrt(0.75), -0.5, 0}}, 0.75);
}

TEST_CASE("gloss spreads mirrored rays alone, translucency refracted ones alone", "[12.20]") {
    // Clear as air. Below it a small glowing ball, above it another one; the camera looks down between them.
    const std::string balls =
        "emission 1 1 1\ntransmission 0 0 0\nspecular 0 0 0\nsphere 0 -5 0  .0005\nsphere 0 5 0  .0005\n";
    const auto sheet = [&](const std::string& blur) {
        return world_with(blur + "specular .25 .25 .25\ntransmission .5 .5 .5\n" + floor_of + balls);
    };
    for (int i = 0; i < 20; ++i) {
        INFO("sharp both ways: 1/4 of the ball above, 1/2 of the one below");
        CHECK(near(seen(sheet(""), down, i).x, 0.75, gamma(64)));
        INFO("gloss 1: of the ball above hardly ever anything is met, of the one below always");
        CHECK(near(seen(sheet("gloss 1\n"), down, i).x, 0.5, gamma(64)));
        INFO("translucency 1: the other way round");
        CHECK(near(seen(sheet("translucency 1\n"), down, i).x, 0.25, gamma(64)));
    }
}

TEST_CASE("a translucent surface shows the mean over its lobe", "[12.20]") {
    const World world =
        world_with("transmission 1 1 1\ntranslucency 1\n" + floor_of +
                   "transmission 0 0 0\nemission 1 1 1\ndisc 0 -1 0  0 1 0  1.7320508075688772\n");
    INFO("a white disc in the dark, within 60 degrees below a surface with translucency 1");
    check_mean(world, down, 0.75);
}

TEST_CASE("sharp mirrors stay sharp beside glossy ones", "[12.20]") {
    const World world =
        world_with("specular 1 1 1\n" + floor_of +
                   "gloss 1\nsphere 99 0 0  1\nspecular 0 0 0\nemission 1 .5 .25\nsphere 0 5 0  .01\n");
    for (int i = 0; i < 20; ++i) {
        INFO("a small ball straight above a mirror that has no gloss");
        CHECK(near_color(seen(world, down, i), {1, 0.5, 0.25}, gamma(64)));
    }
}

TEST_CASE("each spread branch uses up a random point of its own", "[12.20]") {
    const std::string both = "specular .5 .5 .5\ntransmission .5 .5 .5\n";
    INFO("how many numbers the stream has given for one ray onto one surface; a point is two");
    CHECK(numbers_for(world_with("specular 1 1 1\ngloss 9\n" + floor_of), down) == 2);
    CHECK(numbers_for(world_with(both + "gloss 9\n" + floor_of), down) == 2);
    CHECK(numbers_for(world_with(both + "gloss 9\ntranslucency 9\n" + floor_of), down) == 4);
    CHECK(numbers_for(world_with(both + floor_of), down) == 0);
}

TEST_CASE("mirrored and refracted rays spread independently of each other", "[12.20]") {
    // Discs within 45 degrees on both sides: with exponent 1 either ray meets its own half of the time.
    const World world = world_with(
        "specular .5 .5 .5\ntransmission .5 .5 .5\ngloss 1\ntranslucency 1\n" + floor_of +
        "specular 0 0 0\ntransmission 0 0 0\nemission 1 1 1\ndisc 0 1 0  0 1 0  1\ndisc 0 -1 0  0 1 0  1\n");
    check_mean(world, down, 0.5);
    const int count = cases(20000);
    const auto both = mean_of_samples(count, [&](int i) -> Real { return seen(world, down, i).x > 0.75; });
    INFO("both rays meet a white disc, each of them half of the time: in a quarter of " << count
                                                                                        << " samples");
    CHECK(near(both.value, 0.25, both.bound));
}

TEST_CASE("the same stream gives the same light, another one another", "[12.20]") {
    const World world = world_with("diffuse 1 1 1\n" + floor_of + lamp_above);
    INFO("the light of a floor below a lamp, twice with the same random numbers");
    CHECK(near_color(seen(world, down, 5), seen(world, down, 5), 0));
    INFO("and with others");
    CHECK(seen(world, down, 5) != seen(world, down, 6));
}

TEST_CASE("where a spread ray is lost the others go on", "[12.20]") {
    // At 60 degrees a quarter of the mirrored rays is lost; what goes through is sharp and sees white.
    const World world =
        world_with("background 1 1 1\nspecular .5 .5 .5\ntransmission .5 .5 .5\ngloss 1\n" + floor_of);
    const Ray ray{{0, 1, 0}, {std::sqrt(0.75), -0.5, 0}};
    int lost = 0;
    for (int i = 0; i < 200; ++i) {
        const Real found = seen(world, ray, i).x;
        INFO("half of a white sky through a surface, and half of it mirrored or lost: 1 or 1/2");
        const bool is_lost = found < 0.75;
        REQUIRE(near(found, is_lost ? 0.5 : 1, gamma(64)));
        lost += is_lost;
    }
    // A standard deviation is 6.1.
    INFO("how many of 200 mirrored rays were lost, of which a quarter should be");
    CHECK(near(Real(lost), 50, 37));
}
