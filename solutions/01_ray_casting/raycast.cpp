// The loop of every ray tracer: for each pixel a ray, for each ray a colour.
// Later chapters replace the colour; the loop stays.
#include "chapters/01_ray_casting/raycast.hpp"

#include "chapters/01_ray_casting/camera.hpp"

namespace rt {

Vec3 cast_ray(const World& world, const Ray& ray) {
    // [exercise 01.6] Find the nearest hit in front of the ray's origin with closest_hit(world, ray, range).
    // Where there is none, the colour is background(world, ray.direction). Else ask surface_at for the
    // surface and material_at for its material; the colour is what the surface shows without any light:
    // ambient plus emission.
    const std::optional<Hit> hit = closest_hit(world, ray, {0, infinity});
    if (!hit) return background(world, ray.direction);
    const Surface surface = surface_at(world, ray, *hit);
    const Material material = material_at(world, *hit, surface);
    return material.ambient + material.emission;
    // [/exercise]
}

std::vector<Vec3> render_tile(const World& world, const Tile& tile, RayColor color) {
    // [exercise 01.6] For every pixel of the tile, row by row from the top and each row from the left, ask
    // pixel_ray for the ray through the middle of the pixel, and `color` for the colour along that ray. It is
    // also handed stream_of(world, x, y), the pixel's random numbers, which later chapters will use. tile.x1
    // and tile.y1 are the first column and row that no longer belong to the tile.
    std::vector<Vec3> colors;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            Stream stream = stream_of(world, x, y);
            colors.push_back(color(world, pixel_ray(world.view, x + 0.5, y + 0.5), stream));
        }
    }
    return colors;
    // [/exercise]
}

}  // namespace rt
