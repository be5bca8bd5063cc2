// Steps 12.3 to 12.5: the Sobol' sequence, Owen's scrambling, and the points and pixels that are made of
// them.
#include "chapters/12_distribution/sobol.hpp"
#include "tests/catch.hpp"
#include "tests/chi_square.hpp"
#include "tests/support.hpp"
#include "tests/together.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

using namespace rt;
using test::cases;
using test::chi_square;
using test::chi_square_limit;

namespace {

// Each χ² test fails a right program once in ten million runs, and each step has at most eight of them: less
// than once in a million. The contract promises that two thousand keys show nothing.
constexpr std::size_t keys = 2000;

/// A key from anywhere.
std::uint64_t any_key(std::uint64_t number) { return test::Random(number).engine(); }

/// Keys one after the other, from anywhere.
std::vector<std::uint64_t> successive_keys(std::uint64_t number, std::size_t count = keys) {
    std::vector<std::uint64_t> all(count);
    std::iota(all.begin(), all.end(), any_key(number));
    return all;
}

/// The 2^k numbers from `first` on.
std::vector<std::uint32_t> indices_from(std::uint32_t first, int k) {
    std::vector<std::uint32_t> all(std::size_t(1) << k);
    std::iota(all.begin(), all.end(), first);
    return all;
}

void check_even(const std::vector<int>& counts) {
    INFO("chi-square of " << counts.size() << " classes that should be equally full: " << chi_square(counts)
                          << ", at most " << chi_square_limit(counts.size()) << " by chance");
    CHECK(chi_square(counts) < chi_square_limit(counts.size()));
}

/// A 32-bit fraction as a number in [0, 1).
Real fraction(std::uint32_t bits) { return bits * 0x1p-32; }

/// Of a number in [0, 1), its k-th bit after the point, counted from 1.
unsigned bit_of(Real x, int k) {
    return static_cast<unsigned>(std::fmod(std::floor(std::ldexp(x, k)), 2)) & 1;
}
unsigned bit_of(std::uint32_t fraction, int k) { return fraction >> (32 - k) & 1; }

/// The first k bits as 0.101…
std::string binary(std::uint32_t bits, int k) {
    std::string text = "0.";
    for (int i = 1; i <= k; ++i) text += bit_of(bits, i) ? '1' : '0';
    return text;
}

unsigned random_32(test::Random& random) { return static_cast<unsigned>(random.engine() >> 32); }

/// Whether each of the 2^k rectangles of every shape 2^-a by 2^-b, a + b = k, has just one of the 2^k points.
void check_net(const std::vector<Vec2>& points, int k) {
    for (int a = 0; a <= k; ++a) {
        const int b = k - a;
        std::vector<int> inside(points.size());
        for (const Vec2& p : points) {
            REQUIRE((0 <= p.x && p.x < 1 && 0 <= p.y && p.y < 1));
            const auto column = static_cast<std::size_t>(std::ldexp(p.x, a));
            const auto row = static_cast<std::size_t>(std::ldexp(p.y, b));
            ++inside[(row << a) + column];
        }
        INFO("in parts that are 1/" << (1 << a) << " wide and 1/" << (1 << b) << " high");
        const auto most = std::max_element(inside.begin(), inside.end());
        INFO("number " << most - inside.begin() << " of them, row by row, has " << *most << " points");
        REQUIRE(*most == 1);
    }
}

std::vector<Vec2> points_from(std::uint32_t first, int k, std::uint64_t key) {
    return test::answers(indices_from(first, k), [&](std::uint32_t i) { return sobol_point(i, key); });
}

/// Of the four pixels of a square of two by two, row by row: which place of the four each has.
std::array<std::uint32_t, 4> order_in_square(std::uint32_t x, std::uint32_t y, std::uint64_t key) {
    std::array<std::uint32_t, 4> order{};
    for (std::uint32_t i = 0; i < 4; ++i) order[i] = pixel_start(x + i % 2, y + i / 2, 1, key) % 4;
    return order;
}

/// A number from 0 to 23 for each order of four.
std::size_t number_of(const std::array<std::uint32_t, 4>& order) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        std::size_t smaller = 0;
        for (std::size_t j = i + 1; j < 4; ++j) smaller += order[j] < order[i];
        number = number * (4 - i) + smaller;
    }
    return number;
}

}  // namespace

