// Step 11.3: an image in all sizes.
#include "chapters/11_textures/mip_map.hpp"

#include "chapters/11_textures/image_texture.hpp"
#include "common/math/error.hpp"
#include "tests/11_textures/texel_images.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

using namespace rt;
using test::all_wraps;
using test::cases;
using test::grey;
using test::near;
using test::Random;
using test::random_image;

namespace {

Vec3 mean_of(const Image& image) {
    Vec3 sum(0);
    for (const Vec3& p : image.pixels) sum += p;
    return sum / static_cast<Real>(image.pixels.size());
}

std::string sizes_of(const MipMap& map) {
    std::string text;
    for (const Image& level : map.levels)
        text +=
            (text.empty() ? "" : ", ") + std::to_string(level.width) + " x " + std::to_string(level.height);
    return text;
}

/// How much of texel `at` of a row of `size` lies in texel i of the row of m, as a part of the latter.
Real covered(int at, int i, int size, int m) {
    const Real step = static_cast<Real>(size) / m;
    return std::max(Real(0), std::min<Real>(at + 1, (i + 1) * step) - std::max<Real>(at, i * step)) / step;
}

void check_weights(int i, int size, const std::array<Real, 3>& expected) {
    const std::array<Real, 3> weights = halving_weights(i, size);
    INFO("the weights of texels " << 2 * i << ", " << 2 * i + 1 << " and " << 2 * i + 2 << " of " << size
                                  << " in texel " << i << " of the halved row");
    CHECK(near(Vec3(weights[0], weights[1], weights[2]), Vec3(expected[0], expected[1], expected[2]),
               gamma(8)));
}

void check_color(const MipMap& map, const Vec2& uv, Real width, Wrap wrap, const Vec3& expected,
                 Real greatest) {
    const Image& first = map.levels.front();
    INFO(first.width << " x " << first.height << " texels, uv = " << uv << ", width " << width);
    CHECK(test::near_color(trilinear(map, uv, width, wrap), expected,
                           gamma(16 * (first.width + first.height)) * greatest));
}

/// 1 3 5 11, then 2 8, then 5
const Image row = grey({{1, 3, 5, 11}});

void require_levels(const MipMap& map, std::size_t count) {
    INFO("the sizes of the levels are " << sizes_of(map) << "; how many there are");
    REQUIRE(map.levels.size() == count);
}

}  // namespace

TEST_CASE("an even row is halved in pairs, an odd one in parts", "[11.3]") {
    check_weights(0, 4, {0.5, 0.5, 0});
    check_weights(1, 4, {0.5, 0.5, 0});
    check_weights(0, 3, {1.0 / 3, 1.0 / 3, 1.0 / 3});
    check_weights(0, 5, {0.4, 0.4, 0.2});
    check_weights(1, 5, {0.2, 0.4, 0.4});
    check_weights(0, 2, {0.5, 0.5, 0});
    check_weights(0, 1, {1, 0, 0});
}

TEST_CASE("1 3 5 11, by hand", "[11.3]") {
    const MipMap map = mip_map(row);
    INFO("sizes of the levels: " << sizes_of(map));
    require_levels(map, 3);
    REQUIRE(map.levels[1].pixels.size() == 2);
    REQUIRE(map.levels[2].pixels.size() == 1);
    CHECK(near(map.levels[1].pixels[0], Vec3(2), gamma(8) * 11));
    CHECK(near(map.levels[1].pixels[1], Vec3(8), gamma(8) * 11));
    CHECK(near(map.levels[2].pixels[0], Vec3(5), gamma(8) * 11));
}

TEST_CASE("at u = 0.25 it is 2 for half of the image, 5 for all of it", "[11.3]") {
    const MipMap map = mip_map(row);
    require_levels(map, 3);
    check_color(map, {0.25, 0.5}, 0.25, Wrap::Clamp, Vec3(2), 11);
    check_color(map, {0.25, 0.5}, 0.5, Wrap::Clamp, Vec3(2), 11);
    check_color(map, {0.25, 0.5}, 1, Wrap::Clamp, Vec3(5), 11);
    // log2(3) = 1.585 is 0.585 of the way from 2 to 5.
    check_color(map, {0.25, 0.5}, 0.75, Wrap::Clamp, Vec3(2 + 3 * 0.5849625007211562), 11);
    check_color(map, {0.125, 0.5}, 0.25, Wrap::Clamp, Vec3(1), 11);
    // Level 0.5: halfway from 1 to the 2 of level 1.
    check_color(map, {0.125, 0.5}, 0.25 * std::sqrt(2.0), Wrap::Clamp, Vec3(1.5), 11);
}

