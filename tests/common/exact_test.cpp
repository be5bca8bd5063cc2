// Exact sums and the signs made of them, against rational numbers.
#include "common/math/exact.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracle/polygon.hpp"
#include "tests/oracle/sum.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <limits>
#include <vector>

using namespace rt;
using test::cases;
using test::Random;

namespace {

ExactSum sum_of(const std::vector<oracle::Product>& products) {
    ExactSum sum;
    for (const auto& [a, b, c] : products) sum.add(a, b, c);
    return sum;
}

/// A number of any size that a double can have.
Real any_size(Random& random) {
    const int exponent = static_cast<int>(random.index(2100)) - 1076;
    return std::ldexp(random.uniform(-1, 1), exponent);
}

}  // namespace

TEST_CASE("an exact sum of nothing is zero", "[exact]") {
    CHECK(ExactSum().sign() == 0);
    CHECK(ExactSum().value().mantissa == 0);
}

TEST_CASE("what rounding would lose decides the sign of an exact sum", "[exact]") {
    ExactSum sum;
    sum.add(0x1p60, 1);
    sum.add(1, 1);
    sum.subtract(0x1p60, 1);
    CHECK(sum.sign() == 1);
    CHECK(sum.value().mantissa == 0.5);
    CHECK(sum.value().exponent == 1);
    sum.subtract(1, 1);
    CHECK(sum.sign() == 0);
    sum.subtract(std::numeric_limits<Real>::denorm_min(), std::numeric_limits<Real>::denorm_min(),
                 std::numeric_limits<Real>::denorm_min());
    CHECK(sum.sign() == -1);
    CHECK(sum.value().mantissa == -0.5);
    CHECK(sum.value().exponent == 1 - 3 * 1074);
    const Real greatest = std::numeric_limits<Real>::max();
    sum.add(greatest, greatest, greatest);
    CHECK(sum.sign() == 1);
    CHECK(sum.value().exponent == 3 * 1024);
}

TEST_CASE("exact sums agree with rational numbers, at any size and where they cancel", "[exact]") {
    Random random(71);
    for (int i = 0; i < cases(2000); ++i) {
        std::vector<oracle::Product> products;
        const std::size_t count = 1 + random.index(12);
        const bool all_sizes = random.index(2) == 0;
        for (std::size_t k = 0; k < count; ++k) {
            const auto number = [&] { return all_sizes ? any_size(random) : random.uniform(-1, 1); };
            products.push_back({number(), number(), number()});
        }
        // Half of the sums cancel but for the last bits of one product.
        if (random.index(2) == 0) {
            const std::vector<oracle::Product> again = products;
            for (const auto& [a, b, c] : again) products.push_back({-a, b, c});
            products.back()[2] = std::nextafter(products.back()[2], infinity);
        }
        const ExactSum sum = sum_of(products);
        const int right = oracle::sign_of_sum(products);
        INFO("case " << i << ", " << products.size() << " products");
        REQUIRE(sum.sign() == right);
        if (right == 0) continue;
        const auto [mantissa, exponent] = sum.value();
        REQUIRE(std::abs(oracle::relative_error(products, mantissa, exponent)) <= unit_roundoff);
    }
}

TEST_CASE("the turn of three points is exact, on a line and an ulp beside it, at any size", "[exact]") {
    Random random(72);
    int on_a_line = 0;
    for (int i = 0; i < cases(100'000); ++i) {
        // Whole numbers times a power of two, so that points can lie exactly on one line.
        const int exponent = static_cast<int>(random.index(2000)) - 1020;
        const auto whole = [&] { return std::floor(random.uniform(-1e5, 1e5)); };
        const Vec2 step(whole(), whole());
        const auto point = [&] { return std::ldexp(1.0, exponent / 2) * (Real(whole()) * step); };
        Vec2 a = point(), b = point(), c = point();
        if (random.index(2) == 0) b.x = std::nextafter(b.x, random.index(2) == 0 ? infinity : -infinity);
        const Real rest = std::ldexp(1.0, exponent - exponent / 2);
        a *= rest, b *= rest, c *= rest;
        const std::vector<oracle::Product> products{{b.x, c.y, 1},  {-b.x, a.y, 1}, {-a.x, c.y, 1},
                                                    {-b.y, c.x, 1}, {b.y, a.x, 1},  {a.y, c.x, 1}};
        const int right = oracle::sign_of_sum(products);
        on_a_line += right == 0;
        INFO("case " << i);
        REQUIRE(orientation(a, b, c) == right);
        REQUIRE(orientation(b, a, c) == -right);
    }
    CHECK(on_a_line > cases(100'000) / 10);
}
