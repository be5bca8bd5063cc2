// Step 12.10: points of lights by area, and their density as seen.
#include "chapters/12_distribution/area_light.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/light_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::near;
using test::Random;
using test::square_point;

namespace {

/// A lamp of 2 by 2 in a ceiling 3 above the floor: ab × ac points up, so it shines down.
const QuadLight lamp{{-1, 3, -1}, {0, 0, 2}, {2, 0, 0}};
/// Sides of 3, 4 and 5; counterclockwise from above.
const TriangleLight tri{{1, 0, 2}, {1, 3, 2}, {-3, 0, 2}};
const DiscLight disc{{1, 2, 3}, {0, -2, 0}, 2};
const SphereLight ball{{1, 2, 3}, 2};

template <class Light>
std::vector<LightPoint> points_of(const Light& light, std::uint64_t seed) {
    const auto pairs = test::many(static_cast<std::size_t>(cases(20000)), seed, square_point);
    return test::answers(pairs, [&](const Vec2& numbers) { return point_on(light, numbers); });
}

/// The mean of a light's points: of each coordinate six times what chance does.
void check_middle(const std::vector<LightPoint>& points, const Vec3& middle) {
    std::vector<Vec3> places;
    for (const LightPoint& p : points) places.push_back(p.point);
    test::check_mean_direction(places, middle);
}

}  // namespace

TEST_CASE("a point of a square lamp in the ceiling", "[12.10]") {
    for (const Vec2& random : {Vec2(0, 0), Vec2(0.25, 0.5), Vec2(0.75, 0.125)}) {
        INFO(test::show(lamp) << ", random numbers " << random);
        const LightPoint p = point_on(lamp, random);
        CHECK(near(p.point.y, 3, gamma(32) * 3));
        CHECK(std::abs(p.point.x) <= 1 + gamma(32));
        CHECK(std::abs(p.point.z) <= 1 + gamma(32));
        INFO("it shines on the side of -(ab x ac), which is down, and its area is 4");
        CHECK(near(p.normal, {0, -1, 0}, gamma(16)));
        CHECK(near(p.pdf, 0.25, gamma(16)));
    }
}

TEST_CASE("a point of a triangle", "[12.10]") {
    for (const Vec2& random : {Vec2(0, 0), Vec2(0.25, 0.5), Vec2(0.75, 0.125)}) {
        INFO(test::show(tri) << ", random numbers " << random);
        const LightPoint p = point_on(tri, random);
        const Real along_ab = p.point.y / 3, along_ac = (1 - p.point.x) / 4;
        CHECK(near(p.point.z, 2, gamma(64)));
        CHECK(along_ab >= -gamma(64));
        CHECK(along_ac >= -gamma(64));
        CHECK(along_ab + along_ac <= 1 + gamma(128));
        INFO("a, b, c run counterclockwise as seen from above, and the area is 6");
        CHECK(near(p.normal, {0, 0, 1}, gamma(16)));
        CHECK(near(p.pdf, 1 / 6.0, gamma(16)));
    }
}

TEST_CASE("a point of a disc", "[12.10]") {
    for (const Vec2& random : {Vec2(0, 0), Vec2(0.25, 0.5), Vec2(0.75, 0.125)}) {
        INFO(test::show(disc) << ", random numbers " << random);
        const LightPoint p = point_on(disc, random);
        CHECK(near(p.point.y, 2, gamma(128)));
        CHECK(length(p.point - disc.center) <= 2 + gamma(128));
        INFO("the normal is made a unit vector; the area is 4 pi");
        CHECK(near(p.normal, {0, -1, 0}, gamma(16)));
        CHECK(near(p.pdf, 1 / (4 * pi), gamma(16)));
    }
}

TEST_CASE("a point of a sphere", "[12.10]") {
    for (const Vec2& random : {Vec2(0, 0), Vec2(0.25, 0.5), Vec2(0.75, 0.125)}) {
        INFO(test::show(ball) << ", random numbers " << random);
        const LightPoint p = point_on(ball, random);
        CHECK(near(length(p.normal), 1, gamma(16)));
        INFO("the normal points outwards; the area is 16 pi");
        CHECK(near(p.point, ball.center + 2.0 * p.normal, gamma(256)));
        CHECK(near(p.pdf, 1 / (16 * pi), gamma(16)));
    }
}

