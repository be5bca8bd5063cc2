// Step 12.10 in extreme cases: lights of all sizes, numbers at the ends of [0, 1), and nearly from the side.
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

namespace {

void check_point(const LightPoint& p, Real area, Real condition) {
    CHECK(test::is_finite(p.point));
    CHECK(near(length(p.normal), 1, gamma(16)));
    CHECK(near(p.pdf * area, 1, 2 * gamma(16) * condition));
}

}  // namespace

TEST_CASE("points of tiny and huge lights, from extreme random numbers", "[12.10][stability]") {
    Random random(12111);
    for (const Real size : {1e-30, 1e-10, 1.0, 1e10, 1e30}) {
        const Vec3 s = size * random.direction(), t = size * random.perpendicular_to(s);
        const QuadLight quad{Vec3(0), s, t};
        const TriangleLight triangle{Vec3(0), s, t};
        const DiscLight disc{Vec3(0), s, size};
        const SphereLight sphere{Vec3(0), size};
        for (const Real x : test::ends_and_between)
            for (const Real y : test::ends_and_between) {
                INFO("lights of size " << size << ", random numbers " << Vec2(x, y));
                const LightPoint on_quad = point_on(quad, {x, y}), on_triangle = point_on(triangle, {x, y});
                const LightPoint on_disc = point_on(disc, {x, y}), on_sphere = point_on(sphere, {x, y});
                check_point(on_quad, size * size, 4);
                check_point(on_triangle, size * size / 2, 4);
                check_point(on_disc, pi * size * size, 1);
                check_point(on_sphere, 4 * pi * size * size, 1);
                const Real bound = gamma(64) * size;
                using test::LongVec;
                CHECK(test::outside(LongVec(on_quad.point),
                                    {LongVec(0), LongVec(s), LongVec(s + t), LongVec(t)}) <= bound);
                CHECK(test::outside(LongVec(on_triangle.point), {LongVec(0), LongVec(s), LongVec(t)}) <=
                      bound);
                CHECK(length(on_disc.point) <= size + bound);
                CHECK(near(dot(on_disc.point, s / size), 0, bound));
                CHECK(near(length(on_sphere.point), size, bound));
            }
    }
}

TEST_CASE("slivers have the area that they have", "[12.10][stability]") {
    Random random(12112);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 ab = random.direction(), beside = random.perpendicular_to(ab);
        const Vec3 ac = random.uniform(-2, 2) * ab + random.magnitude(-10, 0) * beside;
        const test::Long area = glm::length(glm::cross(test::LongVec(ab), test::LongVec(ac)));
        const QuadLight quad{Vec3(0), ab, ac};
        INFO(test::show(quad));
        const Real condition = static_cast<Real>(length(ab) * length(ac) / area);
        check_point(point_on(quad, Vec2(0.5)), static_cast<Real>(area), condition);
        check_point(point_on(TriangleLight{Vec3(0), ab, ac}, Vec2(0.5)), static_cast<Real>(area / 2),
                    condition);
    }
}

TEST_CASE("density as seen from nearly beside, near and far", "[12.10][stability]") {
    Random random(12113);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 normal = random.direction(), along = random.perpendicular_to(normal);
        const Real far = random.magnitude(-20, 20), up = random.magnitude(-20, 0);
        const Vec3 from = far * (along + up * normal);
        const LightPoint p{Vec3(0), normal, random.magnitude(-30, 30)};
        INFO("pdf " << p.pdf << ", " << far << " away, " << up << " of that above the light's plane");
        const test::LongVec way(from);
        const test::Long distance = glm::length(way);
        const Real cosine = static_cast<Real>(glm::dot(way, test::LongVec(normal)) / distance);
        const Real density = per_steradian(p, from);
        CHECK(density >= 0);
        if (cosine < 1e-12) continue;
        const Real expected = static_cast<Real>(p.pdf * distance * distance / cosine);
        CHECK(near(density, expected, expected * gamma(32) / cosine));
    }
}