TEST_CASE("down to a single texel, also of an image that is not square", "[11.3]") {
    const struct {
        int width, height;
        const char* sizes;
    } images[] = {{8, 2, "8 x 2, 4 x 1, 2 x 1, 1 x 1"},
                  {1, 5, "1 x 5, 1 x 2, 1 x 1"},
                  {7, 6, "7 x 6, 3 x 3, 1 x 1"},
                  {1, 1, "1 x 1"}};
    for (const auto& [width, height, sizes] : images) {
        const MipMap map = mip_map(make_image(width, height));
        INFO("the sizes of the levels of an image of " << width << " x " << height << " texels");
        CHECK(sizes_of(map) == sizes);
    }
}

TEST_CASE("the first level is the image itself", "[11.3]") {
    Random random(11301);
    const Image image = random_image(5, 3, random);
    const MipMap map = mip_map(image);
    INFO("an image of 5 x 3 texels; the sizes of the levels are " << sizes_of(map));
    REQUIRE(test::or_say(!map.levels.empty(), "there are no levels"));
    CHECK(map.levels.front().width == 5);
    CHECK(map.levels.front().height == 3);
    CHECK(test::or_say(map.levels.front().pixels == image.pixels, "its texels are not those of the image"));
}

TEST_CASE("a width of one texel or less is bilinear, one of all or more is the mean", "[11.3]") {
    const MipMap map = mip_map(row);
    require_levels(map, 3);
    for (const Real width : {0.0, 1e-300, 0.125, 0.25})
        for (const Real u : {0.25, 0.375, 0.5}) {
            INFO("bilinear, of 1, 3, 5, 11");
            check_color(map, {u, 0.5}, width, Wrap::Clamp, Vec3(u == 0.25 ? 2 : u == 0.375 ? 3 : 4), 11);
        }
    for (const Real width : {1.0, 2.0, 1e300, infinity})
        for (const Real u : {0.0, 0.375, 0.75}) check_color(map, {u, 0.5}, width, Wrap::Repeat, Vec3(5), 11);
}

TEST_CASE("the greater side counts, whichever it is", "[11.3]") {
    const MipMap column = mip_map(grey({{11}, {5}, {3}, {1}}));
    require_levels(column, 3);
    check_color(column, {0.5, 0.125}, 0.5, Wrap::Clamp, Vec3(2), 11);
    check_color(column, {0.5, 0.125}, 0.25, Wrap::Clamp, Vec3(1), 11);
}

TEST_CASE("beyond the edges it goes on as the image does", "[11.3]") {
    const MipMap map = mip_map(row);
    require_levels(map, 3);
    check_color(map, {-0.25, 0.5}, 0.5, Wrap::Repeat, Vec3(8), 11);
    check_color(map, {-0.25, 0.5}, 0.5, Wrap::Mirror, Vec3(2), 11);
    check_color(map, {1.25, 0.5}, 0.5, Wrap::Clamp, Vec3(8), 11);
}

TEST_CASE("each texel of a level is the mean of what it covers", "[11.3]") {
    Random random(11303);
    for (int i = 0; i < cases(2000); ++i) {
        const int width = 1 + static_cast<int>(random.index(12)),
                  height = 1 + static_cast<int>(random.index(12));
        const Image image = random_image(width, height, random);
        const MipMap map = mip_map(image);
        if (map.levels.size() < 2) continue;
        const Image& half = map.levels[1];
        INFO(width << " x " << height << " texels, sizes of the levels: " << sizes_of(map));
        REQUIRE(half.width == std::max(1, width / 2));
        REQUIRE(half.height == std::max(1, height / 2));
        const int x = static_cast<int>(random.index(static_cast<std::size_t>(half.width)));
        const int y = static_cast<int>(random.index(static_cast<std::size_t>(half.height)));
        Vec3 mean{0};
        for (int at_y = 0; at_y < height; ++at_y)
            for (int at_x = 0; at_x < width; ++at_x)
                mean += covered(at_x, x, width, half.width) * covered(at_y, y, height, half.height) *
                        pixel(image, at_x, at_y);
        INFO("column " << x << " and row " << y << " of the first half");
        CHECK(near(pixel(half, x, y), mean, gamma(64 + width + height)));
    }
}

