// Step 11.9: cells at places where numbers run out of digits.
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

TEST_CASE("cells far from the origin are right", "[11.9][stability]") {
    Random random(11611);
    for (int i = 0; i < cases(3000); ++i) {
        // Whole numbers and quarters, all exact below 2^51; half of them beside or beyond a power of 2^32.
        const int exponent = static_cast<int>(random.index(51));
        Vec3 corner, part;
        for (int axis = 0; axis < 3; ++axis) {
            corner[axis] = std::floor(std::ldexp(random.uniform(-1, 1), i % 2 == 0 ? exponent : 3));
            if (i % 2 != 0) corner[axis] += 0x1p32 * random.sign() * static_cast<Real>(random.index(1000));
            part[axis] = static_cast<Real>(random.index(4)) / 4;
        }
        std::vector<Real> squares(343);
        test::together(squares.size(), [&](std::size_t cube) {
            const int n = static_cast<int>(cube);
            const Vec3 steps(n % 7 - 3, n / 7 % 7 - 3, n / 49 - 3);
            const Vec3 from_here = cell_point(corner + steps) - part + steps;
            squares[cube] = from_here.x * from_here.x + from_here.y * from_here.y + from_here.z * from_here.z;
        });
        std::sort(squares.begin(), squares.end());
        const CellDistances actual = cell_distances(corner + part);
        INFO("cells at " << corner + part << "; first and second distance");
        CHECK(test::near(actual.first, std::sqrt(squares[0]), 16 * unit_roundoff));
        CHECK(test::near(actual.second, std::sqrt(squares[1]), 16 * unit_roundoff));
    }
}

TEST_CASE("distances to cells are in their range everywhere", "[11.9][stability]") {
    Random random(11612);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 q = random.magnitude(-300, 308) * random.in_cube();
        const CellDistances actual = cell_distances(q);
        INFO("cells at " << q << ": first " << actual.first << ", second " << actual.second);
        CHECK((actual.first >= 0 && actual.first <= actual.second));
        CHECK(actual.second <= std::sqrt(Real(3)) * (1 + 8 * unit_roundoff));
        CHECK(test::is_finite(actual.nearest_cell));
    }
}

TEST_CASE("points of the lattice have the cells of both sides", "[11.9][stability]") {
    Random random(11613);
    for (int i = 0; i < cases(5000); ++i) {
        // Beside a corner, by less than rounding can tell from it.
        Vec3 corner;
        for (int axis = 0; axis < 3; ++axis) corner[axis] = static_cast<Real>(random.index(200)) - 100;
        const Vec3 beside =
            corner - random.magnitude(-18, -16) * glm::abs(corner) * glm::abs(random.in_cube());
        const CellDistances at = cell_distances(corner), near = cell_distances(beside);
        INFO("cells at " << corner << " and less than 1e-14 beside it: first " << at.first << " and "
                         << near.first << ", second " << at.second << " and " << near.second);
        CHECK(std::abs(at.first - near.first) <= 4e-14);
        CHECK(std::abs(at.second - near.second) <= 4e-14);
    }
}
