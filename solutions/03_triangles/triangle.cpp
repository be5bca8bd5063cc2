// Triangles: barycentric coordinates, the watertight test, smooth normals.
#include "chapters/03_triangles/triangle.hpp"

#include "common/math/error.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Vec3 unit_vector(const Vec3& v) {
    const Real greatest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(greatest > 0)) return Vec3(0);
    // Brought to size 1 first: the squares of very long and very short vectors leave the range of Real.
    const Vec3 scaled = v / greatest;
    return scaled / glm::length(scaled);
}

Vec3 unit_normal(const Triangle& triangle) {
    // [exercise 03.3] The unit normal: the cross product of the edges from a to b and from a to c.
    // Make the edges unit vectors before you multiply them (unit_vector is given): their product then
    // neither overflows nor underflows, and its length is the sine of the angle between them. If that is at
    // most 8 · unit_roundoff, rounding alone may have made it: return zero, the sign of "no area".
    const Vec3 to_b = unit_vector(triangle.b - triangle.a);
    const Vec3 to_c = unit_vector(triangle.c - triangle.a);
    const Vec3 product = glm::cross(to_b, to_c);
    // Each edge is off by 3 roundings a coordinate, the product by less than 2 more: 8 covers parallel edges.
    const Real sine = glm::length(product);
    return sine > 8 * unit_roundoff ? product / sine : Vec3(0);
    // [/exercise]
}

std::optional<Vec3> barycentric(const Triangle& triangle, const Vec3& point) {
    // [exercise 03.3] The weights of the corners. The weight of a corner is the area of the triangle that
    // the point spans with the other two corners, over the area of the whole. Areas have a sign:
    // take the component of the cross product along the unit normal.
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

Real edge_function(const Vec2& p, const Vec2& q) {
    // [exercise 03.4] p.x·q.y − p.y·q.x, nearly as if without rounding. Where the two products nearly cancel,
    // what their rounding took away decides: std::fma(x, y, -xy) is exactly x·y − xy, where xy is the rounded
    // product. Take it into account for both products, so that (q, p) gets the opposite of (p, q).
    const Real ab = p.x * q.y;
    const Real cd = p.y * q.x;
    return (ab - cd) + (std::fma(p.x, q.y, -ab) - std::fma(p.y, q.x, -cd));
    // [/exercise]
}

ShearedRay shear(const Ray& ray) {
    // [exercise 03.4] Let z be the axis in which |direction| is greatest, x and y the next two in cyclic
    // order. The map has the rows x − (d.x/d.z)·z, y − (d.y/d.z)·z and z; a matrix of GLM is indexed
    // m[column][row], and a column says what becomes of one coordinate of the world.
    const Vec3 d = ray.direction;
    const Vec3 size = glm::abs(d);
    const int z = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int x = (z + 1) % 3;
    const int y = (z + 2) % 3;
    ShearedRay sheared{ray.origin, Mat3(0), d[z]};
    sheared.to_z_axis[x] = {1, 0, 0};
    sheared.to_z_axis[y] = {0, 1, 0};
    sheared.to_z_axis[z] = {-d[x] / d[z], -d[y] / d[z], 1};
    return sheared;
    // [/exercise]
}

std::optional<Hit> intersect(const Triangle& triangle, const ShearedRay& ray, Interval range) {
    // [exercise 03.4] The watertight test.
    //   1. Subtract the ray's origin from each corner and map it: its x and y are now its place as the ray
    //      sees it, with the ray at (0, 0).
    //   2. The edge functions of (c, b), (a, c) and (b, a) are the weights u, v, w of a, b, c, still to be
    //      divided by their sum. Two different signs: a miss. All three zero: edge-on, a miss.
    //   3. The weighted mean of the corners' z, over the direction's z, is t. Is it in the range?
    //   4. A triangle without area (unit_normal) is missed, even where rounding made one up.
    const Vec3 a = ray.to_z_axis * (triangle.a - ray.origin);
    const Vec3 b = ray.to_z_axis * (triangle.b - ray.origin);
    const Vec3 c = ray.to_z_axis * (triangle.c - ray.origin);

    // Most triangles lie wholly beside the ray: nothing more is computed for those.
    if ((a.x > 0 && b.x > 0 && c.x > 0) || (a.x < 0 && b.x < 0 && c.x < 0)) return std::nullopt;
    if ((a.y > 0 && b.y > 0 && c.y > 0) || (a.y < 0 && b.y < 0 && c.y < 0)) return std::nullopt;

    const Real u = edge_function(Vec2(c), Vec2(b));
    const Real v = edge_function(Vec2(a), Vec2(c));
    const Real w = edge_function(Vec2(b), Vec2(a));
    if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) return std::nullopt;
    const Real sum = u + v + w;
    if (sum == 0) return std::nullopt;

    const Real t = (u * a.z + v * b.z + w * c.z) / sum / ray.direction_z;
    if (!contains(range, t)) return std::nullopt;
    if (unit_normal(triangle) == Vec3(0)) return std::nullopt;
    return Hit{.t = t, .uv = {v / sum, w / sum}};
    // [/exercise]
}

std::optional<Hit> intersect(const Triangle& triangle, const Ray& ray, Interval range) {
    return intersect(triangle, shear(ray), range);
}

Surface surface_at(const Triangle& triangle, const Ray&, const Hit& hit) {
    const Real weight_a = 1 - hit.uv.x - hit.uv.y;
    Surface surface;
    // [exercise 03.5] Fill in point (the weighted sum of the corners: it lies better on the triangle than
    // origin + t · direction does), normal, shading_normal (the same) and uv.
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
    surface.error = gamma(7) * size + Vec3(gamma(14) * std::max({reach.x, reach.y, reach.z}));
    return surface;
}

Vec3 interpolate(const TriangleNormals& normals, const Vec2& uv, const Vec3& flat) {
    // [exercise 03.5] The weighted sum of the three normals, made a unit vector; `flat` if it is zero.
    const Vec3 sum = (1 - uv.x - uv.y) * normals.a + uv.x * normals.b + uv.y * normals.c;
    return sum == Vec3(0) ? flat : unit_vector(sum);
    // [/exercise]
}

Vec2 interpolate(const TriangleUvs& uvs, const Vec2& uv) {
    // [exercise 03.5] The weighted sum of the three texture coordinates.
    return (1 - uv.x - uv.y) * uvs.a + uv.x * uvs.b + uv.y * uvs.c;
    // [/exercise]
}

std::optional<Hit> closest_hit(std::span<const Triangle> triangles, const Ray& ray, Interval range) {
    // [exercise 03.6] The nearest hit; shear the ray once, not once a triangle. Shrinking the range as hits
    // are found saves work, but it includes its end: an equally near triangle that comes later must not win.
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
    // [exercise 03.6] Whether there is a hit at all; the first one found is enough.
    const ShearedRay sheared = shear(ray);
    return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& triangle) {
        return intersect(triangle, sheared, range).has_value();
    });
    // [/exercise]
}

}  // namespace rt
