// Expressions of x, y and z: their text, their values, enclosures and derivatives.
#include "common/scene/formula.hpp"
#include "common/scene/evaluate.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <limits>

using namespace rt;
using test::cases;
using test::Random;

namespace {

Real value(const std::string& text, const Vec3& p = {2, 3, 5}) { return value_at(parse_formula(text), p); }

/// `7: what is wrong`, the place counted from 1.
std::string error_of(const std::string& text) {
    try {
        parse_formula(text);
    } catch (const FormulaError& error) {
        return std::to_string(error.at + 1) + ": " + error.what();
    }
    return "";
}

const char* const functions[] = {
    "x+y*z",
    "x*y-z/3",
    "x/(2+y^2)",
    "(x+y+z)^5",
    "(x-y)^-3",
    "sqrt(4+x*y*z)",
    "exp(x*y)-z",
    "log(5+x-y)",
    "sin(3*x)*cos(y)",
    "abs(x-y)*z",
    "min(x*y,z)",
    "max(x,y^2)-z",
    "x^3-3*x*y^2",
    "(2+x)^(y/2)",
    "sin(40*x)/7",
    "cos(1000*x+z)",
    "x/y",
    "sqrt(x)",
    "log(x)",
    "exp(-10*x^2)-y",
    "(x^2+9/4*y^2+z^2-1)^3-x^2*z^3-9/80*y^2*z^3",
};

}  // namespace

TEST_CASE("precedence is that of mathematics", "[expression]") {
    CHECK(value("x+y*z") == 17);
    CHECK(value("(x+y)*z") == 25);
    CHECK(value("z-y-x") == 0);
    CHECK(value("60/y/x") == 10);
    CHECK(value("-x^2") == -4);
    CHECK(value("(-x)^2") == 4);
    CHECK(test::near(value("x^y^x", {2, 3, 0}), 512, 1e-9));
    CHECK(value("2*-x") == -4);
    CHECK(value("x--y") == 5);
    CHECK(value("x^-1") == 0.5);
    CHECK(value("+x") == 2);
    CHECK(value("9/4*y^2") == 20.25);
}

TEST_CASE("numbers and blanks are written in many ways", "[expression]") {
    CHECK(value("x*.5+1.") == 2);
    CHECK(value("1e-3*x + 2E2") == 200.002);
    CHECK(value(" x\t* ( y + 1 ) ") == 8);
    CHECK(value("2*exp(x-2)") == 2);
    CHECK(value("x\f+\v1") == 3);
}

TEST_CASE("functions and powers have their values", "[expression]") {
    CHECK(value("sqrt(x+2)+exp(x-2)+log(y/3)+sin(x-2)+cos(x-2)+abs(-z)") == 9);
    CHECK(value("min(x,y)+max(x,min(y,z))") == 5);
    CHECK(value("x^64") == 0x1p64);
    CHECK(value("(x+2)^.5") == 2);
    CHECK(value("x^0") == 1);
    CHECK(value("x*0^0") == 2);
    CHECK(value("x+0^0.5") == 2);
    CHECK(test::near(value("x^2.5"), std::sqrt(32.0), 1e-14));
    CHECK(test::near(value("(x^y)^(z-y+0*x)"), 64, 1e-9));
    CHECK(test::near(value("2^(x^y)"), 256, 1e-9));
    CHECK(test::near(value("x^65"), 0x1p65, 1e9));
    CHECK(std::isnan(value("(-x)^65")));
    CHECK(std::isnan(value("sqrt(-x)")));
    CHECK(std::isnan(value("(-x)^(y/2)")));
    for (const char* text : {"min(sqrt(-x),1)", "min(1,sqrt(-x))", "max(sqrt(-x),1)", "max(1,sqrt(-x))"}) {
        INFO(text);
        CHECK(std::isnan(value(text)));
    }
}

