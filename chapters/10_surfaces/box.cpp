// The box along the axes: three slabs.
#include "chapters/10_surfaces/box.hpp"

#include "common/math/todo.hpp"

#include <algorithm>

namespace rt {

std::optional<Span> inside(const Box& box, const Ray& ray) {
    // 10.2  Return what the slabs across x, y and z have in common, or nothing. The faces across
    // axis a are 2a and 2a + 1.
    return todo("10.2");
}

std::optional<Hit> intersect(const Box& box, const Ray& ray, Interval range) {
    const std::optional<Span> span = inside(box, ray);
    return span ? first_hit(*span, range) : std::nullopt;
}

Surface surface_at(const Box& box, const Ray& ray, const Hit& hit) {
    Surface surface;
    // 10.2  Set the surface's point, normal and shading_normal. hit.element is the face that was
    // hit. The point must be in that face to the bit, and not beyond its edges.
    return todo("10.2");
    return surface;
}

Bounds bounds_of(const Box& box) { return {box.low, box.high}; }

}  // namespace rt
