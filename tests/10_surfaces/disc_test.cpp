// Step 10.3: the disc.
#include "chapters/10_surfaces/disc.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::ahead;
using test::cases;
using test::Random;

namespace {

/// How far t may be from where the ray meets the disc's plane, by the contract: η along the normal, and
/// 8u|t|.
Real allowed(const Disc& disc, const Ray& ray, Real t) {
    const Real eta = gamma(8) * (length(ray.origin - disc.center) + disc.radius);
    return eta / std::abs(dot(normalize(disc.normal), ray.direction)) + gamma(8) * std::abs(t);
}

void check_hit(const Disc& disc, const Ray& ray, Interval range, Real t) {
    const std::optional<Hit> hit = intersect(disc, ray, range);
    INFO(disc << "\n" << ray << ", range " << range);
    INFO("expected t = " << t << ", actual " << hit);
    REQUIRE(hit.has_value());
    CHECK(test::near(hit->t, t, allowed(disc, ray, t)));
}

void check_miss(const Disc& disc, const Ray& ray, Interval range) {
    const std::optional<Hit> hit = intersect(disc, ray, range);
    INFO(disc << "\n" << ray << ", range " << range);
    INFO("expected no hit, actual " << hit);
    CHECK_FALSE(hit.has_value());
}

const Disc lid{{0, 0, 0}, {0, 1, 0}, 5};

}  // namespace

TEST_CASE("a ray from above meets the disc", "[10.3]") {
    check_hit(lid, {{1, 3, 2}, {0, -1, 0}}, ahead, 3);
    check_hit(lid, {{1, 3, 2}, {0, -2, 0}}, ahead, 1.5);
    check_hit(lid, {{-3, 3, 0}, {1, -1, 0}}, ahead, 3);
}

TEST_CASE("the disc has two sides", "[10.3]") { check_hit(lid, {{1, -3, 2}, {0, 1, 0}}, ahead, 3); }

TEST_CASE("the rim belongs to the disc", "[10.3]") {
    check_hit(lid, {{3, 2, 4}, {0, -1, 0}}, ahead, 2);
    check_hit(lid, {{-5, 2, 0}, {0, -1, 0}}, ahead, 2);
}

TEST_CASE("beyond the rim there is nothing", "[10.3]") {
    check_miss(lid, {{3, 2, 4.001}, {0, -1, 0}}, ahead);
    check_miss(lid, {{4, 2, 4}, {0, -1, 0}}, ahead);
    check_miss(lid, {{0, 2, 0}, {4, -1, 0}}, ahead);
}

TEST_CASE("a parallel ray misses the disc, above, below and in it", "[10.3]") {
    check_miss(lid, {{-9, 1, 0}, {1, 0, 0}}, ahead);
    check_miss(lid, {{-9, -1, 0}, {1, 0, 0}}, ahead);
    check_miss(lid, {{-9, 0, 0}, {1, 0, 0}}, ahead);
}

TEST_CASE("the range of a disc's hit decides", "[10.3]") {
    const Ray ray{{1, 3, 2}, {0, -1, 0}};
    check_miss(lid, ray, {3, infinity});
    check_hit(lid, ray, {0, 3}, 3);
    check_miss(lid, ray, {0, 2.5});
    check_miss(lid, {{1, 3, 2}, {0, 1, 0}}, ahead);
}

TEST_CASE("the normal may have any length", "[10.3]") {
    for (const Real length : {1e-3, 7.0, 1e6}) {
        const Disc slanted{{1, 2, 3}, length * Vec3(1, 1, 0), 2};
        check_hit(slanted, {{4, 5, 3}, {-1, -1, 0}}, ahead, 3);
        check_miss(slanted, {{4, 5, 5.5}, {-1, -1, 0}}, ahead);
    }
}

TEST_CASE("rays that meet the plane clearly inside the rim hit, clearly outside miss", "[10.3]") {
    Random random(10301);
    int judged = 0;
    for (int i = 0; i < cases(20000); ++i) {
        const Real radius = random.magnitude(-3, 3);
        const Vec3 n = random.direction(), center = radius * random.magnitude(-2, 2) * random.direction();
        const Disc disc{center, random.magnitude(-2, 2) * n, radius};
        const bool is_inside = i % 2 == 0;
        const Real gap = random.magnitude(-6, -0.1);
        const Vec3 target = center + radius * (is_inside ? 1 - gap : 1 + gap) * random.perpendicular_to(n);
        const Vec3 eye = target + radius * random.magnitude(-1, 2) * random.direction();
        const Ray ray{eye, random.magnitude(-2, 2) * (target - eye)};
        const Real cosine = std::abs(dot(n, normalize(ray.direction)));
        // What rounding moves the point by: a dozen roundings of lengths, seen along the disc.
        if (gamma(12) * (length(eye - center) + length(center) + radius) > gap * radius * cosine) continue;
        ++judged;
        const std::optional<Hit> hit = intersect(disc, ray, ahead);
        INFO(disc << "\n"
                  << ray << "\nmeets the plane " << gap << " radii " << (is_inside ? "inside" : "outside")
                  << " the rim; " << hit);
        CHECK(hit.has_value() == is_inside);
    }
    CHECK(judged > cases(20000) / 2);
}
