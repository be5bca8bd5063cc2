// Planar polygons: hit the plane, then look inside.
#include "chapters/03_triangles/polygon.hpp"

#include "chapters/01_ray_casting/plane.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "common/math/error.hpp"
#include "common/math/exact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace rt {

Plane supporting_plane(std::span<const Vec3> vertices) {
    // [exercise 03.1] The plane through the first vertex, its normal the sum over all edges by Newell's
    // method. Far from the origin it must be as good as near it.
    const Vec3 first = vertices.front();
    Vec3 normal(0);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec3 p = vertices[i] - first;
        const Vec3 q = vertices[(i + 1) % vertices.size()] - first;
        normal += Vec3((p.y - q.y) * (p.z + q.z), (p.z - q.z) * (p.x + q.x), (p.x - q.x) * (p.y + q.y));
    }
    return {first, normal};
    // [/exercise]
}

int dominant_axis(const Vec3& normal) {
    // [exercise 03.2] Which axis the normal is nearest to, by its number; the first of equally near ones.
    const Vec3 size = glm::abs(normal);
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
    // [/exercise]
}

Vec2 project(const Vec3& point, int axis) {
    // [exercise 03.2] The point without its coordinate `axis`; the two next to it, in cyclic order.
    return {point[(axis + 1) % 3], point[(axis + 2) % 3]};
    // [/exercise]
}

bool point_in_polygon(std::span<const Vec2> polygon, const Vec2& point) {
    // [exercise 03.2] Whether the half-line from the point along +x crosses an odd number of edges. An edge
    // owns its lower end and not its upper one; two polygons that share an edge must agree about the side on
    // which the point lies.
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        Vec2 low = polygon[i];
        Vec2 high = polygon[(i + 1) % polygon.size()];
        if (high.y < low.y) std::swap(low, high);
        if (!(low.y <= point.y && point.y < high.y)) continue;
        const Vec2 edge = high - low;
        const Vec2 offset = point - low;
        const bool edge_is_right_of_point = edge.x * offset.y > edge.y * offset.x;
        if (edge_is_right_of_point) inside = !inside;
    }
    return inside;
    // [/exercise]
}

Plane plane_of(std::span<const Vec3> vertices) {
    Plane plane = supporting_plane(vertices);
    // What the rounding of an edge's share can be off by grows with the edge and with its distance.
    Real size = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec3 p = vertices[i] - plane.point;
        const Vec3 q = vertices[(i + 1) % vertices.size()] - plane.point;
        size += length(q - p) * (length(p) + length(q));
    }
    if (!(length(plane.normal) > size / 64 && size > 1e-280)) plane.normal = exact_normal(vertices);
    return plane;
}

std::optional<Hit> hit_plane(const Polygon& polygon, const Ray& ray, Interval range) {
    const Plane plane = plane_of(polygon.vertices);
    if (plane.normal == Vec3(0)) return std::nullopt;
    std::optional<Hit> hit = intersect(plane, ray, {-infinity, infinity});
    if (!hit) return std::nullopt;

    Vec3 low = plane.point, high = plane.point;
    for (const Vec3& vertex : polygon.vertices) {
        low = min(low, vertex);
        high = max(high, vertex);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const Real d = ray.direction[axis];
        if (d == 0) continue;
        const auto [enter, leave] =
            std::minmax({(low[axis] - ray.origin[axis]) / d, (high[axis] - ray.origin[axis]) / d});
        hit->t = std::min(std::max(hit->t, enter), leave);
    }
    if (!contains(range, hit->t)) return std::nullopt;
    return hit;
}

bool is_close(std::span<const Vec2> outline, Real size) {
    if (!(size > 1e-140 && size < 1e140)) return true;
    const Real near = 8 * unit_roundoff * size;
    // Coordinates of at most 2 · size that are off by `near`, two differences and two products of them: all
    // in all less than 160u · size².
    const Real bound = 256 * unit_roundoff * size * size;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2& p = outline[i];
        const Vec2& q = outline[(i + 1) % outline.size()];
        if (std::abs(p.y) <= near) return true;
        if ((p.y < 0) != (q.y < 0) && std::abs(p.x * q.y - p.y * q.x) <= bound) return true;
    }
    return false;
}

std::optional<Hit> intersect(const Polygon& polygon, const Ray& ray, Interval range) {
    // [exercise 03.10] hit_plane (given) says where the ray meets the polygon's plane. Whether it passes
    // inside is not asked of that point, which is rounded, but of the outline that the ray sees. Where
    // is_close (given) says so, exact_passes_through decides; its size is that of step 03.7.
    const std::optional<Hit> hit = hit_plane(polygon, ray, range);
    if (!hit) return std::nullopt;

    const ShearedRay sheared = shear(ray);
    std::vector<Vec2> outline;
    outline.reserve(polygon.vertices.size());
    Vec3 reach(0);
    for (const Vec3& vertex : polygon.vertices) {
        const Vec3 p = seen(sheared, vertex);
        outline.push_back(Vec2(p));
        reach = max(reach, abs(p));
    }
    const bool inside = is_close(outline, std::max(reach.x, reach.y) + reach.z)
                            ? exact_passes_through(polygon.vertices, ray)
                            : point_in_polygon(outline, {0, 0});
    if (!inside) return std::nullopt;
    return hit;
    // [/exercise]
}

Surface surface_at(const Polygon& polygon, const Ray& ray, const Hit& hit) {
    return surface_at(plane_of(polygon.vertices), ray, hit);
}

}  // namespace rt