// 12.3 ---------------------------------------------------------------------------------------------------

TEST_CASE("points 0 to 7, and point 10, by hand", "[12.3]") {
    const Real first[] = {0, 1. / 2, 1. / 4, 3. / 4, 1. / 8, 5. / 8, 3. / 8, 7. / 8};
    const Real second[] = {0, 1. / 2, 3. / 4, 1. / 4, 5. / 8, 1. / 8, 3. / 8, 7. / 8};
    for (std::uint32_t i = 0; i < 8; ++i) {
        INFO("point " << i);
        CHECK(fraction(sobol_bits(i, 0)) == first[i]);
        CHECK(fraction(sobol_bits(i, 1)) == second[i]);
    }
    INFO("point 10, which is 1010 in binary");
    CHECK(fraction(sobol_bits(10, 0)) == 5. / 16);
    CHECK(fraction(sobol_bits(10, 1)) == 3. / 16);
}

TEST_CASE("point 2^k has the direction number k", "[12.3]") {
    for (std::uint32_t dimension = 0; dimension < sobol_dimensions; ++dimension) {
        const std::array<std::uint32_t, 32> directions = sobol_directions(dimension);
        for (std::uint32_t k = 0; k < 32; ++k) {
            INFO("dimension " << dimension << ", index 2^" << k);
            CHECK(sobol_bits(std::uint32_t(1) << k, dimension) == directions[k]);
        }
    }
}

TEST_CASE("the direction numbers are those of Joe and Kuo", "[12.3]") {
    // Of dimensions 1 to 4, as others print them.
    const std::array<std::uint32_t, 12> expected[] = {
        {0x80000000, 0xc0000000, 0xa0000000, 0xf0000000, 0x88000000, 0xcc000000, 0xaa000000, 0xff000000,
         0x80800000, 0xc0c00000, 0xa0a00000, 0xf0f00000},
        {0x80000000, 0xc0000000, 0x60000000, 0x90000000, 0xe8000000, 0x5c000000, 0x8e000000, 0xc5000000,
         0x68800000, 0x9cc00000, 0xee600000, 0x55900000},
        {0x80000000, 0xc0000000, 0x20000000, 0x50000000, 0xf8000000, 0x74000000, 0xa2000000, 0x93000000,
         0xd8800000, 0x25400000, 0x59e00000, 0xe6d00000},
        {0x80000000, 0x40000000, 0x20000000, 0xb0000000, 0xf8000000, 0xdc000000, 0x7a000000, 0x9d000000,
         0x5a800000, 0x2fc00000, 0xa1600000, 0xf0b00000}};
    for (std::uint32_t dimension = 1; dimension <= 4; ++dimension)
        for (std::size_t k = 0; k < 12; ++k) {
            INFO("dimension " << dimension << ", bit " << k);
            CHECK(sobol_directions(dimension)[k] == expected[dimension - 1][k]);
        }
}

TEST_CASE("in every dimension the first 2^k points are one in each 2^k-th part", "[12.3]") {
    for (std::uint32_t dimension = 0; dimension < sobol_dimensions; ++dimension)
        for (int k = 1; k <= 8; ++k) {
            std::vector<int> inside(std::size_t(1) << k);
            for (const std::uint32_t bits :
                 test::answers(indices_from(0, k), [&](std::uint32_t i) { return sobol_bits(i, dimension); }))
                ++inside[bits >> (32 - k)];
            INFO("dimension " << dimension << ", " << (1 << k) << " points");
            REQUIRE(*std::max_element(inside.begin(), inside.end()) == 1);
        }
}

TEST_CASE("dimensions 0 and 1 are a net for every power of two, wherever it begins", "[12.3]") {
    test::Random random(12301);
    for (int k = 1; k <= 8; ++k)
        for (const std::uint32_t part : {0u, 1u, random_32(random)}) {
            const std::uint32_t begin = part << k;
            const std::vector<Vec2> points = test::answers(indices_from(begin, k), [](std::uint32_t i) {
                return Vec2(fraction(sobol_bits(i, 0)), fraction(sobol_bits(i, 1)));
            });
            INFO("points " << begin << " to " << begin + (std::uint32_t(1) << k) - 1);
            check_net(points, k);
        }
}

