// Winnowing keeps its promise: what two texts share at length leaves the same fingerprint in both.
#include "common/similarity/winnowing.hpp"
#include "common/math/random.hpp"
#include "common/similarity/tiling.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <set>

using namespace rt;

namespace {

std::vector<std::uint16_t> some_kinds(Random& random, std::size_t count, std::uint64_t different) {
    std::vector<std::uint16_t> kinds(count);
    for (auto& kind : kinds) kind = static_cast<std::uint16_t>(1 + random_index(random, different));
    return kinds;
}

}  // namespace

TEST_CASE("hashes of grams are the same wherever a gram stands", "[similarity]") {
    const std::vector<std::uint16_t> kinds{5, 1, 2, 3, 9, 1, 2, 3, 1};
    const std::vector<std::uint64_t> hashes = hashes_of_grams(kinds, 3);
    REQUIRE(hashes.size() == 7);
    CHECK(hashes[1] == hashes[5]);
    CHECK(std::set(hashes.begin(), hashes.end()).size() == 6);
    CHECK(hashes_of_grams(kinds, 10).empty());
}

TEST_CASE("winnowing keeps what its authors show", "[similarity]") {
    // The figure of Schleimer, Wilkerson & Aiken 2003: windows of 4, the least of each, the last of equal
    // ones.
    const std::vector<std::uint64_t> hashes{77, 74, 42, 17, 98, 50, 17, 98, 8,
                                            88, 67, 39, 77, 74, 42, 17, 98};
    CHECK(winnowed(hashes, 4) == std::vector<std::size_t>{3, 6, 8, 11, 15});
    CHECK(winnowed(hashes, 1).size() == hashes.size());
    CHECK(winnowed({}, 4).empty());
    CHECK(winnowed(std::vector<std::uint64_t>{3, 1, 1}, 4) == std::vector<std::size_t>{2});
}

TEST_CASE("of each window a hash is kept, and it is its least", "[similarity]") {
    Random random = random_for(7, 0, 0);
    for (int i = 0; i < 50; ++i) {
        const std::vector<std::uint64_t> hashes = hashes_of_grams(some_kinds(random, 60, 3), 2);
        const std::size_t window = 1 + random_index(random, 9);
        const std::vector<std::size_t> kept = winnowed(hashes, window);
        std::set<std::size_t> expected;
        for (std::size_t begin = 0; begin + window <= hashes.size(); ++begin) {
            std::size_t least = begin;
            for (std::size_t k = begin; k < begin + window; ++k)
                if (hashes[k] <= hashes[least]) least = k;
            expected.insert(least);
        }
        CHECK(kept == std::vector<std::size_t>(expected.begin(), expected.end()));
    }
}

TEST_CASE("a part that two texts share is never missed", "[similarity]") {
    constexpr std::size_t gram = 5, window = 8, least = gram + window - 1;
    Random random = random_for(11, 0, 0);
    for (int i = 0; i < 200; ++i) {
        const std::vector<std::uint16_t> shared = some_kinds(random, least, 9);
        std::vector<std::uint16_t> texts[2];
        std::set<std::uint64_t> kept[2];
        for (int k = 0; k < 2; ++k) {
            for (const auto& part : {some_kinds(random, random_index(random, 30), 9), shared,
                                     some_kinds(random, random_index(random, 30), 9)})
                texts[k].insert(texts[k].end(), part.begin(), part.end());
            const std::vector<std::uint64_t> hashes = hashes_of_grams(texts[k], gram);
            for (const std::size_t at : winnowed(hashes, window)) kept[k].insert(hashes[at]);
        }
        std::vector<std::uint64_t> both;
        std::set_intersection(kept[0].begin(), kept[0].end(), kept[1].begin(), kept[1].end(),
                              std::back_inserter(both));
        CHECK_FALSE(both.empty());
    }
}

TEST_CASE("tiles are the longest first, do not overlap, and are as long as asked", "[similarity]") {
    const std::vector<std::uint16_t> first{1, 2, 3, 4, 5, 6, 0, 7, 8, 9};
    const std::vector<std::uint16_t> second{7, 8, 9, 0, 3, 4, 5, 1, 2, 3, 4};
    std::vector<std::pair<std::size_t, std::size_t>> everywhere;
    for (std::size_t i = 0; i < first.size(); ++i)
        for (std::size_t j = 0; j < second.size(); ++j) everywhere.emplace_back(i, j);
    const std::vector<SharedRun> tiles = shared_runs(first, second, everywhere, 3);
    REQUIRE(tiles.size() == 2);
    CHECK((tiles[0].first == 0 && tiles[0].second == 7 && tiles[0].length == 4));
    // 3 4 5 is shared, too, but its 3 and 4 are in the longer one.
    CHECK((tiles[1].first == 7 && tiles[1].second == 0 && tiles[1].length == 3));
    CHECK(shared_runs(first, second, everywhere, 1).size() == 3);
}
