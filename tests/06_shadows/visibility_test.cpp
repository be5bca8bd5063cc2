// Steps 06.3 and 06.4: what arrives of the light.
#include "tests/06_shadows/things.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

using namespace rt;
using namespace rt::test;

namespace {

/// From the origin along +x up to `end`.
ShadowRay along_x(Real end) { return {{{0, 0, 0}, {1, 0, 0}}, {0, end}}; }

/// What is in the way, in words.
std::string describe(const std::vector<Thing>& things, Real end) {
    std::string text = "a shadow ray from the origin along x as far as " + show(end) + "; in the world:";
    for (const auto& [shape, transmission] : things)
        text += "\n  " + show(shape) + ", transmission " + show(transmission);
    return text + (things.empty() ? " nothing" : "");
}

void check_visible(const std::vector<Thing>& things, Real end, bool visible) {
    INFO(describe(things, end) << "\nthe part of the light that arrives, all or nothing");
    CHECK(near_color(visibility(world_of(things), along_x(end)), Vec3(visible ? 1 : 0), 0));
}

void check_part(const std::vector<Thing>& things, Real end, const Vec3& part) {
    INFO(describe(things, end) << "\nthe part of the light that arrives, by channel");
    CHECK(near_color(colored_visibility(world_of(things), along_x(end)), part, 0));
}

Thing ball_at(Real x, const Vec3& transmission = Vec3(0)) { return {Sphere{{x, 0, 0}, 0.5}, transmission}; }

}  // namespace

TEST_CASE("nothing between: all the light arrives", "[06.3]") {
    check_visible({}, 10, true);
    check_visible({{Sphere{{5, 2, 0}, 1}}}, 10, true);
}

TEST_CASE("something between: none of it does", "[06.3]") {
    check_visible({ball_at(5)}, 10, false);
    check_visible({ball_at(3), ball_at(7)}, 10, false);
    check_visible({ball_at(1e12)}, infinity, false);
}

TEST_CASE("what stands behind the lamp, or behind the surface, is not in the way", "[06.3]") {
    check_visible({ball_at(11)}, 10, true);
    check_visible({ball_at(-2)}, 10, true);
    check_visible({ball_at(-2), ball_at(11), ball_at(5)}, 10, false);
}

TEST_CASE("an empty range is never hidden", "[06.3]") { check_visible({{Sphere{{0, 0, 0}, 1}}}, 0, true); }

TEST_CASE("light is multiplied by the transmission where it enters and where it leaves", "[06.4]") {
    const std::vector<Thing> things = {ball_at(5, {0.5, 1, 0.25})};
    check_part(things, 10, {0.25, 1, 0.0625});
}

TEST_CASE("behind clear glass the rest still counts", "[06.4]") {
    const Thing clear = ball_at(3, Vec3(1)), red = ball_at(6, {1, 0.5, 0.5});
    check_part({clear, red}, 10, {1, 0.25, 0.25});
    check_part({clear, ball_at(6)}, 10, Vec3(0));
}

TEST_CASE("a lamp inside of a ball has one wall to cross, one before it none", "[06.4]") {
    const std::vector<Thing> things = {ball_at(5, {0.5, 1, 0.25})};
    check_part(things, 5, {0.5, 1, 0.25});
    check_part(things, 4, Vec3(1));
}

TEST_CASE("several things multiply, in whatever order the file has them", "[06.4]") {
    const Thing red = ball_at(3, {1, 0.5, 0.5}), blue = ball_at(6, {0.25, 0.5, 1});
    check_part({red, blue}, 10, {0.0625, 0.0625, 0.25});
    check_part({blue, red}, 10, {0.0625, 0.0625, 0.25});
    check_part({blue, red}, 4.5, {1, 0.25, 0.25});
}

TEST_CASE("behind anything opaque it is dark, wherever that stands", "[06.4]") {
    const Thing glass = ball_at(3, {1, 0.5, 0.5}), wall = ball_at(6);
    check_part({glass, wall}, 10, Vec3(0));
    check_part({wall, glass}, 10, Vec3(0));
    check_part({glass, wall}, 5, {1, 0.25, 0.25});
}

TEST_CASE("filters without a common colour let nothing through", "[06.4]") {
    const std::vector<Thing> things = {ball_at(3, {1, 0, 0}), ball_at(6, {0, 1, 1})};
    check_part(things, 10, Vec3(0));
}

TEST_CASE("of sheets in exactly the same place each counts, in whatever order the file has them", "[06.4]") {
    const Plane wall{{2, 0, 0}, {1, 0, 0}}, farther{{3, 0, 0}, {1, 0, 0}};
    const Thing half{wall, Vec3(0.5)}, quarter{wall, Vec3(0.25)}, opaque{wall, Vec3(0)};
    const Thing behind{farther, {1, 0.5, 1}};
    check_part({half, quarter}, 10, Vec3(0.125));
    check_part({half, half, half}, 10, Vec3(0.125));
    check_part({half, behind, quarter}, 10, {0.125, 0.0625, 0.125});
    check_part({half, opaque}, 10, Vec3(0));
    check_part({opaque, half}, 10, Vec3(0));
    check_part({half, quarter}, 2, Vec3(0.125));
    check_part({half, quarter}, 1.5, Vec3(1));
}

TEST_CASE("two balls in the same place filter on both sides", "[06.4]") {
    const std::vector<Thing> things = {ball_at(5, {0.5, 1, 0.5}), ball_at(5, {0.5, 0.25, 1})};
    check_part(things, 10, {0.0625, 0.0625, 0.25});
}

TEST_CASE("where all is opaque, coloured shadows are shadows", "[06.4]") {
    Random random(64);
    std::vector<Thing> things;
    for (int i = 0; i < 20; ++i) things.push_back({Sphere{4.0 * random.in_cube(), random.uniform(0.1, 1)}});
    const World world = world_of(things);
    int hidden = 0;
    for (int i = 0; i < cases(5'000); ++i) {
        const ShadowRay shadow{{4.0 * random.in_cube(), random.direction()}, {0, random.uniform(0, 8)}};
        const Vec3 expected(occluded(world, shadow.ray, shadow.range) ? 0 : 1);
        INFO("20 opaque spheres, a " << shadow << ": expected what `occluded` says");
        REQUIRE(colored_visibility(world, shadow) == expected);
        if (expected == Vec3(0)) ++hidden;
    }
    INFO(hidden << " of the rays were hidden");
    CHECK(hidden > demanded(cases(5'000) / 10, cases(5'000) / 50));
}

TEST_CASE("a hundred panes of glass in a row", "[06.4]") {
    std::vector<Thing> panes;
    for (int i = 0; i < 100; ++i) panes.push_back({Plane{{1.0 + i, 0, 0}, {1, 0, 0}}, {1, 0.5, 0.99}});
    const Vec3 part = colored_visibility(world_of(panes), along_x(infinity));
    INFO("what is left behind 100 panes of transmission (1, 0.5, 0.99): 1, 0.5^100 and 0.99^100");
    CHECK(part.x == 1);
    CHECK(part.y == 0x1p-100);
    CHECK(near(part.z, std::pow(0.99, 100), 1e-13));
}
