// Steps 11.4 and 11.5: what is seen in a direction of the sky.
#include "chapters/11_textures/sky.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <memory>
#include <string>

using namespace rt;
using test::cases;
using test::Random;

namespace {

const Real u16 = 16 * unit_roundoff;

std::string name(SkyMap map) {
    const char* names[] = {"latitude-longitude", "mirror ball", "angular"};
    return names[static_cast<int>(map)];
}

void check_uv(SkyMap map, const Vec3& direction, const Vec2& expected, Real bound = u16) {
    INFO("where does the " << name(map) << " picture show the direction " << direction << "?");
    CHECK(test::near(sky_uv(map, direction), expected, bound));
}

void check_direction(SkyMap map, const Vec2& uv, const Vec3& expected, Real bound = 120 * unit_roundoff) {
    INFO("which direction does the " << name(map) << " picture show at " << uv << "?");
    const std::optional<Vec3> direction = sky_direction(map, uv);
    REQUIRE(direction.has_value());
    CHECK(test::near(*direction, expected, bound));
}

const Real half_root = 0.70710678118654752;  // √2 / 2
const Vec3 example{-1, std::sqrt(Real(2)), 1};

}  // namespace

TEST_CASE("the lesson's direction on a map of the world", "[11.4]") {
    check_uv(SkyMap::LatitudeLongitude, example, {0.375, 0.75});
}

TEST_CASE("the lesson's direction in a light probe", "[11.4]") {
    check_uv(SkyMap::Angular, example, {0.5 - std::sqrt(1.0 / 27), 0.5 + std::sqrt(2.0 / 27)});
}

TEST_CASE("the lesson's direction on a mirrored ball", "[11.4]") {
    check_uv(SkyMap::MirrorBall, example, {0.5 - std::sqrt(1.0 / 48), 0.5 + std::sqrt(1.0 / 24)});
}

TEST_CASE("level directions go once around the map of the world", "[11.4]") {
    check_uv(SkyMap::LatitudeLongitude, {0, 0, 2}, {0.25, 0.5}, unit_roundoff);
    check_uv(SkyMap::LatitudeLongitude, {-2, 0, 0}, {0.5, 0.5}, unit_roundoff);
    check_uv(SkyMap::LatitudeLongitude, {0, 0, -2}, {0.75, 0.5}, unit_roundoff);
    check_uv(SkyMap::LatitudeLongitude, {1, 0, 1}, {0.125, 0.5});
    check_uv(SkyMap::LatitudeLongitude, {1, 0, -1}, {0.875, 0.5});
}

TEST_CASE("where the map of the world begins it also ends", "[11.4]") {
    const Vec2 uv = sky_uv(SkyMap::LatitudeLongitude, {3, 0, 0});
    INFO("u is " << uv.x << "; 0 and 1 are right");
    CHECK((uv.x == 0 || uv.x == 1));
    CHECK(test::near(uv.y, 0.5, unit_roundoff));
}

TEST_CASE("straight up is the map's top and straight down its bottom, at some u of the picture", "[11.4]") {
    for (const Real y : {5.0, -5.0}) {
        const Vec2 uv = sky_uv(SkyMap::LatitudeLongitude, {0, y, 0});
        INFO("direction (0, " << y << ", 0), uv " << uv);
        CHECK(test::near(uv.y, y > 0 ? 1.0 : 0.0, unit_roundoff));
        CHECK((uv.x >= 0 && uv.x <= 1));
    }
}

TEST_CASE("the middle of a ball's picture is +z, of a light probe -z", "[11.4]") {
    check_uv(SkyMap::MirrorBall, {0, 0, 3}, {0.5, 0.5}, unit_roundoff);
    check_uv(SkyMap::Angular, {0, 0, -3}, {0.5, 0.5}, unit_roundoff);
}

TEST_CASE("the direction that is all around the rim is shown at its right end", "[11.4]") {
    check_uv(SkyMap::MirrorBall, {0, 0, -3}, {1, 0.5}, unit_roundoff);
    check_uv(SkyMap::Angular, {0, 0, 3}, {1, 0.5}, unit_roundoff);
}

TEST_CASE("right, left, up and down in the pictures of discs", "[11.4]") {
    const Real r = half_root / 2;  // sin 45°, in halves of the picture
    check_uv(SkyMap::MirrorBall, {2, 0, 0}, {0.5 + r, 0.5});
    check_uv(SkyMap::MirrorBall, {-2, 0, 0}, {0.5 - r, 0.5});
    check_uv(SkyMap::MirrorBall, {0, 2, 0}, {0.5, 0.5 + r});
    check_uv(SkyMap::MirrorBall, {0, -2, 0}, {0.5, 0.5 - r});
    check_uv(SkyMap::Angular, {2, 0, 0}, {0.75, 0.5}, unit_roundoff);
    check_uv(SkyMap::Angular, {-2, 0, 0}, {0.25, 0.5}, unit_roundoff);
    check_uv(SkyMap::Angular, {0, 2, 0}, {0.5, 0.75}, unit_roundoff);
    check_uv(SkyMap::Angular, {0, -2, 0}, {0.5, 0.25}, unit_roundoff);
}

