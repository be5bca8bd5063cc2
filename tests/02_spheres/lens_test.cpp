// Step 02.6, which is optional: the lens that two balls have in common.
#include "chapters/02_spheres/lens.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>

using namespace rt;
using test::ahead;
using test::cases;
using test::Random;

namespace {

/// Radii of 5, centres 3 in front of and behind the origin: a lens 4 thick, whose edge is a circle of
/// radius 4.
const Sphere front{{0, 0, 3}, 5}, back{{0, 0, -3}, 5};

std::string describe(const Sphere& a, const Sphere& b, const Ray& ray, Interval range) {
    return "the lens of a " + test::show(a) + "\nand b " + test::show(b) + "\n" + test::show(ray) + " in " +
           test::show(range);
}

void check_lens(const Ray& ray, Interval range, Real t, std::uint32_t primitive) {
    INFO(describe(front, back, ray, range));
    const std::optional<Hit> hit = intersect_lens(front, back, ray, range);
    REQUIRE(hit);
    {
        INFO("the t of the hit");
        CHECK(test::near(hit->t, t, gamma(8) * 20));
    }
    INFO("its primitive, which is 0 on the surface of a and 1 on that of b");
    CHECK(hit->primitive == primitive);
}

void check_beside(const Ray& ray, Interval range) {
    INFO(describe(front, back, ray, range));
    CHECK_FALSE(intersect_lens(front, back, ray, range));
}

/// How far inside of the sphere the point is; negative outside.
Real depth(const Sphere& sphere, const Vec3& point) { return sphere.radius - length(point - sphere.center); }

}  // namespace

TEST_CASE("a lens 4 thick is entered by the surface of the farther ball", "[02.6]") {
    check_lens({{0, 0, 10}, {0, 0, -1}}, ahead, 8, 1);
    check_lens({{0, 0, -10}, {0, 0, 1}}, ahead, 8, 0);
}

TEST_CASE("3 beside its axis the lens is 2 thick", "[02.6]") {
    check_lens({{3, 0, 10}, {0, 0, -1}}, ahead, 9, 1);
}

TEST_CASE("a ray that meets both balls may pass between them beside the lens", "[02.6]") {
    check_beside({{4.5, 0, 10}, {0, 0, -1}}, ahead);
    check_beside({{0, -4.5, 0}, {0, 0, 1}}, ahead);
}

TEST_CASE("a ray that meets one ball only, or none, misses the lens", "[02.6]") {
    check_beside({{10, 0, 6}, {-1, 0, 0}}, ahead);
    check_beside({{10, 0, -6}, {-1, 0, 0}}, ahead);
    check_beside({{10, 9, 0}, {-1, 0, 0}}, ahead);
    // From inside of one, where roots of 0 for the other would be in the range.
    check_beside({{1, 0, 6}, {1, 0, 0}}, {-100, infinity});
}

TEST_CASE("from inside of a lens one sees its far surface", "[02.6]") {
    check_lens({{0, 0, 0}, {0, 0, -1}}, ahead, 2, 0);
    check_lens({{0, 0, 0}, {0, 0, 1}}, ahead, 2, 1);
}

TEST_CASE("a lens is left by the surface of the nearer ball", "[02.6]") {
    check_lens({{3, 0, 10}, {0, 0, -1}}, {9.5, infinity}, 11, 0);
}

TEST_CASE("from inside of one ball but outside of the lens its near surface is seen", "[02.6]") {
    check_lens({{0, 0, 6}, {0, 0, -2}}, ahead, 2, 1);
    check_beside({{0, 0, 6}, {0, 0, 1}}, ahead);
}

TEST_CASE("where the surfaces of both balls meet, the edge of the lens is that of a", "[02.6]") {
    const Ray across{{10, 0, 0}, {-1, 0, 0}};
    check_lens(across, ahead, 6, 0);
    check_lens(across, {10, infinity}, 14, 0);
}

TEST_CASE("balls that touch have one point in common", "[02.6]") {
    const Sphere above{{0, 0, 5}, 5}, below{{0, 0, -5}, 5};
    const Ray ray{{10, 0, 0}, {-1, 0, 0}};
    INFO(describe(above, below, ray, ahead) << "; they touch at the origin");
    CHECK(test::same_hit(intersect_lens(above, below, ray, ahead), Hit{.t = 10, .primitive = 0}));
}

TEST_CASE("the range of a lens leaves its start out and takes its end in", "[02.6]") {
    const Ray ray{{0, 0, 10}, {0, 0, -1}};
    const Real in = intersections(back, ray).t0, out = intersections(front, ray).t1;  // 8 and 12
    check_lens(ray, {0, in}, 8, 1);
    check_beside(ray, {0, std::nextafter(in, 0.0)});
    check_lens(ray, {in, out}, 12, 0);
    check_beside(ray, {out, infinity});
}

TEST_CASE("a hit of a lens is on one ball and inside of the other; a miss stays outside of one", "[02.6]") {
    Random random(2601);
    int hits = 0, misses = 0;
    for (int i = 0; i < cases(5000); ++i) {
        const Sphere a{random.in_cube(), random.uniform(0.3, 1.5)},
            b{random.in_cube(), random.uniform(0.3, 1.5)};
        const Ray ray{3.0 * random.direction(), normalize(random.in_cube())};
        const std::optional<Hit> hit = intersect_lens(a, b, ray, ahead);
        const Real rounding = 64 * unit_roundoff * 8;
        INFO(describe(a, b, ray, ahead));
        if (hit) {
            ++hits;
            const Vec3 point = point_at(ray, hit->t);
            const Sphere& own = hit->primitive == 0 ? a : b;
            const Sphere& other = hit->primitive == 0 ? b : a;
            INFO("how deep the point of the hit is in the ball that it belongs to");
            CHECK(test::near(depth(own, point), 0, rounding));
            CHECK(test::or_say(depth(other, point) >= -rounding, "the hit is outside of the other ball"));
        }
        // Where both balls are, one sample after the other.
        const Real end = hit ? hit->t : Real(8);
        bool clear = true;
        for (Real t = 0.01; t < end - 1e-3; t += 0.01)
            clear = clear && std::min(depth(a, point_at(ray, t)), depth(b, point_at(ray, t))) <= 1e-6;
        const bool starts_inside = std::min(depth(a, ray.origin), depth(b, ray.origin)) > 0;
        if (!starts_inside)
            CHECK(test::or_say(clear, "the ray is in both balls before its hit, or without one"));
        if (!hit) ++misses;
    }
    CHECK(hits > 0);
    CHECK(misses > 0);
}
