// From a compiled world to a picture, on all cores.
#include "common/render/render.hpp"

#include "common/math/stopwatch.hpp"
#include "common/render/integrators.hpp"
#include "common/render/sampled.hpp"
#include "common/render/scan_convert.hpp"
#include "common/render/tiles.hpp"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <ctime>

namespace rt {
namespace {

/// The chapter's own loop is used where rays meet things; a picture that shows none, as of directions, is
/// asked for before that loop is written.
std::vector<Vec3> colors_of(const World& world, const Tile& tile, RayColor color) {
    ray_counts().camera += static_cast<std::uint64_t>(width(tile) * height(tile));
    if (row_of(world.integrator).objects) return render_tile(world, tile, color);
    std::vector<Vec3> colors;
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) {
            Stream stream = stream_of(world, x, y);
            colors.push_back(color(world, camera_ray(world, {x + 0.5, y + 0.5}, stream), stream));
        }
    return colors;
}

/// One ray through the centre of each pixel.
Image trace_tiles(const World& world, const RenderOptions& options, RayCounts& rays) {
    Image image = make_image(world.view.width, world.view.height);
    const std::vector<Tile> tiles = tiles_of(world.view);
    const RayColor color = options.color ? options.color : color_function(world);
    in_parallel(
        tiles.size(), rays,
        [&](std::size_t i) {
            const Tile& tile = tiles[i];
            const std::vector<Vec3> colors = colors_of(world, tile, color);
            for (int y = tile.y0; y < tile.y1; ++y)
                std::copy_n(colors.begin() + (y - tile.y0) * width(tile), width(tile),
                            &pixel(image, tile.x0, y));
        },
        [&](std::size_t done) {
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
    const Stopwatch watch;
    const double cpu_start = cpu_clock();
    const int threads = options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
    // The control lets there be more threads than cores, the arena makes use of them.
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    arena.execute([&] {
        if (world.visibility == Visibility::Rasterize)
            result.image = rasterize(world);
        else if (world.needs.samples || options.seconds || options.error)
            render_sampled(world, options, result);
        else
            result.image = trace_tiles(world, options, result.rays);
    });
    result.seconds = watch.seconds();
    result.cpu_seconds = cpu_clock() - cpu_start;
    return result;
}

}  // namespace rt