TEST_CASE("density as seen from the floor", "[12.10]") {
    // Straight below: d = 3, cos = 1, so 9/4. From (4, 0, 0), 3-4-5: d = 5, cos = 3/5, so 25/4 : 3/5 =
    // 125/12.
    const LightPoint middle{{0, 3, 0}, {0, -1, 0}, 0.25};
    INFO("the point (0, 3, 0) of a lamp of 4 square units that shines down");
    CHECK(near(per_steradian(middle, Vec3(0)), 2.25, 2.25 * gamma(64)));
    CHECK(near(per_steradian(middle, {4, 0, 0}), 125.0 / 12, 125.0 / 12 * gamma(96)));
    CHECK(near(per_steradian(middle, {0, 0, -4}), 125.0 / 12, 125.0 / 12 * gamma(96)));
    CHECK(near(per_steradian({middle.point, middle.normal, 3}, Vec3(0)), 27, 27 * gamma(64)));
}

TEST_CASE("the dark side of a light sends nothing", "[12.10]") {
    const LightPoint middle{{0, 3, 0}, {0, -1, 0}, 0.25};
    for (const Vec3& from : {Vec3(0, 4, 0), Vec3(4, 6, 0), Vec3(1, 3, 0), Vec3(0, 3, 0)}) {
        INFO("the point (0, 3, 0) of a lamp that shines down, seen from " << from);
        CHECK(near(per_steradian(middle, from), 0, 0));
        CHECK_FALSE(seen_from(middle, from).has_value());
    }
}

TEST_CASE("a point as a direction", "[12.10]") {
    const auto found = seen_from({{0, 3, 0}, {0, -1, 0}, 0.25}, {4, 0, 0});
    INFO("the point (0, 3, 0) of a lamp that shines down, chosen with a density of 1/4, seen from (4, 0, 0)");
    REQUIRE(test::or_say(found.has_value(), "nothing"));
    CHECK(test::near_direction(found->direction, {-0.8, 0.6, 0}, gamma(16)));
    INFO("its distance");
    CHECK(near(found->distance, 5, 5 * gamma(16)));
    INFO("and its density by angle: by area, times d^2/cos");
    CHECK(near(found->pdf, 125.0 / 12, 125.0 / 12 * gamma(96)));
}

TEST_CASE("the middle of all points is the middle of the light", "[12.10]") {
    SECTION("lamp") { check_middle(points_of(lamp, 12100), {0, 3, 0}); }
    SECTION("triangle") { check_middle(points_of(tri, 12101), {-1 / 3.0, 1, 2}); }
    SECTION("disc") { check_middle(points_of(disc, 12102), {1, 2, 3}); }
    SECTION("sphere") { check_middle(points_of(ball, 12103), {1, 2, 3}); }
}

TEST_CASE("equal areas have equally many points", "[12.10]") {
    const int drawn = cases(20000);
    std::vector<int> counts(16, 0);
    const auto count = [&](Real s, Real t) {
        const auto i = static_cast<std::size_t>(std::clamp(4 * s, 0.0, 3.0 + 0.5));
        const auto j = static_cast<std::size_t>(std::clamp(4 * t, 0.0, 3.0 + 0.5));
        ++counts[4 * i + j];
    };
    const auto turn = [](Real y, Real x) { return std::atan2(y, x) / (2 * pi) + 0.5; };
    SECTION("lamp") {
        INFO(test::show(lamp) << " in 4 by 4 parts");
        for (const LightPoint& p : points_of(lamp, 12104)) count((p.point.z + 1) / 2, (p.point.x + 1) / 2);
        test::check_counts(counts, std::vector<Real>(16, 1 / 16.0), drawn);
    }
    SECTION("triangle") {
        INFO(test::show(tri) << " in 16 triangles");
        counts.assign(32, 0);
        std::vector<Real> parts(32, 0);
        for (const LightPoint& p : points_of(tri, 12105))
            ++counts[test::part_of_triangle(p.point.y / 3, (1 - p.point.x) / 4)];
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; i + j < 4; ++j)
                for (std::size_t k = 0; k < (i + j < 3 ? 2U : 1U); ++k) parts[8 * i + 2 * j + k] = 1 / 16.0;
        test::check_counts(counts, parts, drawn);
    }
    SECTION("disc") {
        INFO(test::show(disc) << " in 4 rings of equal areas, each in quarters");
        for (const LightPoint& p : points_of(disc, 12106)) {
            const Vec3 q = (p.point - disc.center) / 2.0;
            count(dot(q, q), turn(q.z, q.x));
        }
        test::check_counts(counts, std::vector<Real>(16, 1 / 16.0), drawn);
    }
    SECTION("sphere") {
        INFO(test::show(ball) << " in 4 slices of equal thickness, each in quarters");
        for (const LightPoint& p : points_of(ball, 12107)) {
            const Vec3 q = (p.point - ball.center) / 2.0;
            count((q.y + 1) / 2, turn(q.z, q.x));
        }
        test::check_counts(counts, std::vector<Real>(16, 1 / 16.0), drawn);
    }
}

