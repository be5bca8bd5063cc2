// The loop of every ray tracer: for each pixel a ray, for each ray a colour.
// Later chapters replace the colour; the loop stays.
#include "chapters/01_ray_casting/raycast.hpp"

#include "chapters/01_ray_casting/camera.hpp"

#include "common/math/todo.hpp"

namespace rt {

Vec3 cast_ray(const World& world, const Ray& ray) {
    // 01.6  Find the nearest hit in front of the ray's origin with closest_hit(world, ray, range).
    // Where there is none, the colour is background(world, ray.direction). Else ask surface_at for the
    // surface and material_at for its material; the colour is what the surface shows without any light:
    // ambient plus emission.
    return todo("01.6");
}

std::vector<Vec3> render_tile(const World& world, const Tile& tile, RayColor color) {
    // 01.6  For every pixel of the tile, row by row from the top and each row from the left, ask
    // pixel_ray for the ray through the middle of the pixel, and `color` for the colour along that ray. It is
    // also handed stream_of(world, x, y), the pixel's random numbers, which later chapters will use. tile.x1
    // and tile.y1 are the first column and row that no longer belong to the tile.
    return todo("01.6");
}

}  // namespace rt
