// How different two pictures look: FLIP against the formulas of its paper, worked out in another way, and
// SSIM.
#include "common/image/flip.hpp"

#include "common/image/color_map.hpp"
#include "common/image/encoding.hpp"
#include "common/image/ssim.hpp"
#include "tests/catch.hpp"
#include "tests/show.hpp"

#include <algorithm>
#include <cmath>

using namespace rt;

namespace {

/// A bright disc before a gradient; in the second picture it stands a pixel farther right, a pixel is black
/// and the right quarter greener.
Image disc(bool second) {
    Image image = make_image(40, 30);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            Vec3 p(6 * x, 8 * y, 128 + 3 * (x - y));
            const int from_middle = x - (second ? 21 : 20);
            if (from_middle * from_middle + (y - 15) * (y - 15) <= 60) p = Vec3(240, 230, 200);
            if (second && x >= 30) p.y = std::min(Real(255), p.y + 10);
            if (second && x == 5 && y == 5) p = Vec3(0);
            for (int c = 0; c < 3; ++c) p[c] = decode(p[c] / 255, Encoding::Srgb);
            pixel(image, x, y) = p;
        }
    return image;
}

/// The red of a picture as grey.
Image grey(Image image) {
    for (Vec3& p : image.pixels) p = Vec3(p.x);
    return image;
}

Image filled(const Vec3& color, int width = 24, int height = 24) {
    Image image = make_image(width, height);
    std::ranges::fill(image.pixels, color);
    return image;
}

Real at(const Channel& channel, int x, int y) {
    return channel.values[static_cast<std::size_t>(y * channel.width + x)];
}

Real greatest(const Channel& channel) { return *std::ranges::max_element(channel.values); }

/// The same in any place of a picture that is alike everywhere.
Real between(const Vec3& a, const Vec3& b) { return at(flip(filled(a), filled(b)), 12, 7); }

}  // namespace

TEST_CASE("FLIP of equal pictures is zero everywhere, also of what no display shows") {
    CHECK(greatest(flip(disc(false), disc(false))) == 0);
    Image wild = filled(Vec3(-1, 7, std::nan("")));
    CHECK(greatest(flip(wild, wild)) == 0);
    CHECK(greatest(flip(wild, filled(Vec3(0, 1, 0)))) == 0);
}

TEST_CASE("FLIP is symmetric, and between 0 and 1") {
    const Channel there = flip(disc(true), disc(false)), back = flip(disc(false), disc(true));
    CHECK(there.values == back.values);
    CHECK(*std::ranges::min_element(there.values) >= 0);
    CHECK(greatest(there) <= 1);
}

TEST_CASE("FLIP of plain colours is what the paper's formulas give by hand") {
    // Green and blue are farther apart than any other two colours, and are 1 by definition. Black and white
    // differ by 100 in L*: 100^0.7 = 25.1189. Green and blue differ by 41.2761, of which 0.4 gets 0.95.
    CHECK(test::near(between({0, 1, 0}, {0, 0, 1}), 1, 1e-12));
    const Real bend = 0.4 * 41.276098412;
    CHECK(test::near(between(Vec3(0), Vec3(1)), 0.95 + 0.05 * (25.118864315 - bend) / (41.276098412 - bend),
                     1e-9));
    CHECK(between(Vec3(0.5), Vec3(0.51)) < between(Vec3(0.5), Vec3(0.52)));
}

TEST_CASE("FLIP is what the authors' own formulas give when they are worked out as they stand") {
    // By NumPy, in double precision, from the formulas of the authors' flip_api.py (version 1.2), with
    // kernels of two dimensions. The value that they publish for their tests is of two photographs, which are
    // not kept here.
    const Channel usual = flip(disc(true), disc(false));
    CHECK(test::near(mean(usual), 0.126026933078, 1e-9));
    CHECK(test::near(at(usual, 28, 12), 0.563975379748, 1e-9));
    CHECK(test::near(at(usual, 20, 15), 0.019463761, 1e-8));
    CHECK(test::near(at(usual, 5, 5), 0.130145827, 1e-8));
    CHECK(test::near(at(usual, 35, 10), 0.152980311, 1e-8));
    const Channel near = flip(disc(true), disc(false), {}, 30);
    CHECK(test::near(mean(near), 0.111400004802, 1e-9));
    CHECK(test::near(at(near, 28, 12), 0.918635506525, 1e-9));
}

TEST_CASE("FLIP sees of a file with 8 bits what is in the file") {
    const Image image = filled(Vec3(0.2)), hardly = filled(Vec3(0.2 + 1e-5));
    CHECK(greatest(flip(image, hardly)) > 0);
    CHECK(greatest(flip(image, hardly, {Encoding::Srgb, true})) == 0);
    // A file of linear numbers is shown as it is: darker.
    const Vec3 shown(decode(0.2, Encoding::Srgb)), also(decode(0.3, Encoding::Srgb));
    CHECK(test::near(mean(flip(image, filled(Vec3(0.3)), {Encoding::Linear, false})), between(shown, also),
                     1e-12));
}

TEST_CASE("SSIM is 1 of equal pictures and what another program gives of others") {
    CHECK(ssim(disc(false), disc(false)) == 1);
    // ssim.js 3.5.0 ('original', without subsampling) rounds brightness to whole numbers: of grey it is one.
    const std::optional<Real> value = ssim(grey(disc(true)), grey(disc(false)), {Encoding::Srgb, true});
    REQUIRE(value.has_value());
    CHECK(test::near(*value, 0.7735842957784371, 1e-9));
    const std::optional<Real> there = ssim(disc(true), disc(false)), back = ssim(disc(false), disc(true));
    REQUIRE(there.has_value());
    CHECK(test::near(*there, *back, 1e-14));
}

TEST_CASE("SSIM of plain pictures is a formula, and of too small ones nothing") {
    const Real a = encode(0.2, Encoding::Srgb), b = encode(0.4, Encoding::Srgb);
    const std::optional<Real> value = ssim(filled(Vec3(0.2)), filled(Vec3(0.4)));
    REQUIRE(value.has_value());
    CHECK(test::near(*value, (2 * a * b + 1e-4) / (a * a + b * b + 1e-4), 1e-9));
    CHECK(ssim(filled(Vec3(0.2), 11, 11), filled(Vec3(0.2), 11, 11)).has_value());
    CHECK_FALSE(ssim(filled(Vec3(0.2), 10, 11), filled(Vec3(0.2), 10, 11)).has_value());
}

TEST_CASE("Magma grows brighter from black on, evenly to the eye") {
    const auto lightness = [](Real value) {  // CIE L*
        const Real y = glm::dot(magma(value), Vec3(0.2126, 0.7152, 0.0722));
        return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
    };
    CHECK(lightness(0) < 1);
    CHECK(
        test::near(lightness(1), 97.3, 1));  // of (0.987053, 0.991438, 0.749504), the last of its 256 colours
    for (int i = 0; i < 16; ++i) {
        INFO("from " << i / 16. << " on");
        const Real step = lightness((i + 1) / 16.) - lightness(i / 16.);
        CHECK(step > 3);
        CHECK(step < 9);
    }
    // The map's colour number 128 of 256, as Matplotlib prints it.
    const Vec3 middle = magma(Real(128) / 255);
    const Real printed[] = {0.716387, 0.214982, 0.475290};
    for (int c = 0; c < 3; ++c) CHECK(test::near(encode(middle[c], Encoding::Srgb), printed[c], 0.01));
    CHECK(magma(std::nan("")) == magma(0));
    CHECK(magma(7) == magma(1));
}
