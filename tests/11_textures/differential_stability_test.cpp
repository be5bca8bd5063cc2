// Step 11.12 and 11.13 on extreme cases: rays that graze, differentials of all sizes, critical angles.
#include "chapters/11_textures/differential.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::Random;

namespace {

RayDifferential some_differential(Random& random, const Ray& ray, Real origin, Real direction) {
    return {origin * random.in_cube(), origin * random.in_cube(),
            direction * random.perpendicular_to(ray.direction),
            direction * random.perpendicular_to(ray.direction)};
}

bool is_finite(const RayDifferential& r) {
    return test::is_finite(r.origin_dx) && test::is_finite(r.origin_dy) && test::is_finite(r.direction_dx) &&
           test::is_finite(r.direction_dy);
}

}  // namespace

TEST_CASE("grazing rays, however little they are inclined, have finite differentials", "[11.12][stability]") {
    Random random(111011);
    for (int i = 0; i < cases(20000); ++i) {
        // Along an axis the cosine is what it was made, from 1e-300 to 0.
        const Real cosine = i % 5 == 0 ? 0 : random.sign() * random.magnitude(-300, -5);
        const Ray ray{random.magnitude(-3, 3) * random.in_cube(), {1, 0, 0}};
        const Vec3 n(cosine, i % 2 == 0 ? 1 : -1, 0);
        const RayDifferential in =
            some_differential(random, ray, random.magnitude(-9, 9), random.magnitude(-9, 1));
        const Real t = random.magnitude(-12, 12);
        INFO(ray << " at t = " << t << ", normal " << n);
        CHECK(is_finite(transferred(in, ray, t, n)));
    }
}

TEST_CASE("slanted rays with changes of all sizes end on the tangent plane", "[11.12][stability]") {
    Random random(111012);
    for (int i = 0; i < cases(20000); ++i) {
        const Ray ray{Vec3(0), random.direction()};
        const Real cosine = random.magnitude(-5.9, 0), t = random.sign() * random.magnitude(-12, 12);
        const Vec3 side = random.perpendicular_to(ray.direction);
        const Vec3 n =
            random.sign() * normalize(cosine * ray.direction + std::sqrt(1 - cosine * cosine) * side);
        const Real origin = random.magnitude(-9, 9), direction = random.magnitude(-9, 1);
        const RayDifferential in = some_differential(random, ray, origin, direction);
        const RayDifferential out = transferred(in, ray, t, n);
        INFO(ray << " at t = " << t << ", normal " << n << ", changes of " << origin << " and " << direction);
        // The way is along the ray, and ends on the plane. The normal is a unit vector but for 4u.
        const Real size = 2 * (origin + std::abs(t) * direction) / std::abs(dot(ray.direction, n));
        CHECK(test::near(dot(out.origin_dx, n), 0, gamma(3 * 24) * size));
        CHECK(test::near(dot(out.origin_dy, n), 0, gamma(3 * 24) * size));
        const Vec3 way = out.origin_dx - (in.origin_dx + t * in.direction_dx);
        CHECK(test::near(cross(way, ray.direction), Vec3(0), gamma(3 * 24) * size));
    }
}

TEST_CASE("near a critical angle differentials are finite", "[11.13][stability]") {
    Random random(111111);
    for (int i = 0; i < cases(20000); ++i) {
        const Real eta = random.uniform(1.01, 3);
        const Real below = i % 4 == 0 ? 0 : random.magnitude(-18, -1);
        const Real sine = (1 - below) / eta;
        const Vec3 n = random.direction();
        const Vec3 d = normalize(sine * random.perpendicular_to(n) - std::sqrt(1 - sine * sine) * n);
        const RayDifferential in = some_differential(random, {Vec3(0), d}, 1, random.magnitude(-9, 1));
        const NormalChange change{random.magnitude(-9, 3) * random.perpendicular_to(n),
                                  random.magnitude(-9, 3) * random.perpendicular_to(n)};
        INFO("d = " << d << ", n = " << n << ", eta = " << eta << ", sine of refraction " << eta * sine);
        CHECK(is_finite(refracted(in, d, n, change, eta)));
        CHECK(is_finite(reflected(in, d, n, change)));
    }
}
