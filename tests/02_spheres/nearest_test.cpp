// Step 02.5: the nearest of many spheres, and whether there is any.
#include "chapters/02_spheres/sphere.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rt;
using test::ahead;
using test::cases;
using test::Random;

namespace {

const Ray down_z{{0, 0, 10}, {0, 0, -1}};

/// What was asked, in words; `primitive` is counted in this order.
std::string describe(const std::vector<Sphere>& spheres, const Ray& ray, Interval range) {
    std::string text = test::show(ray) + " in " + test::show(range);
    for (std::size_t i = 0; i < spheres.size(); ++i)
        text += "\n  " + test::show(i) + ": " + test::show(spheres[i]);
    return text;
}

void check_nearest(const std::vector<Sphere>& spheres, const Ray& ray, Interval range,
                   std::uint32_t primitive, Real t) {
    const std::optional<Hit> hit = closest_hit(spheres, ray, range);
    INFO(describe(spheres, ray, range));
    {
        INFO("closest_hit finds: " << hit << ", expected sphere " << primitive << " at t = " << t);
        REQUIRE(hit);
        CHECK(hit->primitive == primitive);
        CHECK(test::near(hit->t, t, gamma(8) * t));
    }
    CHECK(test::or_say(any_hit(spheres, ray, range), "any_hit finds nothing, expected that it finds one"));
}

void check_none(const std::vector<Sphere>& spheres, const Ray& ray, Interval range) {
    INFO(describe(spheres, ray, range));
    CHECK_FALSE(closest_hit(spheres, ray, range));
    CHECK(
        test::or_say(!any_hit(spheres, ray, range), "any_hit finds something, expected that nothing is hit"));
}

}  // namespace

TEST_CASE("where there are no spheres nothing is hit", "[02.5]") { check_none({}, down_z, ahead); }

TEST_CASE("the nearest sphere is found wherever it stands in the list", "[02.5]") {
    const Sphere near{{0, 0, 5}, 1}, middle{{0, 0, 0}, 2}, far{{0, 0, -5}, 1};
    check_nearest({near, middle, far}, down_z, ahead, 0, 4);
    check_nearest({middle, near, far}, down_z, ahead, 1, 4);
    check_nearest({far, middle, near}, down_z, ahead, 2, 4);
}

TEST_CASE("the nearest surface counts and not the nearest centre", "[02.5]") {
    check_nearest({{{0, 0, 0}, 1}, {{0, 0, -8}, 12}}, down_z, ahead, 1, 6);
}

TEST_CASE("a small sphere inside a large one is seen from inside", "[02.5]") {
    check_nearest({{{0, 0, 0}, 100}, {{0, 0, 5}, 1}}, down_z, ahead, 1, 4);
}

TEST_CASE("spheres missed or behind do not count", "[02.5]") {
    const std::vector<Sphere> spheres{{{9, 0, 0}, 1}, {{0, 0, 20}, 3}, {{0, 0, 0}, 1}};
    check_nearest(spheres, down_z, ahead, 2, 9);
    check_none(std::vector<Sphere>(spheres.begin(), spheres.end() - 1), down_z, ahead);
}

TEST_CASE("any_hit stops at the first sphere that is hit", "[02.5]") {
    // A hundred thousand spheres behind one: asking them all takes thousands of times as long as asking one.
    std::vector<Sphere> spheres(100'000, Sphere{{9, 0, 0}, 1});
    const auto seconds = [&](bool expected) {
        Real least = infinity;
        for (int k = 0; k < 3; ++k) {
            const double before = test::running_seconds();
            CHECK(test::or_say(any_hit(spheres, down_z, ahead) == expected,
                               expected ? "any_hit finds nothing, expected that it finds the first sphere"
                                        : "any_hit finds something, expected that nothing is hit"));
            least = std::min(least, test::running_seconds() - before);
        }
        return least;
    };
    const Real all = seconds(false);
    spheres.front() = {{0, 0, 0}, 1};
    const Real first = seconds(true);
    INFO("where the first of 100,000 spheres is hit, the search took " << first << " s; where none is, "
                                                                       << all << " s");
    CHECK(
        test::or_say(first < all / 10, "any_hit goes on after a hit, expected that it returns at the first"));
}

TEST_CASE("of equal distances the lowest index wins", "[02.5]") {
    const Sphere sphere{{0, 0, 1}, 1}, far{{0, 0, -9}, 1};
    check_nearest({sphere, sphere}, down_z, ahead, 0, 8);
    check_nearest({far, sphere, sphere, far, sphere}, down_z, ahead, 1, 8);
}

TEST_CASE("the range decides for each sphere: start excluded and end included", "[02.5]") {
    const std::vector<Sphere> spheres{{{0, 0, 0}, 1}, {{0, 0, 5}, 1}};
    const Roots far = intersections(spheres[0], down_z);   // 9 and 11, but for rounding
    const Roots near = intersections(spheres[1], down_z);  // 4 and 6
    check_nearest(spheres, down_z, {0, near.t0}, 1, 4);
    check_none(spheres, down_z, {0, 3.5});
    check_nearest(spheres, down_z, {near.t0, infinity}, 1, 6);
    check_nearest(spheres, down_z, {near.t1, infinity}, 0, 9);
    check_none(spheres, down_z, {near.t1, 8.5});
    check_none(spheres, down_z, {far.t1, infinity});
}

TEST_CASE("the nearest hit is what intersect says of each sphere, to the bit", "[02.5]") {
    Random random(2501);
    int hits = 0, misses = 0;
    for (int i = 0; i < cases(2000); ++i) {
        std::vector<Sphere> spheres;
        for (std::size_t k = random.index(20); k > 0; --k) {
            spheres.push_back({10.0 * random.in_cube(), random.uniform(0.1, 4)});
            if (random.index(4) == 0) spheres.push_back(spheres[random.index(spheres.size())]);
        }
        const Ray ray{10.0 * random.in_cube(), random.magnitude(-2, 2) * random.direction()};
        const Real start = random.uniform(-5, 5);
        const Interval range{start, start + random.magnitude(-1, 2)};

        std::optional<Hit> expected;
        for (std::size_t k = 0; k < spheres.size(); ++k) {
            const std::optional<Hit> hit = intersect(spheres[k], ray, range);
            if (!hit || (expected && hit->t >= expected->t)) continue;
            expected = hit;
            expected->primitive = static_cast<std::uint32_t>(k);
        }
        const std::optional<Hit> actual = closest_hit(spheres, ray, range);
        INFO("case " << i << ": " << spheres.size() << " spheres, " << ray << " in " << range);
        CHECK(test::same_hit(actual, expected));
        INFO("whether any_hit finds something");
        CHECK(any_hit(spheres, ray, range) == expected.has_value());
        ++(expected ? hits : misses);
        if (!expected) continue;
        // What blocks the way to a hit is nearer than the hit.
        INFO("the same where the range ends at the hit, or just before it, at " << expected->t);
        CHECK(any_hit(spheres, ray, {range.min, expected->t}) == true);
        CHECK(any_hit(spheres, ray, {range.min, std::nextafter(expected->t, -infinity)}) == false);
    }
    CHECK(hits > 0);
    CHECK(misses > 0);
}