TEST_CASE("operations on constants are done when they are read", "[expression]") {
    CHECK(parse_formula("2*3+4^2-sqrt(9)+x").steps.size() == 3);
    CHECK(parse_formula("x^2").steps.size() == 2);
    CHECK(parse_formula("x*x").steps.size() == 2);
    CHECK(parse_formula("x+2^.3").steps.size() == 3);
    CHECK(parse_formula("2^x").steps.size() == 4);
}

TEST_CASE("what is wrong with an expression has its place", "[expression]") {
    CHECK(error_of("x+") == "3: the expression ends where a number, x, y, z or a function should follow");
    CHECK(error_of("x+*y") == "3: a number, x, y, z, a function or '(' should be here, not '*'");
    CHECK(error_of("(x+y") == "1: this '(' is never closed");
    CHECK(error_of("(x y)") == "4: an operator or ')' should be here, not 'y'");
    CHECK(error_of("x+y)") == "4: there is no '(' to this ')'");
    CHECK(error_of("2x") == "2: an operator should be here, not 'x'");
    CHECK(error_of("x+sine(y)") == "3: unknown name 'sine'; did you mean 'sin'?");
    CHECK(error_of("x+wibble") == "3: unknown name 'wibble'");
    CHECK(error_of("sin x") == "1: 'sin' takes 1 number in parentheses");
    CHECK(error_of("sin(x,y)") == "1: 'sin' takes 1 number in parentheses");
    CHECK(error_of("min(x)") == "1: 'min' takes 2 numbers in parentheses, with a comma between them");
    CHECK(error_of("max(x,y,z)") == "1: 'max' takes 2 numbers in parentheses, with a comma between them");
    CHECK(error_of("x+1.2.3").find("3: '1.2.3' ") == 0);
    CHECK(error_of("x+1e999").find("3: '1e999' ") == 0);
    CHECK(error_of("x+1/0") == "4: not a finite number: inf");
    CHECK(error_of("x+log(0)").find("3: not a finite number: ") == 0);
    CHECK(error_of("x*0^-1") == "4: not a finite number: inf");
    CHECK(error_of("x+10^300^2") == "5: not a finite number: inf");
    CHECK(error_of("x+log(-1)") == "3: this has no value");
    CHECK(error_of("x+sqrt(-4)") == "3: this has no value");
    CHECK(error_of("x+0/0") == "4: this has no value");
    CHECK(error_of("x+(-8)^(1/3)") == "7: this has no value");
    CHECK(error_of("x*(-2)^y") == "7: this has no value");
    CHECK(error_of("x − 1") == "3: an operator should be here, not '−'");
    CHECK(error_of("x*−1") == "3: a number, x, y, z, a function or '(' should be here, not '−'");
    CHECK(error_of("(x²)") == "3: an operator or ')' should be here, not '²'");
    CHECK(error_of("") == "1: the expression ends where a number, x, y, z or a function should follow");
    CHECK(error_of("X+y").find("1: unknown name 'X'") == 0);
    CHECK(error_of("x $ y") == "3: an operator should be here, not '$'");
    CHECK(error_of("1+2") == "1: there is no x, y or z in it, so it has no surface");
    CHECK(error_of(std::string(300, '(') + "x").find("too deeply nested") != std::string::npos);
    std::string waiting;
    for (int i = 0; i < 40; ++i) waiting += "x+(";
    CHECK(error_of(waiting + "x" + std::string(40, ')')).find("more than 32 numbers wait for each other") !=
          std::string::npos);
}

