// Step 11.14: the footprint of a pixel on a texture, and the mean over it.
#include "chapters/11_textures/footprint.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::Random;

namespace {

std::string text(const Footprint& f) {
    return "footprint of " + test::show(f.dx) + " to the right, " + test::show(f.dy) + " down";
}

void check_same(const Footprint& actual, const Footprint& expected, Real bound) {
    INFO(text(actual) << ", expected a " << text(expected));
    CHECK(test::near(actual.dx, expected.dx, bound));
    CHECK(test::near(actual.dy, expected.dy, bound));
}

/// What the contract promises, and as much again for `trilinear`, of values up to `greatest`.
Real bound(const MipMap& map, const Vec2& uv, Real greatest) {
    const Real size = std::max(map.levels.front().width, map.levels.front().height);
    return gamma(32 + 32) * (64 + (1 + std::abs(uv.x) + std::abs(uv.y)) * size) * greatest;
}

/// A texture whose texel in column i, counted from the left, and in row j, from the bottom, is grey(i, j).
template <class Grey>
MipMap texture(int width, int height, Grey grey) {
    Image image = make_image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) pixel(image, x, y) = Vec3(grey(x, height - 1 - y));
    return mip_map(image);
}

/// Black but for one white column.
MipMap white_column(int width, int height, int column) {
    return texture(width, height, [&](int i, int) { return i == column ? 1.0 : 0.0; });
}

/// The centre of a texel.
Vec2 centre(const MipMap& map, int column, int row) {
    return {(column + 0.5) / map.levels.front().width, (row + 0.5) / map.levels.front().height};
}

void check_grey(const MipMap& map, const Vec2& uv, const Footprint& seen, int most_probes, Real expected) {
    const Vec3 actual = anisotropic(map, uv, seen, Wrap::Repeat, most_probes);
    INFO("texture of " << map.levels.front().width << " x " << map.levels.front().height << " texels at uv "
                       << uv << ", " << text(seen) << ", at most " << most_probes << " probes");
    CHECK(test::near(actual, Vec3(expected), bound(map, uv, 1)));
}

/// A smooth texture without symmetries; the same beyond its edges.
MipMap hills(int width, int height) {
    return texture(width, height, [&](int i, int j) {
        const Real x = 2 * pi * i / width, y = 2 * pi * j / height;
        return 0.5 + 0.2 * std::sin(x + 1) + 0.1 * std::cos(2 * y - x) + 0.1 * std::sin(3 * x + 2 * y);
    });
}

/// What the contract says, by the definition: probes and the parts of their cells that are inside.
Vec3 by_definition(const MipMap& map, const Vec2& uv, Vec2 along, Real major, Real minor, int most_probes) {
    const int odd = most_probes % 2 == 1 ? most_probes : most_probes - 1;
    const Real w = std::max(std::max(minor, major / odd), 1.0), half = std::max(major / w, 1.0) / 2;
    const Vec2 step = w * along / Vec2(map.levels.front().width, map.levels.front().height);
    Vec3 total(0);
    for (Real k = -(odd / 2); k <= odd / 2; ++k) {
        const Real part = std::min(k + 0.5, half) - std::max(k - 0.5, -half);
        if (part > 0) total += part * trilinear(map, uv + k * step, width_of(map, w), Wrap::Repeat);
    }
    return total / (2 * half);
}

/// A footprint with these axes, in texels: of a pixel that is turned by any angle. That changes the two
/// vectors, and not the ellipse.
Footprint turned(const MipMap& map, Vec2 along, Real major, Real minor, Real angle) {
    const Vec2 a = major * along, b = minor * Vec2(-along.y, along.x);
    const Image& finest = map.levels.front();
    const Vec2 texels(finest.width, finest.height);
    const Real s = std::sin(angle), c = std::cos(angle);
    return {(c * a + s * b) / texels, (c * b - s * a) / texels};
}

}  // namespace

