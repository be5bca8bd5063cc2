// The box along the axes: three slabs.
#include "chapters/10_surfaces/box.hpp"

#include <algorithm>

namespace rt {

std::optional<Span> inside(const Box& box, const Ray& ray) {
    // [exercise 10.2] Return what the slabs across x, y and z have in common, or nothing. The faces across
    // axis a are 2a and 2a + 1.
    std::optional<Span> span = Span{};
    for (std::uint32_t a = 0; a < 3 && span; ++a) {
        const int i = static_cast<int>(a);
        std::optional<Span> across = slab(ray.origin[i], ray.direction[i], box.low[i], box.high[i]);
        if (!across) return std::nullopt;
        across->enter_face += 2 * a;
        across->leave_face += 2 * a;
        span = common_part(*span, *across);
    }
    return span;
    // [/exercise]
}

std::optional<Hit> intersect(const Box& box, const Ray& ray, Interval range) {
    const std::optional<Span> span = inside(box, ray);
    return span ? first_hit(*span, range) : std::nullopt;
}

Surface surface_at(const Box& box, const Ray& ray, const Hit& hit) {
    Surface surface;
    // [exercise 10.2] Set the surface's point, normal and shading_normal. hit.element is the face that was
    // hit. The point must be in that face to the bit, and not beyond its edges.
    const bool is_high = hit.element % 2 == 1;
    const int axis = static_cast<int>(hit.element / 2);
    surface.point = glm::clamp(point_at(ray, hit.t), box.low, box.high);
    surface.point[axis] = is_high ? box.high[axis] : box.low[axis];
    surface.normal = Vec3(0);
    surface.normal[axis] = is_high ? 1 : -1;
    surface.shading_normal = surface.normal;
    // [/exercise]
    return surface;
}

Bounds bounds_of(const Box& box) { return {box.low, box.high}; }

}  // namespace rt