TEST_CASE("the point of i xor j is the xor of their points", "[12.3]") {
    test::Random random(12302);
    for (int i = 0; i < cases(2000); ++i) {
        const std::uint32_t a = random_32(random), b = random_32(random);
        const auto dimension = static_cast<std::uint32_t>(random.index(sobol_dimensions));
        INFO("indices " << a << " and " << b << ", dimension " << dimension);
        const std::uint32_t both = sobol_bits(a, dimension) ^ sobol_bits(b, dimension);
        CHECK(sobol_bits(a ^ b, dimension) == both);
    }
}

// 12.4 ---------------------------------------------------------------------------------------------------

TEST_CASE("of eight numbers halves stay halves, quarters quarters, and eighths eighths", "[12.4]") {
    for (std::uint64_t key = 0; key < 20; ++key)
        for (std::uint32_t a = 0; a < 8; ++a)
            for (std::uint32_t b = 0; b < a; ++b) {
                const std::uint32_t from_a = a << 29, from_b = b << 29;
                const std::uint32_t to_a = owen_scrambled(from_a, key), to_b = owen_scrambled(from_b, key);
                INFO("key " << key << ": " << binary(from_a, 3) << " becomes " << binary(to_a, 3) << "… and "
                            << binary(from_b, 3) << " becomes " << binary(to_b, 3) << "…");
                int alike = 1;
                while (bit_of(from_a, alike) == bit_of(from_b, alike)) {
                    INFO("bit " << alike << " after the point is the same before, and so it is after");
                    CHECK(bit_of(to_a, alike) == bit_of(to_b, alike));
                    ++alike;
                }
                INFO("bit " << alike << " after the point is the first to differ before, and so it is after");
                CHECK(bit_of(to_a, alike) != bit_of(to_b, alike));
            }
}

TEST_CASE("a bit that changes changes itself, and nothing above it", "[12.4]") {
    test::Random random(12401);
    for (int i = 0; i < cases(3000); ++i) {
        const std::uint64_t key = random.engine();
        const std::uint32_t bits = random_32(random), one = std::uint32_t(1) << (i % 32);
        const std::uint32_t change = owen_scrambled(bits, key) ^ owen_scrambled(bits ^ one, key);
        INFO("key " << key << ", bits " << binary(bits, 32) << ", of which number " << 32 - i % 32
                    << " after the point is changed: the answer is changed by " << binary(change, 32));
        CHECK((change >= one && change - one < one));
    }
}

TEST_CASE("each bit is flipped by half of the keys", "[12.4]") {
    test::Random random(12402);
    std::array<int, 32> flipped{};
    for (std::uint64_t i = 0; i < keys; ++i) {
        const std::uint32_t bits = random_32(random), flips = owen_scrambled(bits, random.engine()) ^ bits;
        for (int k = 1; k <= 32; ++k) flipped[static_cast<std::size_t>(k - 1)] += bit_of(flips, k) ? 1 : 0;
    }
    // A fair coin is off by six of its standard deviations twice in a thousand million times, one of 32 less
    // than once in ten million.
    const Real off = 6 * std::sqrt(Real(keys)) / 2;
    for (std::size_t k = 0; k < 32; ++k) {
        INFO("bit " << k + 1 << " after the point is flipped " << flipped[k] << " times of " << keys);
        CHECK(std::abs(flipped[k] - Real(keys) / 2) < off);
    }
}

TEST_CASE("the coin of the second bit is another one after a 0 than after a 1", "[12.4]") {
    const auto both = test::answers(successive_keys(12403), [](std::uint64_t key) {
        return std::array{owen_scrambled(0, key), owen_scrambled(0x80000000, key)};
    });
    std::vector<int> first_and_low(4), first_and_high(4), low_and_high(4);
    for (const auto& [from_low, from_high] : both) {
        const unsigned first = bit_of(from_low, 1), low = bit_of(from_low, 2), high = bit_of(from_high, 2);
        ++first_and_low[2 * first + low];
        ++first_and_high[2 * first + high];
        ++low_and_high[2 * low + high];
    }
    {
        INFO("the coin of the first bit, and that of the second after a 0");
        check_even(first_and_low);
    }
    {
        INFO("the coin of the first bit, and that of the second after a 1");
        check_even(first_and_high);
    }
    INFO("the coins of the second bit, after a 0 and after a 1");
    check_even(low_and_high);
}

