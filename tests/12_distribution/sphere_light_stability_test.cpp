// Step 12.11 in extreme cases: spheres from 1e-16 of the distance to just below it, against long double.
#include "chapters/12_distribution/sphere_light.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/light_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::Long;
using test::LongVec;
using test::near;
using test::Random;

namespace {

struct Cone {
    Long distance = 0;
    Long cosine = 0;
    Long angle = 0;  ///< solid
};

Cone exact_cone(const SphereLight& light, const Vec3& from) {
    const Long d = glm::length(LongVec(light.center) - LongVec(from)), r = light.radius;
    const Long tangent = std::sqrt((d - r) * (d + r)), half = std::atan2(r, tangent) / 2;
    return {d, tangent / d, 4 * test::long_pi * std::sin(half) * std::sin(half)};
}

void check_sphere(const SphereLight& light, const Vec3& from, const Vec2& numbers) {
    const Cone cone = exact_cone(light, from);
    INFO(test::show(light) << " from " << from << ", random numbers " << numbers);
    const Real expected = static_cast<Real>(cone.angle), d = static_cast<Real>(cone.distance);
    const Real condition = 1 + 1 / static_cast<Real>(cone.cosine);
    CHECK(near(solid_angle(light, from), expected, expected * gamma(24) * condition));
    const auto found = toward(light, from, numbers);
    REQUIRE(found.has_value());
    INFO(test::show(*found));
    CHECK(near(found->pdf * expected, 1, 2 * gamma(24) * condition));
    CHECK(near(length(found->direction), 1, gamma(16)));
    CHECK(found->distance >= 0);
    const LongVec to_center = LongVec(light.center) - LongVec(from), w(found->direction);
    const Long off = glm::length(Long(found->distance) * w - to_center) - light.radius;
    CHECK(near(static_cast<Real>(off), 0, gamma(64) * d));
    const Long angle = std::atan2(glm::length(glm::cross(w, to_center)), glm::dot(w, to_center));
    const Long most =
        std::acos(cone.cosine) < 0.1L ? std::asin(light.radius / cone.distance) : std::acos(cone.cosine);
    CHECK(static_cast<Real>(angle - most) <= gamma(32) * condition);
}

}  // namespace

TEST_CASE("spheres from tiny to huge as seen", "[12.11][stability]") {
    Random random(12119);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 from = random.in_cube() * random.magnitude(-8, 8);
        const Real d = random.magnitude(-8, 8);
        const SphereLight light{from + d * random.direction(), 0.999 * d * random.magnitude(-16, 0)};
        if (exact_cone(light, from).distance < 1.0005L * light.radius) continue;
        const Vec2 numbers = test::square_point(random);
        check_sphere(light, from, i % 4 == 0 ? Vec2(1 - 0x1p-53, numbers.y) : numbers);
    }
}

TEST_CASE("close above the surface of a sphere", "[12.11][stability]") {
    Random random(12120);
    for (int i = 0; i < cases(5000); ++i) {
        const SphereLight light{Vec3(0), random.magnitude(-10, 10)};
        const Vec3 from = light.radius * (1 + random.magnitude(-14.5, 0)) * random.direction();
        const Vec2 numbers = test::square_point(random);
        check_sphere(light, from, i % 4 == 0 ? Vec2(1 - 0x1p-53, numbers.y) : numbers);
    }
}

TEST_CASE("directions to spheres from extreme random numbers", "[12.11][stability]") {
    for (const Real x : test::ends_and_between)
        for (const Real y : test::ends_and_between)
            for (const Real size : {1e-30, 1e-8, 1.0, 1e29})
                for (const Vec3& way : {Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(0.6, 0, -0.8)})
                    check_sphere({2 * size * way, size}, Vec3(0), {x, y});
}

TEST_CASE("tiny spheres are evenly dense", "[12.11][stability]") {
    for (const Real sine : {1e-3, 1e-6, 1e-10}) {
        const Vec3 axis(0, 0, 1);
        const SphereLight light{axis, sine};
        INFO(test::show(light) << " from the origin: 8 rings of equal solid angles, in quarters");
        std::vector<int> counts(32, 0);
        for (const LightDirection& one : test::directions_to(light, Vec3(0), 12121)) {
            const Vec3 w = one.direction;
            const Real ring = (w.x * w.x + w.y * w.y) / (sine * sine);
            ++counts[4 * static_cast<std::size_t>(std::clamp(8 * ring, 0.0, 7.5)) + (w.x > 0 ? 2U : 0U) +
                     (w.y > 0 ? 1U : 0U)];
        }
        test::check_counts(counts, std::vector<Real>(32, 1 / 32.0), cases(20000));
    }
}
