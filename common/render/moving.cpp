// Shapes that move while the shutter is open: asked where they are at the ray's time.
#include "common/render/moving.hpp"

#include "common/math/error.hpp"
#include "common/render/groups.hpp"

namespace rt {

std::optional<Hit> intersect(const Moving& moving, const Ray& ray, Interval range) {
    const Ray seen = seen_while_moving(ray, moving.motion);
    return std::visit([&](const auto& shape) { return intersect(shape, seen, range); }, moving.shape);
}

Surface surface_at(const Moving& moving, const Ray& ray, const Hit& hit, bool uvs) {
    const Ray seen = seen_while_moving(ray, moving.motion);
    Surface surface = std::visit(
        [&]<class Shape>(const Shape& shape) {
            Surface own = surface_at(shape, seen, hit);
            // A triangle that shows coordinates moves as a mesh.
            if constexpr (has_uv<Shape> && !std::is_same_v<Shape, Triangle>)
                if (uvs) set_uv(shape, hit.element, own);
            return own;
        },
        moving.shape);
    const Vec3 way = ray.time * moving.motion;
    surface.point += way;
    // The way is rounded where the ray is moved and where the surface is moved back, and so are the sums.
    surface.error += gamma(4) * (glm::abs(surface.point) + Real(2) * glm::abs(way));
    return surface;
}

Surface surface_at(const Moving& moving, const Ray& ray, const Hit& hit) {
    return surface_at(moving, ray, hit, false);
}

Bounds bounds_of(const Moving& moving) {
    return bounds_while_moving(std::visit([](const auto& shape) { return bounds_of(shape); }, moving.shape),
                               moving.motion);
}

}  // namespace rt
