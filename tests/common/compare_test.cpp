// The distance between two images: hand-made differences, NaN, sizes.

#include "common/image/compare.hpp"
#include "common/image/file.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <string>

namespace rt {
namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

Image filled(int width, int height, Vec3 colour) {
    Image image = make_image(width, height);
    for (Vec3& p : image.pixels) p = colour;
    return image;
}

TEST_CASE("an image equals itself") {
    test::Random random(1);
    Image image = make_image(7, 5);
    for (Vec3& p : image.pixels) p = 2.0 * random.in_cube();
    const Comparison c = compare(image, image);
    CHECK(c.width == 7);
    CHECK(c.height == 5);
    CHECK(c.max == 0);
    CHECK(c.mean == 0);
    CHECK(c.rmse == 0);
    CHECK(c.psnr == infinity);
    CHECK(c.within[0] == 1);
    CHECK(c.within[255] == 1);
    CHECK(c.within16[0] == 1);
}

TEST_CASE("one channel of one pixel that is one byte off counts as that") {
    // Every byte of the display as decoded from a file, against its neighbour: rounding must not make it two.
    for (int byte = 0; byte < 255; ++byte) {
        const Real low = decode(byte / 255.0, Encoding::Srgb),
                   high = decode((byte + 1) / 255.0, Encoding::Srgb);
        const Image reference = filled(4, 5, Vec3(low));
        Image image = reference;
        pixel(image, 3, 2).y = high;
        CAPTURE(byte);
        for (const Comparison& c : {compare(image, reference), compare(reference, image)}) {
            CHECK(c.within[0] == Approx(19 / 20.0));
            CHECK(c.within[1] == 1);
            CHECK(c.max == high - low);
            CHECK(c.mean == Approx((high - low) / 60));
            CHECK(c.rmse == Approx((high - low) / std::sqrt(60)));
            CHECK(c.psnr == Approx(-20 * std::log10((high - low) / std::sqrt(60))));
            CHECK(c.worst_x == 3);
            CHECK(c.worst_y == 2);
        }
    }
}

TEST_CASE("steps of a 16-bit file are counted exactly") {
    test::Random random(2);
    for (int i = 0; i < test::cases(2000); ++i) {
        const std::size_t a = random.index(65536), n = random.index(256);
        if (n == 0 || a + n > 65535) continue;
        CAPTURE(a, n);
        const Comparison c = compare(filled(1, 1, Vec3(0, 0, static_cast<Real>(a) / 65535)),
                                     filled(1, 1, Vec3(0, 0, static_cast<Real>(a + n) / 65535)));
        CHECK(c.within16[n - 1] == 0);
        CHECK(c.within16[n] == 1);
    }
}

TEST_CASE("within counts pixels by their greatest channel, as the display shows them") {
    const Image reference = filled(4, 1, Vec3(0));
    Image image = reference;
    // Of a display's 255 steps; in linear light they are far smaller than 1/255.
    const auto light = [](Real step) { return decode(step / 255, Encoding::Srgb); };
    image.pixels[1] = {light(1), light(2), 0};
    image.pixels[2] = {light(5), light(5), light(5)};
    image.pixels[3] = {0, 0, 1};
    const Comparison c = compare(image, reference);
    CHECK(c.within[0] == 0.25);
    CHECK(c.within[1] == 0.25);
    CHECK(c.within[2] == 0.5);
    CHECK(c.within[4] == 0.5);
    CHECK(c.within[5] == 0.75);
    CHECK(c.within[254] == 0.75);
    CHECK(c.within[255] == 1);
    CHECK(c.within16[255] == 0.75);  // light(5) · 65535 = 99.5; white is 65535 steps away
    CHECK(c.within16[99] == 0.5);
    CHECK(c.max == 1);
    CHECK(c.shown_max == Approx(1));
    CHECK(c.worst_x == 3);
    // Of light that is bright, steps of a display are larger.
    const Comparison bright = compare(filled(1, 1, Vec3(1)), filled(1, 1, Vec3(light(254))));
    CHECK(bright.shown_max == Approx(1 / Real(255)));
    CHECK(bright.max > 2 / Real(255));
    CHECK(bright.within[1] == 1);
}

TEST_CASE("only all pixels are 100 %") {
    CHECK(percent(1) == "100 %");
    CHECK(percent(0.999999) == "99.99 %");
    CHECK(percent(0.5) == "50.00 %");
    CHECK(percent(0) == "0.00 %");
}

TEST_CASE("8-bit pictures are judged by their 8 bits, in their encoding") {
    // One dark step of a linear file is 12.9 of 255 in sRGB's curve, and still one step of that file.
    Image black = make_image(3, 1), dark = black;
    for (int x = 0; x < 3; ++x) pixel(dark, x, 0) = Vec3(x / Real(255));
    CHECK(compare(dark, black, {Encoding::Linear, true}).within[1] == 2 / Real(3));
    CHECK(compare(dark, black, {Encoding::Linear, true}).within[2] == 1);
    CHECK(compare(dark, black).within[12] == 1 / Real(3));

    // What a file of 8 bits would hold of an exact picture is equal to it, and a step away is one step.
    Image exact = make_image(256, 1), file = exact, beside = exact;
    for (int x = 0; x < 256; ++x) {
        pixel(exact, x, 0) = Vec3(decode((x + (x % 2 == 0 ? 0.49 : -0.49)) / 255, Encoding::Srgb));
        pixel(file, x, 0) = Vec3(decode(x / Real(255), Encoding::Srgb));
        pixel(beside, x, 0) = Vec3(decode((x == 255 ? 254 : x + 1) / Real(255), Encoding::Srgb));
    }
    CHECK(compare(file, exact, {Encoding::Srgb, true}).within[0] == 1);
    CHECK(compare(beside, exact, {Encoding::Srgb, true}).within[0] == 0);
    CHECK(compare(beside, exact, {Encoding::Srgb, true}).within[1] == 1);
}

TEST_CASE("a step and a half is more than one and at most two") {
    const Comparison c = compare(filled(1, 1, Vec3(1.5 / 65535)), filled(1, 1, Vec3(0)));
    CHECK(c.within16[1] == 0);
    CHECK(c.within16[2] == 1);
}

TEST_CASE("NaN on one side is a difference of 1, on both none") {
    const Image black = filled(2, 1, Vec3(0)), white = filled(2, 1, Vec3(1));
    Image broken = black;
    broken.pixels[1].x = nan;
    for (const Comparison& c : {compare(broken, black), compare(black, broken)}) {
        CHECK(c.max == 1);
        CHECK(c.mean == Approx(1 / 6.0));
        CHECK(c.rmse == Approx(1 / std::sqrt(6)));
        CHECK(c.worst_x == 1);
        CHECK(c.within[254] == 0.5);
        CHECK(c.within[255] == 1);
    }
    CHECK(compare(broken, broken).max == 0);
    CHECK(difference(broken, black).pixels[1] == Vec3(1, 0, 0));
    CHECK(difference(white, broken).pixels[1] == Vec3(1, 1, 1));
}

TEST_CASE("values outside [0, 1] count as what the display shows") {
    CHECK(compare(filled(1, 1, Vec3(infinity)), filled(1, 1, Vec3(1.5))).max == 0);
    CHECK(compare(filled(1, 1, Vec3(-infinity)), filled(1, 1, Vec3(0))).max == 0);
    CHECK(compare(filled(1, 1, Vec3(-3)), filled(1, 1, Vec3(7))).max == 1);
}

TEST_CASE("the worst pixel is the first of several") {
    Image image = filled(3, 3, Vec3(0));
    pixel(image, 2, 1) = pixel(image, 0, 2) = Vec3(0.5);
    const Comparison c = compare(image, filled(3, 3, Vec3(0)));
    CHECK(c.worst_x == 2);
    CHECK(c.worst_y == 1);
}

TEST_CASE("images of different sizes are refused with both sizes") {
    const std::string expected =
        "the image has 3 x 2 pixels and the reference 2 x 3; only images of one size can be compared";
    const Image wide = filled(3, 2, Vec3(0)), tall = filled(2, 3, Vec3(0));
    CHECK(test::error_of([&] { compare(wide, tall); }) == expected);
    CHECK(test::error_of([&] { difference(wide, tall); }) == expected);
}

TEST_CASE("the difference image is the absolute difference times the gain") {
    const Image image = filled(2, 2, Vec3(0.25, 0.5, 1)), reference = filled(2, 2, Vec3(0.5, 0.5, 0.75));
    CHECK(difference(image, reference).pixels == filled(2, 2, Vec3(0.25, 0, 0.25)).pixels);
    CHECK(difference(image, reference, 8).pixels == filled(2, 2, Vec3(2, 0, 2)).pixels);
}

}  // namespace
}  // namespace rt
