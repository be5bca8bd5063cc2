// Step 11.6: diffuse light from the sky.
#include "chapters/11_textures/harmonics.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

using namespace rt;
using test::cases;
using test::Random;

namespace {

const Real u = unit_roundoff;
const std::array<std::string, 9> names{"Y00", "Y1-1", "Y10", "Y11", "Y2-2", "Y2-1", "Y20", "Y21", "Y22"};

void check_harmonics(const Vec3& d, const std::array<Real, 9>& expected, Real bound) {
    const std::array<Real, 9> actual = harmonics(d);
    for (std::size_t i = 0; i < 9; ++i) {
        INFO("harmonic " << i << ", which is " << names[i] << ", at " << d);
        CHECK(test::near(actual[i], expected[i], bound));
    }
}

void check_coefficients(const SkyLight& light, const std::array<Vec3, 9>& expected, Real bound) {
    for (std::size_t i = 0; i < 9; ++i) {
        INFO("coefficient " << i << ", which is that of " << names[i]);
        CHECK(test::near(light.coefficients[i], expected[i], bound));
    }
}

/// A sky whose light in the direction d is constant + linear·d + d·(quadratic d), the same in all channels;
/// `quadratic` is symmetric.
struct Polynomial2 {
    Real constant = 0;
    Vec3 linear{0};
    Mat3 quadratic{0};
};

Real light_from(const Polynomial2& sky, const Vec3& d) {
    return sky.constant + dot(sky.linear, d) + dot(d, sky.quadratic * d);
}

Polynomial2 any_sky(Random& random) {
    Polynomial2 sky{random.uniform(-0.5, 0.5), random.in_cube() * Real(0.5), {}};
    const Mat3 any(random.in_cube(), random.in_cube(), random.in_cube());
    sky.quadratic = (any + transpose(any)) * Real(0.25);
    return sky;
}

/// Its coefficients by hand: the constant and the quadratic's mean are a multiple of Y00; of the rest, x² and
/// y² and z² without that mean are multiples of Y20 and Y22, and each product has a harmonic of its own.
std::array<Vec3, 9> coefficients_of(const Polynomial2& sky) {
    const Mat3& q = sky.quadratic;
    const Real mean = (q[0][0] + q[1][1] + q[2][2]) / 3;
    const Real first = std::sqrt(4 * pi / 3), product = std::sqrt(4 * pi / 15);
    return {Vec3((sky.constant + mean) * std::sqrt(4 * pi)),
            Vec3(sky.linear.y * first),
            Vec3(sky.linear.z * first),
            Vec3(sky.linear.x * first),
            Vec3(2 * q[0][1] * product),
            Vec3(2 * q[1][2] * product),
            Vec3((q[2][2] - mean) * std::sqrt(4 * pi / 5)),
            Vec3(2 * q[0][2] * product),
            Vec3((q[0][0] - q[1][1]) * product)};
}

/// ∫ L·(n·ω) dω over the hemisphere around n. With ∫ (n·ω) dω = π, ∫ ω (n·ω) dω = 2π/3 n and
/// ∫ ω_i ω_j (n·ω) dω = π/4 (δ_ij + n_i n_j).
Real exact_irradiance(const Polynomial2& sky, const Vec3& n) {
    const Real trace = sky.quadratic[0][0] + sky.quadratic[1][1] + sky.quadratic[2][2];
    return pi * sky.constant + pi * 2 / 3 * dot(sky.linear, n) + pi * (trace + dot(n, sky.quadratic * n)) / 4;
}

/// A picture that is black but for one pixel.
Image one_pixel(int width, int height, int x, int y, const Vec3& color) {
    Image picture = make_image(width, height);
    pixel(picture, x, y) = color;
    return picture;
}

/// The picture of light(direction), of the pixels' middles.
template <class Light>
Image picture_of(int width, int height, Light light) {
    Image picture = make_image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Real longitude = pi * (2 * x + 1) / width, down = pi * (2 * y + 1) / (2 * height);
            pixel(picture, x, y) = Vec3(light(Vec3(std::sin(down) * std::cos(longitude), std::cos(down),
                                                   std::sin(down) * std::sin(longitude))));
        }
    return picture;
}

}  // namespace

