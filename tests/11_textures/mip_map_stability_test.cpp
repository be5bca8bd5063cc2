// Step 11.3 at its ends: widths of all sizes, long thin images, places far away.
#include "chapters/11_textures/mip_map.hpp"
#include "common/math/error.hpp"
#include "tests/11_textures/texel_images.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"
#include "tests/together.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace rt;
using test::all_wraps;
using test::cases;
using test::near;
using test::Random;
using test::random_image;

namespace {

int some_side(Random& random) { return 1 + static_cast<int>(random.magnitude(0, 2) - 0.5); }

}  // namespace

TEST_CASE("weights of halves are not negative, and each texel counts alike", "[11.3][stability]") {
    Random random(11311);
    for (int k = 0; k < 400; ++k) {
        const int size = k < 200 ? 1 + k : 2 + static_cast<int>(random.magnitude(0, 4)),
                  m = std::max(1, size / 2);
        std::vector<Real> counts(static_cast<std::size_t>(size));
        std::vector<std::array<Real, 3>> found(static_cast<std::size_t>(m));
        test::together(found.size(),
                       [&](std::size_t i) { found[i] = halving_weights(static_cast<int>(i), size); });
        for (int i = 0; i < m; ++i) {
            const std::array<Real, 3>& weights = found[static_cast<std::size_t>(i)];
            INFO("texel " << i << " of the half of " << size << ": weights " << weights[0] << ", "
                          << weights[1] << " and " << weights[2]);
            CHECK(near(weights[0] + weights[1] + weights[2], 1, gamma(8)));
            for (int j = 0; j < 3; ++j) {
                const Real weight = weights[static_cast<std::size_t>(j)];
                CHECK(weight >= 0);
                const int at = 2 * i + j;
                if (at < size)
                    counts[static_cast<std::size_t>(at)] += weight;
                else
                    CHECK(weight == 0);
            }
        }
        INFO("a row of " << size);
        for (const Real count : counts) CHECK(near(count, static_cast<Real>(m) / size, gamma(8)));
    }
}

TEST_CASE("widths and places of all sizes give colours of the image", "[11.3][stability]") {
    Random random(11312);
    for (int k = 0; k < cases(200); ++k) {
        const Image image = random_image(some_side(random), some_side(random), random);
        const MipMap map = mip_map(image);
        Vec3 least(1), greatest(0);
        for (const Vec3& p : image.pixels) least = glm::min(least, p), greatest = glm::max(greatest, p);
        const Real bound = gamma(16 * (image.width + image.height));
        for (int i = 0; i < 100; ++i) {
            const Real width = i == 0 ? 0 : i == 1 ? infinity : random.magnitude(-320, 300);
            const Vec2 uv(random.sign() * random.magnitude(-320, 300), random.uniform(-2, 2));
            const Vec3 color = trilinear(map, uv, width, all_wraps[i % 3]);
            INFO(image.width << " x " << image.height << " texels, uv = " << uv << ", width " << width << ": "
                             << color);
            CHECK(glm::all(glm::greaterThanEqual(color, least - bound)));
            CHECK(glm::all(glm::lessThanEqual(color, greatest + bound)));
        }
    }
}

TEST_CASE("continuous in the width, also where a level is whole", "[11.3][stability]") {
    Random random(11313);
    for (int k = 0; k < cases(2000); ++k) {
        const Image image = random_image(some_side(random), some_side(random), random);
        const MipMap map = mip_map(image);
        const Vec2 uv(random.uniform(0, 1), random.uniform(0, 1));
        const Real side = std::max(image.width, image.height);
        const Real level = std::floor(random.uniform(0, static_cast<Real>(map.levels.size())));
        const Real beside = random.magnitude(-17, -2), width = std::exp2(level) / side;
        INFO(image.width << " x " << image.height << " texels, uv = " << uv << ", widths " << width << " +- "
                         << beside << " of it");
        // The level changes by 2·beside/ln 2, and the colour from level to level by 1 at most.
        CHECK(near(trilinear(map, uv, width * (1 - beside), Wrap::Repeat),
                   trilinear(map, uv, width * (1 + beside), Wrap::Repeat),
                   4 * beside + 2 * gamma(16 * (image.width + image.height))));
    }
}

TEST_CASE("the colour goes from level to level without a detour", "[11.3][stability]") {
    Random random(11314);
    for (int k = 0; k < cases(500); ++k) {
        const Image image = random_image(some_side(random), some_side(random), random);
        const MipMap map = mip_map(image);
        const Vec2 uv(random.uniform(0, 1), random.uniform(0, 1));
        const Real side = std::max(image.width, image.height);
        const Real finer = std::floor(random.uniform(0, static_cast<Real>(map.levels.size())));
        const auto at = [&](Real level) {
            return trilinear(map, uv, std::exp2(level) / side, Wrap::Repeat).x;
        };
        const Real first = at(finer), last = at(finer + 1), bound = gamma(32 * (image.width + image.height));
        Real before = first;
        for (const Real way : {0.1, 0.25, 0.5, 0.75, 0.99}) {
            const Real next = at(finer + way);
            INFO(image.width << " x " << image.height << " texels, uv = " << uv << ", level " << finer
                             << " + " << way << ": from " << first << " to " << last);
            CHECK((next - before) * (last >= first ? 1 : -1) >= -bound);
            before = next;
        }
    }
}
