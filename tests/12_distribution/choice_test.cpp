// Step 12.15: one of many, by their weights.
#include "chapters/12_distribution/choice.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/chi_square.hpp"
#include "tests/support.hpp"
#include "tests/together.hpp"

#include <cmath>
#include <vector>

using namespace rt;
using test::cases;
using test::near;
using test::Random;

namespace {

using Numbers = std::vector<Real>;

/// Whether two lists are equal, but for rounding.
test::Told all_near(const Numbers& actual, const Numbers& expected) {
    bool right = actual.size() == expected.size();
    for (std::size_t i = 0; right && i < actual.size(); ++i) right = near(actual[i], expected[i], gamma(16));
    return test::or_say(right, test::show(actual) + ", expected " + test::show(expected));
}

void check_choice(const Numbers& sums, Real random, std::uint32_t index, Real probability, Real rest) {
    INFO("sums " << sums << ", random number " << random);
    const Choice choice = choose(sums, random);
    CHECK(choice.index == index);
    CHECK(near(choice.probability, probability, gamma(16)));
    CHECK(near(choice.random, rest, gamma(16)));
}

}  // namespace

TEST_CASE("sums of three weights", "[12.15]") {
    const Numbers sums = cumulative(Numbers{1, 2, 1});
    INFO("of the weights 1, 2, 1 the sums are " << sums << "; expected 0.25, 0.75, 1");
    CHECK(all_near(sums, {0.25, 0.75, 1}));
    const Numbers one = cumulative(Numbers{7});
    INFO("of the weight 7 they are " << one);
    CHECK(all_near(one, {1}));
    CHECK(cumulative(Numbers{}).empty());
}

TEST_CASE("one of three by hand", "[12.15]") {
    const Numbers sums{0.25, 0.75, 1};
    // Halfway from 0.25 to 0.75, a quarter and three quarters of the way, and 3/5 of the last part.
    check_choice(sums, 0.5, 1, 0.5, 0.5);
    check_choice(sums, 0.375, 1, 0.5, 0.25);
    check_choice(sums, 0.0625, 0, 0.25, 0.25);
    check_choice(sums, 0.90, 2, 0.25, 0.6);
}

TEST_CASE("a number that is equal to a sum belongs to the next", "[12.15]") {
    const Numbers sums{0.25, 0.75, 1};
    check_choice(sums, 0, 0, 0.25, 0);
    check_choice(sums, 0.25, 1, 0.5, 0);
    check_choice(sums, 0.75, 2, 0.25, 0);
}

TEST_CASE("what weighs nothing is never chosen", "[12.15]") {
    const Numbers sums = cumulative(Numbers{0, 1, 0, 0, 3, 0});
    INFO("of the weights 0, 1, 0, 0, 3, 0 the sums are " << sums);
    CHECK(all_near(sums, {0, 0.25, 0.25, 0.25, 1, 1}));
    const Numbers exact{0, 0.25, 0.25, 0.25, 1, 1};
    check_choice(exact, 0, 1, 0.25, 0);
    check_choice(exact, 0.25, 4, 0.75, 0);
    check_choice(exact, 0.625, 4, 0.75, 0.5);
    check_choice(exact, 1 - 0x1p-53, 4, 0.75, 1);
}

TEST_CASE("if none weighs anything, all are equally likely", "[12.15]") {
    const Numbers sums = cumulative(Numbers{0, 0, 0, 0});
    INFO("of the weights 0, 0, 0, 0 the sums are " << sums);
    CHECK(all_near(sums, {0.25, 0.5, 0.75, 1}));
}

TEST_CASE("the last sum is 1, exactly", "[12.15]") {
    // 49 · (1/49) rounds to less than 1, and a number between the two would find nothing.
    for (const std::size_t count : {3u, 10u, 49u, 98u, 103u}) {
        INFO(count << " weights of 1");
        const Numbers sums = cumulative(Numbers(count, 1));
        REQUIRE(sums.size() == count);
        CHECK(near(sums.back(), 1, 0));
        CHECK(choose(sums, 1 - 0x1p-53).index == count - 1);
    }
}

TEST_CASE("what is left of the number is less than 1", "[12.15]") {
    // By a hair less than one part, but both differences round to the same.
    const Numbers sums{0x1p-54, 0.75 + 0x1p-53, 1};
    INFO("sums 2^-54, 0.75 + 2^-53 and 1, random number 0.75");
    const Choice choice = choose(sums, 0.75);
    CHECK(choice.index == 1);
    CHECK(choice.random < 1);
    CHECK(near(choice.random, 1, gamma(16)));
}

TEST_CASE("each is chosen as often as it weighs, and what is left is uniform", "[12.15]") {
    // Chosen by 0.7, and where between the sums in eight parts: together twenty-four classes.
    const Numbers sums{0.7, 0.8, 1};
    const int count = cases(100000);
    std::vector<int> first(8, 0), second(8, 0), third(8, 0);
    const auto numbers = test::many(static_cast<std::size_t>(count), 121501,
                                    [](Random& random) { return random.uniform(0, 1); });
    const std::vector<Choice> choices =
        test::answers(numbers, [&](Real number) { return choose(sums, number); });
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const Choice& choice = choices[i];
        INFO("of the sums 0.7, 0.8 and 1 the number " << numbers[i] << " chooses index " << choice.index
                                                      << " of 0, 1 and 2, and leaves " << choice.random);
        REQUIRE(choice.index < 3);
        REQUIRE(test::or_say(choice.random >= 0 && choice.random < 1, "what is left is not in [0, 1)"));
        auto& part = choice.index == 0 ? first : choice.index == 1 ? second : third;
        ++part[static_cast<std::size_t>(choice.random * 8)];
    }
    const Real weights[] = {0.7, 0.1, 0.2};
    std::size_t which = 0;
    for (const auto& part : {first, second, third}) {
        int all = 0;
        for (const int n : part) all += n;
        const Real weight = weights[which++], expected = count * weight;
        INFO("index " << which - 1 << " was chosen " << all << " times of " << count << "; expected "
                      << expected);
        // Five standard deviations and a half: once in ten million times.
        CHECK(std::abs(all - expected) < 5.5 * std::sqrt(expected * (1 - weight)));
        INFO("what was left, in eighths: " << part);
        CHECK(test::chi_square(part) < test::chi_square_limit(8));
    }
}

TEST_CASE("all together: index, probability and what is left give the number back", "[12.15]") {
    Random random(121502);
    for (int i = 0; i < cases(5000); ++i) {
        Numbers weights(1 + random.index(20));
        Real whole = 0;
        for (Real& weight : weights) {
            const Real size = random.uniform(0, 1);
            weight = random.index(4) == 0 ? 0 : size;
            whole += weight;
        }
        weights[random.index(weights.size())] += 0.01;
        whole += 0.01;
        INFO("weights " << weights);
        const Numbers sums = cumulative(weights);
        REQUIRE(sums.size() == weights.size());
        const Real number = random.uniform(0, 1);
        INFO("sums " << sums << ", random number " << number);
        const Choice choice = choose(sums, number);
        REQUIRE(choice.index < weights.size());
        CHECK(weights[choice.index] > 0);
        CHECK(near(choice.probability, weights[choice.index] / whole, gamma(64)));
        Real before = 0;
        for (std::size_t k = 0; k < choice.index; ++k) before += weights[k] / whole;
        CHECK(near(before + choice.random * choice.probability, number, gamma(64)));
    }
}