TEST_CASE("the harmonics along the axes, with the paper's numbers", "[11.6]") {
    const Real digits = 1e-6;  // the paper prints six
    check_harmonics({1, 0, 0}, {0.282095, 0, 0, 0.488603, 0, 0, -0.315392, 0, 0.546274}, digits);
    check_harmonics({0, 1, 0}, {0.282095, 0.488603, 0, 0, 0, 0, -0.315392, 0, -0.546274}, digits);
    check_harmonics({0, 0, 1}, {0.282095, 0, 0.488603, 0, 0, 0, 0.630783, 0, 0}, digits);
}

TEST_CASE("the harmonics between the axes", "[11.6]") {
    const Real r = std::sqrt(Real(0.5)), digits = 1e-6;
    check_harmonics({r, r, 0}, {0.282095, 0.345494, 0, 0.345494, 0.546274, 0, -0.315392, 0, 0}, digits);
    check_harmonics({0, -r, r}, {0.282095, -0.345494, 0.345494, 0, 0, -0.546274, 0.157696, 0, -0.273137},
                    digits);
    check_harmonics({r, 0, r}, {0.282095, 0, 0.345494, 0.345494, 0, 0, 0.157696, 0.546274, 0.273137}, digits);
}

TEST_CASE("the squares of a band's harmonics have the same sum in every direction", "[11.6]") {
    Random random(1191);
    for (int i = 0; i < cases(1000); ++i) {
        const Vec3 d = random.direction();
        const std::array<Real, 9> y = harmonics(d);
        const std::array<int, 4> starts{0, 1, 4, 9};
        for (std::size_t band = 0; band < 3; ++band) {
            Real sum = 0;
            for (auto k = static_cast<std::size_t>(starts[band]);
                 k < static_cast<std::size_t>(starts[band + 1]); ++k)
                sum += y[k] * y[k];
            INFO("band " << band << " at " << d
                         << ": the sum of the squares is (2·band + 1)/4π (Unsöld 1927)");
            CHECK(test::near(sum, static_cast<Real>(2 * band + 1) / (4 * pi), 64 * u));
        }
    }
}

TEST_CASE("the integral of two harmonics is 1 if they are the same, and else 0", "[11.6]") {
    // Gauss's three heights and eight longitudes integrate polynomials of degree 5 exactly; these have 4.
    std::array<std::array<Real, 9>, 9> sums{};
    for (const Real height : {-std::sqrt(Real(0.6)), Real(0), std::sqrt(Real(0.6))})
        for (int i = 0; i < 8; ++i) {
            const Real weight = (height == 0 ? 8 : 5) / Real(9) * pi / 4, around = pi / 4 * i + 0.3;
            const Real level = std::sqrt(1 - height * height);
            const std::array<Real, 9> y =
                harmonics({level * std::cos(around), height, level * std::sin(around)});
            for (std::size_t a = 0; a < 9; ++a)
                for (std::size_t b = 0; b < 9; ++b) sums[a][b] += weight * y[a] * y[b];
        }
    for (std::size_t a = 0; a < 9; ++a)
        for (std::size_t b = 0; b < 9; ++b) {
            INFO("the integral of " << names[a] << " times " << names[b]);
            CHECK(test::near(sums[a][b], a == b ? 1.0 : 0.0, 200 * u));
        }
}

TEST_CASE("the lesson's sky: one pixel of eight", "[11.6]") {
    // Upper row, first column: the middle is (½, √½, ½), the solid angle π/2, the radiance 2.
    const SkyLight light = projected(one_pixel(4, 2, 0, 0, Vec3(2, 0, 1)));
    const std::array<Real, 9> y{0.282095, 0.345494,  0.244301, 0.244301, 0.386274,
                                0.386274, -0.078848, 0.273137, -0.136569};
    std::array<Vec3, 9> expected;
    for (std::size_t i = 0; i < 9; ++i) expected[i] = y[i] * pi / 2 * Vec3(2, 0, 1);
    check_coefficients(light, expected, 4e-6);
}

