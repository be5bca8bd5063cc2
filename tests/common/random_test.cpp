// Random numbers, in sequences and streams: what they depend on, that they are uniform, and that no two
// sequences have anything in common.
#include "common/math/random.hpp"
#include "common/world/stream.hpp"

#include "tests/catch.hpp"
#include "tests/chi_square.hpp"
#include "tests/support.hpp"

#include <set>
#include <vector>

using rt::Random, rt::Real, rt::random_for, rt::random_real, rt::random_index;
using rt::Stream, rt::next_real, rt::next_point;
using rt::test::cases, rt::test::chi_square, rt::test::chi_square_limit;

namespace {

/// Whether pairs of numbers fill the 16 × 16 fields of a square evenly.
template <class Pair>
void check_pairs(Pair pair) {
    std::vector<int> counts(256);
    for (int i = 0; i < cases(200'000); ++i) {
        const rt::Vec2 place = pair(static_cast<std::uint64_t>(i));
        ++counts[static_cast<std::size_t>(16 * place.x) * 16 + static_cast<std::size_t>(16 * place.y)];
    }
    CHECK(chi_square(counts) < chi_square_limit(256));
}

Real first_of(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample) {
    Random random = random_for(seed, pixel, sample);
    return random_real(random);
}

}  // namespace

TEST_CASE("bits are stirred as by splitmix64") {
    // The first numbers of the published generator from the state 0, whose step is 0x9e3779b97f4a7c15.
    CHECK(rt::stirred(0x9e3779b97f4a7c15u) == 0xe220a8397b1dcdafu);
    CHECK(rt::stirred(2 * 0x9e3779b97f4a7c15u) == 0x6e789e6aa1b965f4u);
    CHECK(rt::mixed(0, 0) == 0xe220a8397b1dcdafu);
}

TEST_CASE("random numbers depend on seed, pixel, sample and dimension, and on nothing else") {
    Random a = random_for(1, 2, 3), b = random_for(1, 2, 3);
    for (int i = 0; i < 10; ++i) CHECK(random_real(a) == random_real(b));
    CHECK(a.dimension == 10);
    const Random copy = a;
    Random again = copy;
    CHECK(random_real(a) == random_real(again));
    CHECK(copy.dimension == 10);

    std::set<std::uint64_t> keys;
    for (std::uint64_t seed = 0; seed < 10; ++seed)
        for (std::uint64_t pixel = 0; pixel < 100; ++pixel)
            for (std::uint64_t sample = 0; sample < 100; ++sample)
                keys.insert(random_for(seed, pixel, sample).key);
    CHECK(keys.size() == 100'000);
}

TEST_CASE("random numbers are from 0 to just below 1") {
    static_assert([] {
        Random random = random_for(0, 0, 0);
        return random_real(random) < 1;
    }());
    Random random = random_for(0, 0, 0);
    Real least = 1, greatest = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Real x = random_real(random);
        if (!(x >= 0 && x < 1)) REQUIRE((x >= 0 && x < 1));
        least = std::min(least, x);
        greatest = std::max(greatest, x);
    }
    // Each fails by chance in e^-20 of all seeds.
    CHECK(least < 2e-4);
    CHECK(greatest > 1 - 2e-4);
}

TEST_CASE("random numbers are uniform, and neighbours in any direction independent") {
    SECTION("one sequence") {
        Random random = random_for(5, 0, 0);
        check_pairs([&](std::uint64_t) { return random_point(random); });
    }
    SECTION("neighbouring pixels") {
        check_pairs([](std::uint64_t i) { return rt::Vec2(first_of(0, i, 0), first_of(0, i + 1, 0)); });
    }
    SECTION("neighbouring samples") {
        check_pairs([](std::uint64_t i) { return rt::Vec2(first_of(0, 7, i), first_of(0, 7, i + 1)); });
    }
    SECTION("neighbouring seeds") {
        check_pairs([](std::uint64_t i) { return rt::Vec2(first_of(i, 7, 0), first_of(i + 1, 7, 0)); });
    }
    SECTION("pixel and sample exchanged") {
        check_pairs([](std::uint64_t i) { return rt::Vec2(first_of(0, i, 1000), first_of(0, 1000, i)); });
    }
    SECTION("the low bits") {
        Random random = random_for(6, 0, 0);
        check_pairs([&](std::uint64_t) {
            const Real x = random_real(random) * 0x1p45, y = random_real(random) * 0x1p45;
            return rt::Vec2(x - std::floor(x), y - std::floor(y));
        });
    }
}

TEST_CASE("a stream's numbers are a function of seed, pixel, sample and dimension", "[stream]") {
    const Stream stream{.seed = 1, .x = 2, .y = 5, .sample = 3, .dimension = 4};
    Stream a = stream, b = stream;
    CHECK(next_real(a) == next_real(b));
    CHECK(a.dimension == 5);
    // Whatever was asked for before.
    Stream later{.seed = 1, .x = 2, .y = 5, .sample = 3};
    for (int i = 0; i < 4; ++i) next_real(later);
    CHECK(next_real(later) == next_real(b = stream));

    std::set<Real> numbers;
    for (std::uint32_t sample = 0; sample < 10; ++sample)
        for (std::uint32_t dimension = 0; dimension < 10; ++dimension)
            for (int other = 1; other <= 10; ++other) {
                Stream seeds{static_cast<std::uint64_t>(other), 0, 0, sample, dimension};
                Stream columns{0, other, 0, sample, dimension}, rows{0, 0, other, sample, dimension};
                numbers.insert({next_real(seeds), next_real(columns), next_real(rows)});
            }
    CHECK(numbers.size() == 3000);
}

TEST_CASE("a stream counts the numbers that it gives", "[stream]") {
    Stream stream;
    const std::uint64_t before = rt::ray_counts().random_numbers;
    const rt::Vec2 point = next_point(stream);
    CHECK(rt::ray_counts().random_numbers == before + 2);
    CHECK(stream.dimension == 2);
    Stream again;
    const Real x = next_real(again);
    CHECK(point == rt::Vec2(x, next_real(again)));
}

TEST_CASE("a stream's numbers are uniform, and neighbours in any direction independent", "[stream]") {
    const auto number = [](Stream stream) { return next_real(stream); };
    SECTION("one stream") {
        Stream stream{.seed = 5};
        check_pairs([&](std::uint64_t) { return next_point(stream); });
    }
    SECTION("neighbouring pixels") {
        check_pairs([&](std::uint64_t i) {
            const int x = static_cast<int>(i % 1024), y = static_cast<int>(i / 1024);
            return rt::Vec2(number({.x = x, .y = y}), number({.x = x, .y = y + 1}));
        });
    }
    SECTION("neighbouring samples") {
        check_pairs([&](std::uint64_t i) {
            const auto sample = static_cast<std::uint32_t>(i);
            return rt::Vec2(number({.sample = sample}), number({.sample = sample + 1}));
        });
    }
    SECTION("a stream and the pattern of its pixel") {
        check_pairs(
            [&](std::uint64_t i) { return rt::Vec2(number({.x = static_cast<int>(i)}), first_of(0, i, 0)); });
    }
}

TEST_CASE("random indices are each as likely as any other") {
    Random random = random_for(8, 0, 0);
    std::vector<int> counts(7);
    for (int i = 0; i < cases(70'000); ++i) {
        const std::uint64_t index = random_index(random, 7);
        REQUIRE(index < 7);
        ++counts[index];
    }
    CHECK(chi_square(counts) < chi_square_limit(7));
    CHECK(random_index(random, 1) == 0);
    CHECK(random_index(random, std::uint64_t(1) << 52) < std::uint64_t(1) << 52);
}
