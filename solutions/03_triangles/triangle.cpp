// Triangles: barycentric coordinates, the watertight test, smooth normals.
#include "chapters/03_triangles/triangle.hpp"

#include "common/math/error.hpp"
#include "common/math/exact.hpp"

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
    // [exercise 03.3] The unit normal of the triangle: right for edges of any length (unit_vector is given),
    // and from the corner where rounding matters least. Where the triangle is so flat that the sine there is
    // at most ¼, return the unit vector of exact_normal, which is given and slow.
    const Vec3 ab = triangle.b - triangle.a;
    const Vec3 bc = triangle.c - triangle.b;
    const Vec3 ca = triangle.a - triangle.c;
    const Vec3 lengths(length(ab), length(bc), length(ca));
    Vec3 product;
    if (lengths.x >= lengths.y && lengths.x >= lengths.z)
        product = cross(unit_vector(bc), unit_vector(ca));
    else if (lengths.y >= lengths.z)
        product = cross(unit_vector(ca), unit_vector(ab));
    else
        product = cross(unit_vector(ab), unit_vector(bc));
    const Real sine = length(product);
    if (sine > 0.25) return product / sine;
    return unit_vector(exact_normal(std::array{triangle.a, triangle.b, triangle.c}));
    // [/exercise]
}

std::optional<Vec3> barycentric(const Triangle& triangle, const Vec3& point) {
    // [exercise 03.3] The weights of the corners a, b and c, with a sign: on the far side of the edge
    // opposite to a corner its weight is negative. A triangle without area has none.
    const Vec3 normal = unit_normal(triangle);
    const Vec3 to_b = triangle.b - triangle.a;
    const Vec3 to_c = triangle.c - triangle.a;
    const Vec3 to_point = point - triangle.a;

    const Real area = glm::dot(glm::cross(to_b, to_c), normal);
    if (area == 0) return std::nullopt;
    const Real b = glm::dot(glm::cross(to_point, to_c), normal) / area;
    const Real c = glm::dot(glm::cross(to_b, to_point), normal) / area;
    return Vec3(1 - b - c, b, c);
    // [/exercise]
}

ShearedRay shear(const Ray& ray) {
    // [exercise 03.4] The ray with its axes renamed: z is the one along which it goes fastest, x and y are
    // the next two in cyclic order; and its slopes along the new x and y.
    const Vec3& d = ray.direction;
    const Vec3 size = abs(d);
    const int z = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int x = (z + 1) % 3;
    const int y = (z + 2) % 3;
    return {ray, x, y, z, {d[x] / d[z], d[y] / d[z]}};
    // [/exercise]
}

Vec3 seen(const ShearedRay& ray, const Vec3& point) {
    // [exercise 03.4] The point as the ray sees it: measured from the ray's origin, its coordinates renamed
    // (x is number ray.x), and sheared so that all points of the ray have x = y = 0.
    const Real* p = glm::value_ptr(point);  // faster than point[ray.x] where the compiler can't know ray.x
    const Real* o = glm::value_ptr(ray.ray.origin);
    const Real z = p[ray.z] - o[ray.z];
    return {p[ray.x] - o[ray.x] - ray.slope.x * z, p[ray.y] - o[ray.y] - ray.slope.y * z, z};
    // [/exercise]
}

Real edge_function(const Vec2& p, const Vec2& q) {
    // [exercise 03.5] p.x·q.y − p.y·q.x, nearly as if without rounding: where the two products nearly cancel,
    // what their rounding took away decides. For (q, p) it must be the exact opposite.
    const Real xy = p.x * q.y;
    const Real yx = p.y * q.x;
    return (xy - yx) + (std::fma(p.x, q.y, -xy) - std::fma(p.y, q.x, -yx));
    // [/exercise]
}

std::optional<Hit> hit_of_seen(const ShearedRay& ray, const Vec3& a, const Vec3& b, const Vec3& c,
                               Interval range) {
    // [exercise 03.6] The ray is at x = y = 0, inside the triangle. The edge functions give the weights
    // of the corners, and these give t, in units of the direction's length. Nothing if it is not in the
    // range.
    const Real e_a = edge_function(Vec2(c), Vec2(b));
    const Real e_b = edge_function(Vec2(a), Vec2(c));
    const Real e_c = edge_function(Vec2(b), Vec2(a));
    const Real sum = e_a + e_b + e_c;
    const Real t = (e_a * a.z + e_b * b.z + e_c * c.z) / sum / ray.ray.direction[ray.z];
    if (!contains(range, t)) return std::nullopt;
    return Hit{.t = t, .uv = {e_b / sum, e_c / sum}};
    // [/exercise]
}

std::optional<Hit> intersect_exactly(const Triangle& triangle, const Ray& ray, Interval range) {
    const std::optional<Crossing> crossing = exact_crossing(triangle.a, triangle.b, triangle.c, ray);
    if (!crossing || !contains(range, crossing->t)) return std::nullopt;
    return Hit{.t = crossing->t, .uv = crossing->weights};
}

