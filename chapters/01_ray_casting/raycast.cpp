// The loop of every ray tracer: for each pixel a ray, for each ray a colour.
// Later chapters replace the colour; the loop stays.
#include "chapters/01_ray_casting/raycast.hpp"

#include "chapters/01_ray_casting/camera.hpp"

#include "common/math/todo.hpp"

namespace rt {

Vec3 cast_ray(const World& world, const Ray& ray) {
    // 01.6  Return the colour of the nearest thing in front of the ray's origin: what its material
    // shows without any light, ambient plus emission. Where there is nothing, return the background's.
    return todo("01.6");
}

std::vector<Vec3> render_tile(const World& world, const Tile& tile, RayColor color) {
    // 01.6  Return what `color` says of the ray through the middle of each pixel of the tile, row
    // by row from the top and each row from the left. `color` is also handed the pixel's random numbers,
    // stream_of(world, x, y), which later chapters will use.
    return todo("01.6");
}

}  // namespace rt
