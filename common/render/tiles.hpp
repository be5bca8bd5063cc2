// A picture in tiles, each worked on by one thread.
#pragma once

#include "common/world/query.hpp"

#include <functional>
#include <vector>

namespace rt {

/// Squares of 16 pixels that cover the picture, row by row; smaller at its right and lower border.
std::vector<Tile> tiles_of(const View& view);

inline int width(const Tile& tile) { return tile.x1 - tile.x0; }
inline int height(const Tile& tile) { return tile.y1 - tile.y0; }

/// The tile, wider by `margin` pixels on every side, also beyond the picture.
inline Tile grown(const Tile& tile, int margin) {
    return {tile.x0 - margin, tile.y0 - margin, tile.x1 + margin, tile.y1 + margin};
}

/// Calls work(i) for all i below `count`, on all threads of the current arena, and adds the rays that it
/// traced to `rays`. `done` is told the number of finished calls, from any thread; it may be empty.
void in_parallel(std::size_t count, RayCounts& rays, const std::function<void(std::size_t)>& work,
                 const std::function<void(std::size_t)>& done);

RayCounts operator-(const RayCounts& a, const RayCounts& b);
void operator+=(RayCounts& a, const RayCounts& b);

}  // namespace rt