TEST_CASE("the mean of every level is the mean of the image", "[11.3]") {
    Random random(11304);
    for (int i = 0; i < cases(500); ++i) {
        const int width = 1 + static_cast<int>(random.index(40)),
                  height = 1 + static_cast<int>(random.index(40));
        const Image image = random_image(width, height, random);
        const MipMap map = mip_map(image);
        for (std::size_t k = 0; k < map.levels.size(); ++k) {
            INFO(width << " x " << height << " texels, level " << k << " of " << sizes_of(map));
            // Sums of width·height numbers, and 16 roundings a level.
            CHECK(near(mean_of(map.levels[k]), mean_of(image), gamma(2 * width * height + 16 * 6)));
        }
    }
}

TEST_CASE("between two levels it goes straight from the one to the other", "[11.3]") {
    Random random(11305);
    for (int i = 0; i < cases(3000); ++i) {
        const int width = 2 + static_cast<int>(random.index(30)),
                  height = 1 + static_cast<int>(random.index(30));
        const MipMap map = mip_map(random_image(width, height, random));
        if (map.levels.size() < 2) continue;
        const std::size_t finer = random.index(map.levels.size() - 1);
        const Real way = random.uniform(0, 1);
        const Vec2 uv(random.uniform(-1, 2), random.uniform(-1, 2));
        const Wrap wrap = all_wraps[i % 3];
        const Vec3 fine = bilinear(map.levels[finer], uv, wrap),
                   coarse = bilinear(map.levels[finer + 1], uv, wrap);
        const Real footprint = std::exp2(static_cast<Real>(finer) + way) / std::max(width, height);
        INFO("level " << finer << " + " << way << " of " << sizes_of(map));
        check_color(map, uv, footprint, wrap, (1 - way) * fine + way * coarse, 1);
    }
}

TEST_CASE("an image of one colour has it at all widths", "[11.3]") {
    Random random(11306);
    for (int i = 0; i < cases(500); ++i) {
        const Vec3 color(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
        Image image =
            make_image(1 + static_cast<int>(random.index(30)), 1 + static_cast<int>(random.index(30)));
        for (Vec3& p : image.pixels) p = color;
        const MipMap map = mip_map(image);
        const Vec2 uv(random.uniform(-3, 3), random.uniform(-3, 3));
        check_color(map, uv, random.magnitude(-3, 1), all_wraps[i % 3], color, 1);
    }
}

TEST_CASE("where the colour grows evenly it is right, or nearly", "[11.3]") {
    Random random(11307);
    for (int i = 0; i < cases(3000); ++i) {
        const bool is_power = i % 2 == 0;
        const int side = is_power ? 1 << (2 + random.index(4)) : 4 + static_cast<int>(random.index(60));
        Image image = make_image(side, side);
        const Real by_u = random.uniform(-1, 1), by_v = random.uniform(-1, 1);
        const auto color = [&](Real u, Real v) { return Vec3(by_u * u + by_v * v); };
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) pixel(image, x, y) = color((x + 0.5) / side, 1 - (y + 0.5) / side);
        const MipMap map = mip_map(image);
        INFO("an image of " << side << " x " << side << " texels: how many levels there are");
        REQUIRE(map.levels.size() >= 3);
        const Real level = random.uniform(0, static_cast<Real>(map.levels.size()) - 2);
        const Real coarse = 1.0 / map.levels[static_cast<std::size_t>(std::ceil(level))].width;
        const Vec2 uv(random.uniform(coarse / 2, 1 - coarse / 2), random.uniform(coarse / 2, 1 - coarse / 2));
        INFO(side << " x " << side << " texels with the colour " << by_u << " u + " << by_v
                  << " v, uv = " << uv << ", level " << level);
        const Real off = is_power ? 0 : (std::abs(by_u) + std::abs(by_v)) * coarse / 16;
        CHECK(test::near_color(trilinear(map, uv, std::exp2(level) / side, Wrap::Clamp), color(uv.x, uv.y),
                               off + gamma(16 * 2 * side) * 2));
    }
}