TEST_CASE("the footprint of a floor's pixel", "[11.14]") {
    // The floor of the lesson: a pixel is 0.15 wide along z and 0.25 long along x. The texture is 2 wide.
    INFO("du = (2, 0, 0), dv = (0, 0, 2); dp = (0, 0, 0.15) to the right, (-0.25, 0, 0) down");
    check_same(footprint({2, 0, 0}, {0, 0, 2}, {0, 0, 0.15}, {-0.25, 0, 0}), {{0, 0.075}, {-0.125, 0}},
               gamma(32) * 0.125);
}

TEST_CASE("what the point moves off the tangents does not count", "[11.14]") {
    INFO("du = (2, 0, 0), dv = (0, 0, 4); dp = (2, 7, 2) to the right, (0, -9, 0) down");
    check_same(footprint({2, 0, 0}, {0, 0, 4}, {2, 7, 2}, {0, -9, 0}), {{1, 0.5}, {0, 0}}, gamma(32) * 5);
}

TEST_CASE("tangents that are not perpendicular share the way between them", "[11.14]") {
    INFO("du = (1, 0, 0), dv = (1, 1, 0); dp = (0, 1, 0) = dv - du to the right, (3, 2, 0) = du + 2 dv down");
    check_same(footprint({1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {3, 2, 0}), {{-1, 1}, {1, 2}}, gamma(32) * 16);
}

TEST_CASE("where tangents are 0 or parallel the texture has no size, and the footprint is 0", "[11.14]") {
    const Vec3 a(0.3, -0.7, 0.2), zero(0);
    const Vec3 pairs[][2] = {{a, zero}, {zero, a}, {zero, zero}, {a, 2.0 * a}, {-3.0 * a, a}, {a, a / 7.0}};
    for (const auto& pair : pairs) {
        INFO("du = " << pair[0] << ", dv = " << pair[1] << "; dp = (1, 2, 3) and (-1, 0, 2)");
        check_same(footprint(pair[0], pair[1], {1, 2, 3}, {-1, 0, 2}), {}, 0);
    }
}

TEST_CASE("a footprint of 0 sees the texture as sharp as it is", "[11.14]") {
    const MipMap map = texture(8, 8, [](int i, int j) { return (10 * i + j) / 100.0; });
    check_grey(map, centre(map, 4, 2), {}, 16, 0.42);
    check_grey(map, centre(map, 4, 2), {{0.01, 0}, {0, 0.02}}, 16, 0.42);
}

TEST_CASE("three probes, on three columns", "[11.14]") {
    // 3 texels wide and 1 high, on column 4: the probes are 1 texel wide, on columns 3, 4 and 5.
    const MipMap stripes = texture(8, 8, [](int i, int) { return i % 2; });
    INFO("columns are black and white in turn; the middle of the footprint is on a black one");
    check_grey(stripes, centre(stripes, 4, 3), {{3.0 / 8, 0}, {0, 1.0 / 8}}, 16, 2.0 / 3);
    check_grey(stripes, centre(stripes, 4, 3), {{0, 1.0 / 8}, {3.0 / 8, 0}}, 16, 2.0 / 3);
}

TEST_CASE("the outermost probes weigh as much as is inside", "[11.14]") {
    // The white column is two to the right of the middle: of the cell from 1½ to 2½, what is below r/2
    // counts.
    const MipMap map = white_column(8, 8, 6);
    INFO("column 6 is white, the middle of the footprint is on column 4");
    for (const Vec2& length_and_grey :
         {Vec2(3, 0), Vec2(4, 0.5 / 4), Vec2(4.5, 0.75 / 4.5), Vec2(5, 1.0 / 5), Vec2(6, 1.0 / 6)})
        check_grey(map, centre(map, 4, 3), {{length_and_grey.x / 8, 0}, {0, 1.0 / 8}}, 16, length_and_grey.y);
}

TEST_CASE("stripes stay sharp along a long footprint", "[11.14]") {
    const MipMap rows = texture(16, 16, [](int, int j) { return j / 16.0; });
    INFO("every row has another grey; the footprint is 12 texels long and 1 high, on row 5");
    check_grey(rows, centre(rows, 2, 5), {{12.0 / 16, 0}, {0, 1.0 / 16}}, 16, 5.0 / 16);
    check_grey(rows, centre(rows, 2, 5), {{0, -1.0 / 16}, {12.0 / 16, 0}}, 16, 5.0 / 16);
}

TEST_CASE("a square footprint needs one lookup", "[11.14]") {
    // 2 by 2 texels around the common corner of 42, 52, 43 and 53 hundredths: their mean, as on level 1.
    const MipMap map = texture(8, 8, [](int i, int j) { return (10 * i + j) / 100.0; });
    check_grey(map, {5.0 / 8, 3.0 / 8}, {{0.25, 0}, {0, 0.25}}, 16, 0.475);
}

TEST_CASE("a texture may be wider than high: it is texels that count", "[11.14]") {
    // 16 × 4 texels. Three of 16 columns and one of 4 rows are 3 texels by 1, however that looks in uv.
    const MipMap map = white_column(16, 4, 9);
    INFO("column 9 is white, the middle of the footprint is on column 8");
    check_grey(map, centre(map, 8, 1), {{3.0 / 16, 0}, {0, 1.0 / 4}}, 16, 1.0 / 3);
    const MipMap row = texture(16, 4, [](int, int j) { return j == 2 ? 1.0 : 0.0; });
    INFO("row 2 is white, the middle of the footprint is on row 1");
    check_grey(row, centre(row, 8, 1), {{1.0 / 16, 0}, {0, 3.0 / 4}}, 16, 1.0 / 3);
}

TEST_CASE("with one probe the whole length is blurred", "[11.14]") {
    const MipMap map = white_column(8, 8, 4);
    INFO("column 4 is white, the footprint is 8 texels long and 1 high");
    for (const int most_probes : {1, 2})
        check_grey(map, centre(map, 4, 3), {{1, 0}, {0, 1.0 / 8}}, most_probes, 1.0 / 8);
}

TEST_CASE("what is too long for the probes is looked at with wider ones", "[11.14]") {
    // 12 texels with at most 3 or 4 probes: three, 4 texels wide each, which is level 2: columns 0 to 3, 4 to
    // 7 and 8 to 11.
    const MipMap map = texture(16, 16, [](int i, int) {
        return i < 4 ? 0.75 : i < 8 ? 0.0 : i < 12 ? 0.3 : 1.0;
    });
    for (const int most_probes : {3, 4})
        check_grey(map, {6.0 / 16, 6.0 / 16}, {{12.0 / 16, 0}, {0, 1.0 / 16}}, most_probes, 0.35);
}

TEST_CASE("probes lie along the longer axis, whatever its direction", "[11.14]") {
    const MipMap map = hills(32, 32);
    const Vec2 uv = centre(map, 9, 20);
    // 3 texels along (0.6, 0.8), 1 across.
    const Footprint seen{Vec2(1.8, 2.4) / 32.0, Vec2(-0.8, 0.6) / 32.0};
    const auto look = [&](Real i, Real j) {
        return trilinear(map, uv + Vec2(i, j) / 32.0, width_of(map, 1), Wrap::Repeat);
    };
    const Vec3 expected = (look(0, 0) + look(0.6, 0.8) + look(-0.6, -0.8)) / 3.0;
    INFO("texture of 32 x 32 texels at uv " << uv << ", " << text(seen) << ", at most 16 probes");
    CHECK(test::near_color(anisotropic(map, uv, seen, Wrap::Repeat, 16), expected, bound(map, uv, 1)));
}

TEST_CASE("beyond the edge of the texture the wrap decides", "[11.14]") {
    const MipMap map = white_column(8, 8, 0);
    const Footprint seen{{3.0 / 8, 0}, {0, 1.0 / 8}};
    const Vec2 uv = centre(map, 7, 3);
    INFO("column 0 is white, the middle of the footprint, 3 texels by 1, is on the last");
    CHECK(test::near_color(anisotropic(map, uv, seen, Wrap::Repeat, 16), Vec3(1.0 / 3), bound(map, uv, 1)));
    CHECK(test::near_color(anisotropic(map, uv, seen, Wrap::Clamp, 16), Vec3(0), bound(map, uv, 1)));
}

TEST_CASE("the axes of a footprint, by hand", "[11.14]") {
    const auto check_axes = [](const Ellipse& actual, Real major, Real minor) {
        {
            INFO("the long axis, in texels");
            CHECK(test::near(actual.major, major, gamma(32) * major));
        }
        INFO("the short axis, in texels");
        CHECK(test::near(actual.minor, minor, gamma(32) * major));
    };
    {
        INFO("a pixel that is (0.5, 0) by (0, 0.5) of a texture of 8 by 8 texels");
        check_axes(ellipse({{0.5, 0}, {0, 0.5}}, {8, 8}), 4, 4);
    }
    {
        INFO("a pixel that is (0.6, 0.4) by (-0.4, 0.15) of 10 by 20 texels: (6, 8) by (-4, 3) texels");
        const Ellipse slanted = ellipse({{0.6, 0.4}, {-0.4, 0.15}}, {10, 20});
        check_axes(slanted, 10, 5);
        INFO("the direction of the long axis");
        CHECK(test::near(slanted.along, Vec2(0.6, 0.8), gamma(32)));
    }
    INFO("a pixel of which both sides are (1, 1) of a single texel: long and without width");
    check_axes(ellipse({{1, 1}, {1, 1}}, {1, 1}), 2, 0);
}

TEST_CASE("the footprint finds what the point was made of", "[11.14]") {
    Random random(111201);
    for (int i = 0; i < cases(20000); ++i) {
        const Vec3 along = random.direction(), across = random.perpendicular_to(along);
        const Real sine = random.magnitude(-2, 0), u = random.magnitude(-3, 3), v = random.magnitude(-3, 3);
        const Vec3 du = u * along;
        const Vec3 dv = v * (sine * across + random.sign() * std::sqrt(1 - sine * sine) * along);
        const Vec3 off = cross(along, across);
        const auto make = [&](const Vec3& part) { return part.x * du + part.y * dv + part.z * off; };
        const Vec3 right = random.in_cube(), down = random.in_cube();
        INFO("du = " << du << ", dv = " << dv << "; dp = " << right.x << " du + " << right.y << " dv + "
                     << right.z << " across, and " << down.x << " du + " << down.y << " dv + " << down.z
                     << " across");
        const Footprint actual = footprint(du, dv, make(right), make(down));
        // The parts are rounded some eight times before they are asked for.
        const Real size = gamma(32 + 8) * (u + v + 1) / (sine * sine * sine);
        CHECK(test::near(actual.dx.x, right.x, size / u));
        CHECK(test::near(actual.dx.y, right.y, size / v));
        CHECK(test::near(actual.dy.x, down.x, size / u));
        CHECK(test::near(actual.dy.y, down.y, size / v));
    }
}

TEST_CASE("a constant texture is constant in every footprint", "[11.14]") {
    Random random(111202);
    const MipMap map = texture(32, 8, [](int, int) { return 0.7; });
    for (int i = 0; i < cases(2000); ++i) {
        const Footprint seen{random.magnitude(-4, 2) * Vec2(random.in_cube()),
                             random.magnitude(-4, 2) * Vec2(random.in_cube())};
        const Vec2 uv(random.in_cube());
        check_grey(map, uv, seen, 1 + static_cast<int>(random.index(64)), 0.7);
    }
}

TEST_CASE("a linear texture has its value at uv as the mean", "[11.14]") {
    Random random(111203);
    const MipMap map = texture(64, 64, [](int i, int j) { return (2 * i + j) / 256.0; });
    for (int i = 0; i < cases(2000); ++i) {
        // Far enough from the edge for the probes: 8 texels long, up to 8 wide.
        const Real angle = random.uniform(0, pi), minor = random.magnitude(-1, 0.9);
        const Footprint seen = turned(map, {std::cos(angle), std::sin(angle)},
                                      std::max(minor, random.uniform(1, 8)), minor, random.uniform(0, 6));
        const Vec2 uv(random.uniform(0.4, 0.6), random.uniform(0.4, 0.6));
        check_grey(map, uv, seen, 1 + static_cast<int>(random.index(20)),
                   (2 * (64 * uv.x - 0.5) + 64 * uv.y - 0.5) / 256);
    }
}

TEST_CASE("anisotropic lookups are what their definition says, however the pixel is turned", "[11.14]") {
    Random random(111204);
    const MipMap square = hills(32, 32), wide = hills(64, 16);
    for (int i = 0; i < cases(4000); ++i) {
        const MipMap& map = i % 2 == 0 ? square : wide;
        const Real angle = random.uniform(0, pi), minor = random.magnitude(-1, 1);
        const Real major = minor * random.magnitude(0, 1.7);
        const Vec2 along(std::cos(angle), std::sin(angle)), uv(2.0 * random.in_cube());
        const int most_probes = 1 + static_cast<int>(random.index(40));
        const Footprint seen = turned(map, along, major, minor, random.uniform(0, 6));
        INFO("texture of " << map.levels.front().width << " x " << map.levels.front().height
                           << " texels at uv " << uv << ", " << text(seen) << ",\nwhose axes are " << major
                           << " along " << along << " and " << minor << " texels; at most " << most_probes
                           << " probes");
        // Of a footprint that is nearly a circle, rounding may turn the axis: by 8u/(1 - minor/major) times
        // the major axis, in texels, none of which differs from the next by more than 1.
        const Real turn = gamma(16) * major / std::max(1 - minor / major, Real(0x1p-20));
        CHECK(test::near_color(anisotropic(map, uv, seen, Wrap::Repeat, most_probes),
                               by_definition(map, uv, along, major, minor, most_probes),
                               bound(map, uv, 1) + turn));
    }
}

TEST_CASE("a growing footprint changes the colour without jumps", "[11.14]") {
    Random random(111205);
    const MipMap map = hills(32, 32);
    for (int i = 0; i < cases(2000); ++i) {
        // Around the ratios at which probes are added, the limit of 15, and axes of one texel.
        const Real ratios[] = {1, 3, 5, 13, 15};
        const Real minor = i % 7 == 0 ? 1 : random.magnitude(0, 0.7), ratio = ratios[random.index(5)];
        const Real angle = random.uniform(0, pi), turn = random.uniform(0, 6), step = 1e-7;
        const Vec2 along(std::cos(angle), std::sin(angle)), uv(random.in_cube());
        const Footprint below = turned(map, along, minor * ratio * (1 - step), minor * (1 - step), turn);
        const Footprint above = turned(map, along, minor * ratio * (1 + step), minor, turn);
        INFO("texture of 32 x 32 texels at uv " << uv << ", at most 16 probes;\nfrom a " << text(below)
                                                << "\nto a " << text(above));
        const Vec3 before = anisotropic(map, uv, below, Wrap::Repeat, 16);
        // The outermost probes move by 75 texels times the step at most, the weights and the level by a few
        // steps; nearly circular footprints may turn, but then have one probe that matters.
        CHECK(test::near_color(anisotropic(map, uv, above, Wrap::Repeat, 16), before, 400 * step));
    }
}
