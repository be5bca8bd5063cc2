// Quadrics in a box, which are given.
#include "chapters/10_surfaces/quadric.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::ahead;

namespace {

const Box room{Vec3(-2), Vec3(2)};

const Quadric ball{Vec3(1), Vec3(0), Vec3(0), -1, room};
const Quadric dish{{1, 0, 1}, Vec3(0), {0, -1, 0}, 0, room};     // y = x² + z²
const Quadric saddle{Vec3(0), {1, 0, 0}, {0, 0, -1}, 0, room};   // z = xy
const Quadric hourglass{{1, -1, 1}, Vec3(0), Vec3(0), 0, room};  // a double cone about y

void check_hit(const Quadric& quadric, const Ray& ray, Interval range, Real t) {
    const std::optional<Hit> hit = intersect(quadric, ray, range);
    INFO(quadric << "\n" << ray << ", range " << range << "; expected t = " << t << ", actual " << hit);
    REQUIRE(hit.has_value());
    CHECK(test::near(hit->t, t, gamma(64) * (1 + std::abs(t))));
}

void check_miss(const Quadric& quadric, const Ray& ray, Interval range = ahead) {
    const std::optional<Hit> hit = intersect(quadric, ray, range);
    INFO(quadric << "\n" << ray << ", range " << range << "; expected no hit, actual " << hit);
    CHECK_FALSE(hit.has_value());
}

void check_spans(const Quadric& quadric, const Ray& ray, const std::vector<Span>& expected) {
    const std::vector<Span> actual = inside(quadric, ray);
    INFO(quadric << "\n" << ray);
    REQUIRE(actual.size() == expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) {
        INFO("expected " << expected[i] << "\nactual   " << actual[i]);
        CHECK(test::near(actual[i].enter, expected[i].enter, gamma(64) * 10));
        CHECK(test::near(actual[i].leave, expected[i].leave, gamma(64) * 10));
        CHECK(actual[i].enter_face == expected[i].enter_face);
        CHECK(actual[i].leave_face == expected[i].leave_face);
    }
}

}  // namespace

TEST_CASE("rays through quadrics, by hand", "[quadric]") {
    check_hit(ball, {{-3, 0, 0}, {1, 0, 0}}, ahead, 2);
    check_hit(ball, {{-3, 0, 0}, {1, 0, 0}}, {2, infinity}, 4);
    check_hit(ball, {{0, 0.6, 3}, {0, 0, -2}}, ahead, 1.1);
    check_miss(ball, {{-3, 1.001, 0}, {1, 0, 0}});
    check_hit(dish, {{-3, 1, 0}, {1, 0, 0}}, ahead, 2);
    check_hit(dish, {{1, -3, 0}, {0, 1, 0}}, ahead, 4);  // along the axis: a linear equation
    check_hit(saddle, {{1, 1, 5}, {0, 0, -1}}, ahead, 4);
    check_hit(saddle, {{-1.5, 1, 5}, {0, 0, -1}}, ahead, 6.5);
    check_hit(hourglass, {{-3, 1, 0}, {1, 0, 0}}, ahead, 2);
    check_miss(hourglass, {{-3, 1, 1.001}, {1, 0, 0}});
}

TEST_CASE("a quadric ends at its box", "[quadric]") {
    check_miss(dish, {{-3, 3, 0}, {1, 0, 0}});  // where y = 3, beyond the box
    check_hit(dish, {{0, 5, 0}, {0, -1, 0}}, ahead, 5);
    check_miss(hourglass, {{-5, 2.5, 0}, {1, 0, 0}});
}

TEST_CASE("a line in the quadric's own direction", "[quadric]") {
    check_miss(hourglass, {{0, -5, 0}, {0, 1, 0}}, {5.5, infinity});
    check_miss({{1, 0, 1}, Vec3(0), Vec3(0), -1, room}, {{0, -5, 0}, {0, 1, 0}});  // the axis of a cylinder
    check_miss({Vec3(0), Vec3(0), {0, 1, 0}, -1, room}, {{-5, 0, 0}, {1, 0, 0}});  // along a plane
}

TEST_CASE("the parts of a line in a quadric", "[quadric]") {
    check_spans(ball, {{-3, 0, 0}, {1, 0, 0}}, {{2, 4, surface_face, surface_face}});
    check_spans(dish, {{0, -3, 0}, {0, 1, 0}}, {{3, 5, surface_face, 3}});
    check_spans(hourglass, {{0, -3, 0.5}, {0, 1, 0}}, {{1, 2.5, 2, surface_face}, {3.5, 5, surface_face, 3}});
    check_spans({{1, 0, 1}, Vec3(0), Vec3(0), -1, room}, {{0, -5, 0}, {0, 1, 0}}, {{3, 7, 2, 3}});
    check_spans(ball, {{-3, 1.5, 0}, {1, 0, 0}}, {});
}

TEST_CASE("a small quadric in a large box is as exact as a sphere", "[quadric]") {
    const Real r = 0x1p-20;
    const Quadric seed{Vec3(1), Vec3(0), Vec3(0), -r * r, room};
    for (const Real part : {0.25, 0.5, 0.75}) {
        const Ray ray{{-3, part * r, 0}, {1, 0, 0}};
        const std::optional<Hit> hit = intersect(seed, ray, ahead);
        INFO(ray << ", hit " << hit);
        REQUIRE(hit.has_value());
        CHECK(test::near(hit->t, 3 - r * std::sqrt(1 - part * part), gamma(16) * 3));
    }
    check_miss(seed, {{-3, 1.0001 * r, 0}, {1, 0, 0}});
}

TEST_CASE("normals of quadrics lead outward", "[quadric]") {
    const auto normal = [](const Quadric& quadric, const Ray& ray) {
        return surface_at(quadric, ray, intersect(quadric, ray, ahead).value()).normal;
    };
    CHECK(test::near(normal(ball, {{-3, 0, 0}, {1, 0, 0}}), Vec3(-1, 0, 0), gamma(8)));
    CHECK(test::near(normal(dish, {{0, 5, 0}, {0, -1, 0}}), Vec3(0, -1, 0), gamma(8)));
    CHECK(test::near(normal(saddle, {{1, 1, 5}, {0, 0, -1}}), Vec3(1, 1, -1) / std::sqrt(3.0), gamma(8)));
    CHECK(test::near(normal(hourglass, {{-3, 0, 0}, {1, 0, 0}}), Vec3(-1, 0, 0), gamma(8)));
}
