// Step 12.12 in extreme cases: tiny and huge triangles, slivers, and viewers next to an edge, a corner or the
// plane, against long double.
#include "chapters/12_distribution/triangle_light.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/light_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::LongVec;
using test::near;
using test::Random;

namespace {

struct Sight {
    TriangleLight light;
    Vec3 from{0};
};

/// With its corners in the other order, if `from` would be on its dark side; any of them first.
Sight turned(Random& random, Sight view) {
    if (test::exact_angle(view.light, view.from) < 0) std::swap(view.light.b, view.light.c);
    const TriangleLight t = view.light;
    const std::size_t first = random.index(3);
    if (first == 1) view.light = {t.b, t.c, t.a};
    if (first == 2) view.light = {t.c, t.a, t.b};
    return view;
}

Real greatest_distance(const test::LongTriangle& t) {
    return static_cast<Real>(std::max({glm::length(t.a), glm::length(t.b), glm::length(t.c)}));
}

void check_view(const Sight& view, const Vec2& numbers) {
    const test::LongTriangle t = test::long_triangle(view.light, view.from);
    const Real expected = static_cast<Real>(test::exact_angle(t));
    const Real bound = gamma(64) * test::angle_condition(t, false);
    INFO(test::show(view.light) << " from " << view.from << ", random numbers " << numbers);
    const Real omega = solid_angle(view.light, view.from);
    CHECK(std::isfinite(omega));
    // The first order of the rounding's effect says nothing where it is not small.
    if (bound < 0.01) CHECK(near(omega, expected, bound));
    const auto found = toward(view.light, view.from, numbers);
    if (!found) {
        const Real nearest =
            static_cast<Real>(std::min({glm::length(t.a), glm::length(t.b), glm::length(t.c)}));
        const bool at_corner = nearest <= gamma(64) * greatest_distance(t);
        CHECK((at_corner || !(expected > 2 * bound)));
        return;
    }
    INFO(test::show(*found));
    CHECK(near(length(found->direction), 1, gamma(16)));
    CHECK(near(found->pdf * omega, 1, gamma(16)));
    CHECK(found->distance > 0);
    CHECK(test::outside(*found, t) <= gamma(64) * greatest_distance(t));
}

template <class Make>
void check_family(std::uint64_t seed, Make make) {
    Random random(seed);
    for (int i = 0; i < cases(2000); ++i) {
        const Sight view = turned(random, make(random));
        const Vec2 numbers = test::square_point(random);
        const Real x = i % 5 == 0 ? 1 - 0x1p-53 : i % 5 == 1 ? 0 : numbers.x;
        check_view(view, {x, i % 7 == 0 ? 1 - 0x1p-53 : numbers.y});
    }
}

TriangleLight any_triangle(Random& random, Real size, const Vec3& middle) {
    const Vec3 a = random.in_cube(), b = random.in_cube(), c = random.in_cube();
    return {middle + size * a, middle + size * b, middle + size * c};
}

Vec3 in_triangle(const TriangleLight& t, Real s, Real r) {
    return t.a + std::sqrt(s) * ((1 - r) * (t.b - t.a) + r * (t.c - t.a));
}

/// Samples of such a view are as dense as the pdf says.
void check_density(const Sight& view, std::uint64_t seed) {
    INFO(test::show(view.light) << " from " << view.from << ", in 16 smaller triangles");
    const test::LongTriangle t = test::long_triangle(view.light, view.from);
    std::vector<int> counts(32, 0);
    for (const LightDirection& one : test::directions_to(view.light, view.from, seed, 8000)) {
        const Vec2 at = test::place_in(test::beyond_corner(one, t.a), t.ab, t.ac);
        ++counts[test::part_of_triangle(at.x, at.y)];
    }
    test::check_counts(counts, test::parts_of_triangle(t), cases(8000));
}

}  // namespace

TEST_CASE("triangles from tiny to huge as seen", "[12.12][stability]") {
    check_family(12133, [](Random& random) {
        const Vec3 from = random.in_cube(), way = random.direction();
        return Sight{any_triangle(random, random.magnitude(-16, 8), from + way), from};
    });
}

TEST_CASE("nearly in the triangle's plane, beside it", "[12.12][stability]") {
    check_family(12134, [](Random& random) {
        const TriangleLight t = any_triangle(random, 1, Vec3(0));
        const Vec3 n = cross(t.b - t.a, t.c - t.a);
        const Vec3 beside = in_triangle(t, random.uniform(0, 1), random.uniform(0, 1)) +
                            4.0 * normalize(random.perpendicular_to(n));
        return Sight{t, beside + random.magnitude(-16, -1) * normalize(n)};
    });
}

TEST_CASE("nearly on the triangle", "[12.12][stability]") {
    check_family(12135, [](Random& random) {
        const Real size = random.magnitude(0, 8), up = size * random.magnitude(-16, -1);
        const TriangleLight t = any_triangle(random, size, Vec3(0));
        const Real s = random.uniform(0, 1), r = random.uniform(0, 1);
        return Sight{t, in_triangle(t, s, r) + up * unit(cross(t.b - t.a, t.c - t.a))};
    });
}

TEST_CASE("next to a triangle's edge or corner", "[12.12][stability]") {
    check_family(12136, [](Random& random) {
        const TriangleLight t = any_triangle(random, 1, Vec3(0));
        const Real along = random.index(2) == 0 ? 0 : random.uniform(0, 1), r = random.magnitude(-16, -1);
        return Sight{t, t.a + along * (t.b - t.a) + r * random.direction()};
    });
}

TEST_CASE("slivers of triangles", "[12.12][stability]") {
    check_family(12137, [](Random& random) {
        const Vec3 a = random.in_cube(), side = random.direction(), up = random.perpendicular_to(side);
        const Real along = random.uniform(-0.5, 1.5), high = random.magnitude(-12, -1);
        return Sight{{a, a + side, a + along * side + high * up}, a + 2.0 * random.direction()};
    });
}

TEST_CASE("directions to triangles from extreme random numbers", "[12.12][stability]") {
    for (const Real x : test::ends_and_between)
        for (const Real y : test::ends_and_between)
            for (const Real size : {1e-30, 1e-10, 1.0, 1e10, 1e30})
                check_view({{{size, 0, 0}, {0, 0, size}, {0, size, 0}}, Vec3(0)}, {x, y});
}

TEST_CASE("directions to triangles in extreme views are evenly dense", "[12.12][stability]") {
    Random random(12138);
    for (const Real small : {1e-2, 1e-5, 1e-8}) {
        const TriangleLight one{{-1, -1, 0}, {0, 2, 0}, {2, -1, 0}};
        const Vec3 way = normalize(Vec3(1, 2, -2));
        // Far away, nearly in the plane, nearly on it, next to an edge, next to a corner.
        check_density({one, way / small}, 12139);
        check_density({one, {4, 3, -small}}, 12140);
        check_density({one, {0.1, 0.2, -small}}, 12141);
        check_density({one, one.a + 0.3 * (one.b - one.a) + small * way}, 12142);
        check_density({one, one.b + small * way}, 12143);
        // A sliver.
        check_density({{{-1, 0, 1}, {0.3, small, 1}, {1, 0, 1}}, {0.2, 0.3, 0}}, 12144);
        // Huge.
        check_density({{one.a / small, one.b / small, one.c / small}, {0.1, 0.2, -1}}, 12145);
    }
}
