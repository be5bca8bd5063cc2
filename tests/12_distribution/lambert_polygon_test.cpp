// Step 12.14: the light of an even polygon, by Lambert's formula.
#include "chapters/12_distribution/lambert_polygon.hpp"
#include "common/math/error.hpp"
#include "tests/12_distribution/polygon_oracle.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rt;
using test::cases;
using test::Long;
using test::near;
using test::Random;

namespace {

using Corners = std::vector<Vec3>;

const Vec3 here{0}, up{0, 0, 1};

/// A square of side 2, one above the ground; counterclockwise as seen from above, so it shines down.
const Corners ceiling{{1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}, {1, -1, 1}};

/// A square of side 2 in the plane x = 1, half of it below the ground.
const Corners wall{{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}};

Corners turned_round(Corners corners) {
    std::reverse(corners.begin(), corners.end());
    return corners;
}

/// Whether both are the same ring of corners, up to `bound`: whichever is the first, and if some are there
/// twice.
bool is_same_ring(const Corners& actual, const Corners& expected, Real bound) {
    Corners ring;
    for (const Vec3& corner : actual)
        if (ring.empty() || !near(corner, ring.back(), bound)) ring.push_back(corner);
    while (ring.size() > 1 && near(ring.front(), ring.back(), bound)) ring.pop_back();
    if (ring.size() != expected.size()) return false;
    for (std::size_t shift = 0; shift < ring.size(); ++shift) {
        bool is_same = true;
        for (std::size_t k = 0; k < ring.size(); ++k)
            is_same = is_same && near(ring[(k + shift) % ring.size()], expected[k], bound);
        if (is_same) return true;
    }
    return ring.empty();
}

test::Told same_ring(const Corners& actual, const Corners& expected, Real bound) {
    return test::or_say(is_same_ring(actual, expected, bound),
                        test::show(actual) + ", expected " + test::show(expected));
}

/// Irradiance of a rectangle from (0, 0) to (x, y) at the height h above the point, in closed form.
Long below_corner(Long x, Long y, Long h) {
    const Long far_x = std::hypot(x, h), far_y = std::hypot(y, h);
    return (x / far_x * std::atan(y / far_x) + y / far_y * std::atan(x / far_y)) / 2;
}

/// Of a wall at the distance c, up to the height z, and from 0 to y along the wall; less the same for z = 0.
Long before_wall(Long y, Long z, Long c) {
    const Long far_z = std::hypot(z, c);
    return (std::atan(y / c) - c / far_z * std::atan(y / far_z)) / 2;
}

Real wall_and_ceiling_angle() { return std::atan(std::sqrt(0.5)); }

}  // namespace

