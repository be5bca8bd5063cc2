// Where a point of a shape lies on a texture, and how the surface runs there.
#include "chapters/11_textures/texture_coordinates.hpp"

#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/10_surfaces/chord.hpp"
#include "common/math/todo.hpp"
#include "common/scene/evaluate.hpp"

#include <cmath>

namespace rt {

namespace {

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

PlaneAxes plane_axes(const Vec3& normal) {
    const Vec3 n = unit(normal);
    const Vec3 level(n.z + n.y * n.y, -n.x * n.y, -n.x);
    // Where `level` nearly vanishes, rounding has also made it oblique: so u is made from v.
    const Vec3 v = unit(cross(n, level == Vec3(0) ? Vec3(1, 0, 0) : level));
    return {cross(v, n), v};
}

Real part_of_turn(Real y, Real x) {
    const Real turn = std::atan2(y, x) / (2 * pi);
    const Real wrapped = turn < 0 ? turn + 1 : turn;
    // A tiny negative turn plus 1 is rounded to 1.
    return wrapped < 1 ? wrapped : 0;
}

Vec2 affine_uv(const std::array<Vec2, 3>& uvs, const Vec3& weights) {
    return weights.x * uvs[0] + weights.y * uvs[1] + weights.z * uvs[2];
}

Vec2 perspective_uv(const std::array<Vec2, 3>& uvs, const Vec3& depths, const Vec3& screen_weights) {
    // 11.1  Return the (u, v) of the point that is seen there. How much does each corner count on
    // the triangle?
    return todo("11.1");
}

namespace {

/// From the centre to p. Rounding may make n.y a little greater than 1, of which there is no arcsine.
Vec3 direction_to(const Vec3& p, const Sphere& sphere) {
    const Vec3 f = p - sphere.center;
    return f == Vec3(0) ? Vec3(1, 0, 0) : clamp(unit(f), Vec3(-1), Vec3(1));
}

}  // namespace

Vec2 texture_uv(const Sphere& sphere, const Vec3& p, std::uint32_t) {
    return sphere_uv(direction_to(p, sphere));
}

TexturePoint texture_point(const Sphere& sphere, const Vec3& p, std::uint32_t) {
    // Given: the direction from the centre to p, and where on the texture that is.
    const Vec3 n = direction_to(p, sphere);
    TexturePoint texture;
    texture.uv = sphere_uv(n);

    // 11.1  Set texture.du and texture.dv: how far the point moves, in units of length, for each
    // unit of u, which is a whole turn, and of v, which is half a turn. At the poles du is 0, and dv runs
    // along the meridian of texture.uv.
    return todo("11.1");
    return texture;
}

TexturePoint texture_point(const Plane& plane, const Vec3& p, std::uint32_t) {
    const auto [u, v] = plane_axes(plane.normal);
    const Vec3 f = p - plane.point;
    return {{dot(f, u), dot(f, v)}, u, v};
}

TexturePoint texture_point(const Disc& disc, const Vec3& p, std::uint32_t) {
    if (!(disc.radius > 0)) return {Vec2(0.5), Vec3(0), Vec3(0)};
    const auto [u, v] = plane_axes(disc.normal);
    const Vec3 f = p - disc.center;
    const Real side = 2 * disc.radius;
    return {0.5 + Vec2(dot(f, u), dot(f, v)) / side, side * u, side * v};
}

TexturePoint texture_point(const Box& box, const Vec3& p, std::uint32_t element) {
    Vec3 normal(0);
    normal[static_cast<int>(element / 2)] = element % 2 == 1 ? 1 : -1;
    const auto [u, v] = plane_axes(normal);
    // u and v are each along an axis of the box. From the middle, so that a face is ±½ in either.
    const Vec3 size = box.high - box.low;
    const Vec3 f = clamp((p - box.low) / size, Vec3(0), Vec3(1)) - 0.5;
    return {{0.5 + dot(f, u), 0.5 + dot(f, v)}, size * u, size * v};
}

namespace {

/// The axis of a cone, and two directions across it between which u counts.
struct Around {
    Vec3 axis, from, towards;
};
Around around(const Cone& cone) {
    const Vec3 axis = cone.b - cone.a;
    const PlaneAxes across = plane_axes(axis);
    return {axis, across.u, -across.v};
}

/// (u, v) on the side.
Vec2 side_uv(const Cone& cone, [[maybe_unused]] const Around& given, const Vec3& p) {
    [[maybe_unused]] const auto& [axis, from, towards] = given;
    [[maybe_unused]] const Vec3 f = p - cone.a;
    // 11.1  Return uv. p is at f, as seen from the end a. u begins at `from`, and a quarter of it
    // is at `towards` (both unit vectors, across the axis). Keep v in [0, 1].
    return todo("11.1");
}

}  // namespace

Vec2 texture_uv(const OpenCone& open, const Vec3& p, std::uint32_t) {
    return side_uv(open.cone, around(open.cone), p);
}

TexturePoint texture_point(const OpenCone& open, const Vec3& p, std::uint32_t) {
    const Cone& cone = open.cone;
    // Given: the axis, two directions across it, and where on the texture p is.
    const Around given = around(cone);
    [[maybe_unused]] const auto& [axis, from, towards] = given;
    [[maybe_unused]] const Vec2 uv = side_uv(cone, given, p);

    // 11.1  Return uv, and with it du and dv: how the point moves on the side, whose radius is
    // radius_a at v = 0 and radius_b at v = 1.
    return todo("11.1");
}

Vec2 texture_uv(const Cone& cone, const Vec3& p, std::uint32_t element) {
    return element == 0 ? texture_uv(OpenCone{cone}, p, 0) : texture_point(cone, p, element).uv;
}

TexturePoint texture_point(const Cone& cone, const Vec3& p, std::uint32_t element) {
    if (element == 1) return texture_point(Disc{cone.a, cone.a - cone.b, cone.radius_a}, p, 0);
    if (element == 2) return texture_point(Disc{cone.b, cone.b - cone.a, cone.radius_b}, p, 0);
    return texture_point(OpenCone{cone}, p, 0);
}

namespace {

/// The axes of a torus, and where on the texture a point lies.
struct OnTorus {
    Vec3 n, x_axis, minus_z_axis;
    Vec2 uv;
};
OnTorus on_torus(const Torus& torus, const Vec3& p) {
    const Vec3 n = unit(torus.axis), f = p - torus.center;
    const auto [x_axis, minus_z_axis] = plane_axes(n);
    const Real x = dot(f, x_axis), z = -dot(f, minus_z_axis), height = dot(f, n);
    // Half a turn more, and backwards: both wrapped by asking for the opposite direction.
    return {
        n, x_axis, minus_z_axis, {part_of_turn(z, -x), part_of_turn(-height, torus.ring - std::hypot(x, z))}};
}

}  // namespace

Vec2 texture_uv(const Torus& torus, const Vec3& p, std::uint32_t) { return on_torus(torus, p).uv; }

TexturePoint texture_point(const Torus& torus, const Vec3& p, std::uint32_t) {
    const auto [n, x_axis, minus_z_axis, uv] = on_torus(torus, p);
    const Real u = uv.x, v = uv.y;
    const Real theta = pi - 2 * pi * u, psi = 2 * pi * v - pi;
    const Vec3 radial = std::cos(theta) * x_axis - std::sin(theta) * minus_z_axis;
    const Vec3 ahead = -std::sin(theta) * x_axis - std::cos(theta) * minus_z_axis;
    // How far the point is from the axis; where R < r the surface ends there.
    const Real distance = std::max(torus.ring + torus.tube * std::cos(psi), Real(0));
    return {uv, -2 * pi * distance * ahead,
            2 * pi * torus.tube * (std::cos(psi) * n - std::sin(psi) * radial)};
}

TexturePoint texture_point(const Polygon& polygon, const Vec3& p, std::uint32_t) {
    const Vec3 first = polygon.vertices.front(), f = p - first;
    const Vec3 du = polygon.vertices[1] - first, dv = polygon.vertices.back() - first, n = cross(du, dv);
    const Real squared = dot(n, n);
    if (!(squared > least_corner * least_corner * dot(du, du) * dot(dv, dv))) return {};
    return {{dot(cross(f, dv), n) / squared, dot(cross(du, f), n) / squared}, du, dv};
}

namespace {

/// On a surface with this normal, of any length, seen from the origin.
TexturePoint seen_from_origin(const Vec3& p, const Vec3& normal) {
    TexturePoint texture = texture_point(Sphere{Vec3(0), length(p)}, p, 0);
    const Vec3 outwards = unit(p), n = unit(normal);
    const Real rise = dot(outwards, n);
    if (!(std::abs(rise) > least_corner)) return {texture.uv, Vec3(0), Vec3(0)};  // also if it is NaN
    texture.du -= dot(texture.du, n) / rise * outwards;
    texture.dv -= dot(texture.dv, n) / rise * outwards;
    return texture;
}

Vec2 uv_from_origin(const Vec3& p) { return texture_uv(Sphere{Vec3(0), 1}, p, 0); }

Vec3 normal_of_face(std::uint32_t face) {
    Vec3 normal(0);
    normal[static_cast<int>(face / 2)] = 1;
    return normal;
}

}  // namespace

Vec2 texture_uv(const Implicit&, const Vec3& p, std::uint32_t) { return uv_from_origin(p); }

TexturePoint texture_point(const Implicit& implicit, const Vec3& p, std::uint32_t element) {
    return seen_from_origin(p,
                            element < surface_face ? normal_of_face(element) : gradient_at(*implicit.f, p));
}

Vec2 texture_uv(const Quadric&, const Vec3& p, std::uint32_t) { return uv_from_origin(p); }

TexturePoint texture_point(const Quadric& q, const Vec3& p, std::uint32_t element) {
    if (element < surface_face) return seen_from_origin(p, normal_of_face(element));
    const Real d = q.mixed.x, e = q.mixed.y, f = q.mixed.z;
    const Vec3 mixed(d * p.y + e * p.z, d * p.x + f * p.z, e * p.x + f * p.y);
    return seen_from_origin(p, Real(2) * q.squares * p + mixed + q.linear);
}

TexturePoint texture_point(const Triangle& triangle, const TriangleUvs& uvs, const Vec2& weights) {
    TexturePoint texture;
    texture.uv = interpolate(uvs, weights);
    const Vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    const Vec2 d1 = uvs.b - uvs.a, d2 = uvs.c - uvs.a;
    const Real area = edge_function(d1, d2);
    if (area == 0) return texture;
    const Vec3 du = (d2.y * e1 - d1.y * e2) / area, dv = (d1.x * e2 - d2.x * e1) / area;
    if (is_finite(du) && is_finite(dv)) texture.du = du, texture.dv = dv;
    return texture;
}

}  // namespace rt