TEST_CASE("an enclosure holds the values at all points, whatever was rounded", "[expression]") {
    Random random(1);
    int enclosed = 0;
    for (const char* text : functions) {
        const Formula f = parse_formula(text);
        for (int i = 0; i < cases(2000); ++i) {
            const Vec3 a = 2.0 * random.in_cube(), b = a + random.magnitude(-16, 0) * random.in_cube();
            const auto between = [&](int k) { return Enclosure{std::min(a[k], b[k]), std::max(a[k], b[k])}; };
            const Enclosure all = evaluate(f, between(0), between(1), between(2));
            for (int j = 0; j < 4; ++j) {
                Vec3 p;
                for (int k = 0; k < 3; ++k)
                    p[k] = std::clamp(random.uniform(between(k).low, between(k).high), between(k).low,
                                      between(k).high);

                const Real v = value_at(f, p);
                if (std::isnan(v)) continue;
                const Enclosure point =
                    evaluate(f, Enclosure{p.x, p.x}, Enclosure{p.y, p.y}, Enclosure{p.z, p.z});
                INFO(text << " at " << p << " is " << v << "; enclosed in " << point << ", all of it in "
                          << all);
                REQUIRE(contains(point, v));
                REQUIRE(contains(all, v));
                ++enclosed;
            }
        }
    }
    CHECK(enclosed > cases(2000) * 50);
}

TEST_CASE("an even power is nowhere negative, and an enclosure of it is tight", "[expression]") {
    const Formula f = parse_formula("x^2"), g = parse_formula("x*x");
    for (const Formula& one : {f, g}) {
        const Enclosure square = evaluate(one, Enclosure{-1, 2}, Enclosure{0, 0}, Enclosure{0, 0});
        CHECK(square.low == 0);
        CHECK(square.high >= 4);
        CHECK(square.high < 4.000001);
    }
}

TEST_CASE("what has no value, or no end, says so", "[expression]") {
    const auto enclose = [](const char* text, Enclosure x) {
        return evaluate(parse_formula(text), x, Enclosure{0, 0}, Enclosure{0, 0});
    };
    CHECK(is_empty(enclose("sqrt(x)", {-2, -1})));
    CHECK(is_empty(enclose("log(x)+x", {-2, -1})));
    CHECK(enclose("sqrt(x)", {-1, 4}).low == -infinity);
    CHECK(enclose("1/x", {-1, 1}).high == infinity);
    CHECK(enclose("1/x", {0, 1}).low == -infinity);
    CHECK(enclose("x*(1/x)", {0, 0}).low == -infinity);
    CHECK(enclose("exp(1000*x)", {1, 2}).high == infinity);
    CHECK(enclose("sin(x)", {0, 7}).high == 1);
    CHECK(enclose("sin(x)", {1e300, 1e300}).low == -1);
    CHECK(enclose("cos(x)", {3, 3.5}).low == -1);
    CHECK(enclose("cos(x)", {3, 3.5}).high < -0.9);
    CHECK_FALSE(std::isnan(enclose("(1/x-1/x)^3*0+x", {-1, 1}).low));
}

TEST_CASE("what has no value at some points makes everything of all that is computed from it",
          "[expression]") {
    for (const char* text : {"sin(sqrt(x))", "cos(log(x))", "abs(sqrt(x))", "exp(log(x))", "x^1.5",
                             "sqrt(x)^0", "sqrt(x)^2", "1/sqrt(x)", "min(sqrt(x),1)", "min(1,log(x))",
                             "max(sqrt(x),-1)", "max(-1,1/x)", "0*sqrt(x)", "sqrt(x)-sqrt(x)"}) {
        const Enclosure y{0, 0};
        const Formula f = parse_formula(text);
        const Enclosure some = evaluate(f, Enclosure{-1, 1}, y, y);
        const Enclosure of_dual = with_gradient(f, Enclosure{-1, 1}, y, y).value;
        INFO(text << " of x from -1 to 1: " << some << ", with derivatives " << of_dual);
        CHECK(is_everything(some));
        CHECK(is_everything(of_dual));
    }
    for (const char* text :
         {"sin(sqrt(x))", "abs(log(x))", "sqrt(x)^0", "min(sqrt(x),1)", "max(1,sqrt(x))"}) {
        const Enclosure y{0, 0};
        const Formula f = parse_formula(text);
        const Enclosure none = evaluate(f, Enclosure{-2, -1}, y, y);
        const Enclosure of_dual = with_gradient(f, Enclosure{-2, -1}, y, y).value;
        INFO(text << " of x from -2 to -1: " << none << ", with derivatives " << of_dual);
        CHECK(is_empty(none));
        CHECK(is_empty(of_dual));
    }
}

