// Steps 12.1 and 12.2: random orders, and stratified numbers and points that are paired by them.
#include "chapters/12_distribution/samples.hpp"
#include "common/math/error.hpp"
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
using test::chi_square;
using test::chi_square_limit;

namespace {

// Each χ² test fails a right program once in ten million runs, and each step has at most seven of them: less
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

/// 0 … count − 1.
std::vector<std::uint32_t> indices(std::uint32_t count) {
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

std::vector<std::uint32_t> order_of(std::uint32_t count, std::uint64_t key) {
    return test::answers(indices(count), [&](std::uint32_t i) { return permuted(i, count, key); });
}

/// Whether each of 0 … count − 1 is there once.
test::Told has_each_once(std::vector<std::uint32_t> places) {
    std::sort(places.begin(), places.end());
    std::string wrong;
    for (std::size_t i = 0; i < places.size() && wrong.empty(); ++i)
        if (places[i] != i)
            wrong = i > 0 && places[i] == places[i - 1]
                        ? "two samples have the place " + test::show(places[i])
                        : "no sample has the place " + test::show(i);
    return test::or_say(wrong.empty(), wrong);
}

/// Only the first few, where they are many.
std::string listed(const std::vector<std::uint32_t>& places) {
    std::string text;
    for (std::size_t i = 0; i < std::min(places.size(), std::size_t(40)); ++i)
        text += (i > 0 ? " " : "") + std::to_string(places[i]);
    return text + (places.size() > 40 ? " …" : "");
}

/// In which of `parts` equal parts of [0, 1) it is; the last one for what is beyond.
std::size_t cell(Real x, std::size_t parts) {
    return static_cast<std::size_t>(std::clamp(x, Real(0), Real(1) - unit_roundoff) *
                                    static_cast<Real>(parts));
}

/// In which of `count` parts of [0, 1) the number is, and how far in it, from 0 to 1.
struct Place {
    std::size_t part = 0;
    Real within = 0;
};
Place place_of(Real x, std::size_t count) {
    const Real scaled = x * static_cast<Real>(count);
    const std::size_t part = cell(x, count);
    return {part, scaled - static_cast<Real>(part)};
}

void check_even(const std::vector<int>& counts) {
    INFO("chi-square of " << counts.size() << " classes that should be equally full: " << chi_square(counts)
                          << ", at most " << chi_square_limit(counts.size()) << " by chance");
    CHECK(chi_square(counts) < chi_square_limit(counts.size()));
}

void check_one_in_each(std::uint32_t count, std::uint64_t key) {
    const std::vector<Real> numbers =
        test::answers(indices(count), [&](std::uint32_t i) { return stratified_number(i, count, key); });
    std::vector<int> inside(count);
    const Real all = count;
    for (const Real x : numbers)
        for (std::uint32_t k = 0; k < count; ++k) inside[k] += k / all <= x && x < (k + 1) / all;
    INFO(count << " numbers of the key " << key);
    if (count <= 16) INFO("they are " << numbers);
    for (std::uint32_t k = 0; k < count; ++k) {
        INFO("from " << k << "/" << count << " to " << k + 1 << "/" << count << " there are " << inside[k]);
        REQUIRE(inside[k] == 1);
    }
}

bool inside(const Stratum& part, const Vec2& p) {
    return part.low.x <= p.x && p.x < part.high.x && part.low.y <= p.y && p.y < part.high.y;
}

/// The strata of 08.2, by its words.
std::vector<Stratum> all_strata(std::uint32_t count) {
    std::vector<Stratum> parts;
    std::uint32_t rows = 1;
    while ((rows + 1) * (rows + 1) <= count) ++rows;
    for (std::uint32_t row = 0; row < rows; ++row) {
        const std::uint32_t begin = row * count / rows, end = (row + 1) * count / rows;
        for (std::uint32_t i = begin; i < end; ++i)
            parts.push_back({{Real(i - begin) / (end - begin), Real(begin) / count},
                             {Real(i - begin + 1) / (end - begin), Real(end) / count}});
    }
    return parts;
}

void check_one_point_in_each(std::uint32_t count, std::uint64_t key) {
    const std::vector<Vec2> points =
        test::answers(indices(count), [&](std::uint32_t i) { return stratified_point(i, count, key); });
    INFO(count << " points of the key " << key);
    if (count <= 16) INFO("they are " << points);
    for (const Stratum& part : all_strata(count)) {
        const auto found =
            std::count_if(points.begin(), points.end(), [&](const Vec2& p) { return inside(part, p); });
        INFO("in the stratum from " << part.low << " to " << part.high << " there are " << found);
        REQUIRE(found == 1);
    }
}

}  // namespace

// 12.1 ---------------------------------------------------------------------------------------------------

TEST_CASE("one sample has the place 0, and two have the places 0 and 1", "[12.1]") {
    for (std::uint64_t key = 0; key < 10; ++key) {
        INFO("key " << key);
        CHECK(permuted(0, 1, key) == 0);
        CHECK(permuted(0, 2, key) + permuted(1, 2, key) == 1);
    }
}

TEST_CASE("five samples have each place once", "[12.1]") {
    for (std::uint64_t key = 0; key < 20; ++key) {
        const std::vector<std::uint32_t> places = order_of(5, key);
        INFO("key " << key << ": the places of 0, 1, 2, 3 and 4 are " << listed(places));
        CHECK(has_each_once(places));
    }
}

TEST_CASE("each place once, for any number of samples", "[12.1]") {
    test::Random random(12101);
    const auto check = [&](std::uint32_t count) {
        const std::uint64_t key = random.engine();
        const std::vector<std::uint32_t> places = order_of(count, key);
        INFO(count << " samples, key " << key << ": their places are " << listed(places));
        REQUIRE(has_each_once(places));
    };
    for (std::uint32_t count = 1; count <= 70; ++count) check(count);
    for (const std::uint32_t count : {100u, 127u, 128u, 129u, 255u, 256u, 257u, 1000u}) check(count);
}

TEST_CASE("an index comes to each place equally often", "[12.1]") {
    for (const std::uint32_t count : {2u, 5u, 16u}) {
        std::vector<int> places(count);
        for (const std::uint32_t place : test::answers(
                 successive_keys(12102), [&](std::uint64_t key) { return permuted(1, count, key); }))
            ++places[std::min(place, count - 1)];
        INFO("the places of sample 1 of " << count << " by " << keys << " keys");
        check_even(places);
    }
}

TEST_CASE("two samples come to each pair of places equally often", "[12.1]") {
    for (const std::uint32_t count : {4u, 9u, 16u}) {
        std::vector<int> pairs(count * (count - 1));
        const std::uint32_t one = count / 2 - 1, other = count / 2;
        const auto places = test::answers(successive_keys(12103), [&](std::uint64_t key) {
            return std::array{permuted(one, count, key), permuted(other, count, key)};
        });
        for (const auto& place : places) {
            const std::uint32_t a = std::min(place[0], count - 1), b = std::min(place[1], count - 1);
            ++pairs[a * (count - 1) + std::min(b < a ? b : b - 1, count - 2)];
        }
        INFO("the places of samples " << one << " and " << other << " of " << count << " by " << keys
                                      << " keys; they are neighbours, and their places need not be");
        check_even(pairs);
    }
}

TEST_CASE("neighbouring keys have independent orders", "[12.1]") {
    const std::vector<std::uint32_t> places = test::answers(
        successive_keys(12104, 2 * keys), [](std::uint64_t key) { return permuted(3, 8, key); });
    std::vector<int> same(64);
    for (std::size_t i = 0; i < places.size(); i += 2)
        ++same[8 * std::min(places[i], 7u) + std::min(places[i + 1], 7u)];
    INFO("the places of sample 3 of 8 by a key and by the next one");
    check_even(same);
}

TEST_CASE("every bit of the key counts", "[12.1]") {
    const std::uint64_t key = any_key(12105);
    for (int bit = 0; bit < 64; ++bit) {
        INFO("the keys " << key << " and " << (key ^ std::uint64_t(1) << bit) << " differ in bit " << bit);
        // By chance once in 32! = 2.6e35 times.
        CHECK(order_of(32, key) != order_of(32, key ^ std::uint64_t(1) << bit));
    }
}

// 12.2 ---------------------------------------------------------------------------------------------------

TEST_CASE("of four numbers one is in each quarter", "[12.2]") {
    for (std::uint64_t key = 0; key < 20; ++key) check_one_in_each(4, key);
}

TEST_CASE("of five points two are in the upper row, which is two fifths high", "[12.2]") {
    for (std::uint64_t key = 0; key < 20; ++key) {
        int upper = 0, left = 0;
        for (std::uint32_t i = 0; i < 5; ++i) {
            const Vec2 p = stratified_point(i, 5, key);
            INFO("key " << key << ", point " << i << " at " << p);
            CHECK((0 <= p.x && p.x < 1 && 0 <= p.y && p.y < 1));
            upper += p.y < 0.4;
            left += p.y < 0.4 && p.x < 0.5;
        }
        INFO("key " << key << ": points in the upper row, and in the left half of it");
        CHECK(upper == 2);
        CHECK(left == 1);
    }
}

TEST_CASE("one number in each part, for any number of samples", "[12.2]") {
    test::Random random(12201);
    for (std::uint32_t count = 1; count <= 40; ++count) check_one_in_each(count, random.engine());
    for (const std::uint32_t count : {100u, 256u}) check_one_in_each(count, random.engine());
}

TEST_CASE("one point in each stratum, for any number of samples", "[12.2]") {
    test::Random random(12202);
    for (std::uint32_t count = 1; count <= 40; ++count) check_one_point_in_each(count, random.engine());
    for (const std::uint32_t count : {100u, 256u}) check_one_point_in_each(count, random.engine());
}

TEST_CASE("a stratum alone is the same as among all", "[12.2]") {
    for (std::uint32_t count = 1; count <= 100; ++count) {
        const std::vector<Stratum> expected = all_strata(count);
        const std::vector<Stratum> parts =
            test::answers(indices(count), [&](std::uint32_t i) { return stratum(i, count); });
        for (std::size_t i = 0; i < count; ++i) {
            INFO("number " << i << " of " << count << " strata: " << parts[i]);
            REQUIRE(parts[i].low == expected[i].low);
            REQUIRE(parts[i].high == expected[i].high);
        }
    }
}

TEST_CASE("a number is anywhere in its part, wherever the others are in theirs", "[12.2]") {
    const auto numbers = test::answers(successive_keys(12203), [](std::uint64_t key) {
        return std::array{stratified_number(0, 8, key), stratified_number(1, 8, key)};
    });
    std::vector<int> within(64), neighbours(64);
    for (const auto& pair : numbers) {
        const Place a = place_of(pair[0], 8), b = place_of(pair[1], 8);
        ++within[8 * a.part + cell(a.within, 8)];
        ++neighbours[8 * cell(a.within, 8) + cell(b.within, 8)];
    }
    {
        INFO("in which of 8 parts number 0 is, and where in it");
        check_even(within);
    }
    INFO("where numbers 0 and 1 are in their parts");
    check_even(neighbours);
}

TEST_CASE("a point is anywhere in its stratum", "[12.2]") {
    const std::vector<Vec2> points =
        test::answers(successive_keys(12204), [](std::uint64_t key) { return stratified_point(2, 16, key); });
    std::vector<int> within(64);
    for (const Vec2& p : points)
        ++within[8 * cell(place_of(p.x, 4).within, 8) + cell(place_of(p.y, 4).within, 8)];
    INFO("where point 2 of 16 is in its stratum, across and down: neither says anything of the other");
    check_even(within);
}

TEST_CASE("neighbouring keys have nothing to do with each other", "[12.2]") {
    const std::vector<std::uint64_t> all = successive_keys(12205, 2 * keys);
    const std::vector<Real> number =
        test::answers(all, [](std::uint64_t key) { return stratified_number(5, 8, key); });
    const std::vector<Vec2> point =
        test::answers(all, [](std::uint64_t key) { return stratified_point(5, 16, key); });
    std::vector<int> parts(64), numbers(64), points(64);
    for (std::size_t i = 0; i < all.size(); i += 2) {
        const Place a = place_of(number[i], 8), b = place_of(number[i + 1], 8);
        ++parts[8 * a.part + b.part];
        ++numbers[8 * cell(a.within, 8) + cell(b.within, 8)];
        const Vec2 &p = point[i], &q = point[i + 1];
        ++points[8 * cell(place_of(p.y, 4).within, 8) + cell(place_of(q.x, 4).within, 8)];
    }
    {
        INFO(
            "in which of 8 parts number 5 is by a key, say its time, and by the next, say its place on a "
            "light");
        check_even(parts);
    }
    {
        INFO("where in its part it is by a key, and by the next");
        check_even(numbers);
    }
    INFO("how far down point 5 of 16 is in its stratum by a key, and how far to the right by the next");
    check_even(points);
}
