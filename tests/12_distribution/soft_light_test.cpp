// Step 12.18: lights with an extent, one random point at a time.
#include "chapters/12_distribution/soft_light.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/soft_light_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"
#include "tests/together.hpp"

#include <array>
#include <cmath>
#include <variant>
#include <vector>

using namespace rt;
using test::both_ways;
using test::cases;
using test::name_of;
using test::near;
using test::Random;
using test::square_point;

namespace {

/// A rectangle at the height h that shines down: from x0 to x1 along x, and z0 to z1 along z.
QuadLight ceiling(Real h, Real x0, Real x1, Real z0, Real z1) {
    return {{x0, h, z0}, {0, 0, z1 - z0}, {x1 - x0, 0, 0}};
}

/// A disc, a rectangle, a triangle and a sphere, of size 1 or 2, that are 2 above the floor and shine on it.
std::vector<AreaLight> lamps() {
    return {{ceiling(2, -1, 1, -1, 1), {4, 2, 1}},
            {DiscLight{{0, 2, 0}, {0, -3, 0}, 1}, {4, 2, 1}},
            {TriangleLight{{-1, 2, -1}, {1, 2, -1}, {0, 2, 1}}, {4, 2, 1}},
            {SphereLight{{0, 3, 0}, 1}, {4, 2, 1}}};
}

/// Of many samples: the colour times the cosine with the normal.
struct Measured {
    Vec3 mean{0};
    Vec3 bound{0};  ///< six times the standard error of the mean: chance exceeds it twice in 10⁹ times
};
Measured measure(const AreaLight& light, const Vec3& point, const Vec3& normal, LightSampling how, int count,
                 Random& random) {
    std::vector<std::optional<LightSample>> samples(static_cast<std::size_t>(count));
    test::together(samples.size(), [&](std::size_t i) {
        samples[i] = sample_light(light, point, how, square_point(random));
    });
    Vec3 sum(0), squares(0);
    for (const auto& sample : samples) {
        const Vec3 one = sample ? sample->color * std::max(dot(normal, sample->direction), Real(0)) : Vec3(0);
        sum += one;
        squares += one * one;
    }
    const Vec3 mean = sum / Real(count);
    const Vec3 variance = glm::max(squares / Real(count) - mean * mean, Vec3(0));
    return {mean, 6.0 * glm::sqrt(variance / Real(count)) + Vec3(gamma(count)) * mean};
}

/// Whether the mean of colour · cosine is `expected` for either way of choosing.
void check_means(const AreaLight& light, const Vec3& point, const Vec3& normal, const Vec3& expected,
                 std::uint64_t seed) {
    Random random(seed);
    for (const LightSampling how : both_ways) {
        const int count = cases(40000);
        const Measured found = measure(light, point, normal, how, count, random);
        INFO(name_of(light) << " of radiance " << light.radiance << " seen from " << point << ", normal "
                            << normal << ", points " << name_of(how)
                            << ": the mean of colour times cosine over " << count << " samples");
        CHECK(near(found.mean.x, expected.x, found.bound.x));
        CHECK(near(found.mean.y, expected.y, found.bound.y));
        CHECK(near(found.mean.z, expected.z, found.bound.z));
    }
}

/// 1/π times the irradiance of a parallel rectangle of radiance 1 whose corner is straight above, a wide and
/// b deep at the height 1: the view factor that handbooks of heat transfer have.
Real corner_factor(Real a, Real b) {
    const Real p = std::hypot(1, a), q = std::hypot(1, b);
    return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2 * pi);
}

}  // namespace

TEST_CASE("a square lamp of side 1/10, 10 above, lights as a point light does", "[12.18]") {
    // radiance · area / (pi d²): the area is 1/100, d² is 100.
    const AreaLight light{ceiling(10, -0.05, 0.05, -0.05, 0.05), pi * Vec3(300, 200, 100)};
    for (const LightSampling how : both_ways) {
        const auto sample = sample_light(light, Vec3(0), how, {0.25, 0.75});
        INFO("radiance pi·(300, 200, 100), area 1/100, distance 10, " << name_of(how)
                                                                      << "; the corners are 1/20000 farther");
        REQUIRE(sample.has_value());
        CHECK(near(sample->direction, {0, 1, 0}, 0.01));
        CHECK(near(sample->distance, 10, 0.001));
        CHECK(test::near_color(sample->color, {0.03, 0.02, 0.01}, 3e-6));
    }
}

TEST_CASE("a small lamp seen aslant counts by the cosine at the lamp", "[12.18]") {
    // 4 above and 3 beside: 5 away, cosine 4/5. Radiance 3125 pi, area 1/10000: 3125·(1/10000)·(4/5)/25.
    const AreaLight light{ceiling(4, 2.995, 3.005, -0.005, 0.005), Vec3(3125 * pi)};
    for (const LightSampling how : both_ways) {
        const auto sample = sample_light(light, Vec3(0), how, {0.75, 0.25});
        INFO("radiance 3125·pi, area 1/10000, distance 5, cosine 4/5, " << name_of(how));
        REQUIRE(sample.has_value());
        CHECK(near(sample->distance, 5, 0.01));
        CHECK(test::near_color(sample->color, Vec3(0.01), 1e-4));
    }
}