TEST_CASE("a billionth away from the pole, the middle and the rim", "[11.4]") {
    // Angles so small that tangent, sine and angle are the same number.
    const Real tiny = 1e-9;
    check_uv(SkyMap::LatitudeLongitude, {0, 1, tiny}, {0.25, 1 - tiny / pi});
    check_uv(SkyMap::LatitudeLongitude, {-tiny, -1, 0}, {0.5, tiny / pi});
    check_uv(SkyMap::MirrorBall, {tiny, 0, 1}, {0.5 + tiny / 4, 0.5});
    check_uv(SkyMap::MirrorBall, {0, tiny, -1}, {0.5, 1});
    check_uv(SkyMap::Angular, {0, -tiny, -1}, {0.5, 0.5 - tiny / (2 * pi)});
    check_uv(SkyMap::Angular, {-tiny, 0, 1}, {tiny / (2 * pi), 0.5});
}

TEST_CASE("the directions of a map of the world", "[11.5]") {
    check_direction(SkyMap::LatitudeLongitude, {0, 0.5}, {1, 0, 0});
    check_direction(SkyMap::LatitudeLongitude, {0.25, 0.5}, {0, 0, 1});
    check_direction(SkyMap::LatitudeLongitude, {0.5, 0.5}, {-1, 0, 0});
    check_direction(SkyMap::LatitudeLongitude, {0.3, 1}, {0, 1, 0});
    check_direction(SkyMap::LatitudeLongitude, {0.7, 0}, {0, -1, 0});
    check_direction(SkyMap::LatitudeLongitude, {0.375, 0.75}, example / Real(2));
}

TEST_CASE("the directions of a light probe", "[11.5]") {
    check_direction(SkyMap::Angular, {0.5, 0.5}, {0, 0, -1});
    check_direction(SkyMap::Angular, {0.75, 0.5}, {1, 0, 0});
    check_direction(SkyMap::Angular, {0.5, 0.25}, {0, -1, 0});
    check_direction(SkyMap::Angular, {0.5, 0.625}, {0, half_root, -half_root});
}

TEST_CASE("the directions of a mirrored ball", "[11.5]") {
    check_direction(SkyMap::MirrorBall, {0.5, 0.5}, {0, 0, 1});
    check_direction(SkyMap::MirrorBall, {0.8, 0.5}, {0.96, 0, 0.28});
    check_direction(SkyMap::MirrorBall, {0.5, 0.1}, {0, -0.96, -0.28});
    check_direction(SkyMap::MirrorBall, {0.5 - std::sqrt(1.0 / 48), 0.5 + std::sqrt(1.0 / 24)},
                    example / Real(2));
}

TEST_CASE("outside of the disc there is nothing", "[11.5]") {
    for (const SkyMap map : {SkyMap::MirrorBall, SkyMap::Angular})
        for (const Vec2& uv : {Vec2(0, 0), Vec2(1, 0), Vec2(0.1, 0.9), Vec2(0.8536, 0.8536)}) {
            const std::optional<Vec3> direction = sky_direction(map, uv);
            INFO(name(map) << " picture at " << uv << ", expected nothing, actual " << direction);
            CHECK_FALSE(direction.has_value());
        }
    for (const SkyMap map : {SkyMap::MirrorBall, SkyMap::Angular}) {
        INFO(name(map) << " picture at (0.8535, 0.8535), just inside");
        CHECK(sky_direction(map, {0.8535, 0.8535}).has_value());
    }
}

TEST_CASE("there and back: the place of the direction at a place", "[11.5]") {
    Random random(1181);
    for (int i = 0; i < cases(3000); ++i) {
        const Vec2 uv{random.uniform(0.01, 0.99), random.uniform(0.01, 0.99)};
        for (const SkyMap map : {SkyMap::LatitudeLongitude, SkyMap::MirrorBall, SkyMap::Angular}) {
            const bool in_disc = length(uv - Vec2(0.5)) < 0.49;
            if (map != SkyMap::LatitudeLongitude && !in_disc) continue;
            const std::optional<Vec3> direction = sky_direction(map, uv);
            INFO(name(map) << " picture at " << uv << ", direction " << direction);
            REQUIRE(direction.has_value());
            CHECK(test::near(length(*direction), 1, 8 * unit_roundoff));
            // Both may be 16u off, and the direction 8u in each coordinate. The places here keep away from
            // poles and rims, where that moves them far; it does by at most 8u/(2 sin 0.02π) here.
            CHECK(test::near(sky_uv(map, *direction), uv, 2 * u16 + 64 * unit_roundoff));
        }
    }
}

TEST_CASE("a gradient mixes the horizon's colour with the zenith's or the nadir's by the height", "[11.4]") {
    const GradientSky sky{{0, 0.5, 1}, {1, 1, 1}, {0.5, 0.25, 0}};
    const auto check = [&](const Vec3& direction, const Vec3& expected) {
        INFO("zenith (0, 0.5, 1), horizon (1, 1, 1), nadir (0.5, 0.25, 0); direction " << direction);
        CHECK(test::near(gradient_color(sky, direction), expected, 8 * unit_roundoff));
    };
    check({0, 1, 0}, {0, 0.5, 1});
    check({1, 0, 0}, {1, 1, 1});
    check({0, -1, 0}, {0.5, 0.25, 0});
    check({0.8, 0.6, 0}, {0.4, 0.7, 1});
    check({0, -0.8, 0.6}, {0.6, 0.4, 0.2});
    check({0, 3, 4}, {0.4, 0.7, 1});
    check({0, -8, -6}, {0.6, 0.4, 0.2});
}

