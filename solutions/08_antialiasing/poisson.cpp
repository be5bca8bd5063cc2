// Samples that keep their distance: Poisson disk patterns by dart throwing.
#include "chapters/08_antialiasing/samples.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// The darts that stick in the torus, in side × side cells that are wide enough for this: what is near a
/// point lies in its cell or in one of the eight around it.
struct DartBoard {
    int side = 1;
    std::vector<std::vector<Vec2>> cells;
};

[[maybe_unused]] DartBoard board_for(Real distance) {
    const int side = std::max(1, static_cast<int>(1 / distance));
    return {side, std::vector<std::vector<Vec2>>(static_cast<std::size_t>(side * side))};
}

/// Index of the cell (x, y), where −1 and `side` are the cells across the edge.
[[maybe_unused]] std::size_t cell_index(const DartBoard& board, int x, int y) {
    const int column = (x + board.side) % board.side, row = (y + board.side) % board.side;
    return static_cast<std::size_t>(row * board.side + column);
}

[[maybe_unused]] void insert(DartBoard& board, const Vec2& dart) {
    const int x = static_cast<int>(dart.x * board.side), y = static_cast<int>(dart.y * board.side);
    board.cells[cell_index(board, x, y)].push_back(dart);
}

/// Whether one of the darts is nearer to `point` than `distance`, which is not greater than in board_for.
[[maybe_unused]] bool has_near(const DartBoard& board, const Vec2& point, Real distance) {
    const int x = static_cast<int>(point.x * board.side), y = static_cast<int>(point.y * board.side);
    for (int row = y - 1; row <= y + 1; ++row) {
        for (int column = x - 1; column <= x + 1; ++column) {
            for (const Vec2& other : board.cells[cell_index(board, column, row)]) {
                if (torus_distance(point, other) < distance) return true;
            }
        }
    }
    return false;
}

}  // namespace

Real torus_distance(const Vec2& a, const Vec2& b) {
    const Vec2 d = glm::abs(a - b);
    return glm::length(glm::min(d, Real(1) - d));
}

PoissonDisk poisson_disk_samples(int count, Random random) {
    // [exercise 08.4] Throw darts, by random_point(random), until `count` of them stick. A dart sticks if no
    // sample is nearer than the distance, by torus_distance. The contract says with what distance to begin,
    // and when it shrinks. A single sample may lie anywhere, at the distance ∞. With `board_for`, `has_near`
    // and `insert` above, a dart need not be compared with all samples.
    const Real weight = Real(1) / count;
    if (count == 1) return {{{random_point(random), weight}}, infinity};
    PoissonDisk disk;
    disk.samples.reserve(static_cast<std::size_t>(count));
    disk.distance = 0.7 * std::sqrt(2 / (std::numbers::sqrt3 * count));
    DartBoard board = board_for(disk.distance);
    int refused = 0;
    while (disk.samples.size() < static_cast<std::size_t>(count)) {
        const Vec2 dart = random_point(random);
        if (!has_near(board, dart, disk.distance)) {
            disk.samples.push_back({dart, weight});
            insert(board, dart);
            refused = 0;
        } else if (++refused == 32 * count) {
            disk.distance *= 0.95;
            refused = 0;
        }
    }
    return disk;
    // [/exercise]
}

}  // namespace rt
