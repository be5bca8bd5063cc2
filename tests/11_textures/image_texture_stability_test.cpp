// Step 11.2 far beyond the edges.
#include "chapters/11_textures/image_texture.hpp"
#include "common/math/error.hpp"
#include "tests/11_textures/texel_images.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

using namespace rt;
using test::all_wraps;
using test::cases;
using test::name_of;
using test::near;
using test::Random;
using test::random_image;

TEST_CASE("places of all sizes are wrapped to texels", "[11.2][stability]") {
    Random random(11211);
    const std::int64_t least = std::numeric_limits<std::int64_t>::min() / 2;
    for (int i = 0; i < cases(20000); ++i) {
        const int size = i % 3 == 0 ? 1 + static_cast<int>(random.index(4))
                                    : 1 + static_cast<int>(random.magnitude(0, 9.3));
        const auto place = static_cast<std::int64_t>(random.sign() * random.magnitude(0, 18));
        for (const Wrap wrap : all_wraps)
            for (const std::int64_t at : {place, least, -least, std::int64_t{-1}, std::int64_t{size}}) {
                const int texel = wrapped(at, size, wrap);
                INFO(size << " texels, " << name_of(wrap) << ", place " << at << " -> " << texel);
                CHECK(texel >= 0);
                CHECK(texel < size);
            }
        INFO(size << " texels, place " << place);
        CHECK((place - wrapped(place, size, Wrap::Repeat)) % size == 0);
        // A mirrored place differs from its texel, or from the one on the other side of the edge, by a
        // period.
        const std::int64_t period = 2 * std::int64_t{size}, texel = wrapped(place, size, Wrap::Mirror);
        CHECK(((place - texel) % period == 0 || (place + texel + 1) % period == 0));
    }
}

TEST_CASE("whole images away is the same place", "[11.2][stability]") {
    Random random(11212);
    for (int i = 0; i < cases(20000); ++i) {
        const int width = 1 + static_cast<int>(random.index(9)),
                  height = 1 + static_cast<int>(random.index(9));
        const Image image = random_image(width, height, random);
        const Wrap wrap = all_wraps[i % 2];
        // Multiples of 2^-20, so that the sum with up to 2^31 of the images is exact.
        const auto coordinate = [&] { return std::floor(random.uniform(0, 1) * 0x1p20) * 0x1p-20; };
        const auto periods = [&] { return 2 * std::floor(random.sign() * random.magnitude(0, 9)); };
        const Vec2 uv(coordinate(), coordinate()), far = uv + Vec2(periods(), periods());
        INFO(width << " x " << height << " texels, " << name_of(wrap) << ", uv = " << uv << " and " << far);
        CHECK(near(bilinear(image, far, wrap), bilinear(image, uv, wrap), 2 * gamma(16 * (width + height))));
    }
}

TEST_CASE("coordinates of all sizes give colours of the image", "[11.2][stability]") {
    Random random(11213);
    const Image image = random_image(5, 3, random);
    Vec3 least(1), greatest(0);
    for (const Vec3& p : image.pixels) least = glm::min(least, p), greatest = glm::max(greatest, p);
    for (int i = 0; i < cases(20000); ++i) {
        const Vec2 uv(random.sign() * random.magnitude(-320, 300),
                      random.sign() * random.magnitude(-320, 30));
        for (const Wrap wrap : all_wraps) {
            INFO(name_of(wrap) << ", uv = " << uv);
            const Vec3 mixed = bilinear(image, uv, wrap), one = nearest(image, uv, wrap);
            CHECK(glm::all(glm::greaterThanEqual(mixed, least - gamma(8))));
            CHECK(glm::all(glm::lessThanEqual(mixed, greatest + gamma(8))));
            CHECK(std::find(image.pixels.begin(), image.pixels.end(), one) != image.pixels.end());
        }
    }
}

TEST_CASE("clamped, the edge goes on for ever", "[11.2][stability]") {
    Random random(11214);
    const Image image = random_image(5, 3, random);
    for (int i = 0; i < cases(5000); ++i) {
        const Real far = random.magnitude(0, 300), v = random.uniform(0, 1);
        INFO("u = 1 + " << far << " and -" << far << ", v = " << v);
        CHECK(near(bilinear(image, {1 + far, v}, Wrap::Clamp), bilinear(image, {1, v}, Wrap::Clamp),
                   gamma(256)));
        CHECK(
            near(bilinear(image, {-far, v}, Wrap::Clamp), bilinear(image, {0, v}, Wrap::Clamp), gamma(256)));
    }
}

TEST_CASE("across the seam of an image that repeats the colour is continuous", "[11.2][stability]") {
    Random random(11215);
    for (int i = 0; i < cases(5000); ++i) {
        const int width = 1 + static_cast<int>(random.index(9));
        const Image image = random_image(width, 2, random);
        const Real beside = random.magnitude(-300, -3), v = random.uniform(0, 1);
        for (const Wrap wrap : all_wraps)
            for (const Real seam : {0.0, 1.0}) {
                INFO(width << " x 2 texels, " << name_of(wrap) << ", u = " << seam << " +- " << beside);
                const Vec3 before = bilinear(image, {seam - beside, v}, wrap);
                const Vec3 after = bilinear(image, {seam + beside, v}, wrap);
                CHECK(near(before, after, 2 * beside * width + 2 * gamma(16 * (width + 2))));
            }
    }
}
