// The one list of shapes that a world is made of, and what is said about each.
#pragma once

#include "common/scene/shapes.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <string_view>
#include <type_traits>

namespace rt {

/// A map of space and its inverse; both affine.
struct Transform {
    Mat4 to_world{1};
    Mat4 to_local{1};
};

/// Any shape under a transform that it cannot take into its own numbers.
template <class Shape>
struct Placed {
    Transform transform;
    Shape shape{};
};

/// A sphere that is stretched. All are the unit sphere: centre and radius are part of the transform.
using Ellipsoid = Placed<Sphere>;

struct SharedMesh;

/// A mesh that several objects show, as a shape in its own space.
struct MeshUse {
    std::shared_ptr<const SharedMesh> mesh;
};

/// One of the objects that show a mesh.
using Instance = Placed<MeshUse>;

template <class... Shape>
struct List {};

/// All shapes, in the order in which a world's groups stand. A shape brings
///   – its struct (common/scene/shapes.hpp), its place in this list, and its words below;
///   – `intersect`, `surface_at` and `bounds_of` in its chapter's contract. Where they are missing,
///     common/render/groups.hpp does not compile. A shape whose words say that it is endless has no bounds,
///     but `contains`. `overlaps` with a box may make its accelerators better than its bounds do, `prepared`
///     works out once a ray what all of them need, and `transformed` takes a transform into the shape's own
///     numbers; where there is none, a transform makes it a Placed<Shape>, which is another word in this
///     list.
using Shapes = List<Plane, Sphere, Triangle, Polygon, Ellipsoid, Instance>;

/// What messages call a shape, whose code it runs, what it costs, and what holds of every one.
struct ShapeWords {
    std::string_view one, many;
    std::array<std::string_view, 4> steps;  ///< that a picture of it needs, beside those of every picture
    /// One question of a ray, and one about a box (`overlaps`), in units of what a sphere costs.
    Real ask = 1;
    Real overlap = 1;
    int crossings = 2;        ///< how often a line crosses its surface, at most
    bool is_endless = false;  ///< no box is around it
};

/// The words of each shape; a shape of the list that has none does not compile.
template <class Shape>
inline constexpr ShapeWords words = Shape::there_are_no_words_for_this_shape;
template <>
inline constexpr ShapeWords words<Plane>{
    .one = "plane", .many = "planes", .steps = {"01.4"}, .is_endless = true};
template <>
inline constexpr ShapeWords words<Sphere>{"sphere", "spheres", {"02.3", "02.4"}};
template <>
inline constexpr ShapeWords words<Triangle>{"triangle", "triangles", {"03.4", "03.5"}, 1, 3};
template <>
inline constexpr ShapeWords words<Polygon>{"polygon", "polygons", {"03.7"}};
template <>
inline constexpr ShapeWords words<Ellipsoid>{
    "ellipsoid with its matrices", "ellipsoids with their matrices", {"04.6", "02.3", "02.4"}};
template <>
inline constexpr ShapeWords words<Instance>{
    "instance with its matrices", "instances with their matrices", {"04.6", "03.4", "03.5"}};

/// The bytes that a shape owns beside its own. One that owns memory says here, or in its chapter's contract,
/// how much.
template <class Shape>
requires(std::is_trivially_copyable_v<Shape>) std::size_t owned_bytes(const Shape&) { return 0; }
inline std::size_t owned_bytes(const Polygon& polygon) { return polygon.vertices.size() * sizeof(Vec3); }
/// A mesh is the world's, not its objects'.
inline std::size_t owned_bytes(const MeshUse&) { return 0; }
template <class Shape>
std::size_t owned_bytes(const Placed<Shape>& placed) {
    return owned_bytes(placed.shape);
}

}  // namespace rt
