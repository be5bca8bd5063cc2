// One section a shape: its statement, its texture coordinates, its box and its scaling; and where it is not
// as most shapes are, lengths, places and inside. To add a shape, add a section.
#include "common/povray/shapes.hpp"

#include "common/povray/mesh.hpp"
#include "common/povray/placement.hpp"
#include "common/povray/writer.hpp"
#include "common/scene/range.hpp"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace rt::povray {
namespace {

/// Adds a point of a shape's own space.
void extend(Box& box, const Mat4& m, const Vec3& p) {
    const Vec3 here(m * Vec4(p, 1));
    box = {glm::min(box.low, here), glm::max(box.high, here)};
}

bool overlap(const Box& a, const Box& b) {
    return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

/// The statement of a shape whose texture coordinates are 0 everywhere.
std::string without_uv(const std::string& statement, const std::string& transform) {
    return statement + transform + " texture { NoUv } }";
}

// Sphere ----------------------------------------------------------------------------------------------------

std::string open_statement(const Scene&, const Sphere& sphere) {
    return fmt::format("sphere {{ {}, {}", triple(sphere.center), number(sphere.radius));
}

/// Texture coordinates belong to the object, so they move with it.
std::string with_uv(const Scene& scene, const Sphere& sphere, const std::string& transform) {
    return fmt::format("{} texture {{ SphereUv scale {} translate {} }}{} }}", open_statement(scene, sphere),
                       number(sphere.radius), triple(sphere.center), transform);
}

Box box_of(const Scene&, const Sphere& sphere, const Mat4& m) {
    const Vec3 center(m * Vec4(sphere.center, 1));
    const Mat3 rows = glm::transpose(Mat3(m));
    const Vec3 half = sphere.radius * Vec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
    return {center - half, center + half};
}

/// An ellipsoid's shortest axis at least: a ball of radius r, r times the smallest stretch of a direction.
Real least_length_of(const Scene&, const Sphere& sphere, const Mat4& m) {
    const Mat3 back = glm::inverse(Mat3(m));
    Real squares = 0;
    for (int i = 0; i < 3; ++i) squares += glm::dot(back[i], back[i]);
    return sphere.radius / std::sqrt(squares / 3);
}

Real own_size(const Scene&, const Sphere& sphere) { return sphere.radius; }

void scale(Scene&, Sphere& sphere, Real factor) { sphere.center *= factor, sphere.radius *= factor; }

bool contains(const Sphere& sphere, const Vec3& p) { return glm::length(p - sphere.center) < sphere.radius; }

// Plane -----------------------------------------------------------------------------------------------------

std::string open_statement(const Scene&, const Plane& plane) {
    const Vec3 n = unit_along(plane.normal);
    return fmt::format("plane {{ {}, {}", triple(n), number(glm::dot(n, plane.point)));
}

std::string with_uv(const Scene& scene, const Plane& plane, const std::string& transform) {
    return without_uv(open_statement(scene, plane), transform);
}

Box box_of(const Scene&, const Plane&, const Mat4&) { return {Vec3(-infinity), Vec3(infinity)}; }

Real least_length_of(const Scene&, const Plane&, const Mat4&) { return 0; }

void scale(Scene&, Plane& plane, Real factor) { plane.point *= factor; }

bool contains(const Plane& plane, const Vec3& p) { return glm::dot(plane.normal, p - plane.point) < 0; }

/// The plane after `m`, with a unit normal.
Plane moved(const Plane& plane, const Mat4& m) {
    const Mat3 directions(m);
    return {Vec3(m * Vec4(plane.point, 1)),
            unit_along(glm::transpose(glm::inverse(directions)) * unit_along(plane.normal))};
}

/// Straight, because there is no farthest point.
Real reach_of(const Scene& scene, const Plane& plane, const Mat4& m) {
    const Plane here = moved(plane, m);
    return std::abs(glm::dot(here.normal, scene.camera.eye - here.point));
}

/// Whether one of them is on the inner side.
bool may_reach(const Scene&, const Plane& plane, const Mat4& m, std::span<const Vec3> corners) {
    const Plane here = moved(plane, m);
    return std::ranges::any_of(corners, [&](const Vec3& corner) {
        Real height = 0;
        for (int i = 0; i < 3; ++i)
            if (here.normal[i] != 0)  // corners may be infinitely far away
                height += here.normal[i] * (corner[i] - here.point[i]);
        return height <= 0;
    });
}

// Triangle --------------------------------------------------------------------------------------------------

/// Only meshes have texture coordinates in POV-Ray, so for those a triangle becomes a mesh of one.
std::string open_statement(const Scene& scene, const TriangleObject& triangle) {
    const bool uv = row_of(scene.integrator).uvs;
    std::string text = fmt::format("{}{}triangle {{ ", uv ? "mesh { " : "", triangle.smooth ? "smooth_" : "");
    for (std::size_t i = 0; i < 3; ++i) {
        if (i > 0) text += ", ";
        if (triangle.smooth) {
            const SmoothVertex& v = scene.smooth_vertices[triangle.vertex[i]];
            text += triple(v.position) + ", " + triple(in_range(v.normal) ? v.normal : near_one(v.normal));
        } else {
            text += triple(scene.vertices[triangle.vertex[i]]);
        }
    }
    return uv ? text + " uv_vectors <0, 0>, <1, 0>, <0, 1> }" : text;
}

std::string with_uv(const Scene& scene, const TriangleObject& triangle, const std::string& transform) {
    return open_statement(scene, triangle) + transform + " texture { MeshUv } }";
}

Box box_of(const Scene& scene, const TriangleObject& triangle, const Mat4& m) {
    Box box;
    for (const std::uint32_t i : triangle.vertex)
        extend(box, m, triangle.smooth ? scene.smooth_vertices[i].position : scene.vertices[i]);
    return box;
}

void scale_vertex(Scene& scene, std::uint32_t& index, Real factor) {
    scene.vertices.push_back(scene.vertices[index] * factor);
    index = static_cast<std::uint32_t>(scene.vertices.size()) - 1;
}

void scale_smooth_vertex(Scene& scene, std::uint32_t& index, Real factor) {
    const SmoothVertex v = scene.smooth_vertices[index];
    scene.smooth_vertices.push_back({v.position * factor, v.normal});
    index = static_cast<std::uint32_t>(scene.smooth_vertices.size()) - 1;
}

void scale(Scene& scene, TriangleObject& triangle, Real factor) {
    for (std::uint32_t& i : triangle.vertex)
        triangle.smooth ? scale_smooth_vertex(scene, i, factor) : scale_vertex(scene, i, factor);
}

// Polygon ---------------------------------------------------------------------------------------------------

std::string open_statement(const Scene& scene, const PolygonObject& polygon) {
    std::string text = fmt::format("polygon {{ {}", polygon.vertex.size() + 1);
    for (const std::uint32_t i : polygon.vertex) text += ", " + triple(scene.vertices[i]);
    return text + ", " + triple(scene.vertices[polygon.vertex.front()]);
}

std::string with_uv(const Scene& scene, const PolygonObject& polygon, const std::string& transform) {
    return without_uv(open_statement(scene, polygon), transform);
}

Box box_of(const Scene& scene, const PolygonObject& polygon, const Mat4& m) {
    Box box;
    for (const std::uint32_t i : polygon.vertex) extend(box, m, scene.vertices[i]);
    return box;
}

void scale(Scene& scene, PolygonObject& polygon, Real factor) {
    for (std::uint32_t& i : polygon.vertex) scale_vertex(scene, i, factor);
}

// Mesh ------------------------------------------------------------------------------------------------------

std::string open_statement(const Scene&, const MeshObject& shown) {
    return fmt::format("object {{ Mesh{}", shown.mesh);
}

std::string with_uv(const Scene& scene, const MeshObject& shown, const std::string& transform) {
    return open_statement(scene, shown) + transform + " texture { MeshUv } }";
}

Box box_of(const Scene& scene, const MeshObject& shown, const Mat4& m) {
    const Mesh& mesh = scene.meshes[shown.mesh];
    Box box;
    for (const auto& face : mesh.triangles)
        for (const Mesh::Corner& corner : face)
            extend(box, m, mesh.positions[static_cast<std::size_t>(corner.position)]);
    return box;
}

Real own_size(const Scene&, const MeshObject&) { return 0; }

void scale(Scene&, MeshObject&, Real) {}

bool is_endless(const Scene& scene, const MeshObject& shown) { return !is_closed(scene.meshes[shown.mesh]); }

// What holds of most shapes ---------------------------------------------------------------------------------

template <class Shape>
Real least_length_of(const Scene& scene, const Shape& shape, const Mat4& m) {
    const Box box = box_of(scene, shape, m);
    return glm::length(box.high - box.low);
}

template <class Shape>
Real reach_of(const Scene& scene, const Shape& shape, const Mat4& m) {
    const Vec3& eye = scene.camera.eye;
    const Box box = box_of(scene, shape, m);
    return glm::length(glm::max(glm::abs(box.low - eye), glm::abs(box.high - eye)));
}

template <class Shape>
bool may_reach(const Scene& scene, const Shape& shape, const Mat4& m, std::span<const Vec3> corners) {
    Box around;
    for (const Vec3& corner : corners) around = {glm::min(around.low, corner), glm::max(around.high, corner)};
    return overlap(box_of(scene, shape, m), around);
}

template <class Shape>
Real own_size(const Scene& scene, const Shape& shape) {
    return least_length_of(scene, shape, Mat4(1));
}

template <class Shape>
bool contains(const Shape&, const Vec3&) {
    return false;
}

template <class Shape>
bool is_endless(const Scene& scene, const Shape& shape) {
    const Box box = box_of(scene, shape, Mat4(1));
    return max_component(box.high - box.low) == infinity;
}

/// Whether the shape has a section.
template <class Shape>
constexpr bool has_section() {
    constexpr bool is_whole = requires(Scene & scene, Shape & shape, const Mat4& m) {
        open_statement(scene, shape);
        with_uv(scene, shape, std::string());
        box_of(scene, shape, m);
        scale(scene, shape, Real(2));
    };
    static_assert(is_whole,
                  "this shape's section in common/povray/shapes.cpp is missing, or lacks one of "
                  "open_statement, with_uv, box_of and scale");
    return is_whole;
}

/// What `ask` says of the object's shape.
template <class Answer, class SomeObject, class Ask>
Answer of_shape(SomeObject& object, const Ask& ask) {
    return std::visit(
        [&]<class Shape>(Shape& shape) {
            if constexpr (has_section<std::remove_const_t<Shape>>())
                return ask(shape);
            else
                return Answer();
        },
        object.shape);
}

}  // namespace

// Any of them -----------------------------------------------------------------------------------------------

std::string open_statement(const Scene& scene, const Object& object) {
    return of_shape<std::string>(object, [&](const auto& s) { return open_statement(scene, s); });
}

std::string with_uv(const Scene& scene, const Object& object, const std::string& transform) {
    return of_shape<std::string>(object, [&](const auto& s) { return with_uv(scene, s, transform); });
}

Box box_of(const Scene& scene, const Object& object, const Mat4& m) {
    return of_shape<Box>(object, [&](const auto& s) { return box_of(scene, s, m); });
}

Real least_length_of(const Scene& scene, const Object& object, const Mat4& m) {
    return of_shape<Real>(object, [&](const auto& s) { return least_length_of(scene, s, m); });
}

Real reach_of(const Scene& scene, const Object& object, const Mat4& m) {
    return of_shape<Real>(object, [&](const auto& s) { return reach_of(scene, s, m); });
}

bool may_reach(const Scene& scene, const Object& object, const Mat4& m, std::span<const Vec3> corners) {
    return of_shape<bool>(object, [&](const auto& s) { return may_reach(scene, s, m, corners); });
}

Real own_size(const Scene& scene, const Object& object) {
    return of_shape<Real>(object, [&](const auto& s) { return own_size(scene, s); });
}

void scale(Scene& scene, Object& object, Real factor) {
    of_shape<void>(object, [&](auto& s) { scale(scene, s, factor); });
}

bool contains(const Object& object, const Vec3& p) {
    return of_shape<bool>(object, [&](const auto& s) { return contains(s, p); });
}

bool is_endless(const Scene& scene, const Object& object) {
    return of_shape<bool>(object, [&](const auto& s) { return is_endless(scene, s); });
}

}  // namespace rt::povray