TEST_CASE("neighbouring keys toss coins of their own", "[12.4]") {
    const std::vector<std::uint32_t> scrambled = test::answers(
        successive_keys(12404, 2 * keys), [](std::uint64_t key) { return owen_scrambled(0, key); });
    std::vector<int> coins(16);
    for (std::size_t i = 0; i < scrambled.size(); i += 2)
        ++coins[4 * (scrambled[i] >> 30) + (scrambled[i + 1] >> 30)];
    INFO("the first two bits of what 0 becomes, by a key and by the next");
    check_even(coins);
}

TEST_CASE("every bit of the key changes the coins", "[12.4]") {
    const std::uint64_t key = any_key(12405);
    for (int bit = 0; bit < 64; ++bit) {
        INFO("the keys " << key << " and " << (key ^ std::uint64_t(1) << bit) << " differ in bit " << bit);
        int different = 0;
        // By chance both are alike once in 2^64 times.
        for (const std::uint32_t bits : {0x12345678u, 0x9abcdef0u})
            different += owen_scrambled(bits, key) != owen_scrambled(bits, key ^ std::uint64_t(1) << bit);
        CHECK(different > 0);
    }
}

// 12.5 ---------------------------------------------------------------------------------------------------

TEST_CASE("of four points one is in each quarter, each quarter of the width, and of the height", "[12.5]") {
    for (std::uint64_t key = 0; key < 20; ++key) {
        const std::vector<Vec2> points = points_from(0, 2, key);
        INFO("key " << key << ": " << points);
        check_net(points, 2);
    }
}

TEST_CASE("2^k points are a net, wherever they begin", "[12.5]") {
    test::Random random(12501);
    for (int k = 0; k <= 8; ++k)
        for (const std::uint32_t part : {0u, 1u, random_32(random), ~0u}) {
            const std::uint64_t key = random.engine();
            INFO("points " << (part << k) << " to " << (part << k) + (std::uint32_t(1) << k) - 1 << ", key "
                           << key);
            check_net(points_from(part << k, k, key), k);
        }
}

TEST_CASE("taken over the keys, a point is anywhere", "[12.5]") {
    std::vector<int> cells(64);
    for (const Vec2& p :
         test::answers(successive_keys(12502), [](std::uint64_t key) { return sobol_point(5, key); }))
        ++cells[static_cast<std::size_t>(8 * p.y) % 8 * 8 + static_cast<std::size_t>(8 * p.x) % 8];
    INFO("where point 5 is, on a board of 8 by 8");
    check_even(cells);
}

TEST_CASE("points 0 and 2 are in the same half, or not, as the key says", "[12.5]") {
    const std::vector<unsigned> same = test::answers(successive_keys(12503, 2 * keys), [](std::uint64_t key) {
        return bit_of(sobol_point(0, key).x, 1) == bit_of(sobol_point(2, key).x, 1) ? 1u : 0u;
    });
    std::vector<int> halves(4);
    for (std::size_t i = 0; i < same.size(); i += 2) ++halves[2 * same[i] + same[i + 1]];
    INFO(
        "whether both are in the left half or both in the right one, by a key and by the next: if that is "
        "the "
        "same for all keys, the points of two keys are not paired at random");
    check_even(halves);
}

TEST_CASE("across and down have coins of their own, as have neighbouring keys", "[12.5]") {
    struct Differ {
        unsigned across = 0, down = 0;
    };
    const std::vector<Differ> differ = test::answers(successive_keys(12504, 2 * keys), [](std::uint64_t key) {
        const Vec2 a = sobol_point(0, key), b = sobol_point(1, key);
        return Differ{bit_of(a.x, 2) ^ bit_of(b.x, 2), bit_of(a.y, 2) ^ bit_of(b.y, 2)};
    });
    std::vector<int> own(4), next(4);
    for (std::size_t i = 0; i < differ.size(); i += 2) {
        ++own[2 * differ[i].across + differ[i].down];
        ++next[2 * differ[i].down + differ[i + 1].across];
    }
    {
        INFO("whether the second bits of points 0 and 1 differ, across and down");
        check_even(own);
    }
    INFO("whether they differ down, and across by the next key");
    check_even(next);
}