TEST_CASE("Lambert's vector of an eighth of the sphere", "[12.14]") {
    // Three edges of 90 degrees; the planes' normals are z, x and y.
    const Corners eighth{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    INFO("corners " << eighth << " seen from " << here);
    CHECK(near(lambert_vector(eighth, here), Vec3(pi / 4), gamma(64)));
    INFO("then the other way round");
    CHECK(near(lambert_vector(turned_round(eighth), here), Vec3(-pi / 4), gamma(64)));
}

TEST_CASE("a square lamp above the ground", "[12.14]") {
    // Each edge is seen under the angle acos(1/3), and its plane leans by 45 degrees: ½·4·acos(1/3)/√2.
    const Real expected = std::sqrt(2.0) * std::acos(1 / 3.0);
    INFO("corners " << ceiling << " seen from " << here);
    CHECK(near(lambert_vector(ceiling, here), Vec3(0, 0, expected), gamma(128)));
    CHECK(near(polygon_irradiance(ceiling, here, up), expected, gamma(128)));
    INFO("then the other way round");
    CHECK(near(polygon_irradiance(turned_round(ceiling), here, up), expected, gamma(128)));
    INFO("then with the ground turned away: the lamp is below the horizon");
    CHECK(near(polygon_irradiance(ceiling, here, -up), 0, gamma(128)));
}

TEST_CASE("the part of a wall that is above the horizon", "[12.14]") {
    const Corners upper{{1, 1, 0}, {1, 1, 1}, {1, -1, 1}, {1, -1, 0}};
    INFO("corners " << wall << " seen from " << here << " with the normal " << up);
    const Corners seen = above_horizon(wall, here, up);
    INFO("above the horizon: " << seen);
    CHECK(same_ring(seen, upper, gamma(64)));
    INFO("then seen from (0, 0, 0.5), which is half a unit higher");
    const Corners less = above_horizon(wall, {0, 0, 0.5}, up);
    INFO("above the horizon: " << less);
    CHECK(same_ring(less, {{1, 1, 0.5}, {1, 1, 1}, {1, -1, 1}, {1, -1, 0.5}}, gamma(64)));
}

TEST_CASE("where the horizon crosses an edge", "[12.14]") {
    // One end is 1 above, the other 3 below: a quarter of the way.
    const Corners triangle{{0, 0, 1}, {4, 0, -3}, {0, 8, -3}};
    INFO("corners " << triangle << " seen from " << here << " with the normal " << up);
    const Corners seen = above_horizon(triangle, here, up);
    INFO("above the horizon: " << seen);
    CHECK(same_ring(seen, {{0, 0, 1}, {1, 0, 0}, {0, 2, 0}}, gamma(64)));
}

TEST_CASE("nothing or all of it above the horizon", "[12.14]") {
    const Corners all = above_horizon(ceiling, here, up);
    INFO("of " << ceiling << " seen from " << here << " there is above the horizon: " << all);
    CHECK(same_ring(all, ceiling, 0));
    // On the horizon is above it.
    const Corners eighth{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Corners touching = above_horizon(eighth, here, up);
    INFO("of " << eighth << " there is: " << touching);
    CHECK(same_ring(touching, eighth, 0));
    INFO("of what is below the horizon nothing is to be seen");
    CHECK(near(polygon_irradiance(ceiling, {0, 0, 2}, up), 0, gamma(64)));
}

TEST_CASE("a wall is cut by the horizon", "[12.14]") {
    // Without the cut the lower half would take away what the upper half gives.
    const Real expected = pi / 4 - wall_and_ceiling_angle() / std::sqrt(2.0);
    INFO("corners " << wall << " seen from " << here << " with the normal " << up);
    CHECK(near(polygon_irradiance(wall, here, up), expected, gamma(128)));
    CHECK(near(polygon_irradiance(turned_round(wall), here, up), expected, gamma(128)));
    INFO("then with the normal down: the lower half is the same");
    CHECK(near(polygon_irradiance(wall, here, -up), expected, gamma(128)));
}

TEST_CASE("a wall that fills half of the sky", "[12.14]") {
    // The dome in front of it is half a sphere, cos θ of which is π/2. What is missing is below 1/1e9 of it.
    const Real far = 1e10;
    const Corners endless{{1, -far, -far}, {1, far, -far}, {1, far, far}, {1, -far, far}};
    INFO("corners " << endless << " seen from " << here);
    CHECK(near(polygon_irradiance(endless, here, up), pi / 2, 1e-9));
    CHECK(near(polygon_irradiance(endless, here, {1, 0, 0}), pi, 1e-9));
}

TEST_CASE("a small lamp far away", "[12.14]") {
    // cos²θ/d², as of a point: 2, 3 and 6 million away, that is 7 million; cos θ is 6/7. The edges' terms are
    // 1e7 times greater than their sum, and what they may be wrong by is gamma(20)·Σ θ·2.
    const Vec3 middle{2e6, 3e6, 6e6};
    const Corners lamp{middle + Vec3(0.5, 0.5, 0), middle + Vec3(-0.5, 0.5, 0), middle + Vec3(-0.5, -0.5, 0),
                       middle + Vec3(0.5, -0.5, 0)};
    const Real expected = 36 / (49.0 * 49e12);
    INFO("corners " << lamp << " seen from " << here);
    CHECK(near(polygon_irradiance(lamp, here, up), expected, gamma(20) * 8 / 7e6));
}

TEST_CASE("a point in the line of an edge", "[12.14]") {
    // From the first corner only the opposite edge counts: 90 degrees, in the plane with the normal −y.
    const Corners corner{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    INFO("corners " << corner << " seen from the first");
    CHECK(near(lambert_vector(corner, here), Vec3(0, -pi / 4, 0), gamma(64)));
    const Corners in_line{{1, 0, 0}, {3, 0, 0}, {0, 0, 1}}, on_edge{{-1, 0, 0}, {3, 0, 0}, {0, 0, 1}};
    INFO("then seen from the line of the first edge of " << in_line);
    CHECK(near(lambert_vector(in_line, here), Vec3(0), gamma(64)));
    INFO("then seen from the first edge of " << on_edge << ": only the others count");
    CHECK(near(lambert_vector(on_edge, here), Vec3(0, -pi / 2, 0), gamma(64)));
}

TEST_CASE("equal corners, and fewer than three", "[12.14]") {
    Corners twice = ceiling;
    twice.insert(twice.begin() + 2, ceiling[1]);
    twice.push_back(ceiling[3]);
    const Real expected = 2 * std::sqrt(2.0) * wall_and_ceiling_angle();
    INFO("corners " << twice);
    CHECK(near(lambert_vector(twice, here), Vec3(0, 0, expected), gamma(128)));
    for (const std::size_t count : {0u, 1u, 2u}) {
        const Corners few(ceiling.begin(), ceiling.begin() + static_cast<std::ptrdiff_t>(count));
        INFO("then only the corners " << few);
        CHECK(near(lambert_vector(few, here), Vec3(0), gamma(64)));
        CHECK(near(polygon_irradiance(few, here, up), 0, gamma(64)));
    }
}

TEST_CASE("an L is a square without a corner", "[12.14]") {
    const Corners l{{2, 0, 1}, {2, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}, {0, 0, 1}};
    const Long corner = below_corner(2, 2, 1) - 2 * below_corner(1, 2, 1) + below_corner(1, 1, 1);
    INFO("corners " << l << " seen from (0, 0, 0), which is below one of them");
    CHECK(
        near(polygon_irradiance(l, here, up), static_cast<Real>(below_corner(2, 2, 1) - corner), gamma(128)));
}

TEST_CASE("a U of which two towers are above the horizon", "[12.14]") {
    const Corners u{{1, -3, -1},  {1, 3, -1},    {1, 3, 2},  {1, 1, 2},
                    {1, 1, -0.5}, {1, -1, -0.5}, {1, -1, 2}, {1, -3, 2}};
    const Long tower = before_wall(3, 2, 1) - before_wall(1, 2, 1);
    INFO("corners " << u << " seen from " << here);
    CHECK(near(polygon_irradiance(u, here, up), static_cast<Real>(2 * tower), gamma(256)));
}

TEST_CASE("rectangles above the ground, in closed form", "[12.14]") {
    Random random(121401);
    for (int i = 0; i < cases(2000); ++i) {
        const Real x = random.uniform(-3, 3), y = random.uniform(-3, 3), h = random.magnitude(-1, 1);
        const Real right = x + random.magnitude(-1, 1), back = y + random.magnitude(-1, 1);
        const Corners lamp{{x, y, h}, {right, y, h}, {right, back, h}, {x, back, h}};
        INFO("corners " << lamp << " seen from " << here << " with the normal " << up);
        const Long expected = below_corner(right, back, h) - below_corner(x, back, h) -
                              below_corner(right, y, h) + below_corner(x, y, h);
        const Real bound = test::exact_irradiance(lamp, here, up).bound;
        CHECK(near(polygon_irradiance(lamp, here, up), static_cast<Real>(expected), bound));
        CHECK(near(lambert_vector(lamp, here).z, static_cast<Real>(expected), bound));
    }
}

TEST_CASE("walls through the horizon, in closed form", "[12.14]") {
    Random random(121402);
    for (int i = 0; i < cases(2000); ++i) {
        const Real c = random.magnitude(-1, 1), y = random.uniform(-3, 3), z = random.uniform(-2, 1);
        const Real left = y + random.magnitude(-1, 1), top = z + random.magnitude(-1, 1);
        const Corners lamp{{c, y, z}, {c, left, z}, {c, left, top}, {c, y, top}};
        INFO("corners " << lamp << " seen from " << here << " with the normal " << up);
        const Long low = std::max(z, 0.0), high = std::max(top, 0.0);
        const Long expected = before_wall(left, high, c) - before_wall(y, high, c) -
                              before_wall(left, low, c) + before_wall(y, low, c);
        const Real bound = test::exact_irradiance(lamp, here, up).bound;
        CHECK(near(polygon_irradiance(lamp, here, up), static_cast<Real>(expected), bound));
    }
}

TEST_CASE("new corners are on the horizon, and the others stay", "[12.14]") {
    Random random(121403);
    int cut = 0;
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 point = random.in_cube(), normal = random.direction();
        const Corners triangle{random.in_cube(), random.in_cube(), random.in_cube()};
        INFO("corners " << triangle << " seen from " << point << " with the normal " << normal);
        const Corners seen = above_horizon(triangle, point, normal);
        INFO("above the horizon: " << seen);
        std::size_t kept = 0;
        for (const Vec3& corner : seen) {
            const bool is_old = std::find(triangle.begin(), triangle.end(), corner) != triangle.end();
            CHECK((is_old || near(dot(corner - point, normal), 0, gamma(64))));
        }
        for (const Vec3& corner : triangle)
            if (dot(corner - point, normal) > gamma(64)) {
                ++kept;
                CHECK(std::find(seen.begin(), seen.end(), corner) != seen.end());
            }
        if (kept == 1 || kept == 2) {
            ++cut;
            CHECK(seen.size() >= kept + 2);
        }
        if (kept == 0) CHECK(near(length(lambert_vector(seen, point)), 0, 1e-9));
    }
    CHECK(cut >= test::demanded(cases(800), cases(200)));
}
