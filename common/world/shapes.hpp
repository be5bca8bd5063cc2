// The one list of shapes that a world is made of, and what is said about each.
#pragma once

#include "common/scene/shapes.hpp"
#include "common/world/bounds.hpp"
#include "common/world/spin.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

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

/// A shape that has an inside, where it stands: what combinations are made of.
using Solid =
    std::variant<Plane, Placed<Plane>, Sphere, Ellipsoid, Instance, Box, Placed<Box>, Cone, Placed<Cone>,
                 Torus, Placed<Torus>, Implicit, Placed<Implicit>, Quadric, Placed<Quadric>>;

/// Solids as one (constructive solid geometry): a tree, whose leaves are the parts. Its branches name part k
/// as k and node k as ~k, which is negative. The whole is the last node or, without any, the only part.
struct Combination {
    /// A flat face of a part across an axis of the world, in the plane of another part's.
    struct CommonPlane {
        std::uint32_t element = 0;  ///< of the part
        int axis = 0;               ///< 0, 1, 2 for x, y, z
        Real place = 0;             ///< the plane's coordinate there
    };
    struct Part {
        Solid solid;
        std::uint32_t first_element = 0;  ///< Hit::element counts through those of all the parts
        bool is_taken_away = false;       ///< what is inside the part is outside of the whole
        Bounds bounds;                    ///< around it, wider by more than rounding; may be infinite
        std::vector<CommonPlane> common_planes;
    };
    struct Node {
        SetOperation operation = SetOperation::Union;
        std::int32_t first = 0, second = 0;
        Bounds bounds;  ///< as a part's
    };
    std::vector<Part> parts;
    std::vector<Node> nodes;  ///< each after those that it is made of
};

/// Any shape that has an end, while it does not move.
using Still = std::variant<Sphere, Triangle, Polygon, Ellipsoid, Instance, Box, Placed<Box>, Disc,
                           Placed<Disc>, Cone, Placed<Cone>, OpenCone, Placed<OpenCone>, Torus, Placed<Torus>,
                           Implicit, Placed<Implicit>, Quadric, Placed<Quadric>, Combination>;

/// A shape that moves evenly while the shutter is open.
struct Moving {
    Vec3 motion{0};  ///< from where it is at time 0 to where it is at time 1; world space
    Still shape;     ///< where it is at time 0
};

/// A shape that turns while the shutter is open, and may move.
struct Turning {
    std::vector<Spin> spins;  ///< where they are at time 0; each turns with those before it
    Vec3 motion{0};           ///< of the whole, as in Moving
    Still shape;              ///< where it is at time 0
};

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
using Shapes = List<Plane, Sphere, Triangle, Polygon, Ellipsoid, Instance, Placed<Plane>, Box, Placed<Box>,
                    Disc, Placed<Disc>, Cone, Placed<Cone>, OpenCone, Placed<OpenCone>, Torus, Placed<Torus>,
                    Implicit, Placed<Implicit>, Quadric, Placed<Quadric>, Combination, Moving, Turning>;

/// What messages call a shape, whose code it runs, what it costs, and what holds of every one.
struct ShapeWords {
    std::string_view one, many;
    std::array<std::string_view, 6> steps;  ///< that a picture of it needs, beside those of every picture
    /// One question of a ray, and one about a box (`overlaps`), in units of what a sphere costs.
    Real ask = 1;
    Real overlap = 1;
    int crossings = 2;        ///< how often a line crosses its surface, at most
    bool is_endless = false;  ///< no box is around it
};

/// Of a surface that a line may cross any number of times.
inline constexpr int as_many_as_it_likes = std::numeric_limits<int>::max();

/// The words of each shape; a shape of the list that has none does not compile.
template <class Shape>
inline constexpr ShapeWords words = Shape::there_are_no_words_for_this_shape;
template <>
inline constexpr ShapeWords words<Plane>{
    .one = "plane", .many = "planes", .steps = {"01.4"}, .is_endless = true};
template <>
inline constexpr ShapeWords words<Sphere>{"sphere", "spheres", {"02.3", "02.4"}};
template <>
inline constexpr ShapeWords words<Triangle>{"triangle", "triangles", {"03.7", "03.8"}, 1, 3};
template <>
inline constexpr ShapeWords words<Polygon>{"polygon", "polygons", {"03.10"}};
template <>
inline constexpr ShapeWords words<Ellipsoid>{
    "ellipsoid with its matrices", "ellipsoids with their matrices", {"04.6", "02.3", "02.4"}};
template <>
inline constexpr ShapeWords words<Instance>{
    "instance with its matrices", "instances with their matrices", {"04.6", "03.7", "03.8"}};

template <>
inline constexpr ShapeWords words<Placed<Plane>>{.one = "plane with its matrices",
                                                 .many = "planes with their matrices",
                                                 .steps = {"04.6", "01.4"},
                                                 .is_endless = true};
template <>
inline constexpr ShapeWords words<Box>{"box", "boxes", {"10.1", "10.2"}};
template <>
inline constexpr ShapeWords words<Placed<Box>>{
    "box with its matrices", "boxes with their matrices", {"04.6", "10.1", "10.2"}};