TEST_CASE("the four pixels of a square have four successive places", "[12.5]") {
    for (std::uint64_t key = 0; key < 20; ++key) {
        std::array<std::uint32_t, 4> starts{pixel_start(0, 0, 16, key), pixel_start(1, 0, 16, key),
                                            pixel_start(0, 1, 16, key), pixel_start(1, 1, 16, key)};
        INFO("key " << key << ", 16 points a pixel: pixels (0, 0), (1, 0), (0, 1) and (1, 1) begin at "
                    << starts[0] << ", " << starts[1] << ", " << starts[2] << " and " << starts[3]);
        std::sort(starts.begin(), starts.end());
        CHECK(starts[0] % 64 == 0);
        for (std::uint32_t i = 1; i < 4; ++i) CHECK(starts[i] == starts[0] + 16 * i);
    }
}

TEST_CASE("the pixels of every square share successive indices", "[12.5]") {
    test::Random random(12505);
    for (int i = 0; i < cases(100); ++i) {
        const std::uint32_t side = 1u << (1 + i % 3), count = 1u << random.index(9), pixels = side * side;
        const std::uint32_t x = random_32(random) % 4096 / side * side;
        const std::uint32_t y = random_32(random) % 4096 / side * side;
        const std::uint64_t key = random.engine();
        std::vector<std::uint32_t> starts;
        for (std::uint32_t j = 0; j < pixels; ++j)
            starts.push_back(pixel_start(x + j % side, y + j / side, count, key));
        std::sort(starts.begin(), starts.end());
        INFO("the " << side << " by " << side << " pixels from (" << x << ", " << y << ") on, " << count
                    << " points each, key " << key << ": the first begins at " << starts[0]);
        REQUIRE(starts[0] % (pixels * count) == 0);
        for (std::uint32_t j = 0; j < pixels; ++j) REQUIRE(starts[j] == starts[0] + j * count);
    }
}

TEST_CASE("after 4096 pixels it begins again", "[12.5]") {
    for (std::uint64_t key = 0; key < 5; ++key) {
        INFO("key " << key);
        CHECK(pixel_start(4096 + 17, 3 * 4096 + 1000, 8, key) == pixel_start(17, 1000, 8, key));
        CHECK(pixel_start(4096 + 17, 1000, 8, key) != pixel_start(17 + 2048, 1000, 8, key));
    }
}

TEST_CASE("a square of pixels has each of the 24 orders equally often", "[12.5]") {
    const std::vector<std::uint64_t> all = successive_keys(12506);
    std::vector<int> by_key(24), by_place(24);
    for (const auto& order :
         test::answers(all, [](std::uint64_t key) { return order_in_square(34, 56, key); }))
        ++by_key[number_of(order)];
    std::vector<std::uint32_t> squares(keys);
    std::iota(squares.begin(), squares.end(), 0u);
    for (const auto& order : test::answers(
             squares, [&](std::uint32_t i) { return order_in_square(2 * (i % 50), 2 * (i / 50), all[0]); }))
        ++by_place[number_of(order)];
    {
        INFO("the square at (34, 56), by " << keys << " keys");
        check_even(by_key);
    }
    INFO(keys << " squares by one key");
    check_even(by_place);
}

TEST_CASE("four pixels of four points each have a net of sixteen together", "[12.5]") {
    test::Random random(12507);
    for (int i = 0; i < 20; ++i) {
        const std::uint32_t x = random_32(random) % 2048 * 2, y = random_32(random) % 2048 * 2;
        const std::uint64_t key = random.engine();
        std::vector<Vec2> points;
        for (std::uint32_t j = 0; j < 4; ++j) {
            const std::uint32_t start = pixel_start(x + j % 2, y + j / 2, 4, key);
            for (const Vec2& p : points_from(start, 2, key)) points.push_back(p);
        }
        INFO("the pixels from (" << x << ", " << y << ") on, key " << key);
        check_net(points, 4);
    }
}
