// Triangles: barycentric coordinates, the watertight test, smooth normals.
#include "chapters/03_triangles/triangle.hpp"

#include "common/math/error.hpp"
#include "common/math/exact.hpp"
#include "common/math/todo.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {

Vec3 unit_vector(const Vec3& v) {
    const Real greatest = size_of(v);
    if (!(greatest > 0)) return Vec3(0);
    // Brought to size 1 first: the squares of very long and very short vectors leave the range of Real.
    const Vec3 scaled = v / greatest;
    return scaled / glm::length(scaled);
}

Vec3 unit_normal(const Triangle& triangle) {
    // 03.3  The unit normal of the triangle: right for edges of any length (unit_vector is given),
    // and from the corner where rounding matters least. Where the triangle is so flat that the sine there is
    // at most ¼, return the unit vector of exact_normal, which is given and slow.
    return todo("03.3");
}

std::optional<Vec3> barycentric(const Triangle& triangle, const Vec3& point) {
    // 03.3  The weights of the corners a, b and c, with a sign: on the far side of the edge
    // opposite to a corner its weight is negative. A triangle without area has none.
    return todo("03.3");
}

ShearedRay shear(const Ray& ray) {
    // 03.4  The ray with its axes renamed: z is the one along which it goes fastest, x and y are
    // the next two in cyclic order; and its slopes along the new x and y.
    return todo("03.4");
}

Vec3 seen(const ShearedRay& ray, const Vec3& point) {
    // 03.4  The point as the ray sees it: measured from the ray's origin, its coordinates renamed
    // (x is number ray.x), and sheared so that all points of the ray have x = y = 0.
    return todo("03.4");
}

Real edge_function(const Vec2& p, const Vec2& q) {
    // 03.5  p.x·q.y − p.y·q.x, nearly as if without rounding: where the two products nearly cancel,
    // what their rounding took away decides. For (q, p) it must be the exact opposite.
    return todo("03.5");
}

std::optional<Hit> hit_of_seen(const ShearedRay& ray, const Vec3& a, const Vec3& b, const Vec3& c,
                               Interval range) {
    // 03.6  The ray is at x = y = 0, inside the triangle. The edge functions give the weights
    // of the corners, and these give t, in units of the direction's length. Nothing if it is not in the
    // range.
    return todo("03.6");
}

std::optional<Hit> intersect_exactly(const Triangle& triangle, const Ray& ray, Interval range) {
    const std::optional<Crossing> crossing = exact_crossing(triangle.a, triangle.b, triangle.c, ray);
    if (!crossing || !contains(range, crossing->t)) return std::nullopt;
    return Hit{.t = crossing->t, .uv = crossing->weights};
}

std::optional<Hit> intersect(const Triangle& triangle, const ShearedRay& ray, Interval range) {
    // 03.7  The watertight test: the answer of exact arithmetic, and its help only where rounding
    // leaves a doubt. Let `size` be the greatest |x| or |y| of the corners as the ray sees them, plus the
    // greatest |z|. Then x and y are off by less than 8u · size, and p.x·q.y − p.y·q.x of an edge by less
    // than 128u · size². intersect_exactly, which is given, decides what these leave open; and all of it
    // where size is outside of 1e-140 to 1e140, because its square might leave the range of Real. What is a
    // sure hit is found by hit_of_seen (03.6).
    return todo("03.7");
}

std::optional<Hit> intersect(const Triangle& triangle, const Ray& ray, Interval range) {
    return intersect(triangle, shear(ray), range);
}

Surface surface_at(const Triangle& triangle, const Ray&, const Hit& hit) {
    const Real weight_a = 1 - hit.uv.x - hit.uv.y;
    Surface surface;
    // 03.8  Fill in point (by the weights, not by t), normal, shading_normal and uv, all of the
    // flat triangle.
    return todo("03.8");
    // Given; chapter 6 derives it. The point: two roundings in weight_a, one in each product, two in the sum,
    // and two to cover those of this line. What else is wrong has the size of the greatest distance of a
    // corner: 2 because weight_a rounds differences of corners too, 10 because the next ray, which starts
    // here, finds the plane through the corners no better than that, and two for this line.
    const Vec3 size =
        glm::abs(weight_a * triangle.a) + glm::abs(hit.uv.x * triangle.b) + glm::abs(hit.uv.y * triangle.c);
    const Vec3 reach =
        glm::max(glm::max(glm::abs(triangle.a - surface.point), glm::abs(triangle.b - surface.point)),
                 glm::abs(triangle.c - surface.point));
    surface.error = gamma(7) * size + Vec3(gamma(14) * max_component(reach));
    return surface;
}

Vec3 interpolate(const TriangleNormals& normals, const Vec2& uv, const Vec3& flat) {
    // 03.8  The unit normal between those of the corners; `flat` where they cancel.
    return todo("03.8");
}

Vec2 interpolate(const TriangleUvs& uvs, const Vec2& uv) {
    // 03.8  The texture coordinates between those of the corners.
    return todo("03.8");
}

std::optional<Hit> closest_hit(std::span<const Triangle> triangles, const Ray& ray, Interval range) {
    // 03.9  The nearest hit with any of the triangles, of equally near ones the first. What depends
    // on the ray alone is worked out once, not once a triangle.
    return todo("03.9");
}

bool any_hit(std::span<const Triangle> triangles, const Ray& ray, Interval range) {
    // 03.9  Whether any triangle is hit; the first one found is enough.
    return todo("03.9");
}

Real solid_angle(const Triangle& triangle, const Vec3& from) {
    // 03.11  How much of the view the triangle fills, seen from the point: the area of its shadow
    // on the unit sphere around it. Positive where the point sees the triangle's back.
    return todo("03.11");
}

Real winding_number(std::span<const Triangle> triangles, const Vec3& point) {
    // 03.11  How often the triangles go round the point: all that they fill of its view, over the
    // whole view.
    return todo("03.11");
}

}  // namespace rt
