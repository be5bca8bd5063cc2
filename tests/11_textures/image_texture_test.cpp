// Step 11.2: the colour of an image between its pixels, and beyond its edges.
#include "chapters/11_textures/image_texture.hpp"
#include "common/math/error.hpp"
#include "tests/11_textures/texel_images.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rt;
using test::all_wraps;
using test::cases;
using test::grey;
using test::name_of;
using test::near;
using test::Random;
using test::random_image;

namespace {

/// 1 2
/// 3 4
const Image four = grey({{1, 2}, {3, 4}});

/// The numbers of the texels at the places −3·size … 3·size − 1, written down one after the other.
std::vector<int> laid_out(int size, Wrap wrap) {
    std::vector<int> places;
    for (int copy = -3; copy < 3; ++copy)
        for (int i = 0; i < size; ++i) {
            if (wrap == Wrap::Clamp)
                places.push_back(copy < 0 ? 0 : copy > 0 ? size - 1 : i);
            else
                places.push_back(wrap == Wrap::Mirror && copy % 2 != 0 ? size - 1 - i : i);
        }
    return places;
}

/// A tent's height at this distance from its middle.
Real tent(Real distance) { return std::max(Real(0), 1 - std::abs(distance)); }

/// Tents over all the texels, as they are laid out: bilinear, without looking for neighbours.
Vec3 sum_of_tents(const Image& image, const Vec2& uv, Wrap wrap) {
    const std::vector<int> columns = laid_out(image.width, wrap), rows = laid_out(image.height, wrap);
    Vec3 sum(0);
    for (std::size_t j = 0; j < rows.size(); ++j)
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const Real x = static_cast<Real>(i) + 0.5 - 3 * image.width;
            const Real y = static_cast<Real>(j) + 0.5 - 3 * image.height;
            const Real weight = tent(uv.x * image.width - x) * tent(uv.y * image.height - y);
            if (weight > 0) sum += weight * pixel(image, columns[i], image.height - 1 - rows[j]);
        }
    return sum;
}

void check_bilinear(const Image& image, const Vec2& uv, Wrap wrap, Real expected) {
    INFO(image.width << " x " << image.height << " texels, " << name_of(wrap) << ", uv = " << uv);
    CHECK(near(bilinear(image, uv, wrap), Vec3(expected), gamma(16 * (image.width + image.height)) * 9));
}

void check_nearest(const Image& image, const Vec2& uv, Wrap wrap, Real expected) {
    INFO(image.width << " x " << image.height << " texels, " << name_of(wrap) << ", uv = " << uv);
    CHECK(near(nearest(image, uv, wrap), Vec3(expected), 0));
}

}  // namespace

TEST_CASE("a row that repeats, is mirrored, is clamped", "[11.2]") {
    const int repeat[] = {2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0}, mirror[] = {2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0},
              clamp[] = {0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2};
    for (int i = -4; i <= 6; ++i) {
        INFO("three texels, place " << i);
        CHECK(wrapped(i, 3, Wrap::Repeat) == repeat[i + 4]);
        CHECK(wrapped(i, 3, Wrap::Mirror) == mirror[i + 4]);
        CHECK(wrapped(i, 3, Wrap::Clamp) == clamp[i + 4]);
    }
}

TEST_CASE("rows of a texture count from the bottom", "[11.2]") {
    INFO("the image 1 2 above 3 4");
    CHECK(near(texel(four, 0, 0, Wrap::Repeat), Vec3(3), 0));
    CHECK(near(texel(four, 1, 0, Wrap::Repeat), Vec3(4), 0));
    CHECK(near(texel(four, 0, 1, Wrap::Repeat), Vec3(1), 0));
    CHECK(near(texel(four, 1, 1, Wrap::Clamp), Vec3(2), 0));
    CHECK(near(texel(four, 2, -1, Wrap::Repeat), Vec3(1), 0));
    CHECK(near(texel(four, 2, -1, Wrap::Clamp), Vec3(4), 0));
}

TEST_CASE("the nearest texel is the one around the point", "[11.2]") {
    check_nearest(four, {0.1, 0.1}, Wrap::Repeat, 3);
    check_nearest(four, {0.6, 0.4}, Wrap::Repeat, 4);
    check_nearest(four, {0.4, 0.6}, Wrap::Repeat, 1);
    check_nearest(four, {0.9, 0.9}, Wrap::Repeat, 2);
}

TEST_CASE("the nearest texel beyond the edges", "[11.2]") {
    check_nearest(four, {-0.1, 0.1}, Wrap::Repeat, 4);
    check_nearest(four, {-0.1, 0.1}, Wrap::Mirror, 3);
    check_nearest(four, {-0.1, 0.1}, Wrap::Clamp, 3);
    check_nearest(four, {1.1, 0.1}, Wrap::Repeat, 3);
    check_nearest(four, {1.1, 0.1}, Wrap::Mirror, 4);
    check_nearest(four, {1.1, 1.1}, Wrap::Repeat, 3);
    check_nearest(four, {-7.9, 3.9}, Wrap::Clamp, 1);
    check_nearest(four, {-7.9, 3.9}, Wrap::Repeat, 1);
    check_nearest(four, {-7.9, 3.9}, Wrap::Mirror, 3);
}

