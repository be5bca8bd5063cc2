// Steps 10.7 and 10.8: real roots of a polynomial.
#include "chapters/10_surfaces/polynomial.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace rt;
using test::cases;
using test::Random;

namespace {

/// Between 0 and 5 it is positive up to 1, not up to 2, and so on.
const Polynomial one_to_four{{24, -50, 35, -10, 1}};

/// How far t may be from a simple root, by the contract: as far as |p(t)| ≤ 16u·Σ|aᵢtⁱ| leads; and a quarter
/// more, because the expected root is rounded, too, and the slope changes a little on the way.
Real allowed(const Polynomial& p, Real root) {
    Real sum = 0;
    for (std::size_t i = 0; i < p.a.size(); ++i)
        sum += std::abs(p.a[i] * std::pow(root, static_cast<int>(i)));
    return gamma(20) * sum / std::abs(evaluate(p, root).slope);
}

void check_root(const Polynomial& p, Real low, Real high, Real expected, Real tolerance) {
    const Real t = root_between(p, low, high);
    INFO(p << ", from " << low << " to " << high << ": expected " << expected << ", actual " << t);
    CHECK(test::near(t, expected, tolerance));
}
void check_root(const Polynomial& p, Real low, Real high, Real expected) {
    check_root(p, low, high, expected, allowed(p, expected));
}

void check_changes(const Polynomial& p, Real low, Real high, const std::vector<Real>& expected) {
    const SignChanges changes = sign_changes(p, low, high);
    std::string list;
    for (const Real t : expected) list += " " + test::show(t);
    INFO(p << ", from " << low << " to " << high);
    INFO("expected:" << (list.empty() ? " no change of sign" : list) << "; actual: " << changes);
    REQUIRE(changes.count == static_cast<int>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(test::near(changes.t[i], expected[i], allowed(p, expected[i])));
}

/// (t − roots[0])···(t − roots[3])
Polynomial with_roots(const std::vector<Real>& roots) {
    Polynomial p{{1}};
    for (std::size_t i = 0; i < roots.size(); ++i)
        for (std::size_t k = i + 2; k-- > 0;) p.a[k] = (k > 0 ? p.a[k - 1] : 0) - roots[i] * p.a[k];
    return p;
}

}  // namespace

// ------------------------------------------------------------------------------------- one root, between

TEST_CASE("the root of a straight line, rising or falling", "[10.7]") {
    check_root({{-3, 2}}, 0, 5, 1.5);
    check_root({{3, -2}}, 0, 5, 1.5);
    check_root({{-3, 2}}, -100, 2, 1.5);
}

TEST_CASE("the root of t^2 - 2 to the last bits", "[10.7]") {
    check_root({{-2, 0, 1}}, 0, 2, std::sqrt(2.0));
    check_root({{2, 0, -1}}, 0, 2, std::sqrt(2.0));
    check_root({{-2, 0, 1}}, -1e6, 0, -std::sqrt(2.0));
}

TEST_CASE("small numbers are not taken for 0", "[10.7]") {
    check_root({{-2e-20, 0, 1e-20}}, 0, 2, std::sqrt(2.0));
    check_root({{-2e-20, 0, 1}}, 0, 2, std::sqrt(2e-20));
}

TEST_CASE("Newton's step may lead out of the interval", "[10.7]") {
    // From the middle, 0.25, it leads to 10.8; and from 0 it leads nowhere.
    check_root({{-2, 0, 0, 1}}, -1, 1.5, std::cbrt(2.0));
    check_root({{-2, 0, 0, 1}}, -2, 2, std::cbrt(2.0));
}

TEST_CASE("where the polynomial is flat, half steps find the root", "[10.7]") {
    // (t - 1)^3 is within 16u (1 + 3 + 3 + 1) of 0 up to 2.43e-5 away, so the root has no more than five
    // digits.
    check_root({{-1, 3, -3, 1}}, 0, 2.75, 1, 2.5e-5);
    check_root({{1, -3, 3, -1}}, -100, 2.75, 1, 2.5e-5);
}

TEST_CASE("a root at one of the ends is found there", "[10.7]") {
    // -(t - 1)(t - 2) is not positive at 1 and is from there on.
    check_root({{-2, 3, -1}}, 1, 1.5, 1);
    check_root({{-2, 3, -1}}, 1.5, 2, 2);
}

TEST_CASE("the root is not beyond the ends of the bracket", "[10.7]") {
    // At 0.5 the polynomial is 0 but for rounding, and Newton's last step leads to below it.
    const Polynomial p{{-0.0234375, -0.054687499999999993, 0.828125, -1.75, 1}};
    for (const Real high : {0.6, 0.7}) {
        const Real t = root_between(p, 0.5, high);
        INFO(p << " between 0.5 and " << test::show(high) << ": " << test::show(t));
        CHECK(t >= 0.5);
        CHECK(t <= high);
    }
}

// ----------------------------------------------------------------------------------------- all the roots

TEST_CASE("the worked example: t^3 - 3t + 1", "[10.8]") {
    // Its derivative is 0 at -1 and 1, where it is 3 and -1.
    check_changes({{1, -3, 0, 1}}, -2, 2,
                  {2 * std::cos(8 * pi / 9), 2 * std::cos(4 * pi / 9), 2 * std::cos(2 * pi / 9)});
}

TEST_CASE("the roots 1, 2, 3 and 4", "[10.8]") {
    check_changes(one_to_four, 0, 5, {1, 2, 3, 4});
    check_changes(one_to_four, -1000, 1000, {1, 2, 3, 4});
}

TEST_CASE("only the roots of the interval", "[10.8]") {
    check_changes(one_to_four, 1.5, 3.5, {2, 3});
    check_changes(one_to_four, 1.5, 1.75, {});
    check_changes(one_to_four, 2.5, 100, {3, 4});
    check_changes(one_to_four, -5, 0, {});
}

TEST_CASE("a polynomial that has no roots", "[10.8]") {
    check_changes({{1, 0, 0, 0, 1}}, -10, 10, {});
    check_changes({{-1, 0, 0, 0, -1}}, -10, 10, {});
    check_changes({{2, -2, 1}}, -10, 10, {});
}

TEST_CASE("a polynomial of a lower degree", "[10.8]") {
    check_changes({{-1, 0, 0, 0, 1}}, -10, 10, {-1, 1});
    check_changes({{0, -1, 0, 1}}, -10, 10, {-1, 0, 1});
    check_changes({{-1, 0, 1}}, -10, 10, {-1, 1});
    check_changes({{-5, 2}}, -10, 10, {2.5});
    check_changes({{-5}}, -10, 10, {});
    check_changes({{5}}, -10, 10, {});
    check_changes({{0}}, -10, 10, {});
}

TEST_CASE("an interval of one point has no change", "[10.8]") {
    check_changes(one_to_four, 1, 1, {});
    check_changes(one_to_four, 2.5, 2.5, {});
}

TEST_CASE("no change of sign is found outside of the interval", "[10.8]") {
    // At 0.5 the polynomial is 0 but for rounding, and Newton's last step may lead to below it.
    const Polynomial p{{-0.0234375, -0.054687499999999993, 0.828125, -1.75, 1}};
    const SignChanges changes = sign_changes(p, 0.5, 1.5311667705431196);
    INFO(p << " from 0.5 to 1.5311667705431196: " << changes);
    for (std::size_t i = 0; i < static_cast<std::size_t>(changes.count); ++i) {
        CHECK(changes.t[i] >= 0.5);
        CHECK(changes.t[i] <= 1.5311667705431196);
    }
}

TEST_CASE("two roots that are a millionth apart are two", "[10.8]") {
    // (t - 1)(t - 1 - e): its coefficients are exact.
    const Real e = 0x1p-20;
    check_changes({{1 + e, -2 - e, 1}}, 0, 2, {1, 1 + e});
    check_changes({{-1 - e, 2 + e, -1}}, 0, 2, {1, 1 + e});
    check_changes({{1 + e, -2 - e, 1}}, -1e4, 1e4, {1, 1 + e});
}

TEST_CASE("a polynomial that stays a millionth away from 0 has no roots", "[10.8]") {
    // (t - 1)^2 + e^2
    const Real e = 0x1p-20;
    check_changes({{1 + e * e, -2, 1}}, 0, 2, {});
    check_changes({{-1 - e * e, 2, -1}}, 0, 2, {});
}

TEST_CASE("a double root is two changes, or none", "[10.8]") {
    for (const Polynomial& p :
         {Polynomial{{1, -2, 1}}, Polynomial{{-1, 2, -1}}, Polynomial{{4, -12, 13, -6, 1}}}) {
        const SignChanges changes = sign_changes(p, 0, 1.5);
        INFO(p << " has a double root at 1 (the last one also at 2): " << changes);
        CHECK(changes.count % 2 == 0);
        for (std::size_t i = 0; i < static_cast<std::size_t>(changes.count); ++i)
            CHECK(test::near(changes.t[i], 1, 2.6e-7));  // where the last is within 16u·36 of 0
    }
}

TEST_CASE("two quartics on which closed formulas fail", "[10.8]") {
    // (t^2 - 120t + 5524.5)^2 = 4048200, so that t = 60 +- sqrt(sqrt(4048200) - 1924.5).
    const Real half = std::sqrt(std::sqrt(4048200.0) - 1924.5);
    check_changes({{26471900.25, -1325880, 25449, -240, 1}}, -300, 300, {60 - half, 60 + half});
    check_changes({{57126150.652217, -476217.617178, -48660.891842, 19.534611, 1}}, -300, 300,
                  {-223.009483226308410, -39.8852846856193326, 30.11797881450675617, 213.2421780974209868});
}

TEST_CASE("quartics with whole roots have them", "[10.8]") {
    Random random(10701);
    for (int i = 0; i < cases(5000); ++i) {
        std::vector<Real> roots;
        while (roots.size() < 4) {
            const Real root = static_cast<Real>(random.index(33)) - 16;
            if (std::find(roots.begin(), roots.end(), root) == roots.end()) roots.push_back(root);
        }
        const Polynomial p = with_roots(roots);
        std::sort(roots.begin(), roots.end());
        check_changes(p, -20, 20, roots);
    }
}
