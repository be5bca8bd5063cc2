// Cells (Worley 1996), with one feature point in each unit cube.
#include "chapters/11_textures/cells.hpp"

#include "common/math/mixed.hpp"
#include "common/math/todo.hpp"

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
    // 11.9  Look into all the cubes that may have one of the two nearest points, and into as few
    // others as you can. Lose no digits where q is far from the origin.
    return todo("11.9");
}

}  // namespace rt