TEST_CASE("between four texels, by hand", "[11.2]") {
    // At x = 0.25 and y = 0.75 from the centre of the 3: rows 3.25 and 1.25, of which a quarter and three.
    check_bilinear(four, {0.375, 0.625}, Wrap::Repeat, 1.75);
}

TEST_CASE("at the centre of a texel its colour, halfway the mean", "[11.2]") {
    for (const Wrap wrap : all_wraps) {
        check_bilinear(four, {0.25, 0.25}, wrap, 3);
        check_bilinear(four, {0.75, 0.75}, wrap, 2);
        check_bilinear(four, {0.5, 0.25}, wrap, 3.5);
        check_bilinear(four, {0.25, 0.5}, wrap, 2);
        check_bilinear(four, {0.5, 0.5}, wrap, 2.5);
    }
}

TEST_CASE("at an edge the other side shines through, if the image repeats", "[11.2]") {
    check_bilinear(four, {0, 0.25}, Wrap::Repeat, 3.5);
    check_bilinear(four, {0, 0.25}, Wrap::Mirror, 3);
    check_bilinear(four, {0, 0.25}, Wrap::Clamp, 3);
    check_bilinear(four, {1, 1}, Wrap::Repeat, 2.5);
    check_bilinear(four, {1, 1}, Wrap::Mirror, 2);
    check_bilinear(four, {0.125, 0.25}, Wrap::Repeat, 3.25);
    check_bilinear(four, {-0.125, 0.25}, Wrap::Repeat, 3.75);
}

TEST_CASE("columns and rows are not mixed up", "[11.2]") {
    const Image wide = grey({{1, 2, 3, 4}, {5, 6, 7, 8}});
    INFO("an image of 4 x 2 texels, above 1 2 3 4 and below 5 6 7 8");
    {
        INFO("the texel in column 3 of row 0, which is the lowest");
        CHECK(near(texel(wide, 3, 0, Wrap::Clamp), Vec3(8), 0));
    }
    check_nearest(wide, {0.9, 0.1}, Wrap::Repeat, 8);
    check_nearest(wide, {0.1, 0.9}, Wrap::Repeat, 1);
    check_bilinear(wide, {0.875, 0.25}, Wrap::Repeat, 8);
}

TEST_CASE("a single texel has one colour everywhere", "[11.2]") {
    for (const Wrap wrap : all_wraps)
        for (const Vec2& uv : {Vec2(0.5, 0.5), Vec2(0, 1), Vec2(-3.25, 8.5)}) {
            check_bilinear(grey({{7}}), uv, wrap, 7);
            check_nearest(grey({{7}}), uv, wrap, 7);
        }
}

TEST_CASE("bilinear is a sum of tents over the texels, laid out as they wrap", "[11.2]") {
    Random random(11202);
    for (int i = 0; i < cases(3000); ++i) {
        const int width = 1 + static_cast<int>(random.index(7)),
                  height = 1 + static_cast<int>(random.index(7));
        const Image image = random_image(width, height, random);
        const Wrap wrap = all_wraps[i % 3];
        const Vec2 uv(random.uniform(-1.9, 1.9), random.uniform(-1.9, 1.9));
        INFO(width << " x " << height << " texels, " << name_of(wrap) << ", uv = " << uv);
        CHECK(
            near(bilinear(image, uv, wrap), sum_of_tents(image, uv, wrap), 2 * gamma(16 * (width + height))));
    }
}

TEST_CASE("nearest is the texel whose square the point is in", "[11.2]") {
    Random random(11203);
    for (int i = 0; i < cases(10000); ++i) {
        const int width = 1 + static_cast<int>(random.index(7)),
                  height = 1 + static_cast<int>(random.index(7));
        const Image image = random_image(width, height, random);
        const Wrap wrap = all_wraps[i % 3];
        // A place of the layout, and a point clearly inside of it.
        const std::vector<int> columns = laid_out(width, wrap), rows = laid_out(height, wrap);
        const std::size_t column = random.index(columns.size()), row = random.index(rows.size());
        const Vec2 uv((static_cast<Real>(column) + random.uniform(0.01, 0.99)) / width - 3,
                      (static_cast<Real>(row) + random.uniform(0.01, 0.99)) / height - 3);
        INFO(width << " x " << height << " texels, " << name_of(wrap) << ", uv = " << uv);
        CHECK(near(nearest(image, uv, wrap), pixel(image, columns[column], height - 1 - rows[row]), 0));
    }
}
