// The objects of a scene as the primitives of a world.
#include "common/render/primitives.hpp"

#include "common/math/input_error.hpp"
#include "common/render/bodies.hpp"
#include "common/render/groups.hpp"
#include "common/scene/parse.hpp"
#include "common/scene/range.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>

namespace rt {
namespace {

/// The matrices of a scene's transform tree, and what can be said of them without looking at numbers.
struct Transforms {
    std::vector<Mat4> matrix;
    std::vector<std::optional<Mat4>> inverse;     ///< of those that were asked for, see transform_of
    std::vector<std::optional<Real>> similarity;  ///< the factor for all lengths alike, if there is one
    std::vector<bool> turns;                      ///< whether directions are turned or mirrored
};

Transforms transforms_of(const Scene& scene) {
    const auto transformed = [](const Object& object) { return object.transform >= 0; };
    if (std::none_of(scene.objects.begin(), scene.objects.end(), transformed)) return {};
    Transforms transforms{compose(scene.transforms), {}, {}, {}};
    transforms.inverse.resize(scene.transforms.size());
    for (const TransformNode& node : scene.transforms) {
        const auto parent = static_cast<std::size_t>(node.parent);
        std::optional<Real> factor = node.parent < 0 ? 1 : transforms.similarity[parent];
        bool turns = node.parent >= 0 && transforms.turns[parent];
        if (const auto* scale = std::get_if<Scale>(&node.step)) {
            const Vec3 by = glm::abs(scale->by);
            factor = factor && by.x == by.y && by.y == by.z ? std::optional(*factor * by.x) : std::nullopt;
            turns = turns || by != scale->by;
        }
        turns = turns || std::holds_alternative<Rotate>(node.step);
        transforms.similarity.push_back(factor);
        transforms.turns.push_back(turns);
    }
    return transforms;
}

/// A triangle with what its corners know.
struct Face {
    Triangle triangle;
    std::optional<TriangleNormals> normals;
    std::optional<TriangleUvs> uvs;
};

Face face_of(const Mesh& mesh, const std::array<Mesh::Corner, 3>& corners) {
    const auto [a, b, c] = corners;
    const auto at = [](const auto& list, std::int32_t i) { return list[static_cast<std::size_t>(i)]; };
    Face face;
    face.triangle = {at(mesh.positions, a.position), at(mesh.positions, b.position),
                     at(mesh.positions, c.position)};
    if (a.normal >= 0 && b.normal >= 0 && c.normal >= 0)
        face.normals = {at(mesh.normals, a.normal), at(mesh.normals, b.normal), at(mesh.normals, c.normal)};
    if (a.uv >= 0 && b.uv >= 0 && c.uv >= 0)
        face.uvs = {at(mesh.uvs, a.uv), at(mesh.uvs, b.uv), at(mesh.uvs, c.uv)};
    return face;
}

/// Meshes that are flattened by more are not shared: the sphere around an instance is met like a ball, and
/// that must not lose a triangle.
constexpr Real most_flattening_of_instance = 1e7;

/// How much longer the longest half-axis of a ball's image is than the shortest; too much by a factor of 3 at
/// most.
Real flattening_of(const Transform& t) {
    Real there = 0, back = 0;
    for (int column = 0; column < 3; ++column) {
        there += dot(Vec3(t.to_world[column]), Vec3(t.to_world[column]));
        back += dot(Vec3(t.to_local[column]), Vec3(t.to_local[column]));
    }
    return std::sqrt(there) * std::sqrt(back);
}

/// Unit normals at the corners, so that those of the file weigh alike when they are interpolated.
TriangleNormals unit_normals(const TriangleNormals& n) { return {unit(n.a), unit(n.b), unit(n.c)}; }

TriangleNormals flat_normals(const Triangle& t) {
    const Vec3 n = cross(unit(t.b - t.a), unit(t.c - t.a));
    return {n, n, n};
}

/// Texture coordinates of a triangle that has none: the weights of its corners b and c.
constexpr TriangleUvs weights{{0, 0}, {1, 0}, {0, 1}};

Sphere bound_of(const Mesh& mesh) {
    Vec3 low(infinity), high(-infinity);
    for (const Vec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
    const Vec3 center = 0.5 * low + 0.5 * high;
    Real radius = 0;
    for (const Vec3& p : mesh.positions) radius = std::max(radius, glm::length(p - center));
    // Wider by 2^-20, so that rounding in the sphere test cannot lose a triangle for rays from up to a
    // million radii away.
    return {center, radius * (1 + 0x1p-20)};
}

template <class>
struct AllGroups;
template <class... Shape>
struct AllGroups<List<Shape...>> {
    using Tuple = std::tuple<Group<Shape>...>;
};

/// Fills a world from a scene's objects, each kind of shape in a group of its own.
struct Builder {
    Builder(const Scene& from, World& to)
        : scene(from),
          world(to),
          transforms(transforms_of(from)),
          uses(from.meshes.size()),
          shared(from.meshes.size()) {
        if (to.needs.refraction || to.needs.colored_shadows) {
            Bodies found = bodies_of(from, to.needs.refraction);
            bodies = std::move(found.of);
            to.sheets = std::move(found.sheets);
        }
        for (const Object& one : from.objects)
            if (const auto* mesh = std::get_if<MeshObject>(&one.shape)) ++uses[mesh->mesh];
    }

    void add_all() {
        for (const Object& one : scene.objects) {
            object = &one;
            transform = transform_of(one);
            std::visit([&](const auto& shape) { add(shape); }, one.shape);
        }
        std::apply([&](auto&... group) { (keep(group), ...); }, groups);
    }

    /// Moves the group into the world, if it has any shapes.
    template <class Shape>
    void keep(Group<Shape>& group) {
        if (!group.shapes.empty()) {
            if constexpr (requires(const Shape& shape) { shape.transform; }) world.needs.transforms = true;
            world.groups.emplace_back(std::move(group));
            place_shapes(world, world.groups.size() - 1);
        }
        // Smooth triangles are a group beside that of the flat ones.
        if constexpr (std::is_same_v<Shape, Triangle>)
            if (&group != &smooth) keep(smooth);
    }

    /// The transform of an object. Each step on the way to it is looked at, so that nothing is lost in the
    /// middle of a chain that later steps could not bring back.
    std::optional<Transform> transform_of(const Object& one) {
        if (one.transform < 0) return std::nullopt;
        std::vector<std::size_t> chain;
        for (int i = one.transform; i >= 0 && !transforms.inverse[static_cast<std::size_t>(i)];
             i = scene.transforms[static_cast<std::size_t>(i)].parent)
            chain.push_back(static_cast<std::size_t>(i));
        for (auto node = chain.rbegin(); node != chain.rend(); ++node) {
            const auto complain = [&](std::string_view what) {
                fail(scene.transforms[*node].place,
                     fmt::format("the transform in force after this step {}", what));
            };
            const Mat4& m = transforms.matrix[*node];
            if (!in_range(m)) complain(fmt::format("has numbers beyond {}", largest_number));
            const std::optional<Mat4> back = inverse(m);
            if (!back) complain("is singular: it has no inverse");
            if (!in_range(Mat3(*back)))
                complain(fmt::format("makes lengths shorter by more than {}", largest_number));
            transforms.inverse[*node] = back;
        }
        const auto node = static_cast<std::size_t>(one.transform);
        return Transform{transforms.matrix[node], *transforms.inverse[node]};
    }

    [[noreturn]] void fail(SourcePlace place, const std::string& what) const {
        throw InputError(fmt::format("{}:{}:{}: {}", scene.file, place.line, place.column, what));
    }

    /// Refuses the object being added if the point is too far away.
    void check_place(const Vec3& p) const {
        if (!in_range(p))
            fail(object->place, fmt::format("coordinates beyond {}: a point of this object is at {} {} {}",
                                            largest_number, p.x, p.y, p.z));
    }

    /// Refuses the object being added if its size is out of range.
    void check_size(const char* noun, Real size) const {
        if (!(size >= smallest_size && size <= largest_number))
            fail(object->place, fmt::format("{} from {} to {} can be drawn, but this is {}", noun,
                                            smallest_size, largest_number, size));
    }

    /// Corners that are all in the same place, or on one line, are no error: there is nothing to see.
    void check_corners(std::span<const Vec3> corners) const {
        Vec3 low(infinity), high(-infinity);
        for (const Vec3& corner : corners) {
            check_place(corner);
            low = glm::min(low, corner), high = glm::max(high, corner);
        }
        if (low != high) check_size("faces", std::min(size_of(high - low), largest_number));
    }

    /// A ball that is too flat, or too far away in a parallel projection, would be drawn wrong by rounding.
    void check_ball(const Vec3& center, Real shortest, Real longest, Real flattening) const {
        const Camera& camera = scene.camera;
        if (camera.projection == Projection::Perspective) {
            const Real most = most_flattening * std::min(Real(1), camera.fovy);
            if (!(flattening <= 3 * most))
                fail(object->place,
                     fmt::format("a ball that is flattened too much: by at most {:.2g} it can be drawn here",
                                 most));
            return;
        }
        // What is smaller than a pixel shows nothing that could be wrong.
        const bool is_seen = longest * largest_side >= camera.view_height;
        const Real far = glm::length(center - camera.eye);
        if (is_seen && !(far <= most_flattening * shortest))
            fail(
                object->place,
                fmt::format("a ball whose shortest half-axis, {:.2g}, is less than 1/{} of its distance from "
                            "the eye; bring the eye of the parallel projection nearer",
                            shortest, most_flattening));
    }

    Vec3 point(const Vec3& p) const { return transform ? transform_point(transform->to_world, p) : p; }
    Vec3 normal(const Vec3& n) const { return transform ? transform_normal(transform->to_local, n) : n; }

    /// Appends a shape to a group, as the next primitive of the file.
    template <class Shape>
    void append(Group<Shape>& group, Shape shape) {
        const auto number = static_cast<std::uint32_t>(world.primitives.size());
        const auto own = static_cast<std::uint32_t>(object - scene.objects.data());
        const std::uint32_t body = bodies.empty() ? own : bodies[own];
        if (body != own) world.faces.push_back({number, own});
        group.primitive.push_back(number);
        group.shapes.push_back(std::move(shape));
        world.primitives.push_back({.material = object->material, .object = body});
    }
    template <class Shape>
    void append(Shape shape) {
        append(std::get<Group<Shape>>(groups), std::move(shape));
    }

    /// A shape that stands in the file as it stands in the world.
    template <class Shape>
    void add(const Shape& shape) {
        if (!transform) return append_checked(shape);
        if constexpr (requires { transformed(shape, *transform); })
            if (const std::optional<Shape> moved = transformed(shape, *transform))
                return append_checked(*moved);
        append_checked(Placed<Shape>{*transform, shape});
    }

    /// Refuses a shape whose bounds are out of range.
    template <class Shape>
    void append_checked(const Shape& shape) {
        if constexpr (requires { bounds_of(shape); }) {
            const auto box = bounds_of(shape);
            check_place(box.low);
            check_place(box.high);
            check_size("sizes", size_of(box.high - box.low));
        }
        append(shape);
    }

    void add(const Plane& plane) {
        // Of any length in the file; no plane is another by a power of two.
        const Plane baked{point(plane.point), near_one(normal(near_one(plane.normal)))};
        check_place(baked.point);
        append(baked);
    }

    void add(const Sphere& sphere) {
        const auto node = static_cast<std::size_t>(object->transform);
        const std::optional<Real> factor = transform ? transforms.similarity[node] : 1;
        // A sphere that is turned is the same sphere, but for its texture coordinates.
        if (factor && !(world.needs.uvs && transform && transforms.turns[node])) {
            const Sphere baked{point(sphere.center), sphere.radius * *factor};
            check_place(baked.center);
            check_size("radii", baked.radius);
            check_ball(baked.center, baked.radius, baked.radius, 1);
            append(baked);
            return;
        }
        // The ellipsoid is the unit sphere's image, so the sphere's own centre and radius join the map.
        const Real r = sphere.radius;
        Mat4 from_unit(r), to_unit(1 / r);
        from_unit[3] = Vec4(sphere.center, 1);
        to_unit[3] = Vec4(-sphere.center / r, 1);
        check_size("radii", r);
        const Ellipsoid ellipsoid{{transform->to_world * from_unit, to_unit * transform->to_local}, {}};
        check_ellipsoid(ellipsoid.transform);
        append(ellipsoid);
    }

    /// For the map from the unit ball.
    void check_ellipsoid(const Transform& map) const {
        Real there = 0, back = 0;
        for (int i = 0; i < 3; ++i) {
            there = std::max(there, size_of(Vec3(map.to_world[i])));
            back = std::max(back, size_of(Vec3(map.to_local[i])));
        }
        check_place(Vec3(map.to_world[3]));
        check_size("half-axes", there);
        check_size("half-axes", 1 / back);
        check_ball(Vec3(map.to_world[3]), 1 / back, there, flattening_of(map));
    }

    void add(const Face& face) {
        const Triangle& t = face.triangle;
        const Triangle baked{point(t.a), point(t.b), point(t.c)};
        check_corners(std::array{baked.a, baked.b, baked.c});
        const bool is_smooth = world.needs.normals && face.normals;
        if (is_smooth) {
            // Not made unit vectors again: the map is linear, so interpolating its images is the same as
            // mapping what was interpolated, as instances do.
            const TriangleNormals n = unit_normals(*face.normals);
            smooth.normals.push_back({normal(n.a), normal(n.b), normal(n.c)});
        }
        Group<Triangle>& group = is_smooth ? smooth : std::get<Group<Triangle>>(groups);
        if (world.needs.uvs) group.uvs.push_back(face.uvs.value_or(weights));
        append(group, baked);
    }

    void add(const TriangleObject& triangle) {
        const auto [i, j, k] = triangle.vertex;
        const auto& v = scene.vertices;
        const auto& s = scene.smooth_vertices;
        if (triangle.smooth)
            add(Face{{s[i].position, s[j].position, s[k].position},
                     TriangleNormals{s[i].normal, s[j].normal, s[k].normal},
                     {}});
        else
            add(Face{{v[i], v[j], v[k]}, {}, {}});
    }

    void add(const PolygonObject& polygon) {
        Polygon shape;
        for (const std::uint32_t index : polygon.vertex)
            shape.vertices.push_back(point(scene.vertices[index]));
        check_corners(shape.vertices);
        append(std::move(shape));
    }

    void add(const MeshObject& shown) {
        const Mesh& mesh = scene.meshes[shown.mesh];
        const bool too_flat = transform && !(flattening_of(*transform) <= 3 * most_flattening_of_instance);
        if (uses[shown.mesh] == 1 || too_flat) {
            for (const auto& corners : mesh.triangles) add(face_of(mesh, corners));
            return;
        }
        std::shared_ptr<SharedMesh>& one = shared[shown.mesh];
        if (!one) {
            one = std::make_shared<SharedMesh>(share(mesh));
            world.meshes.push_back(one);
        }
        const Instance instance{transform.value_or(Transform{}), {one}};
        check_instance(instance.transform, one->bound);
        append(instance);
    }

    /// A mesh that instances share must be in range in its own space, too, and so its image.
    void check_instance(const Transform& map, const Sphere& bound) const {
        check_place(bound.center + bound.radius);
        check_place(bound.center - bound.radius);
        if (bound.radius > 0) check_size("meshes", bound.radius);
        Real reach = 0;
        for (int row = 0; row < 3; ++row)
            reach = std::max(
                reach, glm::length(Vec3(map.to_world[0][row], map.to_world[1][row], map.to_world[2][row])));
        const Vec3 center = transform_point(map.to_world, bound.center);
        check_place(center + reach * bound.radius);
        check_place(center - reach * bound.radius);
    }

    SharedMesh share(const Mesh& mesh) const {
        SharedMesh result;
        Group<Triangle>& triangles = result.triangles;
        for (const auto& corners : mesh.triangles) {
            const Face face = face_of(mesh, corners);
            triangles.shapes.push_back(face.triangle);
            if (world.needs.normals && !mesh.normals.empty())
                triangles.normals.push_back(face.normals ? unit_normals(*face.normals)
                                                         : flat_normals(face.triangle));
            if (world.needs.uvs) triangles.uvs.push_back(face.uvs.value_or(weights));
        }
        result.bound = bound_of(mesh);
        return result;
    }

    const Scene& scene;
    World& world;
    Transforms transforms;
    std::vector<std::size_t> uses;                    ///< how many objects show each mesh
    std::vector<std::shared_ptr<SharedMesh>> shared;  ///< each mesh that several do

    std::vector<std::uint32_t> bodies;  ///< as Bodies::of

    const Object* object = nullptr;      ///< the one being added,
    std::optional<Transform> transform;  ///< and its transform

    AllGroups<Shapes>::Tuple groups;
    Group<Triangle> smooth;
};

}  // namespace

void add_primitives(const Scene& scene, World& world) { Builder(scene, world).add_all(); }

void place_shapes(World& world, std::size_t group) {
    const auto number = static_cast<std::uint32_t>(group);
    std::visit(
        [&](const auto& of) {
            for (std::uint32_t i = 0; i < of.primitive.size(); ++i) {
                world.primitives[of.primitive[i]].group = number;
                world.primitives[of.primitive[i]].index = i;
            }
        },
        world.groups[group]);
}

}  // namespace rt
