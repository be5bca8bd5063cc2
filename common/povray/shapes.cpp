// One section a shape: the beginning of its statement, its box and its scaling; and where it is not as most
// shapes are, texture coordinates, lengths and inside. To add a shape, add a section.
#include "common/povray/shapes.hpp"

#include "common/povray/mesh.hpp"
#include "common/povray/placement.hpp"
#include "common/povray/writer.hpp"
#include "common/scene/range.hpp"

#include <glm/matrix.hpp>

#include <cmath>

namespace rt::povray {
namespace {

/// Adds a point of a shape's own space.
void extend(Box& box, const Mat4& m, const Vec3& p) {
    const Vec3 here(m * Vec4(p, 1));
    box = {glm::min(box.low, here), glm::max(box.high, here)};
}

// Sphere ----------------------------------------------------------------------------------------------------

std::string beginning(const Scene&, const Sphere& sphere) {
    return fmt::format("sphere {{ {}, {}", triple(sphere.center), number(sphere.radius));
}

/// Texture coordinates belong to the object, so they move with it.
std::string with_uv(const Scene& scene, const Sphere& sphere, const std::string& transform) {
    return fmt::format("{} texture {{ SphereUv scale {} translate {} }}{} }}", beginning(scene, sphere),
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

std::string beginning(const Scene&, const Plane& plane) {
    const Vec3 n = unit_along(plane.normal);
    return fmt::format("plane {{ {}, {}", triple(n), number(glm::dot(n, plane.point)));
}

Box box_of(const Scene&, const Plane&, const Mat4&) { return {Vec3(-infinity), Vec3(infinity)}; }

Real least_length_of(const Scene&, const Plane&, const Mat4&) { return 0; }

void scale(Scene&, Plane& plane, Real factor) { plane.point *= factor; }

bool contains(const Plane& plane, const Vec3& p) { return glm::dot(plane.normal, p - plane.point) < 0; }

bool is_endless(const Scene&, const Plane&) { return true; }

// Triangle --------------------------------------------------------------------------------------------------

/// Only meshes have texture coordinates in POV-Ray, so for those a triangle becomes a mesh of one.
std::string beginning(const Scene& scene, const TriangleObject& triangle) {
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
    return beginning(scene, triangle) + transform + " texture { MeshUv } }";
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

bool has_inside(const TriangleObject&) { return false; }

// Polygon ---------------------------------------------------------------------------------------------------

std::string beginning(const Scene& scene, const PolygonObject& polygon) {
    std::string text = fmt::format("polygon {{ {}", polygon.vertex.size() + 1);
    for (const std::uint32_t i : polygon.vertex) text += ", " + triple(scene.vertices[i]);
    return text + ", " + triple(scene.vertices[polygon.vertex.front()]);
}

Box box_of(const Scene& scene, const PolygonObject& polygon, const Mat4& m) {
    Box box;
    for (const std::uint32_t i : polygon.vertex) extend(box, m, scene.vertices[i]);
    return box;
}

void scale(Scene& scene, PolygonObject& polygon, Real factor) {
    for (std::uint32_t& i : polygon.vertex) scale_vertex(scene, i, factor);
}

bool has_inside(const PolygonObject&) { return false; }

// Mesh ------------------------------------------------------------------------------------------------------

std::string beginning(const Scene&, const MeshObject& shown) {
    return fmt::format("object {{ Mesh{}", shown.mesh);
}

std::string with_uv(const Scene& scene, const MeshObject& shown, const std::string& transform) {
    return beginning(scene, shown) + transform + " texture { MeshUv } }";
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
std::string with_uv(const Scene& scene, const Shape& shape, const std::string& transform) {
    return beginning(scene, shape) + transform + " texture { NoUv } }";
}

template <class Shape>
Real least_length_of(const Scene& scene, const Shape& shape, const Mat4& m) {
    const Box box = box_of(scene, shape, m);
    return glm::length(box.high - box.low);
}

template <class Shape>
Real own_size(const Scene& scene, const Shape& shape) {
    return least_length_of(scene, shape, Mat4(1));
}

template <class Shape>
bool has_inside(const Shape&) {
    return true;
}

template <class Shape>
bool contains(const Shape&, const Vec3&) {
    return false;
}

template <class Shape>
bool is_endless(const Scene&, const Shape&) {
    return false;
}

}  // namespace

// Any of them -----------------------------------------------------------------------------------------------

std::string beginning(const Scene& scene, const Object& object) {
    return std::visit([&](const auto& s) { return beginning(scene, s); }, object.shape);
}

std::string with_uv(const Scene& scene, const Object& object, const std::string& transform) {
    return std::visit([&](const auto& s) { return with_uv(scene, s, transform); }, object.shape);
}

Box box_of(const Scene& scene, const Object& object, const Mat4& m) {
    return std::visit([&](const auto& s) { return box_of(scene, s, m); }, object.shape);
}

Real least_length_of(const Scene& scene, const Object& object, const Mat4& m) {
    return std::visit([&](const auto& s) { return least_length_of(scene, s, m); }, object.shape);
}

Real own_size(const Scene& scene, const Object& object) {
    return std::visit([&](const auto& s) { return own_size(scene, s); }, object.shape);
}

void scale(Scene& scene, Object& object, Real factor) {
    std::visit([&](auto& s) { scale(scene, s, factor); }, object.shape);
}

bool has_inside(const Object& object) {
    return std::visit([](const auto& s) { return has_inside(s); }, object.shape);
}

bool contains(const Object& object, const Vec3& p) {
    return std::visit([&](const auto& s) { return contains(s, p); }, object.shape);
}

bool is_endless(const Scene& scene, const Object& object) {
    return std::visit([&](const auto& s) { return is_endless(scene, s); }, object.shape);
}

}  // namespace rt::povray
