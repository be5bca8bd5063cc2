// Step 12.14 near edges, far away, for slivers, and along the horizon; against quadrature in long double.
#include "chapters/12_distribution/lambert_polygon.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/polygon_oracle.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <vector>

using namespace rt;
using test::cases;
using test::near;
using test::Random;

namespace {

using Corners = std::vector<Vec3>;

/// A polygon around `middle` in the plane of a and b: at growing angles, as far away as it happens, so that
/// it need not be convex.
Corners star(Random& random, const Vec3& middle, const Vec3& a, const Vec3& b) {
    const std::size_t count = 3 + random.index(6);
    const Real first = random.uniform(0, 2 * pi), way = random.sign();
    Corners corners;
    for (std::size_t k = 0; k < count; ++k) {
        const Real turn =
            first + way * 2 * pi * (static_cast<Real>(k) + random.uniform(0, 0.5)) / static_cast<Real>(count);
        corners.push_back(middle + random.uniform(0.3, 1) * (std::cos(turn) * a + std::sin(turn) * b));
    }
    return corners;
}

Corners star_of_size(Random& random, const Vec3& middle, Real size) {
    const Vec3 across = random.direction(), along = random.perpendicular_to(across);
    return star(random, middle, size * across, size * along);
}

void check_irradiance(const Corners& corners, const Vec3& point, const Vec3& normal) {
    INFO("corners " << corners << " seen from " << point << " with the normal " << normal);
    const test::ExactIrradiance exact = test::exact_irradiance(corners, point, normal);
    CHECK(near(polygon_irradiance(corners, point, normal), exact.value, exact.bound));
}

}  // namespace

TEST_CASE("polygons of any shape, with and without the horizon", "[12.14][stability]") {
    Random random(121410);
    for (int i = 0; i < cases(3000); ++i) {
        const Vec3 normal = random.direction(), away = random.direction();
        const Vec3 middle = random.magnitude(-0.5, 1) * away;
        check_irradiance(star_of_size(random, middle, 1), Vec3(0), normal);
    }
}

TEST_CASE("a point next to an edge", "[12.14][stability]") {
    Random random(121411);
    for (int i = 0; i < cases(3000); ++i) {
        const Vec3 normal = random.direction(), away = random.direction(), middle = random.in_cube();
        const Corners corners = star_of_size(random, middle, 1);
        const std::size_t k = random.index(corners.size());
        const Real part = random.uniform(0, 1);
        const Vec3 on_edge = (1 - part) * corners[k] + part * corners[(k + 1) % corners.size()];
        check_irradiance(corners, on_edge + random.magnitude(-12, 0) * away, normal);
    }
}

TEST_CASE("a point next to a corner", "[12.14][stability]") {
    Random random(121412);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 normal = random.direction(), away = random.direction(), middle = random.in_cube();
        const Corners corners = star_of_size(random, middle, 1);
        const Vec3 corner = corners[random.index(corners.size())];
        check_irradiance(corners, corner + random.magnitude(-12, 0) * away, normal);
    }
}

TEST_CASE("polygons far away", "[12.14][stability]") {
    Random random(121413);
    for (int i = 0; i < cases(3000); ++i) {
        const Vec3 away = random.direction(), normal = normalize(random.direction() + away);
        const Vec3 middle = random.magnitude(0, 8) * away;
        check_irradiance(star_of_size(random, middle, 1), Vec3(0), normal);
    }
}

TEST_CASE("slivers", "[12.14][stability]") {
    Random random(121414);
    for (int i = 0; i < cases(3000); ++i) {
        const Vec3 normal = random.direction(), away = random.direction();
        const Vec3 middle = random.magnitude(-1, 1) * away, long_way = random.direction();
        const Vec3 aside = random.perpendicular_to(long_way);
        const Vec3 short_way = random.magnitude(-8, 0) * aside;
        check_irradiance(star(random, middle, long_way, short_way), Vec3(0), normal);
    }
}

TEST_CASE("edges along the horizon", "[12.14][stability]") {
    // Upright walls whose lower corners are above or below the horizon by nothing, a little, or more.
    Random random(121415);
    const auto little = [&] {
        const Real way = random.sign(), size = random.magnitude(-18, 0);
        return random.index(3) == 0 ? 0 : way * size;
    };
    for (int i = 0; i < cases(3000); ++i) {
        const Real c = random.magnitude(-2, 2), y = random.uniform(-2, 2), width = random.magnitude(-2, 1);
        const Real first = little(), second = little(), height = random.magnitude(-1, 1);
        const Corners wall{{c, y, first}, {c, y + width, second}, {c, y + width, height}, {c, y, height}};
        check_irradiance(wall, Vec3(0), {0, 0, 1});
    }
}

TEST_CASE("polygons seen nearly from their own plane", "[12.14][stability]") {
    Random random(121416);
    for (int i = 0; i < cases(1000); ++i) {
        const Real height = random.magnitude(-10, 0), x = random.uniform(1.5, 3);
        const Corners corners = star(random, {x, 0, height}, {1, 0, 0}, {0, 1, 0});
        check_irradiance(corners, Vec3(0), {0, 0, 1});
        const Real lean = random.magnitude(-10, -1);
        check_irradiance(corners, Vec3(0), normalize(Vec3(lean, 0, 1)));
        check_irradiance(corners, Vec3(0), normalize(Vec3(-lean, 0, 1)));
    }
}

TEST_CASE("polygons of all sizes", "[12.14][stability]") {
    Random random(121417);
    for (int i = 0; i < cases(1000); ++i) {
        const Real scale = random.magnitude(-50, 50);
        const Vec3 point = scale * random.in_cube(), middle = scale * random.in_cube();
        const Vec3 normal = random.direction();
        check_irradiance(star_of_size(random, middle, scale), point, normal);
    }
}
