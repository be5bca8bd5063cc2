// Step 12.13 in extreme cases: tiny and huge rectangles, strips, and viewers next to an edge, a corner or the
// plane, against long double.
#include "chapters/12_distribution/rectangle_light.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/light_checks.hpp"
#include "tests/12_distribution/parallelogram_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::Random;

namespace {

struct Sight {
    QuadLight light;
    Vec3 from{0};
};

QuadLight any_rectangle(Random& random, Real width, Real height, const Vec3& middle) {
    const Vec3 s = random.direction(), t = random.perpendicular_to(s);
    return {middle - width / 2 * s - height / 2 * t, width * s, height * t};
}

Vec3 normal_of(const QuadLight& light) { return unit(cross(light.ac, light.ab)); }

template <class Make>
void check_family(std::uint64_t seed, Make make) {
    Random random(seed);
    for (int i = 0; i < cases(1500); ++i) {
        Sight view = make(random);
        if (test::exact_angle(view.light, view.from) < 0) std::swap(view.light.ab, view.light.ac);
        const Vec2 numbers = test::square_point(random);
        const Real x = i % 5 == 0 ? 1 - 0x1p-53 : i % 5 == 1 ? 0 : numbers.x;
        test::check_view(view.light, view.from, {x, i % 7 == 0 ? 1 - 0x1p-53 : numbers.y});
    }
}

}  // namespace

TEST_CASE("rectangles from tiny to huge as seen", "[12.13][stability]") {
    check_family(12160, [](Random& random) {
        const Vec3 from = random.in_cube(), way = random.direction();
        const Real width = random.magnitude(-16, 8), height = width * random.magnitude(-1, 1);
        return Sight{any_rectangle(random, width, height, from + way), from};
    });
}

TEST_CASE("long strips of light", "[12.13][stability]") {
    check_family(12161, [](Random& random) {
        const Vec3 from = random.in_cube(), way = random.direction();
        const Real width = random.magnitude(-8, 8), height = random.magnitude(-8, 8);
        return Sight{any_rectangle(random, width, height, from + way), from};
    });
}

TEST_CASE("nearly in the rectangle's plane, beside it", "[12.13][stability]") {
    check_family(12162, [](Random& random) {
        const QuadLight light = any_rectangle(random, 1, random.magnitude(-2, 2), Vec3(0));
        const Real s = random.uniform(1.01, 3), t = random.uniform(-1, 2);
        const Vec3 beside = light.corner + s * light.ab + t * light.ac;
        return Sight{light, beside + random.magnitude(-16, -1) * normal_of(light)};
    });
}

TEST_CASE("nearly on the rectangle", "[12.13][stability]") {
    check_family(12163, [](Random& random) {
        const QuadLight light = any_rectangle(random, 1, random.magnitude(-1, 1), Vec3(0));
        const Real s = random.uniform(0, 1), t = random.uniform(0, 1);
        const Vec3 under = light.corner + s * light.ab + t * light.ac;
        return Sight{light, under + random.magnitude(-16, -1) * normal_of(light)};
    });
}

TEST_CASE("next to a rectangle's edge or corner", "[12.13][stability]") {
    check_family(12164, [](Random& random) {
        const QuadLight light = any_rectangle(random, 1, 1, Vec3(0));
        const Real s = static_cast<Real>(random.index(2));
        const Real t = random.index(2) == 0 ? random.uniform(0, 1) : s;
        const Vec3 there = light.corner + s * light.ab + t * light.ac;
        return Sight{light, there + random.magnitude(-16, -1) * random.direction()};
    });
}

TEST_CASE("slivers of parallelograms", "[12.13][stability]") {
    check_family(12165, [](Random& random) {
        const Vec3 corner = random.in_cube(), ab = random.direction(), up = random.perpendicular_to(ab);
        const Vec3 ac = random.uniform(-2, 2) * ab + random.magnitude(-10, -1) * up;
        return Sight{{corner, ab, ac}, corner + 4.0 * random.direction()};
    });
}

TEST_CASE("directions to rectangles from extreme random numbers", "[12.13][stability]") {
    for (const Real x : test::ends_and_between)
        for (const Real y : test::ends_and_between)
            for (const Real size : {1e-30, 1e-10, 1.0, 1e10, 1e30})
                for (const Real near : {1e-9, 1e-3, 1.0, 1e3, 1e9}) {
                    if (near * size < 1e-30 || near * size > 1e30) continue;
                    const Vec3 corner = size * Vec3(-0.25, near, -0.5);
                    test::check_view({corner, {0, 0, size}, {size, 0, 0}}, Vec3(0), {x, y});
                }
}

TEST_CASE("directions to rectangles in extreme views are evenly dense", "[12.13][stability]") {
    for (const Real small : {1e-2, 1e-5, 1e-8}) {
        const QuadLight one{{-1, 0, -1}, {0, 0, 3}, {2, 0, 0}};
        const Vec3 way = normalize(Vec3(1, -2, -2));
        // Far away, nearly in the plane, nearly on it, next to an edge, next to a corner.
        test::check_density(one, way / small, 12166, 8000);
        test::check_density(one, {4, -small, 0.3}, 12167, 8000);
        test::check_density(one, {0.1, -small, 0.2}, 12168, 8000);
        test::check_density(one, one.corner + 0.3 * one.ab + small * way, 12169, 8000);
        test::check_density(one, one.corner + one.ac + small * way, 12170, 8000);
        // Strips along either side, and a huge square.
        test::check_density({{-1, 1, -1}, {0, 0, 3}, {2 * small, 0, 0}}, {0.2, 0, 0.3}, 12171, 8000);
        test::check_density({{-1, 1, -1}, {0, 0, 3 * small}, {2, 0, 0}}, {0.2, 0, 0.3}, 12172, 8000);
        test::check_density({one.corner / small, one.ab / small, one.ac / small}, {0.1, -1, 0.2}, 12173,
                            8000);
    }
}