std::optional<Hit> intersect(const Triangle& triangle, const ShearedRay& ray, Interval range) {
    // [exercise 03.7] The watertight test: the answer of exact arithmetic, and its help only where rounding
    // leaves a doubt. Let `size` be the greatest |x| or |y| of the corners as the ray sees them, plus the
    // greatest |z|. Then x and y are off by less than 8u · size, and p.x·q.y − p.y·q.x of an edge by less
    // than 128u · size². intersect_exactly, which is given, decides what these leave open; and all of it
    // where size is outside of 1e-140 to 1e140, because its square might leave the range of Real. What is a
    // sure hit is found by hit_of_seen (03.6).
    const Vec3 a = seen(ray, triangle.a);
    const Vec3 b = seen(ray, triangle.b);
    const Vec3 c = seen(ray, triangle.c);
    const Vec3 low = min(min(a, b), c);
    const Vec3 high = max(max(a, b), c);
    const Vec3 reach = max(high, -low);
    const Real size = std::max(reach.x, reach.y) + reach.z;
    if (!(size > 1e-140 && size < 1e140)) return intersect_exactly(triangle, ray.ray, range);

    // Most triangles lie wholly beside the ray: nothing more is computed for those.
    const Real near = 8 * unit_roundoff * size;
    if (low.x > near || high.x < -near || low.y > near || high.y < -near) return std::nullopt;

    const auto turn = [](const Vec3& p, const Vec3& q) { return p.x * q.y - p.y * q.x; };
    const Real turn_a = turn(c, b), turn_b = turn(a, c), turn_c = turn(b, a);
    const Real bound = 128 * unit_roundoff * size * size;
    if (std::min({turn_a, turn_b, turn_c}) < -bound && std::max({turn_a, turn_b, turn_c}) > bound)
        return std::nullopt;
    const Real least = std::min({std::abs(turn_a), std::abs(turn_b), std::abs(turn_c)});
    if (!(least > bound)) return intersect_exactly(triangle, ray.ray, range);
    return hit_of_seen(ray, a, b, c, range);
    // [/exercise]
}

std::optional<Hit> intersect(const Triangle& triangle, const Ray& ray, Interval range) {
    return intersect(triangle, shear(ray), range);
}

Surface surface_at(const Triangle& triangle, const Ray&, const Hit& hit) {
    const Real weight_a = 1 - hit.uv.x - hit.uv.y;
    Surface surface;
    // [exercise 03.8] Fill in point (by the weights, not by t), normal, shading_normal and uv, all of the
    // flat triangle.
    surface.point = weight_a * triangle.a + hit.uv.x * triangle.b + hit.uv.y * triangle.c;
    surface.normal = unit_normal(triangle);
    surface.shading_normal = surface.normal;
    surface.uv = hit.uv;
    // [/exercise]
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
    // [exercise 03.8] The unit normal between those of the corners; `flat` where they cancel.
    const Vec3 sum = (1 - uv.x - uv.y) * normals.a + uv.x * normals.b + uv.y * normals.c;
    return sum == Vec3(0) ? flat : unit_vector(sum);
    // [/exercise]
}

Vec2 interpolate(const TriangleUvs& uvs, const Vec2& uv) {
    // [exercise 03.8] The texture coordinates between those of the corners.
    return (1 - uv.x - uv.y) * uvs.a + uv.x * uvs.b + uv.y * uvs.c;
    // [/exercise]
}

std::optional<Hit> closest_hit(std::span<const Triangle> triangles, const Ray& ray, Interval range) {
    // [exercise 03.9] The nearest hit with any of the triangles, of equally near ones the first. What depends
    // on the ray alone is worked out once, not once a triangle.
    const ShearedRay sheared = shear(ray);
    std::optional<Hit> nearest;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        std::optional<Hit> hit = intersect(triangles[i], sheared, range);
        if (!hit || (nearest && hit->t == nearest->t)) continue;
        hit->primitive = static_cast<std::uint32_t>(i);
        nearest = hit;
        range.max = hit->t;
    }
    return nearest;
    // [/exercise]
}

bool any_hit(std::span<const Triangle> triangles, const Ray& ray, Interval range) {
    // [exercise 03.9] Whether any triangle is hit; the first one found is enough.
    const ShearedRay sheared = shear(ray);
    return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& triangle) {
        return intersect(triangle, sheared, range).has_value();
    });
    // [/exercise]
}

Real solid_angle(const Triangle& triangle, const Vec3& from) {
    // [exercise 03.11] How much of the view the triangle fills, seen from the point: the area of its shadow
    // on the unit sphere around it. Positive where the point sees the triangle's back.
    const Vec3 a = unit_vector(triangle.a - from);
    const Vec3 b = unit_vector(triangle.b - from);
    const Vec3 c = unit_vector(triangle.c - from);
    const Real volume = dot(a, cross(b, c));
    return 2 * std::atan2(volume, 1 + dot(a, b) + dot(b, c) + dot(c, a));
    // [/exercise]
}

Real winding_number(std::span<const Triangle> triangles, const Vec3& point) {
    // [exercise 03.11] How often the triangles go round the point: all that they fill of its view, over the
    // whole view.
    Real sum = 0;
    for (const Triangle& triangle : triangles) sum += solid_angle(triangle, point);
    return sum / (4 * pi);
    // [/exercise]
}

}  // namespace rt
