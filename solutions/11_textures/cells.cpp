// Cells (Worley 1996), with one feature point in each unit cube.
#include "chapters/11_textures/cells.hpp"

#include "common/math/mixed.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace rt {

Vec3 cell_point(const Vec3& cell) {
    std::uint64_t bits = 0;
    for (int axis = 0; axis < 3; ++axis)
        bits = mixed(bits, static_cast<std::uint64_t>(cell[axis] - 0x1p32 * std::floor(cell[axis] / 0x1p32)));
    const std::uint64_t x = stirred(bits + 1), y = stirred(bits + 2), z = stirred(bits + 3);
    return {real_of(x), real_of(y), real_of(z)};
}

CellDistances cell_distances(const Vec3& q) {
    // [exercise 11.9] Look into all the cubes that may have one of the two nearest points, and into as few
    // others as you can. Lose no digits where q is far from the origin.
    const std::array<Real, 5> steps{0, -1, 1, -2, 2};
    const Vec3 own = glm::floor(q), place = q - own;
    // Two points are no farther than √3, and cubes at three steps at least 2. Those near q come first.
    Real first = infinity, second = infinity;  // squares
    Vec3 nearest(0);
    for (const Real x : steps)
        for (const Real y : steps)
            for (const Real z : steps) {
                const Vec3 step(x, y, z);
                const Vec3 gap = glm::max(Vec3(0), glm::max(step - place, place - step - Real(1)));
                if (dot(gap, gap) >= second) continue;
                const Vec3 way = step + cell_point(own + step) - place;
                const Real square = dot(way, way);
                if (square < first)
                    second = first, first = square, nearest = step;
                else if (square < second)
                    second = square;
            }
    return {std::sqrt(first), std::sqrt(second), own + nearest};
    // [/exercise]
}

}  // namespace rt