TEST_CASE("the lesson's sky lights a surface that faces it with 17/16 of what it should", "[11.6]") {
    const SkyLight light = projected(one_pixel(4, 2, 0, 0, Vec3(2)));
    const Vec3 d{0.5, std::sqrt(Real(0.5)), 0.5}, sideways{std::sqrt(Real(0.5)), 0, -std::sqrt(Real(0.5))};
    const auto check = [&](const Vec3& normal, Real expected) {
        INFO("light π around (0.5, 0.7071, 0.5), normal " << normal);
        CHECK(test::near_color(irradiance(light, normal), Vec3(expected), 100 * u));
    };
    check(d, 17 * pi / 16);
    check(sideways, 3 * pi / 32);
    check(-d, pi / 16);
}

TEST_CASE("no irradiance is negative", "[11.6]") {
    const SkyLight light = projected(one_pixel(4, 2, 0, 0, Vec3(2, 0, 1)));
    // Where the cosine is -8/15, nine harmonics have their least value, which is negative.
    const Vec3 d{0.5, std::sqrt(Real(0.5)), 0.5}, sideways{std::sqrt(Real(0.5)), 0, -std::sqrt(Real(0.5))};
    const Vec3 normal = -Real(8) / 15 * d + std::sqrt(Real(161)) / 15 * sideways;
    INFO("light around (0.5, 0.7071, 0.5), normal " << normal << ", at 122 degrees from it");
    CHECK(test::near_color(irradiance(light, normal), Vec3(0), 0));
}

TEST_CASE("rows of pixels: the first one is at the top", "[11.6]") {
    // Two rows, one column: the middle of the one pixel is at longitude π and latitude ±π/4, its angle 2π.
    const Real c = 2 * pi * std::sqrt(3 / (8 * pi));
    const SkyLight upper = projected(one_pixel(1, 2, 0, 0, Vec3(1)));
    INFO("one column, two rows; only the upper pixel is bright");
    CHECK(test::near(upper.coefficients[1], Vec3(c), 100 * u));
    CHECK(test::near(upper.coefficients[3], Vec3(-c), 100 * u));
    const SkyLight lower = projected(one_pixel(1, 2, 0, 1, Vec3(1)));
    INFO("one column, two rows; only the lower pixel is bright");
    CHECK(test::near(lower.coefficients[1], Vec3(-c), 100 * u));
}

TEST_CASE("the solid angles of all pixels sum up to that of the sphere", "[11.6]") {
    for (const auto& size : {std::array{1, 1}, {4, 2}, {3, 5}, {16, 8}, {7, 100}}) {
        const SkyLight light = projected(picture_of(size[0], size[1], [](const Vec3&) { return 1; }));
        INFO("a sky of radiance 1, a picture of " << size[0] << " by " << size[1] << " pixels");
        // (n + 32)u of the sum, which is 4π·Y00 = √(4π).
        const Real bound = (size[0] * size[1] + 32) * u * 4;
        CHECK(test::near(light.coefficients[0], Vec3(std::sqrt(4 * pi)), bound));
    }
}

TEST_CASE("a sky of radiance 1 gives pi, and makes a white surface 1", "[11.6]") {
    SkyLight light{};
    light.coefficients[0] = Vec3(1, 0.5, 0) * std::sqrt(4 * pi);
    for (const Vec3& normal : {Vec3(0, 1, 0), Vec3(0.6, 0, 0.8), Vec3(0, 0, -1)}) {
        INFO("radiance (1, 0.5, 0) from everywhere, normal " << normal);
        CHECK(test::near_color(irradiance(light, normal), pi * Vec3(1, 0.5, 0), 64 * u));
        CHECK(test::near(sky_diffuse(light, normal, Vec3(1, 1, 1)), Vec3(1, 0.5, 0), 64 * u));
        CHECK(test::near(sky_diffuse(light, normal, Vec3(0.5, 0.5, 1)), Vec3(0.5, 0.25, 0), 64 * u));
    }
}

