// Step 11.23: the sun of a sky's picture as a lamp.
#include "chapters/11_textures/sun.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>

using namespace rt;
using test::cases;
using test::near;
using test::near_color;
using test::near_direction;
using test::Random;

namespace {

/// A picture of one colour but for some pixels.
Image sky_of(int width, int height, const Vec3& color) {
    Image image = make_image(width, height);
    for (Vec3& p : image.pixels) p = color;
    return image;
}

/// Solid angle of a pixel in row j: a zone of the unit ball has the area 2π times its height.
Real angle_of(const Image& image, int j) {
    const Real top = std::cos(pi * j / image.height), bottom = std::cos(pi * (j + 1) / image.height);
    return 2 * pi * (top - bottom) / image.width;
}

}  // namespace

TEST_CASE("the sun of the lesson's sky: one pixel of eight", "[11.23]") {
    Image picture = make_image(4, 2);
    pixel(picture, 0, 0) = Vec3(2);
    const SkyAndSun parts = without_sun(picture, 1);
    INFO("black but for the top left pixel of radiance 2, of which 1 stays");
    {
        INFO("the light of the lamp: solid angle pi/2 times radiance 1, over pi");
        CHECK(near_color(parts.light, Vec3(0.5), gamma(64)));
    }
    {
        INFO("the direction to it: the middle of that pixel");
        CHECK(near_direction(parts.to_sun, {0.5, std::sqrt(0.5), 0.5}, gamma(64)));
    }
    INFO("what that pixel still shows");
    CHECK(near_color(pixel(parts.sky, 0, 0), Vec3(1), gamma(8)));
}

TEST_CASE("a sky that is nowhere too bright stays as it is", "[11.23]") {
    const Image picture = sky_of(8, 4, {0.25, 0.5, 1});
    const SkyAndSun parts = without_sun(picture, 1);
    INFO("8 by 4 pixels of (0.25, 0.5, 1), the limit 1");
    {
        INFO("the light of the lamp");
        CHECK(near_color(parts.light, Vec3(0), 0));
    }
    {
        INFO("the direction to a lamp that is none");
        CHECK(near(parts.to_sun, Vec3(0, 1, 0), 0));
    }
    INFO("the pixel in column 3 and row 1");
    CHECK(near_color(pixel(parts.sky, 3, 1), Vec3(0.25, 0.5, 1), 0));
}

TEST_CASE("a pixel beside the pole is a small sun", "[11.23]") {
    // Rows are 30° high: the top one is 1 − cos 30° of the way from pole to equator, in height.
    Image picture = make_image(6, 6);
    pixel(picture, 2, 0) = Vec3(0, 6, 0);
    const SkyAndSun parts = without_sun(picture, 0);
    INFO("6 by 6 pixels, black but for one in the top row, which is (0, 6, 0); the limit 0");
    CHECK(near_color(parts.light, Vec3(0, 2 * (1 - std::sqrt(0.75)), 0), gamma(64)));
}

TEST_CASE("the top row of a sky is above", "[11.23]") {
    Image picture = make_image(4, 2);
    for (int i = 0; i < 4; ++i) pixel(picture, i, 0) = Vec3(3, 2, 1);
    INFO("a bright upper half: the direction to the lamp");
    CHECK(near_direction(without_sun(picture, 0).to_sun, {0, 1, 0}, gamma(64)));
}

TEST_CASE("of two suns the brighter one draws the lamp towards itself", "[11.23]") {
    // At level: middles at longitudes 45° and 135°, three times as much light from the first.
    Image picture = make_image(4, 3);
    pixel(picture, 0, 1) = Vec3(1, 1, 4), pixel(picture, 1, 1) = Vec3(2, 1, 1);
    INFO("4 by 3 pixels, black but for (1, 1, 4) at longitude 45 and (2, 1, 1) at 135 degrees; the limit 1");
    CHECK(near_direction(without_sun(picture, 1).to_sun, Vec3(1, 0, 2) / std::sqrt(5.0), gamma(64)));
}

TEST_CASE("each channel is cut by itself", "[11.23]") {
    Image picture = make_image(4, 2);
    pixel(picture, 2, 1) = Vec3(0.5, 1, 5);
    const SkyAndSun parts = without_sun(picture, 1);
    INFO("black but for one pixel of (0.5, 1, 5), the limit 1");
    {
        INFO("what that pixel still shows");
        CHECK(near_color(pixel(parts.sky, 2, 1), Vec3(0.5, 1, 1), gamma(8)));
    }
    INFO("the light of the lamp");
    CHECK(near_color(parts.light, Vec3(0, 0, 2), gamma(64)));
}

TEST_CASE("no light is lost between sky and lamp", "[11.23]") {
    Random random(11231);
    for (int i = 0; i < cases(300); ++i) {
        const int width = 1 + static_cast<int>(random.index(20));
        Image picture = make_image(width, 1 + static_cast<int>(random.index(20)));
        for (Vec3& p : picture.pixels) p = random.magnitude(-1, 2) * (random.in_cube() + Vec3(1));
        const Real most = random.magnitude(-1, 2);
        const SkyAndSun parts = without_sun(picture, most);
        INFO("a picture of " << picture.width << " by " << picture.height << " pixels, the limit " << most);
        Vec3 before(0), after = pi * parts.light;
        Real brightest = 0, greatest = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                before += angle_of(picture, y) * pixel(picture, x, y);
                after += angle_of(picture, y) * pixel(parts.sky, x, y);
                brightest = std::max(brightest, max_component(pixel(parts.sky, x, y)));
                greatest = std::max(greatest, max_component(pixel(picture, x, y)));
            }
        {
            INFO("the brightest channel that is left");
            CHECK(test::or_say(brightest <= most + gamma(8) * greatest,
                               "the sky is still brighter than the limit"));
        }
        INFO("the light of the picture, and that of sky and lamp together");
        CHECK(near_color(after, before, gamma(4 * width * picture.height + 200) * 4 * pi * 200));
    }
}
