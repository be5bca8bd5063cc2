// Step 12.15 with weights of all sizes, many of them, and numbers next to the sums.
#include "chapters/12_distribution/choice.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <vector>

using namespace rt;
using test::cases;
using test::near;
using test::Random;

namespace {

using Numbers = std::vector<Real>;

}  // namespace

TEST_CASE("weights of all sizes", "[12.15][stability]") {
    Random random(121510);
    for (int i = 0; i < cases(3000); ++i) {
        const std::size_t count = 1 + random.index(12);
        Numbers weights(count);
        for (Real& weight : weights) {
            const Real size = random.magnitude(-150, 150);
            weight = random.index(3) == 0 ? 0 : size;
        }
        INFO("weights " << weights);
        const Numbers sums = cumulative(weights);
        INFO("sums " << sums);
        REQUIRE(sums.size() == count);
        CHECK(near(sums.back(), 1, 0));
        long double all = 0, sum = 0;
        for (const Real weight : weights) all += weight;
        for (std::size_t k = 0; k < count && all > 0; ++k) {
            sum += weights[k];
            const Real expected = static_cast<Real>(sum / all);
            CHECK(near(sums[k], expected, gamma(static_cast<int>(count) + 3) * expected));
            const Real before = k == 0 ? 0 : sums[k - 1];
            CHECK(sums[k] >= before);
            if (weights[k] == 0) CHECK(near(sums[k], before, 0));
        }
        for (const Real number : {0.0, 0x1p-1074, 1e-300, 0.5, 1 - 0x1p-53}) {
            const Choice choice = choose(sums, number);
            INFO("random number " << number);
            REQUIRE(choice.index < count);
            CHECK((all == 0 || weights[choice.index] > 0));
            CHECK(choice.probability > 0);
            CHECK((choice.random >= 0 && choice.random < 1));
        }
    }
}

TEST_CASE("numbers next to the sums", "[12.15][stability]") {
    Random random(121511);
    for (int i = 0; i < cases(5000); ++i) {
        // Sums that are unlike each other by a few ulps, or by much.
        Numbers sums;
        Real sum = 0;
        const std::size_t count = 2 + random.index(6);
        for (std::size_t k = 0; k + 1 < count; ++k) {
            const Real step = random.magnitude(-17, -1);
            sum += random.index(4) == 0 ? 0 : step;
            sums.push_back(sum);
        }
        sums.push_back(1);
        const Real at = sums[random.index(count - 1)];
        const std::size_t way = random.index(3);
        const Real number = way == 0 ? at : std::nextafter(at, way == 1 ? 0.0 : 1.0);
        INFO("sums " << sums << ", random number " << number);
        const Choice choice = choose(sums, number);
        // Counted, and not searched.
        std::size_t expected = 0;
        for (const Real s : sums) expected += s <= number;
        REQUIRE(choice.index == expected);
        const Real before = expected == 0 ? 0 : sums[expected - 1];
        CHECK(near(choice.probability, sums[expected] - before, gamma(2) * sums[expected]));
        CHECK((choice.random >= 0 && choice.random < 1));
        const long double rest = (static_cast<long double>(number) - before) / (sums[expected] - before);
        CHECK(near(choice.random, static_cast<Real>(rest), gamma(5)));
    }
}

TEST_CASE("a hundred thousand lights", "[12.15][stability]") {
    const std::size_t count = 100000;
    Numbers weights(count);
    for (std::size_t k = 0; k < count; ++k) weights[k] = static_cast<Real>(k % 7);
    const Numbers sums = cumulative(weights);
    REQUIRE(sums.size() == count);
    CHECK(near(sums.back(), 1, 0));
    Random random(121512);
    // A search from the first on would look at 5e9 sums here, and be as right.
    for (int i = 0; i < cases(2000); ++i) {
        const Real number = random.uniform(0, 1);
        const Choice choice = choose(sums, number);
        INFO("random number " << number);
        REQUIRE(choice.index < count);
        CHECK(weights[choice.index] > 0);
        CHECK(sums[choice.index] > number);
        if (choice.index > 0) CHECK(sums[choice.index - 1] <= number);
    }
}