template <>
inline constexpr ShapeWords words<Disc>{.one = "disc", .many = "discs", .steps = {"10.3"}, .crossings = 1};
template <>
inline constexpr ShapeWords words<Placed<Disc>>{.one = "disc with its matrices",
                                                .many = "discs with their matrices",
                                                .steps = {"04.6", "10.3"},
                                                .crossings = 1};
template <>
inline constexpr ShapeWords words<Cone>{
    "cone or cylinder", "cones and cylinders", {"10.1", "10.4", "10.5", "10.6"}, 3};
template <>
inline constexpr ShapeWords words<Placed<Cone>>{"cone or cylinder with its matrices",
                                                "cones and cylinders with their matrices",
                                                {"04.6", "10.1", "10.4", "10.5", "10.6"},
                                                3};
template <>
inline constexpr ShapeWords words<OpenCone>{
    "open cone or cylinder", "open cones and cylinders", {"10.4", "10.6"}, 3};
template <>
inline constexpr ShapeWords words<Placed<OpenCone>>{"open cone or cylinder with its matrices",
                                                    "open cones and cylinders with their matrices",
                                                    {"04.6", "10.4", "10.6"},
                                                    3};
template <>
inline constexpr ShapeWords words<Torus>{.one = "torus",
                                         .many = "tori",
                                         .steps = {"10.1", "10.7", "10.8", "10.9", "10.10"},
                                         .ask = 10,
                                         .crossings = 4};
template <>
inline constexpr ShapeWords words<Placed<Torus>>{.one = "torus with its matrices",
                                                 .many = "tori with their matrices",
                                                 .steps = {"04.6", "10.1", "10.7", "10.8", "10.9", "10.10"},
                                                 .ask = 10,
                                                 .crossings = 4};
template <>
inline constexpr ShapeWords words<Implicit>{.one = "implicit surface",
                                            .many = "implicit surfaces",
                                            .steps = {"10.1", "10.2", "10.11", "10.12", "10.13"},
                                            .ask = 500,
                                            .crossings = as_many_as_it_likes};
template <>
inline constexpr ShapeWords words<Placed<Implicit>>{
    .one = "implicit surface with its matrices",
    .many = "implicit surfaces with their matrices",
    .steps = {"04.6", "10.1", "10.2", "10.11", "10.12", "10.13"},
    .ask = 500,
    .crossings = as_many_as_it_likes};
template <>
inline constexpr ShapeWords words<Quadric>{"quadric", "quadrics", {"02.1", "10.1", "10.2"}, 7};
template <>
inline constexpr ShapeWords words<Placed<Quadric>>{
    "quadric with its matrices", "quadrics with their matrices", {"04.6", "02.1", "10.1", "10.2"}, 7};
template <>
inline constexpr ShapeWords words<Combination>{
    "combination of solids", "combinations of solids", {"10.1", "10.15"}, 10};
template <>
inline constexpr ShapeWords words<Moving>{.one = "moving shape",
                                          .many = "moving shapes",
                                          .steps = {"12.8", "12.9"},
                                          .ask = 3,
                                          .crossings = as_many_as_it_likes};
template <>
inline constexpr ShapeWords words<Turning>{.one = "turning shape",
                                           .many = "turning shapes",
                                           .steps = {"12.8", "12.9", "12.21"},
                                           .ask = 8,
                                           .crossings = as_many_as_it_likes};

/// The bytes that a shape owns beside its own. One that owns memory says here, or in its chapter's contract,
/// how much.
template <class Shape>
requires(std::is_trivially_copyable_v<Shape>) std::size_t owned_bytes(const Shape&) { return 0; }
inline std::size_t owned_bytes(const Polygon& polygon) { return polygon.vertices.size() * sizeof(Vec3); }
inline std::size_t owned_bytes(const Implicit& implicit) { return bytes_of(*implicit.f); }
/// A mesh is the world's, not its objects'.
inline std::size_t owned_bytes(const MeshUse&) { return 0; }
template <class Shape>
std::size_t owned_bytes(const Placed<Shape>& placed) {
    return owned_bytes(placed.shape);
}
inline std::size_t owned_bytes(const Combination& combination) {
    std::size_t bytes = combination.parts.size() * sizeof(Combination::Part) +
                        combination.nodes.size() * sizeof(Combination::Node);
    for (const Combination::Part& part : combination.parts)
        bytes += part.common_planes.size() * sizeof(Combination::CommonPlane) +
                 std::visit([](const auto& solid) { return owned_bytes(solid); }, part.solid);
    return bytes;
}

inline std::size_t owned_bytes(const Moving& moving) {
    return std::visit([](const auto& shape) { return owned_bytes(shape); }, moving.shape);
}
inline std::size_t owned_bytes(const Turning& turning) {
    return turning.spins.size() * sizeof(Spin) +
           std::visit([](const auto& shape) { return owned_bytes(shape); }, turning.shape);
}

}  // namespace rt
