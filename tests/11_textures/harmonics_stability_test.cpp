// Step 11.6 in extreme cases: pictures of any shape, and light of any size.
#include "chapters/11_textures/harmonics.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::Random;

TEST_CASE("one bright pixel of a picture of any shape", "[11.6][stability]") {
    Random random(1196);
    for (int i = 0; i < cases(2000); ++i) {
        const int width = 1 + static_cast<int>(random.index(40)),
                  height = 1 + static_cast<int>(random.index(300));
        const int x = static_cast<int>(random.index(static_cast<std::size_t>(width)));
        const int y =
            random.index(3) == 0 ? 0 : static_cast<int>(random.index(static_cast<std::size_t>(height)));
        const Real radiance = random.magnitude(-200, 200);
        Image picture = make_image(width, height);
        pixel(picture, x, y) = Vec3(radiance);
        const SkyLight light = projected(picture);
        // From above: cos a − cos b = 2 sin((a + b)/2) sin((b − a)/2), which subtracts nothing.
        const Real down = pi * (2 * y + 1) / (2 * height), around = pi * (2 * x + 1) / width;
        const Real angle = 4 * pi / width * std::sin(down) * std::sin(pi / (2 * height));
        const Vec3 d{std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around)};
        INFO("pixel (" << x << ", " << y << ") of " << width << " by " << height << ", radiance "
                       << radiance);
        // The rows' sines are each off by 2u; the light's unit is the radiance here.
        const Real lit = radiance * angle, bound = 32 * unit_roundoff * (lit + radiance * 2 * pi / width);
        const Real y0 = 1 / std::sqrt(4 * pi), y1 = std::sqrt(3 / (4 * pi));
        CHECK(test::near(light.coefficients[0], Vec3(lit * y0), bound));
        CHECK(test::near(light.coefficients[1], Vec3(lit * y1 * d.y), bound));
        CHECK(test::near(light.coefficients[2], Vec3(lit * y1 * d.z), bound));
        CHECK(test::near(light.coefficients[3], Vec3(lit * y1 * d.x), bound));

        const Vec3 n = random.direction();
        const Real c = dot(n, d), nine = lit * (0.25 + c / 2 + (15 * c * c - 5) / 32);
        INFO("normal " << n << ", cosine " << c);
        CHECK(test::near(irradiance(light, n), Vec3(nine > 0 ? nine : 0), 10 * bound));
    }
}

TEST_CASE("a sky of one colour in a picture of any shape", "[11.6][stability]") {
    Random random(1197);
    for (int i = 0; i < cases(300); ++i) {
        const int width = 1 + static_cast<int>(random.index(100)),
                  height = 1 + static_cast<int>(random.index(100));
        const Real radiance = random.magnitude(-200, 200);
        Image picture = make_image(width, height);
        for (Vec3& color : picture.pixels) color = Vec3(radiance, 0, 2 * radiance);
        INFO("radiance " << radiance << ", picture of " << width << " by " << height << " pixels");
        const Vec3 expected = Vec3(radiance, 0, 2 * radiance) * std::sqrt(4 * pi);
        // (n + 32)u, and as much for the rows' sines.
        const Real bound = 2 * (width * height + 32) * unit_roundoff * 2 * radiance * std::sqrt(4 * pi);
        CHECK(test::near(projected(picture).coefficients[0], expected, bound));
    }
}
