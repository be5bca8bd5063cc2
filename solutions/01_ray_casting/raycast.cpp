// The loop of every ray tracer: for each pixel a ray, for each ray a colour.
// Later chapters replace the colour; the loop stays.
#include "chapters/01_ray_casting/raycast.hpp"

#include "chapters/01_ray_casting/camera.hpp"

namespace rt {

Vec3 cast_ray(const World& world, const Ray& ray) {
    // [exercise 01.6] Return the colour of the nearest thing in front of the ray's origin: what its material
    // shows without any light, ambient plus emission. Where there is nothing, return the background's.
    const std::optional<Hit> hit = closest_hit(world, ray, {0, infinity});
    if (!hit) return background(world, ray.direction);
    const Surface surface = surface_at(world, ray, *hit);
    const Material material = material_at(world, *hit, surface);
    return material.ambient + material.emission;
    // [/exercise]
}

std::vector<Vec3> render_tile(const World& world, const Tile& tile, RayColor color) {
    // [exercise 01.6] Return what `color` says of the ray through the middle of each pixel of the tile, row
    // by row from the top and each row from the left. `color` is also handed the pixel's random numbers,
    // stream_of(world, x, y), which later chapters will use.
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