TEST_CASE("enclosures hold at the ends of what a double can hold, too", "[expression]") {
    const Real least = std::numeric_limits<Real>::denorm_min(), most = std::numeric_limits<Real>::max();
    const auto point = [](Real x) { return Enclosure{x, x}; };
    const Enclosure half = point(least) * point(0.5);
    INFO("half the least number: " << half);
    CHECK(half.low <= 0);
    CHECK(half.high > 0);
    const Enclosure twice = point(most) * point(2);
    INFO("twice the greatest number: " << twice);
    CHECK(twice.low <= most);
    CHECK(twice.high == infinity);
    CHECK((point(1) / twice).high > 0x1p-1025);
    CHECK((point(least) * point(2)).low <= 2 * least);
    CHECK((point(3) * point(0)).low == 0);
    CHECK((point(3) * point(0.25)).low == 0.75);
    CHECK((point(3) * point(0.25)).high == 0.75);
    CHECK(power(point(1e-200), 2).low == 0);
    CHECK(power(point(1e-200), 2).high > 0);
    CHECK(power(point(1e200), 3).high == infinity);
    CHECK(power(point(-1e200), 3).low == -infinity);
}

TEST_CASE("at a kink the derivative is enclosed with those of both sides", "[expression]") {
    const auto slope = [](const char* text, Enclosure x) {
        return with_gradient(parse_formula(text), x, Enclosure{0, 0}, Enclosure{0, 0}).slope[0];
    };
    for (const char* text : {"abs(x)", "max(x,-x)", "-min(x,-x)"}) {
        INFO(text);
        const Enclosure kink = slope(text, {-1, 1}), exactly = slope(text, {0, 0});
        CHECK(kink.low <= -1);
        CHECK(kink.high >= 1);
        CHECK(exactly.low <= -1);
        CHECK(exactly.high >= 1);
        CHECK(slope(text, {0.5, 1}).low > 0.99);
        CHECK(slope(text, {-1, -0.5}).high < -0.99);
    }
}

TEST_CASE("derivatives are those of finite differences, and enclosed", "[expression]") {
    Random random(2);
    for (const char* text : functions) {
        const Formula f = parse_formula(text);
        for (int i = 0; i < cases(200); ++i) {
            const Vec3 p = 0.25 + 0.5 * (random.in_cube() + Vec3(1));
            const Vec3 gradient = gradient_at(f, p);
            for (int k = 0; k < 3; ++k) {
                const Real h = 1e-6;
                Vec3 a = p, b = p;
                a[k] -= h, b[k] += h;
                const Real difference = (value_at(f, b) - value_at(f, a)) / (2 * h);
                if (std::isnan(difference)) continue;
                INFO(text << " at " << p << " along "
                          << "xyz"[k] << ": derivative " << gradient[k] << ", difference " << difference);
                // Corners of abs, min and max may lie between.
                const auto there = [&](int j) {
                    return Enclosure{std::min(a[j], b[j]), std::max(a[j], b[j])};
                };
                const Enclosure slope =
                    with_gradient(f, there(0), there(1), there(2)).slope[static_cast<std::size_t>(k)];
                const Real slack = 1e-5 * (1 + std::abs(difference)) *
                                   (std::string(text).find("1000") != std::string::npos ? 100 : 1);
                CHECK(slope.low - slack <= difference);
                CHECK(difference <= slope.high + slack);
                CHECK(slope.low <= gradient[k]);
                CHECK(gradient[k] <= slope.high);
            }
        }
    }
}

TEST_CASE("another unit changes no value", "[expression]") {
    Random random(3);
    for (const char* text : functions) {
        const Formula f = parse_formula(text), scaled = in_other_unit(f, 8);
        const Vec3 p = random.in_cube();
        const Real here = value_at(f, p), there = value_at(scaled, 8.0 * p);
        INFO(text << " at " << p);
        CHECK((here == there || (std::isnan(here) && std::isnan(there))));
    }
}