TEST_CASE("bright above the horizon and black below it", "[11.6]") {
    // The exact irradiance is π(1 + n.y)/2; nine harmonics give just that.
    SkyLight light{};
    light.coefficients[0] = Vec3(std::sqrt(pi));
    light.coefficients[1] = Vec3(std::sqrt(3 * pi) / 2);
    for (const Vec3& normal : {Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, -0.6, 0.8), Vec3(0, 0.6, -0.8)}) {
        INFO("radiance 1 from above, normal " << normal);
        CHECK(test::near_color(irradiance(light, normal), Vec3(pi * (1 + normal.y) / 2), 200 * u));
    }
    const Image picture = picture_of(8, 16384, [](const Vec3& d) { return d.y > 0 ? 1 : 0; });
    check_coefficients(projected(picture), light.coefficients, 1e-6);
}

TEST_CASE("each band by itself: x, and xy", "[11.6]") {
    // L = 1 + x gives π + 2π/3 n.x, and L = 1 + xy gives π + π/4 n.x n.y.
    const Polynomial2 x{1, {1, 0, 0}, Mat3(0)};
    const auto check_light = [](const char* sky, const SkyLight& light, const Vec3& normal, Real expected) {
        INFO("the light of a sky that shines " << sky << " on a surface with the normal " << normal);
        CHECK(test::near_color(irradiance(light, normal), Vec3(expected), 200 * u));
    };
    const SkyLight of_x{coefficients_of(x)};
    check_light("1 + x", of_x, {1, 0, 0}, 5 * pi / 3);
    check_light("1 + x", of_x, {-0.6, 0.8, 0}, 0.6 * pi);
    const Polynomial2 xy{1, {0, 0, 0}, Mat3(0, 0.5, 0, 0.5, 0, 0, 0, 0, 0)};
    const SkyLight of_xy{coefficients_of(xy)};
    check_light("1 + xy", of_xy, {0.6, 0.8, 0}, 1.12 * pi);
    check_light("1 + xy", of_xy, {0.6, 0, -0.8}, pi);
}

TEST_CASE("skies of degree 2 are exact", "[11.6]") {
    Random random(1192);
    for (int i = 0; i < cases(3000); ++i) {
        const Polynomial2 sky = any_sky(random);
        const Vec3 n = random.direction();
        const Real expected = exact_irradiance(sky, n);
        INFO("L(d) = " << sky.constant << " + " << sky.linear << "·d + d·Qd with Q = " << sky.quadratic
                       << "\nnormal " << n);
        // 32u of the terms, whose sizes sum up to less than 15, and as much for what is expected.
        CHECK(test::near_color(irradiance(SkyLight{coefficients_of(sky)}, n),
                               Vec3(expected > 0 ? expected : 0), 1000 * u));
    }
}

TEST_CASE("the coefficients of a picture of a sky of degree 2", "[11.6]") {
    // Eight columns integrate the products exactly. A row errs by its height squared: over all of them by at
    // most 96π/24·(π/16384)² M, M being the greatest product of light and harmonic. That is less than 3·0.64.
    Random random(1193);
    for (int i = 0; i < cases(30); ++i) {
        const Polynomial2 sky = any_sky(random);
        INFO("L(d) = " << sky.constant << " + " << sky.linear << "·d + d·Qd with Q = " << sky.quadratic);
        const Image picture = picture_of(8, 16384, [&](const Vec3& d) { return light_from(sky, d); });
        check_coefficients(projected(picture), coefficients_of(sky), 1e-6);
    }
}

