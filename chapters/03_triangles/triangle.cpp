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
    // 03.3  The unit normal: the cross product of two edges. The products at the three corners,
    // ab × bc, bc × ca and ca × ab, are all the same but for rounding, and best is the one at the corner with
    // the greatest angle, which lies opposite to the longest edge. Make the edges unit vectors before you
    // multiply them (unit_vector is given): their product then neither overflows nor underflows, and its
    // length is the sine of the angle between them. Where that is at most ¼, rounding weighs too much: return
    // the unit vector of exact_normal, which is given and slow.
    return todo("03.3");
}

std::optional<Vec3> barycentric(const Triangle& triangle, const Vec3& point) {
    // 03.3  The weights of the corners. The weight of a corner is the area of the triangle that
    // the point spans with the other two corners, over the area of the whole. Areas have a sign:
    // take the component of the cross product along the unit normal.
    return todo("03.3");
}

ShearedRay shear(const Ray& ray) {
    // 03.4  Let z be the axis in which |direction| is greatest, x and y the next two in cyclic
    // order, and divide the direction's x and y by its z.
    return todo("03.4");
}

Vec3 seen(const ShearedRay& ray, const Vec3& point) {
    // 03.4  Subtract the ray's origin from the point, coordinate by coordinate: x, y and z are
    // those with the numbers ray.x, ray.y and ray.z. Then shear: x − slope.x·z, y − slope.y·z and z.
    return todo("03.4");
}

Real edge_function(const Vec2& p, const Vec2& q) {
    // 03.5  p.x·q.y − p.y·q.x, nearly as if without rounding. Where the two products nearly cancel,
    // what their rounding took away decides: std::fma(x, y, -xy) is exactly x·y − xy, where xy is the rounded
    // product. Take it into account for both products, so that (q, p) gets the opposite of (p, q).
    return todo("03.5");
}

std::optional<Hit> hit_of_seen(const ShearedRay& ray, const Vec3& a, const Vec3& b, const Vec3& c,
                               Interval range) {
    // 03.6  The ray is at x = y = 0. The edge functions of x and y of (c, b), (a, c) and (b, a) are
    // the weights u, v, w of a, b and c, still to be divided by their sum: each edge weighs the corner
    // opposite to it. The weighted mean of the corners' z, over the z of the direction (its coordinate number
    // ray.z), is t. Is it in the range?
    return todo("03.6");
}

std::optional<Hit> intersect_exactly(const Triangle& triangle, const Ray& ray, Interval range) {
    const std::optional<Crossing> crossing = exact_crossing(triangle.a, triangle.b, triangle.c, ray);
    if (!crossing || !contains(range, crossing->t)) return std::nullopt;
    return Hit{.t = crossing->t, .uv = crossing->weights};
}

std::optional<Hit> intersect(const Triangle& triangle, const ShearedRay& ray, Interval range) {
    // 03.7  The watertight test.
    //   1. See the corners along the ray, which is now at x = y = 0. Let `size` be the greatest |x| or |y| of
    //      the three, plus the greatest |z|: all errors grow with it. Where its square might overflow or
    //      underflow (outside of 1e-140 to 1e140), leave it to intersect_exactly, which is given.
    //   2. The places are off by less than 8u · size. Are all three x, or all three y, on the same side of 0
    //      and further away than that? A miss.
    //   3. The cross products p.x·q.y − p.y·q.x of (c, b), (a, c) and (b, a) tell on which side of each edge
    //      the ray passes; they are off by less than 128u · size². One surely negative and one surely
    //      positive: a miss. Else, if one of them may be 0, let intersect_exactly decide.
    //   4. Here the ray passes through the triangle: what is left is hit_of_seen (03.6).
    return todo("03.7");
}

std::optional<Hit> intersect(const Triangle& triangle, const Ray& ray, Interval range) {
    return intersect(triangle, shear(ray), range);
}

Surface surface_at(const Triangle& triangle, const Ray&, const Hit& hit) {
    const Real weight_a = 1 - hit.uv.x - hit.uv.y;
    Surface surface;
    // 03.8  Fill in point (the weighted sum of the corners: it lies better on the triangle than
    // origin + t · direction does), normal, shading_normal (the same) and uv.
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
    // 03.8  The weighted sum of the three normals, made a unit vector; `flat` if it is zero.
    return todo("03.8");
}

Vec2 interpolate(const TriangleUvs& uvs, const Vec2& uv) {
    // 03.8  The weighted sum of the three texture coordinates.
    return todo("03.8");
}

std::optional<Hit> closest_hit(std::span<const Triangle> triangles, const Ray& ray, Interval range) {
    // 03.9  The nearest hit; shear the ray once, not once a triangle. Shrinking the range as hits
    // are found saves work, but it includes its end: an equally near triangle that comes later must not win.
    return todo("03.9");
}

bool any_hit(std::span<const Triangle> triangles, const Ray& ray, Interval range) {
    // 03.9  Whether there is a hit at all; the first one found is enough.
    return todo("03.9");
}

}  // namespace rt
