// Planar polygons: hit the plane, then look inside.
#include "chapters/03_triangles/polygon.hpp"

#include "chapters/01_ray_casting/plane.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace rt {

Plane supporting_plane(std::span<const Vec3> vertices) {
    // 03.1  The plane through the first vertex. Its normal is the sum over the edges p → q of
    // ((p.y − q.y)(p.z + q.z), (p.z − q.z)(p.x + q.x), (p.x − q.x)(p.y + q.y)); do not forget the edge from
    // the last vertex back to the first. Measure p and q from the first vertex: far from the origin the
    // sums p.x + q.x would swallow the polygon.
    return todo("03.1");
}

int dominant_axis(const Vec3& normal) {
    // 03.2  The index of the greatest of |x|, |y|, |z|; the first of equal ones.
    return todo("03.2");
}

Vec2 project(const Vec3& point, int axis) {
    // 03.2  Drop the coordinate `axis`; keep the next two in cyclic order, x → y → z → x.
    return todo("03.2");
}

bool point_in_polygon(std::span<const Vec2> polygon, const Vec2& point) {
    // 03.2  Count the edges that the half-line from the point along +x crosses; odd is inside.
    // An edge counts where its lower end is at most as high as the point and its upper end is higher; that
    // way each vertex belongs to one end of the half-line only. Compute on which side of the edge the point
    // is from the lower to the upper end, so that the two polygons that share the edge get the same answer.
    return todo("03.2");
}

std::optional<Hit> intersect(const Polygon& polygon, const Ray& ray, Interval range) {
    // 03.2  Hit the supporting plane (chapter 1), then ask whether the point is inside: both, the
    // polygon and the point, projected along the dominant axis of the normal.
    return todo("03.2");
}

Surface surface_at(const Polygon& polygon, const Ray& ray, const Hit& hit) {
    return surface_at(supporting_plane(polygon.vertices), ray, hit);
}

std::optional<Hit> closest_hit(std::span<const Polygon> polygons, const Ray& ray, Interval range) {
    std::optional<Hit> nearest;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        std::optional<Hit> hit = intersect(polygons[i], ray, range);
        if (!hit || (nearest && hit->t == nearest->t)) continue;
        hit->primitive = static_cast<std::uint32_t>(i);
        nearest = hit;
        range.max = hit->t;
    }
    return nearest;
}

bool any_hit(std::span<const Polygon> polygons, const Ray& ray, Interval range) {
    return std::any_of(polygons.begin(), polygons.end(),
                       [&](const Polygon& polygon) { return intersect(polygon, ray, range).has_value(); });
}

}  // namespace rt
