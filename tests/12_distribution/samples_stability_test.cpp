// Steps 12.1 and 12.2 with as many samples as there can be.
#include "chapters/12_distribution/samples.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rt;
using test::cases;
using test::near;

namespace {

/// Around each power of two, and the most there can be.
std::vector<std::uint32_t> counts() {
    std::vector<std::uint32_t> all{~std::uint32_t(0)};
    for (int k = 2; k < 32; ++k)
        for (const int more : {-1, 0, 1})
            all.push_back((std::uint32_t(1) << k) + static_cast<std::uint32_t>(more));
    return all;
}

/// The first, the last, and some between.
std::vector<std::uint32_t> some_of(std::uint32_t count, test::Random& random) {
    std::vector<std::uint32_t> indices{0, count - 1};
    for (int i = 0; i < cases(100); ++i) indices.push_back(static_cast<std::uint32_t>(random.index(count)));
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return indices;
}

/// Whether no two neighbours of a sorted list are equal.
template <class T>
bool are_different(const std::vector<T>& sorted) {
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

std::uint64_t any_key(test::Random& random) {
    const std::uint64_t keys[] = {0, ~std::uint64_t(0), std::uint64_t(1) << 63, random.engine()};
    return keys[random.index(4)];
}

}  // namespace

TEST_CASE("places of some of up to 2^32 - 1 samples are below the count, and differ", "[12.1][stability]") {
    test::Random random(12191);
    for (const std::uint32_t count : counts()) {
        const std::uint64_t key = any_key(random);
        std::vector<std::uint32_t> places;
        const std::vector<std::uint32_t> indices = some_of(count, random);
        for (const std::uint32_t index : indices) {
            places.push_back(permuted(index, count, key));
            INFO("sample " << index << " of " << count << ", key " << key << ": place " << places.back());
            REQUIRE(places.back() < count);
        }
        std::sort(places.begin(), places.end());
        INFO(indices.size() << " of " << count << " samples, key " << key);
        CHECK(are_different(places));
    }
}

TEST_CASE("numbers of up to 2^32 - 1 samples are in parts of their own", "[12.2][stability]") {
    test::Random random(12291);
    for (const std::uint32_t count : counts()) {
        const std::uint64_t key = any_key(random);
        std::vector<Real> parts;
        for (const std::uint32_t index : some_of(count, random)) {
            const Real x = stratified_number(index, count, key), all = count;
            INFO("number " << index << " of " << count << ", key " << key << ": " << x);
            REQUIRE((0 <= x && x < 1));
            Real part = std::floor(x * all);
            // The product may be rounded over the border.
            if (x < part / all) --part;
            if (x >= (part + 1) / all) ++part;
            parts.push_back(part);
        }
        std::sort(parts.begin(), parts.end());
        INFO("numbers of " << count << " samples, key " << key);
        CHECK(are_different(parts));
    }
}

TEST_CASE("points of up to 2^32 - 1 samples are in strata of their own", "[12.2][stability]") {
    test::Random random(12292);
    for (const std::uint32_t count : counts()) {
        const std::uint64_t key = any_key(random);
        std::vector<std::pair<Real, Real>> corners;
        // Row j begins with part floor(j·count/rows); found here by trial from where the point is.
        const Real all = count, rows = std::floor(std::sqrt(all));
        for (const std::uint32_t index : some_of(count, random)) {
            const Vec2 p = stratified_point(index, count, key);
            INFO("point " << index << " of " << count << ", key " << key << ": " << p);
            REQUIRE((0 <= p.x && p.x < 1 && 0 <= p.y && p.y < 1));
            const auto begin = [&](Real row) { return std::floor(row * all / rows); };
            Real row = std::floor(p.y * rows);
            while (row > 0 && p.y < begin(row) / all) --row;
            while (p.y >= begin(row + 1) / all) ++row;
            const Real columns = begin(row + 1) - begin(row);
            Real column = std::floor(p.x * columns);
            if (p.x < column / columns) --column;
            if (p.x >= (column + 1) / columns) ++column;
            corners.emplace_back(row, column);
        }
        std::sort(corners.begin(), corners.end());
        INFO("points of " << count << " samples, key " << key);
        CHECK(are_different(corners));
    }
}

TEST_CASE("a stratum of very many has its share of the square", "[12.2][stability]") {
    test::Random random(12293);
    for (const std::uint32_t count : counts())
        for (const std::uint32_t index : some_of(count, random)) {
            const Stratum part = stratum(index, count);
            INFO("stratum " << index << " of " << count << ": " << part);
            const Vec2 size = part.high - part.low;
            // The edges are right to u, their differences to u of 1, which is u·rows of themselves.
            const Real share = size.x * size.y * count;
            CHECK(near(share, 1, gamma(8) * std::sqrt(Real(count))));
            CHECK((part.low.x >= 0 && part.high.x <= 1 && part.low.y >= 0 && part.high.y <= 1));
        }
}