TEST_CASE("the dark side of a lamp sends nothing", "[12.18]") {
    for (const AreaLight& light : lamps()) {
        // From above, and the sphere from inside.
        const Vec3 point = std::holds_alternative<SphereLight>(light.shape) ? Vec3(0.1, 3, 0) : Vec3(0, 3, 0);
        for (const LightSampling how : both_ways) {
            const auto sample = sample_light(light, point, how, {0.3, 0.6});
            INFO(name_of(light) << " seen from " << point << ", " << name_of(how));
            CHECK_FALSE(sample.has_value());
        }
    }
}

TEST_CASE("the direction and the distance lead to a point of the lamp", "[12.18]") {
    Random random(12181);
    for (const AreaLight& light : lamps())
        for (const LightSampling how : both_ways)
            for (int i = 0; i < cases(200); ++i) {
                const Vec2 numbers = square_point(random);
                const auto sample = sample_light(light, {0.5, 0, 0}, how, numbers);
                INFO(name_of(light) << " seen from (0.5, 0, 0), random numbers " << numbers << ", "
                                    << name_of(how));
                if (std::holds_alternative<SphereLight>(light.shape) && !sample) continue;  // its far side
                REQUIRE(sample.has_value());
                INFO(*sample);
                REQUIRE(near(length(sample->direction), 1, gamma(16)));
                const Vec3 found = Vec3(0.5, 0, 0) + sample->distance * sample->direction;
                if (std::holds_alternative<SphereLight>(light.shape))
                    REQUIRE(near(length(found - Vec3(0, 3, 0)), 1, gamma(512)));
                else
                    REQUIRE(near(found.y, 2, gamma(512)));
                REQUIRE(std::abs(found.x) <= 1 + gamma(512));
            }
}

TEST_CASE("by angle a lamp that is the face of a cube around the point always sends the same", "[12.18]") {
    // A sixth of 4 pi: the colour is radiance·(4 pi/6)/pi.
    Random random(12182);
    const AreaLight light{ceiling(1, -1, 1, -1, 1), {3, 1.5, 0.75}};
    for (int i = 0; i < cases(300); ++i) {
        const Vec2 numbers = square_point(random);
        const auto sample = sample_light(light, Vec3(0), LightSampling::Angle, numbers);
        INFO(name_of(light) << " seen from the origin, random numbers " << numbers
                            << ": its solid angle is 4·pi/6 wherever the point is");
        REQUIRE(sample.has_value());
        REQUIRE(test::near_color(sample->color, {2, 1, 0.5}, gamma(1024)));
    }
}

TEST_CASE("by angle a ball and an eighth of all directions always send the same, too", "[12.18]") {
    // Radius 3 from 5 away: 2 pi (1 − 4/5) = 0.4 pi. The triangle cuts off a corner of space: 4 pi/8.
    const AreaLight ball{SphereLight{{0, 5, 0}, 3}, Vec3(5)};
    const AreaLight eighth{TriangleLight{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, Vec3(5)};
    Random random(12183);
    for (int i = 0; i < cases(300); ++i) {
        const Vec2 numbers = square_point(random);
        INFO("random numbers " << numbers << ", radiance 5, seen from the origin");
        const auto of_ball = sample_light(ball, Vec3(0), LightSampling::Angle, numbers);
        REQUIRE(of_ball.has_value());
        INFO(name_of(ball) << ": solid angle 0.4·pi");
        REQUIRE(near(of_ball->color, Vec3(2), gamma(1024)));
        const auto of_eighth = sample_light(eighth, Vec3(0), LightSampling::Angle, numbers);
        REQUIRE(of_eighth.has_value());
        INFO(name_of(eighth) << ": solid angle pi/2");
        REQUIRE(near(of_eighth->color, Vec3(2.5), gamma(1024)));
    }
}

TEST_CASE("by area the points are even on the lamp, however near it is", "[12.18]") {
    // 1/10 below the middle: by angle almost all of them would be in the four parts there.
    const AreaLight light{ceiling(0.1, -1, 1, -1, 1), Vec3(1)};
    std::vector<int> counts(16, 0);
    const int drawn = cases(20000);
    const auto pairs = test::many(static_cast<std::size_t>(drawn), 12184, square_point);
    const auto samples = test::answers(pairs, [&](const Vec2& numbers) {
        return sample_light(light, Vec3(0), LightSampling::Area, numbers);
    });
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        INFO("by area, seen from the origin, random numbers " << pairs[i]);
        REQUIRE(test::or_say(samples[i].has_value(), "nothing"));
        const Vec3 found = samples[i]->distance * samples[i]->direction;
        const auto part = [](Real x) {
            return static_cast<std::size_t>(std::clamp(2 * (x + 1), Real(0), Real(3.5)));
        };
        ++counts[4 * part(found.x) + part(found.z)];
    }
    INFO(name_of(light) << " in 4 × 4 equal parts, seen from the origin, chosen by area");
    test::check_counts(counts, std::vector<Real>(16, 1 / 16.0), drawn);
}

