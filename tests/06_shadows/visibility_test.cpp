// Steps 06.3 and 06.4: what arrives of the light.
#include "tests/06_shadows/things.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

using namespace rt;
using namespace rt::test;

namespace {

/// From the origin along +x up to `end`.
ShadowRay along_x(Real end) { return {{{0, 0, 0}, {1, 0, 0}}, {0, end}}; }

Thing ball_at(Real x, const Vec3& transmission = Vec3(0)) { return {Sphere{{x, 0, 0}, 0.5}, transmission}; }

}  // namespace

TEST_CASE("nothing between: all the light arrives", "[06.3]") {
    CHECK(visibility(world_of({}), along_x(10)) == Vec3(1));
    CHECK(visibility(world_of({{Sphere{{5, 2, 0}, 1}}}), along_x(10)) == Vec3(1));
}

TEST_CASE("something between: none of it does", "[06.3]") {
    CHECK(visibility(world_of({ball_at(5)}), along_x(10)) == Vec3(0));
    CHECK(visibility(world_of({ball_at(3), ball_at(7)}), along_x(10)) == Vec3(0));
    CHECK(visibility(world_of({ball_at(1e12)}), along_x(infinity)) == Vec3(0));
}

TEST_CASE("what stands behind the lamp, or behind the surface, is not in the way", "[06.3]") {
    CHECK(visibility(world_of({ball_at(11)}), along_x(10)) == Vec3(1));
    CHECK(visibility(world_of({ball_at(-2)}), along_x(10)) == Vec3(1));
    CHECK(visibility(world_of({ball_at(-2), ball_at(11), ball_at(5)}), along_x(10)) == Vec3(0));
}

TEST_CASE("an empty range is never hidden", "[06.3]") {
    CHECK(visibility(world_of({{Sphere{{0, 0, 0}, 1}}}), along_x(0)) == Vec3(1));
}

TEST_CASE("light is multiplied by the transmission where it enters and where it leaves", "[06.4]") {
    const World world = world_of({ball_at(5, {0.5, 1, 0.25})});
    CHECK(colored_visibility(world, along_x(10)) == Vec3(0.25, 1, 0.0625));
}

TEST_CASE("a lamp inside of a ball has one wall to cross, one before it none", "[06.4]") {
    const World world = world_of({ball_at(5, {0.5, 1, 0.25})});
    CHECK(colored_visibility(world, along_x(5)) == Vec3(0.5, 1, 0.25));
    CHECK(colored_visibility(world, along_x(4)) == Vec3(1));
}

TEST_CASE("several things multiply, in whatever order the file has them", "[06.4]") {
    const Thing red = ball_at(3, {1, 0.5, 0.5}), blue = ball_at(6, {0.25, 0.5, 1});
    CHECK(colored_visibility(world_of({red, blue}), along_x(10)) == Vec3(0.0625, 0.0625, 0.25));
    CHECK(colored_visibility(world_of({blue, red}), along_x(10)) == Vec3(0.0625, 0.0625, 0.25));
    CHECK(colored_visibility(world_of({blue, red}), along_x(4.5)) == Vec3(1, 0.25, 0.25));
}

TEST_CASE("behind anything opaque it is dark, wherever that stands", "[06.4]") {
    const Thing glass = ball_at(3, {1, 0.5, 0.5}), wall = ball_at(6);
    CHECK(colored_visibility(world_of({glass, wall}), along_x(10)) == Vec3(0));
    CHECK(colored_visibility(world_of({wall, glass}), along_x(10)) == Vec3(0));
    CHECK(colored_visibility(world_of({glass, wall}), along_x(5)) == Vec3(1, 0.25, 0.25));
}

TEST_CASE("filters without a common colour let nothing through", "[06.4]") {
    const World world = world_of({ball_at(3, {1, 0, 0}), ball_at(6, {0, 1, 1})});
    CHECK(colored_visibility(world, along_x(10)) == Vec3(0));
}

TEST_CASE("of sheets in exactly the same place each counts, in whatever order the file has them", "[06.4]") {
    const Plane wall{{2, 0, 0}, {1, 0, 0}}, farther{{3, 0, 0}, {1, 0, 0}};
    const Thing half{wall, Vec3(0.5)}, quarter{wall, Vec3(0.25)}, opaque{wall, Vec3(0)};
    const Thing behind{farther, {1, 0.5, 1}};
    CHECK(colored_visibility(world_of({half, quarter}), along_x(10)) == Vec3(0.125));
    CHECK(colored_visibility(world_of({half, half, half}), along_x(10)) == Vec3(0.125));
    CHECK(colored_visibility(world_of({half, behind, quarter}), along_x(10)) == Vec3(0.125, 0.0625, 0.125));
    CHECK(colored_visibility(world_of({half, opaque}), along_x(10)) == Vec3(0));
    CHECK(colored_visibility(world_of({opaque, half}), along_x(10)) == Vec3(0));
    CHECK(colored_visibility(world_of({half, quarter}), along_x(2)) == Vec3(0.125));
    CHECK(colored_visibility(world_of({half, quarter}), along_x(1.5)) == Vec3(1));
}

TEST_CASE("two balls in the same place filter on both sides", "[06.4]") {
    const World world = world_of({ball_at(5, {0.5, 1, 0.5}), ball_at(5, {0.5, 0.25, 1})});
    CHECK(colored_visibility(world, along_x(10)) == Vec3(0.0625, 0.0625, 0.25));
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
        INFO(show(shadow));
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
    CHECK(part.x == 1);
    CHECK(part.y == 0x1p-100);
    CHECK(std::abs(part.z - std::pow(0.99, 100)) <= 1e-13);
}