TEST_CASE("the mean of 1/density is the solid angle", "[12.10]") {
    // From the middle of a cube its top is a sixth of all directions, 4 pi/6. A sphere of radius 3 seen from
    // 5 away fills 2 pi (1 - 4/5), and more than half of its points are on the side that is not seen.
    const auto mean = [](const auto& light, const Vec3& from, Real expected) {
        INFO(test::show(light) << " seen from " << from);
        std::vector<Vec3> parts;
        for (const Real density : test::answers(points_of(light, 12108),
                                                [&](const LightPoint& p) { return per_steradian(p, from); }))
            parts.push_back(Vec3(density > 0 ? 1 / density : 0, 0, 0));
        test::check_mean_direction(parts, {expected, 0, 0});
    };
    mean(lamp, {0, 2, 0}, 2 * pi / 3);
    mean(SphereLight{{0, 0, 5}, 3}, Vec3(0), 0.4 * pi);
    // From 4 in front of the middle of a disc of radius 3 the cone has the cosine 4/5, too.
    mean(DiscLight{{0, 0, 4}, {0, 0, -1}, 3}, Vec3(0), 0.4 * pi);
    mean(TriangleLight{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, Vec3(0), pi / 2);
}

TEST_CASE("density as seen, against long double", "[12.10]") {
    Random random(12109);
    for (int i = 0; i < cases(2000); ++i) {
        const LightPoint p{random.in_cube(), random.direction(), random.magnitude(-3, 3)};
        const Vec3 from = p.point + random.magnitude(-3, 3) * random.direction();
        INFO("point " << p.point << ", normal " << p.normal << ", pdf " << p.pdf << ", from " << from);
        const test::LongVec way = test::LongVec(from) - test::LongVec(p.point);
        const test::Long far = glm::length(way), cosine = glm::dot(way, test::LongVec(p.normal)) / far;
        if (cosine < 1e-12L) continue;
        const Real expected = static_cast<Real>(p.pdf * far * far / cosine);
        CHECK(near(per_steradian(p, from), expected, expected * gamma(32) / static_cast<Real>(cosine)));
    }
}

TEST_CASE("a disc, as directions", "[12.10]") {
    Random random(12110);
    const Vec3 from(2, -1, 2);
    for (int i = 0; i < cases(1000); ++i) {
        const Vec2 numbers = square_point(random);
        const auto found = toward(disc, from, numbers);
        INFO(test::show(disc) << " from " << from << ", random numbers " << numbers);
        REQUIRE(test::or_say(found.has_value(), "nothing"));
        INFO(test::show(*found));
        const Vec3 point = from + found->distance * found->direction;
        CHECK(near(length(found->direction), 1, gamma(16)));
        CHECK(near(point.y, 2, gamma(128)));
        CHECK(length(point - disc.center) <= 2 + gamma(128));
        // cos θ is the part of the direction upwards.
        const Real expected = found->distance * found->distance / (4 * pi * found->direction.y);
        CHECK(near(found->pdf, expected, expected * gamma(128)));
    }
    INFO(test::show(disc) << " from (0, 5, 0), on its dark side");
    CHECK(test::or_say(!toward(disc, {0, 5, 0}, Vec2(0.5)), "a direction, expected nothing"));
}