TEST_CASE("by area the colour is that of the chosen point", "[12.18]") {
    // area · cos/(pi d²), and with the lamp at the height 1 the cosine is 1/d.
    Random random(12185);
    const AreaLight light{ceiling(1, 0, 3, 0, 2), Vec3(pi)};
    for (int i = 0; i < cases(300); ++i) {
        const Vec2 numbers = square_point(random);
        const auto sample = sample_light(light, Vec3(0), LightSampling::Area, numbers);
        INFO("by area, seen from the origin, random numbers " << numbers);
        REQUIRE(test::or_say(sample.has_value(), "nothing"));
        const Real expected = 6 * std::pow(sample->distance, -3);
        INFO("radiance pi, area 6, at the height 1: 6/d³; the sample has d = " << sample->distance);
        REQUIRE(test::near_color(sample->color, Vec3(expected), gamma(256) * expected));
    }
}

TEST_CASE("a ball's mean light on a surface that faces it is radiance·(R/d)²", "[12.18]") {
    check_means({SphereLight{{0, 5, 0}, 3}, {25, 50, 100}}, Vec3(0), {0, 1, 0}, {9, 18, 36}, 12186);
}

TEST_CASE("a disc's mean light straight below its centre is radiance·R²/(R² + h²)", "[12.18]") {
    check_means({DiscLight{{0, 2, 0}, {0, -1, 0}, 1}, {5, 10, 0}}, Vec3(0), {0, 1, 0}, {1, 2, 0}, 12187);
}

TEST_CASE("a square's mean light is that of the formula from the handbook", "[12.18]") {
    // Side 2 at the height 1: four squares of side 1 that meet above the point; about 0.554.
    const Real all = 4 * corner_factor(1, 1);
    check_means({ceiling(1, -1, 1, -1, 1), Vec3(1)}, Vec3(0), {0, 1, 0}, Vec3(all), 12188);
    INFO("a triangle that is half of the square has half its light");
    check_means({TriangleLight{{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}}, Vec3(1)}, Vec3(0), {0, 1, 0},
                Vec3(all / 2), 12189);
}

TEST_CASE("under an endless lamp a white surface is as bright as the lamp", "[12.18]") {
    // 10⁶ wide at the height 1: one part in 10¹² is missing.
    const AreaLight light{ceiling(1, -5e5, 5e5, -5e5, 5e5), {1, 2, 4}};
    Random random(12190);
    const Measured found = measure(light, Vec3(0), {0, 1, 0}, LightSampling::Angle, cases(40000), random);
    INFO("diffuse 1, radiance (1, 2, 4) in all directions: 1/pi times the irradiance pi·(1, 2, 4)");
    CHECK(near(found.mean.x, 1, found.bound.x));
    CHECK(near(found.mean.z, 4, found.bound.z));
}

TEST_CASE("near a lamp colours differ less if they are chosen by angle", "[12.18]") {
    // At a quarter of the side below its middle.
    const AreaLight light{ceiling(0.5, -1, 1, -1, 1), Vec3(1)};
    Random random(12191);
    std::array<Real, 2> noise{};
    for (std::size_t i = 0; i < 2; ++i)
        noise[i] = measure(light, Vec3(0), {0, 1, 0}, both_ways[i], cases(20000), random).bound.x;
    INFO("six standard errors of colour times cosine: by area " << noise[0] << ", by angle " << noise[1]);
    CHECK(noise[1] < noise[0] / 2);
}

TEST_CASE("in the mean both ways are Lambert's formula, for triangles and parallelograms anywhere",
          "[12.18]") {
    Random random(12192);
    for (int i = 0; i < cases(40); ++i) {
        const Vec3 a = random.in_cube(), ab = random.in_cube(), ac = random.in_cube();
        const Vec3 back = normalize(cross(ab, ac)), beside = random.in_cube();
        const Real h = random.uniform(0.3, 3);
        // The bright side of a triangle is the dark one of a parallelogram; the corners run counterclockwise.
        const bool is_quad = random.index(2) == 0;
        const Vec3 point = a + beside - dot(beside, back) * back + (is_quad ? -h : h) * back;
        const AreaLight light = is_quad ? AreaLight{QuadLight{a, ab, ac}, Vec3(pi)}
                                        : AreaLight{TriangleLight{a, a + ab, a + ac}, Vec3(pi)};
        const std::vector<Vec3> corners =
            is_quad ? std::vector{a, a + ac, a + ab + ac, a + ab} : std::vector{a, a + ab, a + ac};
        std::vector<test::LongVec> seen;
        for (const Vec3& corner : corners) seen.emplace_back(corner - point);
        const Vec3 flow(test::exact_flow(seen));
        for (const LightSampling how : both_ways) {
            const Measured found = measure(light, point, normalize(flow), how, 4000, random);
            INFO(name_of(light) << " of radiance pi seen from " << point << ", normal " << normalize(flow)
                                << ", " << name_of(how) << ", 4000 samples");
            REQUIRE(near(found.mean.x, length(flow), found.bound.x));
        }
    }
}
