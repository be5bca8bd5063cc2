// The shapes of the course, as plain data; at the end, those that a scene file can have.
#pragma once

#include "common/math/vec.hpp"
#include "common/scene/formula.hpp"

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

/// All points p with low ≤ p ≤ high in each coordinate; low < high in each.
struct Box {
    Vec3 low{-1};
    Vec3 high{1};
};

/// The points of a plane that are no farther than `radius` > 0 from `center`. `normal` need not be a unit
/// vector; not zero.
struct Disc {
    Vec3 center{0};
    Vec3 normal{0, 1, 0};
    Real radius = 1;
};

/// A round solid about the axis from a to b, a ≠ b: straight from radius_a at a to radius_b at b, with flat
/// ends. One radius may be 0, which is an apex; a cylinder has two equal ones.
struct Cone {
    Vec3 a{0};
    Real radius_a = 1;
    Vec3 b{0, 1, 0};
    Real radius_b = 0;
};

/// The side of a cone or cylinder alone, without its ends: a surface that has no inside.
struct OpenCone {
    Cone cone;
};

/// All points that are no farther than `tube` > 0 from a ring: a circle of radius `ring` > 0 around `center`,
/// across `axis`, which need not be a unit vector; not zero. Where tube = ring, the hole is one point, and
/// where it is greater, there is no hole, but a dimple at either end of the axis.
struct Torus {
    Vec3 center{0};
    Vec3 axis{0, 1, 0};
    Real ring = 1;
    Real tube = 0.25;
};

/// All points in the box with f = 0. The box is no part of the surface, which is open where it ends there.
struct Implicit {
    Box box;
    SharedFormula f;  ///< not null
};

/// All points in the box with A·x² + B·y² + C·z² + D·xy + E·xz + F·yz + G·x + H·y + I·z + J = 0.
struct Quadric {
    Vec3 squares{1};  ///< A, B, C
    Vec3 mixed{0};    ///< D, E, F
    Vec3 linear{0};   ///< G, H, I
    Real constant = -1;
    Box box;
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

/// How solids are put together: what is in any of them, in all of them, or in the first but in no other.
enum class SetOperation : std::uint8_t { Union, Intersection, Difference };

/// `union`, `intersection`, `difference`: the solids up to its `end`, in order; indices into Scene::parts.
struct CombinationObject {
    SetOperation operation = SetOperation::Union;
    std::vector<std::uint32_t> parts;
};

/// What an object of a file can be.
using FileShape = std::variant<Sphere, Plane, TriangleObject, PolygonObject, MeshObject, Box, Disc, Cone,
                               OpenCone, Torus, Implicit, Quadric, CombinationObject>;

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
template <>
inline constexpr FileShapeWords file_words<Box>{"box", true};
template <>
inline constexpr FileShapeWords file_words<Disc>{"disc", false};
template <>
inline constexpr FileShapeWords file_words<Cone>{"cone or cylinder", true};
template <>
inline constexpr FileShapeWords file_words<OpenCone>{"open cone or cylinder", false};
template <>
inline constexpr FileShapeWords file_words<Torus>{"torus", true};
template <>
inline constexpr FileShapeWords file_words<Implicit>{"implicit surface", true};
template <>
inline constexpr FileShapeWords file_words<Quadric>{"quadric", true};
template <>
inline constexpr FileShapeWords file_words<CombinationObject>{"combination of solids", true};

/// The words of an object's shape.
inline const FileShapeWords& words_of(const FileShape& shape) {
    return *std::visit([]<class Shape>(const Shape&) { return &file_words<Shape>; }, shape);
}

}  // namespace rt
