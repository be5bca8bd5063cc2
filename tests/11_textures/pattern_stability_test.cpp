// Step 11.8: patterns at places where numbers run out of digits.
#include "chapters/11_textures/pattern.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <vector>

using namespace rt;
using test::cases;
using test::Random;

namespace {

constexpr PatternKind without_cells[] = {PatternKind::Stripes, PatternKind::Rings, PatternKind::Gradient,
                                         PatternKind::Marble, PatternKind::Wood};

struct Known {
    Vec3 q;
    Real value;
};

// As in pattern_test.cpp.
const std::vector<Known> far_marble{
    {{1070315.3125, 1086495.625, 1074644.375}, 0.9958713667317095},
    {{-1072387.375, -1098805.5625, -1051403.6875}, 0.6540209237299881},
    {{1073796206.3125, 1073760921.5, 1073750361.625}, 0.014863222938583168},
    {{-1073781323.0, -1073786112.125, -1073782450.6875}, 0.3624318722662712},
    {{34359778484.9375, 34359779759.3125, 34359801442.9375}, 0.26493785188059354},
    {{-34359761452.0625, -34359771946.0, -34359785245.75}, 0.8540623076464585},
    {{1099511630144.8125, 1099511675772.75, 1099511628965.875}, 0.7953982010458367},
    {{-1099511633900.3125, -1099511653534.1875, -1099511660031.875}, 0.05312514361505587},
    {{17592186089554.688, 17592186077301.875, 17592186058578.688}, 0.27201880129167666},
    {{-17592186083195.062, -17592186101167.125, -17592186071742.625}, 0.1925235377916865},
};

}  // namespace

TEST_CASE("marble is right far from the origin", "[11.8][stability]") {
    for (const Known& at : far_marble) {
        INFO("marble at " << at.q);
        CHECK(test::near(marble_value(at.q), at.value, 40000 * unit_roundoff));
    }
}

TEST_CASE("patterns are in [0, 1] everywhere", "[11.8][stability]") {
    Random random(11511);
    for (int i = 0; i < cases(5000); ++i) {
        // As far as a scene may be large and a pattern small.
        const Vec3 q = random.magnitude(-60, 60) * random.in_cube();
        for (const PatternKind kind : without_cells) {
            const Real value = pattern_value(kind, q);
            INFO("pattern " << static_cast<int>(kind) << " at " << q << " is " << value);
            CHECK((value >= 0 && value <= 1));
        }
    }
}

TEST_CASE("stripes far away are as even as near", "[11.8][stability]") {
    Random random(11512);
    for (int i = 0; i < cases(5000); ++i) {
        const auto whole = static_cast<std::int64_t>(std::ldexp(1.0, static_cast<int>(random.index(53))) *
                                                     random.uniform(-1, 1));
        const auto x = static_cast<Real>(whole);
        INFO("stripes at x = " << x << ", a whole number");
        CHECK(test::near(stripe_value({x, 0, 0}), static_cast<Real>(whole & 1), 0));
        if (std::abs(x) < 0x1p51) {
            INFO("and half a unit farther");
            CHECK(test::near(stripe_value({x + 0.5, 0, 0}), static_cast<Real>(whole & 1), 0));
            CHECK(test::near(gradient_value({0, x + 0.5, 0}), 0.5, 0));
        }
    }
}

TEST_CASE("a scene times a power of two has the same colours to the bit", "[11.8][stability]") {
    Random random(11513);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 point = random.magnitude(-3, 3) * random.in_cube();
        const Real size = random.magnitude(-2, 2),
                   scale = std::ldexp(1.0, static_cast<int>(random.index(160)) - 80);
        for (const PatternKind kind : without_cells) {
            const SolidPattern pattern{kind, size, {1, 0, 0.5}, {0, 1, 0.25}};
            const SolidPattern scaled{kind, scale * size, {1, 0, 0.5}, {0, 1, 0.25}};
            INFO("pattern " << static_cast<int>(kind) << " of size " << size << " at " << point
                            << ", and both times " << scale);
            CHECK(pattern_color(scaled, scale * point) == pattern_color(pattern, point));
        }
    }
}

TEST_CASE("colours of every size are mixed without overflow", "[11.8][stability]") {
    Random random(11514);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 first = random.magnitude(-30, 30) * glm::abs(random.in_cube());
        const Vec3 second = random.magnitude(-30, 30) * glm::abs(random.in_cube());
        const Real part = random.uniform(0, 1);
        const Vec3 color = pattern_color({PatternKind::Gradient, 1, first, second}, {0, part, 0});
        const Vec3 low = glm::min(first, second), high = glm::max(first, second);
        INFO("a gradient from " << first << " to " << second << " at y = " << part << " is " << color);
        CHECK(glm::all(glm::greaterThanEqual(color, low * (1 - gamma(4)))));
        CHECK(glm::all(glm::lessThanEqual(color, high * (1 + gamma(4)))));
    }
}
