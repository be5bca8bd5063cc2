// The methods of textbooks, which break on the stability families.
#include "tests/stability/naive.hpp"

#include "chapters/03_triangles/polygon.hpp"

#include <cmath>

namespace rt::naive {

Roots solve_quadratic(Real a, Real h, Real c) {
    const Real b = 2 * h;
    const Real d = b * b - 4 * a * c;
    if (d < 0) return {};
    const Real root = std::sqrt(d);
    return {d > 0 ? 2 : 1, (-b - root) / (2 * a), (-b + root) / (2 * a)};
}

Roots intersections(const Sphere& sphere, const Ray& ray) {
    const Vec3 o = ray.origin - sphere.center;
    return solve_quadratic(dot(ray.direction, ray.direction), dot(o, ray.direction),
                           dot(o, o) - sphere.radius * sphere.radius);
}

std::optional<Hit> intersect(const Sphere& sphere, const Ray& ray, Interval range) {
    const Roots both = intersections(sphere, ray);
    if (both.count == 0) return std::nullopt;
    for (const Real t : {both.t0, both.t1})
        if (t > epsilon && contains(range, t)) return Hit{.t = t};
    return std::nullopt;
}

std::optional<Hit> intersect(const Triangle& triangle, const Ray& ray, Interval range) {
    const Vec3 to_b = triangle.b - triangle.a, to_c = triangle.c - triangle.a;
    const Vec3 p = cross(ray.direction, to_c);
    const Real determinant = dot(to_b, p);
    if (std::abs(determinant) < parallel) return std::nullopt;

    const Real inverse = 1 / determinant;
    const Vec3 from_a = ray.origin - triangle.a;
    const Real u = dot(from_a, p) * inverse;
    if (u < 0 || u > 1) return std::nullopt;
    const Vec3 q = cross(from_a, to_b);
    const Real v = dot(ray.direction, q) * inverse;
    if (v < 0 || u + v > 1) return std::nullopt;
    const Real t = dot(to_c, q) * inverse;
    if (!(t > epsilon) || !contains(range, t)) return std::nullopt;
    return Hit{.t = t, .uv = {u, v}};
}

std::optional<Vec3> barycentric(const Triangle& triangle, const Vec3& point) {
    const Vec3 to_b = triangle.b - triangle.a, to_c = triangle.c - triangle.a;
    const Vec3 to_p = point - triangle.a;
    const Real bb = dot(to_b, to_b), bc = dot(to_b, to_c), cc = dot(to_c, to_c);
    const Real pb = dot(to_p, to_b), pc = dot(to_p, to_c);
    const Real determinant = bb * cc - bc * bc;
    if (determinant == 0) return std::nullopt;
    const Real b = (cc * pb - bc * pc) / determinant;
    const Real c = (bb * pc - bc * pb) / determinant;
    return Vec3{1 - b - c, b, c};
}

Vec3 unit_normal(const Triangle& triangle) {
    const Vec3 product = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    return product == Vec3(0) ? product : normalize(product);
}

std::optional<Hit> intersect(const Polygon& polygon, const Ray& ray, Interval range) {
    const Plane plane = supporting_plane(polygon.vertices);
    const Real denominator = dot(plane.normal, ray.direction);
    if (denominator == 0) return std::nullopt;
    const Real t = dot(plane.normal, plane.point - ray.origin) / denominator;
    const int axis = dominant_axis(plane.normal);
    const auto is_inside = [&] {
        std::vector<Vec2> corners;
        for (const Vec3& vertex : polygon.vertices) corners.push_back(project(vertex, axis));
        return rt::point_in_polygon(corners, project(point_at(ray, t), axis));
    };
    return contains(range, t) && is_inside() ? std::optional(Hit{.t = t}) : std::nullopt;
}

bool point_in_polygon(std::span<const Vec2> polygon, const Vec2& point) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2& p = polygon[i];
        const Vec2& q = polygon[(i + 1) % polygon.size()];
        if ((p.y > point.y) == (q.y > point.y)) continue;
        if (point.x < (q.x - p.x) * (point.y - p.y) / (q.y - p.y) + p.x) inside = !inside;
    }
    return inside;
}

std::optional<Mat4> inverse(const Mat4& m) {
    const Vec3 x(m[0]), y(m[1]), z(m[2]), t(m[3]);
    const Vec3 rows[3] = {cross(y, z), cross(z, x), cross(x, y)};
    const Real determinant = dot(x, rows[0]);
    if (std::abs(determinant) < singular) return std::nullopt;
    Mat4 result(1);
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) result[c][r] = rows[r][c] / determinant;
        result[3][r] = -dot(rows[r], t) / determinant;
    }
    return result;
}

Vec3 transform_normal(const Mat4& m, const Vec3& n) {
    return Vec3(m[0]) * n.x + Vec3(m[1]) * n.y + Vec3(m[2]) * n.z;
}

Ray to_local(const Transform& transform, const Ray& ray) {
    const Mat4& m = transform.to_local;
    return {Vec3(m * Vec4(ray.origin, 1)), normalize(Vec3(m * Vec4(ray.direction, 0))), ray.time};
}

}  // namespace rt::naive
