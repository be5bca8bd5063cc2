// Step 12.11: directions to spheres.
#include "chapters/12_distribution/sphere_light.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/light_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::directions_to;
using test::near;
using test::Random;
using test::square_point;

namespace {

/// Radius 3, seen from 5 away: the cone's sine is 3/5, its cosine 4/5, and the tangents are 4 long.
const SphereLight ball{{0, 0, 5}, 3};

void check_solid_angle(const SphereLight& light, const Vec3& from, Real expected, Real part) {
    INFO("the solid angle of a " << test::show(light) << " seen from " << from);
    CHECK(near(solid_angle(light, from), expected, expected * part));
}

}  // namespace

TEST_CASE("the solid angle of a sphere of radius 3 from 5 away", "[12.11]") {
    // 2 pi (1 - 4/5)
    check_solid_angle(ball, Vec3(0), 0.4 * pi, gamma(54));
    check_solid_angle(ball, {0, 0, 10}, 0.4 * pi, gamma(54));
    check_solid_angle(ball, {4, 0, 8}, 0.4 * pi, gamma(54));
    // Radius 1 from √2 away: the cone's angle is 45 degrees.
    check_solid_angle({{1, 1, 0}, 1}, Vec3(0), 2 * pi * (1 - std::sqrt(0.5)), gamma(59));
}

TEST_CASE("a small sphere far away keeps its solid angle", "[12.11]") {
    // r/d = 1e-9: pi·1e-18, up to a part of 1e-18/4. The cosine is 1 for a program.
    const SphereLight star{{0, 1e9, 0}, 1};
    check_solid_angle(star, Vec3(0), pi * 1e-18, gamma(48));
    INFO(test::show(star) << " from the origin");
    const auto found = toward(star, Vec3(0), {0.5, 0.5});
    REQUIRE(found.has_value());
    CHECK(near(found->pdf, 1e18 / pi, 1e18 / pi * gamma(64)));
    CHECK(near(found->direction, {0, 1, 0}, 1e-9 + gamma(64)));
}

TEST_CASE("from inside a sphere there is no light", "[12.11]") {
    for (const Vec3& from : {Vec3(0, 0, 5), Vec3(0, 0, 3), Vec3(1, 1, 4), Vec3(0, 0, 2), Vec3(0, 3, 5)}) {
        INFO(test::show(ball) << " from " << from << ", which is not outside");
        CHECK(near(solid_angle(ball, from), 0, 0));
        CHECK_FALSE(toward(ball, from, Vec2(0.5)).has_value());
    }
}

TEST_CASE("directions to a sphere of radius 3 from 5 away", "[12.11]") {
    for (const Vec2& numbers : {Vec2(0, 0), Vec2(0.25, 0.5), Vec2(0.75, 0.125), Vec2(0.999, 0.999)}) {
        const auto found = toward(ball, Vec3(0), numbers);
        INFO(test::show(ball) << " from the origin, random numbers " << numbers);
        REQUIRE(test::or_say(found.has_value(), "nothing"));
        INFO(test::show(*found));
        CHECK(near(length(found->direction), 1, gamma(16)));
        INFO("the pdf is 1/(0.4 pi) for all");
        CHECK(near(found->pdf, 2.5 / pi, 2.5 / pi * gamma(64)));
        INFO("the cosine with the axis is at least 4/5");
        CHECK(found->direction.z >= 0.8 - gamma(64));
        INFO("the nearer side of the sphere is between 2 and 4 away");
        CHECK(found->distance >= 2 - gamma(512));
        CHECK(found->distance <= 4 + gamma(512));
        CHECK(near(length(found->distance * found->direction - ball.center), 3, 5 * gamma(64)));
    }
}

TEST_CASE("a sphere in any direction", "[12.11]") {
    Random random(12114);
    for (int i = 0; i < cases(3000); ++i) {
        const Vec3 from = random.in_cube(), axis = random.direction();
        const Real d = random.uniform(0.1, 10), sine = random.uniform(0.01, 0.99);
        const SphereLight light{from + d * axis, sine * d};
        const Vec2 numbers = square_point(random);
        INFO(test::show(light) << " from " << from << ", random numbers " << numbers);
        const auto found = toward(light, from, numbers);
        REQUIRE(found.has_value());
        INFO(test::show(*found));
        // Rounding the centre moves it by u of its coordinates: up to 11 times u of d.
        const Real rest = std::sqrt((1 - sine) * (1 + sine));
        CHECK(near(length(found->direction), 1, gamma(16)));
        CHECK(dot(found->direction, light.center - from) >= d * (rest - 12 * gamma(64)));
        const Vec3 point = from + found->distance * found->direction;
        CHECK(near(length(point - light.center), light.radius, (1 + d) * gamma(256)));
        INFO("the ray enters the sphere there: it does not leave it");
        CHECK(dot(point - light.center, found->direction) <= (1 + d) * gamma(256));
    }
}

TEST_CASE("the mean direction to a sphere", "[12.11]") {
    // The cosine is uniform from 4/5 to 1.
    std::vector<Vec3> directions;
    for (const LightDirection& one : directions_to(ball, Vec3(0), 12115)) directions.push_back(one.direction);
    INFO(test::show(ball) << " from the origin: the mean cosine is 9/10");
    test::check_mean_direction(directions, {0, 0, 0.9});
}

TEST_CASE("directions to a sphere are evenly dense", "[12.11]") {
    const auto check = [](const Vec3& axis, Real sine, std::uint64_t seed) {
        const SphereLight light{4.0 * axis, 4 * sine};
        const Vec3 u = normalize(cross(axis, Vec3(0.3, 0.9, -0.2))), v = cross(axis, u);
        const Real most = 1 - std::sqrt((1 - sine) * (1 + sine));
        std::vector<int> counts(32, 0);
        INFO(test::show(light) << " from the origin: 4 rings of equal solid angles, in 8 sectors");
        for (const LightDirection& one : directions_to(light, Vec3(0), seed)) {
            // 1 − cos without cancellation is half the square of the chord.
            const Vec3 chord = one.direction - axis;
            const Real ring = 4 * dot(chord, chord) / 2 / most;
            const Real sector =
                8 * (std::atan2(dot(one.direction, v), dot(one.direction, u)) / (2 * pi) + 0.5);
            const auto i = static_cast<std::size_t>(std::clamp(ring, 0.0, 3.5));
            const auto j = static_cast<std::size_t>(std::clamp(sector, 0.0, 7.5));
            ++counts[8 * i + j];
        }
        test::check_counts(counts, std::vector<Real>(32, 1 / 32.0), cases(20000));
    };
    check({0, 0, 1}, 0.6, 12116);
    check({0, -1, 0}, 0.99, 12117);
    check(normalize(Vec3(1, 2, -3)), 0.1, 12118);
}
