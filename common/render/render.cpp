// From a compiled world to a picture, on all cores.
#include "common/render/render.hpp"

#include "chapters/01_ray_casting/camera.hpp"
#include "common/render/scan_convert.hpp"
#include "common/render/shade.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <mutex>

namespace rt {
namespace {

constexpr int tile_size = 16;

std::vector<Tile> tiles_of(const View& view) {
    std::vector<Tile> tiles;
    for (int y = 0; y < view.height; y += tile_size)
        for (int x = 0; x < view.width; x += tile_size)
            tiles.push_back(
                {x, y, std::min(x + tile_size, view.width), std::min(y + tile_size, view.height)});
    return tiles;
}

RayCounts operator-(const RayCounts& a, const RayCounts& b) {
    return {a.camera - b.camera, a.shadow - b.shadow, a.reflection - b.reflection,
            a.refraction - b.refraction};
}
void operator+=(RayCounts& a, const RayCounts& b) {
    a = {a.camera + b.camera, a.shadow + b.shadow, a.reflection + b.reflection, a.refraction + b.refraction};
}

/// The chapter's own loop is used where there is something to hit; a picture of directions is asked for
/// before that loop is written.
std::vector<Vec3> colors_of(const World& world, const Tile& tile, RayColor color) {
    ray_counts().camera += static_cast<std::uint64_t>((tile.x1 - tile.x0) * (tile.y1 - tile.y0));
    if (world.integrator != Integrator::Directions) return render_tile(world, tile, color);
    std::vector<Vec3> colors;
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x)
            colors.push_back(color(world, pixel_ray(world.view, x + 0.5, y + 0.5)));
    return colors;
}

Image trace_tiles(const World& world, const RenderOptions& options, RayCounts& rays) {
    Image image = make_image(world.view.width, world.view.height);
    const std::vector<Tile> tiles = tiles_of(world.view);
    const RayColor color = color_function(world);
    std::mutex mutex;
    std::size_t done = 0;
    tbb::parallel_for(std::size_t(0), tiles.size(), [&](std::size_t i) {
        const Tile& tile = tiles[i];
        const RayCounts before = ray_counts();
        const std::vector<Vec3> colors = colors_of(world, tile, color);
        const RayCounts counted = ray_counts() - before;
        const int width = tile.x1 - tile.x0;
        for (int y = tile.y0; y < tile.y1; ++y)
            std::copy_n(colors.begin() + (y - tile.y0) * width, width, &pixel(image, tile.x0, y));
        const std::lock_guard lock(mutex);
        rays += counted;
        ++done;
        if (options.progress) options.progress(static_cast<Real>(done) / static_cast<Real>(tiles.size()));
    });
    return image;
}

double cpu_clock() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

RenderResult render(const World& world, const RenderOptions& options) {
    RenderResult result;
    const auto start = std::chrono::steady_clock::now();
    const double cpu_start = cpu_clock();
    const int threads = options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
    // The control lets there be more threads than cores, the arena makes use of them.
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    arena.execute([&] {
        result.image = world.integrator == Integrator::Rasterize ? rasterize(world)
                                                                 : trace_tiles(world, options, result.rays);
    });
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    result.cpu_seconds = cpu_clock() - cpu_start;
    return result;
}

}  // namespace rt
