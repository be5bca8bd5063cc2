// A picture in tiles, each worked on by one thread.
#include "common/render/tiles.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>

namespace rt {
namespace {

constexpr int tile_size = 16;

}  // namespace

std::vector<Tile> tiles_of(const View& view) {
    std::vector<Tile> tiles;
    for (int y = 0; y < view.height; y += tile_size)
        for (int x = 0; x < view.width; x += tile_size)
            tiles.push_back(
                {x, y, std::min(x + tile_size, view.width), std::min(y + tile_size, view.height)});
    return tiles;
}

void in_parallel(std::size_t count, RayCounts& rays, const std::function<void(std::size_t)>& work,
                 const std::function<void(std::size_t)>& done) {
    std::mutex mutex;
    std::size_t finished = 0;
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
        const RayCounts before = ray_counts();
        work(i);
        const RayCounts counted = ray_counts() - before;
        const std::lock_guard lock(mutex);
        rays += counted;
        ++finished;
        if (done) done(finished);
    });
}

RayCounts operator-(const RayCounts& a, const RayCounts& b) {
    return {a.camera - b.camera, a.shadow - b.shadow, a.reflection - b.reflection,
            a.refraction - b.refraction, a.random_numbers - b.random_numbers};
}

void operator+=(RayCounts& a, const RayCounts& b) {
    a = {a.camera + b.camera, a.shadow + b.shadow, a.reflection + b.reflection, a.refraction + b.refraction,
         a.random_numbers + b.random_numbers};
}

}  // namespace rt
