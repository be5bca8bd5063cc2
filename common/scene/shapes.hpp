// The shapes of the course, as plain data; at the end, those that a scene file can have.
#pragma once

#include "common/math/vec.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rt {

/// All points p with dot(normal, p − point) = 0. `normal` need not be a unit vector; not zero.
struct Plane {
    Vec3 point{0};
    Vec3 normal{0, 1, 0};
};

/// All points at distance `radius` > 0 from `center`.
struct Sphere {
    Vec3 center{0};
    Real radius = 1;
};

/// Corners in counterclockwise order seen from the side that the normal points to.
struct Triangle {
    Vec3 a{0};
    Vec3 b{0};
    Vec3 c{0};
};

/// A planar polygon, convex or not, without holes; at least three vertices, in order.
struct Polygon {
    std::vector<Vec3> vertices;
};

/// Triangles that share vertices, as a `.obj` file gives them.
struct Mesh {
    /// Indices of one corner: position, and −1 where the file gives no normal or texture coordinate.
    struct Corner {
        std::int32_t position = 0;
        std::int32_t normal = -1;
        std::int32_t uv = -1;
    };
    std::string file;
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;
    std::vector<Vec2> uvs;
    std::vector<std::array<Corner, 3>> triangles;
};

/// `tri` and `trinormal`: three indices into one of the scene's two lists of vertices.
struct TriangleObject {
    std::array<std::uint32_t, 3> vertex{};
    bool smooth = false;  ///< indices are into Scene::smooth_vertices; normals are interpolated
};

/// `polygon`: a planar polygon, its vertices in order; indices into Scene::vertices.
struct PolygonObject {
    std::vector<std::uint32_t> vertex;
};

/// `mesh`: all the triangles of one file, an index into Scene::meshes. Objects that name the same
/// file share it.
struct MeshObject {
    std::uint32_t mesh = 0;
};

/// What an object of a file can be.
using FileShape = std::variant<Sphere, Plane, TriangleObject, PolygonObject, MeshObject>;

/// What everybody has to know of a shape of a file.
struct FileShapeWords {
    std::string_view name;  ///< for messages
    /// Whether one alone has an inside, where glass bends and absorbs light: a ball has, a triangle has not.
    bool has_inside;
};

/// The words of each shape; a shape that has none does not compile.
template <class Shape>
inline constexpr FileShapeWords file_words = Shape::there_are_no_file_words_for_this_shape;
template <>
inline constexpr FileShapeWords file_words<Sphere>{"sphere", true};
template <>
inline constexpr FileShapeWords file_words<Plane>{"plane", true};
template <>
inline constexpr FileShapeWords file_words<TriangleObject>{"triangle", false};
template <>
inline constexpr FileShapeWords file_words<PolygonObject>{"polygon", false};
template <>
inline constexpr FileShapeWords file_words<MeshObject>{"mesh", true};

/// The words of an object's shape.
inline const FileShapeWords& words_of(const FileShape& shape) {
    return *std::visit([]<class Shape>(const Shape&) { return &file_words<Shape>; }, shape);
}

}  // namespace rt
