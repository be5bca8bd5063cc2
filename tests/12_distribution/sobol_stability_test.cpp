// Steps 12.3 to 12.5 at the ends of all 32-bit numbers.
#include "chapters/12_distribution/sobol.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <vector>

using namespace rt;
using test::cases;

TEST_CASE("the coordinate of the last index, and of random ones, bit by bit", "[12.3][stability]") {
    test::Random random(12391);
    for (int i = 0; i < cases(2000); ++i) {
        const std::uint32_t index = i == 0 ? ~0u : static_cast<std::uint32_t>(random.engine() >> 32);
        const auto dimension = static_cast<std::uint32_t>(random.index(sobol_dimensions));
        const std::array<std::uint32_t, 32> numbers = sobol_directions(dimension);
        // Output bit by output bit: the parity of how many chosen numbers have it.
        std::uint32_t expected = 0;
        for (int bit = 31; bit >= 0; --bit) {
            int chosen = 0;
            for (std::size_t k = 0; k < 32; ++k) chosen += (index >> k & 1) && (numbers[k] >> bit & 1);
            if (chosen % 2 == 1) expected += std::uint32_t(1) << bit;
        }
        INFO("index " << index << ", dimension " << dimension);
        REQUIRE(sobol_bits(index, dimension) == expected);
    }
}

TEST_CASE("the last bits are scrambled as the first ones", "[12.4][stability]") {
    test::Random random(12491);
    for (int i = 0; i < cases(500); ++i) {
        const std::uint64_t key = i == 0 ? 0 : i == 1 ? ~std::uint64_t(0) : random.engine();
        const std::uint32_t base = (i % 3 == 0 ? ~0u : static_cast<std::uint32_t>(random.engine())) & ~15u;
        std::vector<std::uint32_t> images;
        for (std::uint32_t j = 0; j < 16; ++j) images.push_back(owen_scrambled(base + j, key));
        const std::uint32_t first = images[0] & ~15u;
        std::sort(images.begin(), images.end());
        INFO("the 16 fractions from " << base << " on, key " << key);
        for (std::uint32_t j = 0; j < 16; ++j) REQUIRE(images[j] == first + j);
    }
}

TEST_CASE("all places of points are in the square", "[12.5][stability]") {
    test::Random random(12591);
    for (int i = 0; i < cases(5000); ++i) {
        const std::uint64_t key = i % 4 == 0 ? 0 : i % 4 == 1 ? ~std::uint64_t(0) : random.engine();
        const std::uint32_t index = i % 3 == 0 ? ~0u - static_cast<std::uint32_t>(i)
                                               : static_cast<std::uint32_t>(random.engine() >> 32);
        const Vec2 p = sobol_point(index, key);
        INFO("point " << index << ", key " << key << ": " << p);
        REQUIRE((0 <= p.x && p.x < 1 && 0 <= p.y && p.y < 1));
        const Vec2 whole = p * 0x1p32;
        REQUIRE(glm::floor(whole) == whole);
    }
}

TEST_CASE("pixels far away, and of all counts", "[12.5][stability]") {
    test::Random random(12592);
    for (int i = 0; i < cases(2000); ++i) {
        const std::uint32_t count = 1u << random.index(9);
        const auto x = static_cast<std::uint32_t>(random.engine()), y = ~x - static_cast<std::uint32_t>(i);
        const std::uint64_t key = random.engine();
        INFO("pixel (" << x << ", " << y << "), " << count << " points each, key " << key);
        const std::uint32_t start = pixel_start(x, y, count, key);
        REQUIRE(start % count == 0);
        REQUIRE(start / count < 1u << 24);
        REQUIRE(start == pixel_start(x % 4096, y % 4096, count, key));
    }
}