TEST_CASE("any sky without negative light is right within 3/32 of all its light", "[11.6]") {
    Random random(1194);
    for (int i = 0; i < cases(300); ++i) {
        // Up to eight bright pixels: what each gives is its light times the cosine, if that is positive.
        Image picture = make_image(16, 8);
        const Vec3 n = random.direction();
        Real all = 0, exact = 0;
        for (std::size_t count = 1 + random.index(8); count > 0; --count) {
            const int x = static_cast<int>(random.index(16)), y = static_cast<int>(random.index(8));
            const Real radiance = random.uniform(0, 3);
            pixel(picture, x, y) += Vec3(radiance);
            const Real longitude = pi * (2 * x + 1) / 16, down = pi * (2 * y + 1) / 16;
            const Vec3 d{std::sin(down) * std::cos(longitude), std::cos(down),
                         std::sin(down) * std::sin(longitude)};
            const Real light = radiance * pi / 8 * (std::cos(pi * y / 8) - std::cos(pi * (y + 1) / 8));
            all += light;
            exact += light * std::max(dot(d, n), Real(0));
        }
        INFO("bright pixels with a light of " << all << " in all, normal " << n);
        CHECK(
            test::near_color(irradiance(projected(picture), n), Vec3(exact), (Real(3) / 32 + 500 * u) * all));
    }
}

TEST_CASE("a smooth sky of degree 4, against a sum over the hemisphere", "[11.6]") {
    // L = (1 + b·d)⁴, which is not negative. Of what is beyond degree 2, the cosine takes away degree 3 and
    // leaves π/24 of degree 4; that is less than 3/32 of all the light.
    Random random(1195);
    for (int i = 0; i < cases(100); ++i) {
        const Vec3 b = random.in_cube() / Real(2), n = random.direction();
        const Vec3 s = random.perpendicular_to(n), t = cross(n, s);
        const auto light = [&](const Vec3& d) { return std::pow(1 + dot(b, d), 4); };
        Real sum = 0;
        for (int j = 0; j < 64; ++j)
            for (int k = 0; k < 16; ++k) {
                const Real c = (j + 0.5) / 64, away = std::sqrt(1 - c * c), around = pi / 8 * k;
                sum += c * light(c * n + away * (std::cos(around) * s + std::sin(around) * t)) * pi / 512;
            }
        // ∫ (1 + b·d)⁴ dω = 4π(1 + 2b² + b⁴/5). The fourth degree's harmonic is at most 8/35 b⁴ in size, and
        // its share π/24; the sum over 64 heights and the picture of 1024 rows err by less than 1e-3 of all
        // the light.
        const Real b2 = dot(b, b), all = 4 * pi * (1 + 2 * b2 + b2 * b2 / 5);
        const Real bound = Real(8) / 35 * b2 * b2 * pi / 24 + 1e-3 * all;
        INFO("L(d) = (1 + b·d)⁴ with b = " << b << ", normal " << n);
        CHECK(test::near_color(irradiance(projected(picture_of(16, 1024, light)), n), Vec3(sum), bound));
    }
}

TEST_CASE("the light of skies as scenes have them", "[11.6]") {
    {
        INFO("the first coefficient of a sky that is (0.5, 1, 2) everywhere: that times the root of 4 pi");
        const SkyLight grey = sky_light(ConstantSky{{0.5, 1, 2}});
        CHECK(test::near_color(grey.coefficients[0], Vec3(0.5, 1, 2) * std::sqrt(4 * pi), 1e-10));
    }
    INFO(
        "the first coefficient of a gradient: half of the horizon's colour, a quarter of each of the others");
    const SkyLight gradient = sky_light(GradientSky{{0, 0, 4}, {1, 1, 1}, {0, 2, 0}});
    CHECK(test::near_color(gradient.coefficients[0], Vec3(0.5, 1, 1.5) * std::sqrt(4 * pi), 1e-5));
    INFO("then a sky that is a picture");
    const Image picture = one_pixel(4, 2, 0, 0, Vec3(2));
    const SkyLight shown = sky_light(ImageSky{std::make_shared<const Image>(picture)});
    check_coefficients(shown, projected(picture).coefficients, 1e-13);
}