TEST_CASE("a direction is turned clockwise, so that the picture turns counterclockwise", "[11.4]") {
    const auto check_turned = [](const Vec3& d, Real degrees, const Vec3& expected) {
        INFO("the direction " << d << " in a sky whose picture is turned by " << degrees << " degrees");
        CHECK(test::near_direction(turned(d, turn_by(radians(degrees))), expected, 4 * unit_roundoff));
    };
    check_turned({1, 2, 3}, 0, {1, 2, 3});
    check_turned({0, 2, -1}, 90, {1, 2, 0});
    check_turned({1, 0, 0}, -90, {0, 0, -1});
    check_turned({1, 0, 0}, 180, {-1, 0, 0});
}

TEST_CASE("the sky's light: one colour, a gradient", "[11.4]") {
    const Sky grey = ConstantSky{{0.5, 0.25, 0.125}};
    {
        INFO("a sky that is (0.5, 0.25, 0.125) everywhere, in the direction (1, 2, 3)");
        CHECK(test::near_color(sky_radiance(grey, {1, 2, 3}), Vec3(0.5, 0.25, 0.125), 0));
    }
    const Sky gradient = GradientSky{{0, 0.5, 1}, {1, 1, 1}, {0.5, 0.25, 0}};
    INFO("a gradient from (1, 1, 1) at the horizon to (0, 0.5, 1) above, in the direction (0, 3, 4)");
    CHECK(test::near_color(sky_radiance(gradient, {0, 3, 4}), Vec3(0.4, 0.7, 1), 8 * unit_roundoff));
}

namespace {

/// Four columns and two rows: red counts the columns from the left, blue is 1 in the upper row.
Image small_picture() {
    Image image = make_image(4, 2);
    for (int x = 0; x < 4; ++x) {
        pixel(image, x, 0) = {Real(x), 0, 1};
        pixel(image, x, 1) = {Real(x), 0, 0};
    }
    return image;
}

void check_seen(SkyMap map, Real degrees, const Vec3& direction, const Vec3& expected) {
    const ImageSky sky{std::make_shared<const Image>(small_picture()), map, turn_by(radians(degrees))};
    INFO("a sky of 4 by 2 pixels, " << name(map) << ", turned by " << degrees
                                    << " degrees; red is the column, "
                                    << "blue the upper row; direction " << direction);
    // The place is 16u off at most, times 4 columns, and colours differ by at most 3 from one to the next.
    CHECK(test::near_color(sky_radiance(sky, direction), expected, 16 * u16));
}

}  // namespace

TEST_CASE("a picture of the sky: between the centres of its pixels, and around", "[11.4]") {
    const SkyMap map = SkyMap::LatitudeLongitude;
    check_seen(map, 0, {1, 0, 1}, {0, 0, 0.5});    // u = ⅛: the middle of the first column
    check_seen(map, 0, {0, 0, 1}, {0.5, 0, 0.5});  // u = ¼: between the first and the second
    check_seen(map, 0, {-1, 0, 1}, {1, 0, 0.5});
    check_seen(map, 0, {1, 0, -1}, {3, 0, 0.5});
    check_seen(map, 0, {1, 0, 0}, {1.5, 0, 0.5});  // between the last and the first
    check_seen(map, 0, {1, std::sqrt(Real(2)), 1}, {0, 0, 1});
    check_seen(map, 0, {1, -std::sqrt(Real(2)), 1}, {0, 0, 0});
    check_seen(map, 0, {1, 10, 1}, {0, 0, 1});  // above the upper row's middle: that row, not the lower one
    check_seen(map, 0, {1, -10, 1}, {0, 0, 0});
}

TEST_CASE("a picture of the sky, turned", "[11.4]") {
    // What was at x + z is at x − z after a quarter turn counterclockwise as seen from above.
    check_seen(SkyMap::LatitudeLongitude, 90, {1, 0, -1}, {0, 0, 0.5});
    check_seen(SkyMap::LatitudeLongitude, 180, {1, 0, 1}, {2, 0, 0.5});
    check_seen(SkyMap::Angular, 90, {0, 0, -1}, {2.5, 0, 0.5});  // looks up x
}

TEST_CASE("pictures of discs do not go around", "[11.4]") {
    check_seen(SkyMap::Angular, 0, {0, 0, -1}, {1.5, 0, 0.5});
    check_seen(SkyMap::Angular, 0, {0, 0, 1}, {3, 0, 0.5});
    check_seen(SkyMap::MirrorBall, 0, {0, 0, -1}, {3, 0, 0.5});
    check_seen(SkyMap::Angular, 0, {0, -1, 0}, {1.5, 0, 0});
}
