// The objects of a scene as the primitives of a world.
#include "common/render/primitives.hpp"

#include "chapters/04_transforms/transform.hpp"
#include "common/math/input_error.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace rt {
namespace {

/// The matrices of a scene's transform tree, and what can be said of them without looking at numbers.
struct Transforms {
    std::vector<Mat4> matrix;
    std::vector<std::optional<Real>> similarity;  ///< the factor for all lengths alike, if there is one
    std::vector<bool> turns;                      ///< whether directions are turned or mirrored
};

Transforms transforms_of(const Scene& scene) {
    const auto transformed = [](const Object& object) { return object.transform >= 0; };
    if (std::none_of(scene.objects.begin(), scene.objects.end(), transformed)) return {};
    Transforms transforms{compose(scene.transforms), {}, {}};
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

/// The vector with length 1; it may be as short or long as numbers go.
Vec3 unit(const Vec3& v) {
    const Vec3 size = glm::abs(v);
    return normalize(v / std::max({size.x, size.y, size.z}));
}

/// Unit normals at the corners, so that those of the file weigh alike when they are interpolated.
TriangleNormals unit(const TriangleNormals& n) { return {unit(n.a), unit(n.b), unit(n.c)}; }

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

/// Fills a world from a scene's objects, each kind of shape in its own group.
struct Builder {
    enum Kind {
        PlaneKind,
        SphereKind,
        FlatKind,
        SmoothKind,
        PolygonKind,
        EllipsoidKind,
        InstanceKind,
        kinds
    };

    Builder(const Scene& from, World& to)
        : scene(from),
          world(to),
          transforms(transforms_of(from)),
          uses(from.meshes.size()),
          shared(from.meshes.size()) {
        for (const Object& one : from.objects)
            if (const auto* mesh = std::get_if<MeshObject>(&one.shape)) ++uses[mesh->mesh];
    }

    void add_all() {
        for (const Object& one : scene.objects) {
            object = &one;
            transform = transform_of(one);
            std::visit([&](const auto& shape) { add(shape); }, one.shape);
        }
        std::array<std::uint32_t, kinds> group_of{};
        const auto keep = [&](auto& group, Kind kind) {
            group_of[kind] = static_cast<std::uint32_t>(world.groups.size());
            if (!group.shapes.empty()) world.groups.emplace_back(std::move(group));
        };
        world.needs.transforms = !ellipsoids.shapes.empty() || !instances.shapes.empty();
        keep(planes, PlaneKind);
        keep(spheres, SphereKind);
        keep(flat, FlatKind);
        keep(smooth, SmoothKind);
        keep(polygons, PolygonKind);
        keep(ellipsoids, EllipsoidKind);
        keep(instances, InstanceKind);
        for (Primitive& primitive : world.primitives) primitive.group = group_of[primitive.group];
    }

    std::optional<Transform> transform_of(const Object& one) const {
        if (one.transform < 0) return std::nullopt;
        const auto node = static_cast<std::size_t>(one.transform);
        const Mat4& m = transforms.matrix[node];
        if (const std::optional<Mat4> back = inverse(m)) return Transform{m, *back};
        const SourcePlace place = scene.transforms[node].place;
        throw InputError(
            fmt::format("{}:{}:{}: the transform in force after this step is singular: it has no inverse",
                        scene.file, place.line, place.column));
    }

    Vec3 point(const Vec3& p) const { return transform ? transform_point(transform->to_world, p) : p; }
    Vec3 normal(const Vec3& n) const { return transform ? transform_normal(transform->to_local, n) : n; }

    /// Appends a shape to its group, as the next primitive of the file.
    template <class AnyGroup, class Shape>
    void append(AnyGroup& group, Kind kind, Shape shape) {
        group.primitive.push_back(static_cast<std::uint32_t>(world.primitives.size()));
        world.primitives.push_back({kind, static_cast<std::uint32_t>(group.shapes.size()), object->material,
                                    static_cast<std::uint32_t>(object - scene.objects.data())});
        group.shapes.push_back(std::move(shape));
    }

    void add(const Plane& plane) {
        append(planes, PlaneKind, Plane{point(plane.point), normal(plane.normal)});
    }

    void add(const Sphere& sphere) {
        const auto node = static_cast<std::size_t>(object->transform);
        const std::optional<Real> factor = transform ? transforms.similarity[node] : 1;
        // A sphere that is turned is the same sphere, but for its texture coordinates.
        if (factor && !(world.needs.uvs && transform && transforms.turns[node])) {
            append(spheres, SphereKind, Sphere{point(sphere.center), sphere.radius * *factor});
            return;
        }
        // The ellipsoid is the unit sphere's image, so the sphere's own centre and radius join the map.
        const Real r = sphere.radius;
        Mat4 from_unit(r), to_unit(1 / r);
        from_unit[3] = Vec4(sphere.center, 1);
        to_unit[3] = Vec4(-sphere.center / r, 1);
        append(ellipsoids, EllipsoidKind,
               Ellipsoid{{transform->to_world * from_unit, to_unit * transform->to_local}});
    }

    void add(const Face& face) {
        const Triangle& t = face.triangle;
        const Triangle baked{point(t.a), point(t.b), point(t.c)};
        const bool is_smooth = world.needs.normals && face.normals;
        if (is_smooth) {
            // Not made unit vectors again: the map is linear, so interpolating its images is the same as
            // mapping what was interpolated, as instances do.
            const TriangleNormals n = unit(*face.normals);
            smooth.normals.push_back({normal(n.a), normal(n.b), normal(n.c)});
        }
        Triangles& group = is_smooth ? smooth : flat;
        if (world.needs.uvs) group.uvs.push_back(face.uvs.value_or(weights));
        append(group, is_smooth ? SmoothKind : FlatKind, baked);
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
        append(polygons, PolygonKind, std::move(shape));
    }

    void add(const MeshObject& shown) {
        const Mesh& mesh = scene.meshes[shown.mesh];
        if (uses[shown.mesh] == 1) {
            for (const auto& corners : mesh.triangles) add(face_of(mesh, corners));
            return;
        }
        std::optional<std::uint32_t>& index = shared[shown.mesh];
        if (!index) {
            index = static_cast<std::uint32_t>(world.meshes.size());
            world.meshes.push_back(share(mesh));
        }
        append(instances, InstanceKind, Instance{transform.value_or(Transform{}), *index});
    }

    SharedMesh share(const Mesh& mesh) const {
        SharedMesh result;
        Triangles& triangles = result.triangles;
        for (const auto& corners : mesh.triangles) {
            const Face face = face_of(mesh, corners);
            triangles.shapes.push_back(face.triangle);
            if (world.needs.normals && !mesh.normals.empty())
                triangles.normals.push_back(face.normals ? unit(*face.normals) : flat_normals(face.triangle));
            if (world.needs.uvs) triangles.uvs.push_back(face.uvs.value_or(weights));
        }
        result.bound = bound_of(mesh);
        return result;
    }

    const Scene& scene;
    World& world;
    Transforms transforms;
    std::vector<std::size_t> uses;                     ///< how many objects show each mesh
    std::vector<std::optional<std::uint32_t>> shared;  ///< where each mesh went, if several do

    const Object* object = nullptr;      ///< the one being added,
    std::optional<Transform> transform;  ///< and its transform

    Planes planes;
    Spheres spheres;
    Triangles flat;
    Triangles smooth;
    Polygons polygons;
    Ellipsoids ellipsoids;
    Instances instances;
};

}  // namespace

void add_primitives(const Scene& scene, World& world) { Builder(scene, world).add_all(); }

}  // namespace rt
