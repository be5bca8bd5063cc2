// Step 02.1: the roots of a quadratic polynomial.
#include "chapters/02_spheres/quadratic.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::Random;

namespace {

// A root comes from a square root, a sum and a division, each rounded once; one rounding to spare.
test::Nearness<Real> close(Real actual, Real expected) {
    return test::near(actual, expected, 4 * unit_roundoff * std::abs(expected));
}

void check_roots(Real a, Real h, Real c, Real discriminant, Real expected0, Real expected1) {
    const Roots roots = solve_quadratic(a, h, c, discriminant);
    INFO("a = " << a << ", h = " << h << ", c = " << c << ", discriminant = " << discriminant);
    INFO("expected t0 = " << expected0 << ", t1 = " << expected1 << "; found " << roots);
    {
        INFO("how many roots there are");
        CHECK(roots.count == (expected0 == expected1 ? 1 : 2));
    }
    INFO("t0 is the smaller one, t1 the larger");
    CHECK(close(roots.t0, expected0));
    CHECK(close(roots.t1, expected1));
}

}  // namespace

TEST_CASE("the lesson's example: t^2 - 20t + 84 has the roots 6 and 14", "[02.1]") {
    check_roots(1, -10, 84, 16, 6, 14);
}

TEST_CASE("t^2 - 5t + 6 has the roots 2 and 3", "[02.1]") { check_roots(1, -2.5, 6, 0.25, 2, 3); }

TEST_CASE("t^2 - 4 has the roots -2 and 2, though h is zero", "[02.1]") {
    check_roots(1, 0.0, -4, 4, -2, 2);
    check_roots(1, -0.0, -4, 4, -2, 2);
}

TEST_CASE("t^2 + 5t has the roots -5 and 0", "[02.1]") {
    check_roots(1, 2.5, 0, 6.25, -5, 0);
    check_roots(1, -2.5, 0, 6.25, 0, 5);
}

TEST_CASE("a double root is counted once and stands in t0 and t1", "[02.1]") {
    check_roots(1, 1, 1, 0, -1, -1);
    check_roots(4, -12, 36, 0, 3, 3);
}

TEST_CASE("a negative discriminant means no root", "[02.1]") {
    INFO("how many roots there are");
    CHECK(solve_quadratic(1, 0, 1, -1).count == 0);
    CHECK(solve_quadratic(2, 5, 100, -175).count == 0);
}

TEST_CASE("roots ascend for either sign of a and of h", "[02.1]") {
    check_roots(1, -2, 3, 1, 1, 3);
    check_roots(1, 2, 3, 1, -3, -1);
    check_roots(-1, 2, -3, 1, 1, 3);
    check_roots(-1, -2, -3, 1, -3, -1);
}

TEST_CASE("a*t^2 = 0 has the double root 0, not NaN", "[02.1]") { check_roots(3, 0, 0, 0, 0, 0); }

TEST_CASE("the small root keeps its digits beside a root four million million times as large", "[02.1]") {
    // t^2 - 2^21 t + 1 has the roots 2^20 ± sqrt(2^40 - 1); by Taylor's series these are 2^-21 + 2^-63
    // and 2^21 - 2^-21.
    const Real h = 0x1p20, discriminant = 0x1p40 - 1;
    const Real small = 0x1p-21 + 0x1p-63, large = 0x1p21 - 0x1p-21;
    check_roots(1, -h, 1, discriminant, small, large);
    check_roots(1, h, 1, discriminant, -large, -small);
}

TEST_CASE("the product of the roots is c / a", "[02.1]") {
    Random random(2103);
    for (int i = 0; i < cases(5000); ++i) {
        // The closer the discriminant comes to h², the more -h ± sqrt(discriminant) cancels. That difference
        // is exact here (Sterbenz 1974), and so is the rounding error of h·h, so c is good to two roundings.
        const Real a = random.magnitude(-3, 3), h = random.uniform(-5, 5);
        const Real discriminant = h * h * (1 - random.magnitude(-12, -1));
        const Real c = (h * h - discriminant + std::fma(h, h, -(h * h))) / a;
        const Roots roots = solve_quadratic(a, h, c, discriminant);
        INFO("a = " << a << ", h = " << h << ", c = " << c << ", discriminant = " << discriminant << ": "
                    << roots << "; two roots, whose product times a is c");
        CHECK(roots.count == 2);
        CHECK(test::near(roots.t0 * roots.t1 * a, c, 8 * unit_roundoff * std::abs(c)));
    }
}

TEST_CASE("the discriminant is taken as given, not computed again", "[02.1]") {
    // Roots 2^27 and 2^27 + 2, discriminant 1; but h*h - a*c, rounded, is 0.
    const Real p = 0x1p27;
    check_roots(1, -(p + 1), p * (p + 2), 1, p, p + 2);
}

TEST_CASE("roots of polynomials made from known roots are found", "[02.1]") {
    Random random(2101);
    for (int i = 0; i < cases(20000); ++i) {
        // Whole numbers small enough that all coefficients, and the discriminant, are exact.
        const Real p = std::floor(random.uniform(-0x1p20, 0x1p20));
        const Real q = p + std::floor(random.magnitude(0, 6));
        const Real a = (1 + static_cast<Real>(random.index(7))) * (i % 2 == 0 ? 1 : -1);
        const Real half = a * (q - p) / 2;
        check_roots(a, -a * (p + q) / 2, a * p * q, half * half, p, q);
    }
}

TEST_CASE("measuring t in another unit changes only its unit", "[02.1]") {
    Random random(2102);
    for (int i = 0; i < cases(5000); ++i) {
        const Real a = random.magnitude(-3, 3), h = random.uniform(-5, 5), root = random.magnitude(-9, 2);
        const Real c = (h - root) * (h + root) / a;
        const Real s = std::ldexp(1, static_cast<int>(random.index(81)) - 40);
        const Roots one = solve_quadratic(a, h, c, root * root);
        const Roots other = solve_quadratic(a * s * s, h * s, c, root * root * s * s);
        INFO("a = " << a << ", h = " << h << ", c = " << c << ", root of the discriminant " << root << ": "
                    << one << "\nt in units " << s << " times as large: " << other);
        CHECK(one.count == 2);
        CHECK(one.t0 <= one.t1);
        CHECK(other.t0 == one.t0 / s);
        CHECK(other.t1 == one.t1 / s);
    }
}
