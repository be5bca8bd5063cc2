// Step 11.9: the distances to the two nearest feature points.
#include "chapters/11_textures/cells.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"
#include "tests/together.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rt;
using test::cases;
using test::Random;

namespace {

constexpr Real bound = 16 * unit_roundoff;  // the contract's

void check_distances(const Vec3& q, Real first, Real second, const Vec3& cell, Real tolerance) {
    const CellDistances actual = cell_distances(q);
    INFO("cells at " << q << "; first and second distance, and the nearest point's cube");
    CHECK(test::near(actual.first, first, tolerance));
    CHECK(test::near(actual.second, second, tolerance));
    CHECK(test::near(actual.nearest_cell, cell, 0));
}

/// The distances to the points of all cubes up to three steps away, in order; `from` is in the cube at
/// `corner`.
std::vector<Real> sorted_distances(const Vec3& corner, const Vec3& from) {
    std::vector<Real> distances(343);
    test::together(distances.size(), [&](std::size_t cube) {
        const int i = static_cast<int>(cube);
        const Vec3 steps(i % 7 - 3, i / 7 % 7 - 3, i / 49 - 3);
        const Vec3 point = cell_point(corner + steps);
        distances[cube] =
            std::hypot(point.x - from.x + steps.x, point.y - from.y + steps.y, point.z - from.z + steps.z);
    });
    std::sort(distances.begin(), distances.end());
    return distances;
}

}  // namespace

TEST_CASE("the two nearest points are as computed by hand", "[11.9]") {
    // Seen from its cube's corner, the point of (2, 0, 0) is at (0.7721, 0.3140, 0.9790) and that of (1, 0,
    // 0) at (0.7386, 0.4211, 0.4935); all others are farther away.
    check_distances({2.5, 0.5, 0.5}, 0.5814, 0.7655, {2, 0, 0}, 1e-4);
    check_distances({1.5, 0.5, 0.5}, 0.2514, 0.7155, {1, 0, 0}, 1e-4);
}

TEST_CASE("the nearest point may be in the next cube", "[11.9]") {
    // The same two points as above, the other way round.
    check_distances({2.25, 0.5, 0.5}, 0.5175, 0.7325, {1, 0, 0}, 1e-4);
}

TEST_CASE("at a feature point the first distance is 0", "[11.9]") {
    for (const Vec3& cell : {Vec3(0, 0, 0), Vec3(3, 1, 2), Vec3(-4, -1, 7)}) {
        const Vec3 q = cell + cell_point(cell);
        const CellDistances actual = cell_distances(q);
        INFO("cells at " << q << ", the point of the cube at " << cell << "; first distance and cube");
        // The sum that is q was rounded, up to the size of 8.
        CHECK(test::near(actual.first, 0, 8 * bound));
        CHECK(test::near(actual.nearest_cell, cell, 0));
    }
}

TEST_CASE("cells go on below 0", "[11.9]") {
    check_distances({-1.5, 2.25, -3.75}, 0.48098748590211871, 0.85732792216336251, {-2, 2, -4}, bound);
}

TEST_CASE("the second nearest point may be two cubes away", "[11.9]") {
    check_distances({-393, 195, 359.25}, 0.66583339612414116, 1.0304575366060589, {-394, 194, 359}, bound);
    check_distances({199, -363.9375, -182}, 0.88753699728552726, 1.1064641531828558, {199, -364, -183},
                    bound);
    check_distances({-101.9375, -138.3125, -456.75}, 0.94424201767757332, 1.1099630054767773,
                    {-102, -139, -457}, bound);
}

TEST_CASE("the nearest point may be two cubes away", "[11.9]") {
    check_distances({34, -237, 415.5}, 1.0488160951259438, 1.0505089807883872, {32, -237, 415}, bound);
    check_distances({298.0625, 457.0625, 52}, 1.0689348880436449, 1.0742246543019303, {297, 457, 50}, bound);
    check_distances({-235.375, -40, -67.875}, 1.0466470724548635, 1.1132020214622456, {-236, -42, -68},
                    bound);
}

TEST_CASE("no point of 7 x 7 x 7 cubes is nearer", "[11.9]") {
    Random random(11601);
    for (int i = 0; i < cases(4000); ++i) {
        const Vec3 q = Real(300) * random.in_cube(), corner = glm::floor(q);
        const std::vector<Real> expected = sorted_distances(corner, q - corner);
        const CellDistances actual = cell_distances(q);
        INFO("cells at " << q << "; first and second distance");
        CHECK(test::near(actual.first, expected[0], bound));
        CHECK(test::near(actual.second, expected[1], bound));
    }
}

TEST_CASE("the nearest cube has the nearest point", "[11.9]") {
    Random random(11602);
    for (int i = 0; i < cases(4000); ++i) {
        const Vec3 q = Real(8) * random.in_cube();
        const CellDistances actual = cell_distances(q);
        INFO("cells at " << q << ", nearest cube " << actual.nearest_cell << "; distance to its point");
        CHECK(test::near(glm::floor(actual.nearest_cell), actual.nearest_cell, 0));
        const Vec3 point = actual.nearest_cell + cell_point(actual.nearest_cell);
        // The sum is of the size of 16 and was rounded.
        CHECK(test::near(glm::distance(point, q), actual.first, 16 * bound));
    }
}

TEST_CASE("the distances change by no more than the way", "[11.9]") {
    Random random(11603);
    for (int i = 0; i < cases(20000); ++i) {
        Vec3 q = Real(50) * random.in_cube();
        // Half of them across the side of a cube.
        const int axis = static_cast<int>(random.index(3));
        if (i % 2 == 0) q[axis] = std::round(q[axis]) - 1e-9;
        const Real way = i % 2 == 0 ? 2e-9 : random.magnitude(-9, -1);
        Vec3 p = q;
        p[axis] += way;
        const CellDistances before = cell_distances(q), after = cell_distances(p);
        INFO("cells at " << q << " and at " << p << ": first " << before.first << " and " << after.first
                         << ", second " << before.second << " and " << after.second);
        // p was rounded, too, by the size of 50.
        const Real most = way + 2 * bound + 64 * unit_roundoff;
        CHECK(std::abs(after.first - before.first) <= most);
        CHECK(std::abs(after.second - before.second) <= most);
    }
}
