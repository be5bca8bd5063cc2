// From a scene as written to a world as rendered.
#include "common/render/compile.hpp"

#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "common/math/input_error.hpp"
#include "common/render/eye_inside.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rt {
namespace {

bool is_zero(const Vec3& v) { return v == Vec3(0); }

[[noreturn]] void fail(const Scene& scene, SourcePlace place, const std::string& what) {
    throw InputError(fmt::format("{}:{}:{}: {}", scene.file, place.line, place.column, what));
}

View view_of(const Scene& scene) {
    const Camera& camera = scene.camera;
    const bool perspective = camera.projection == Projection::Perspective;
    return {.frame = camera_frame(camera),
            .eye = camera.eye,
            .projection = camera.projection,
            .half_height = perspective ? std::tan(camera.fovy / 2) : camera.view_height / 2,
            .width = scene.width,
            .height = scene.height};
}

/// The matrices of a scene's transform tree, and what can be said of them without looking at numbers.
struct Transforms {
    std::vector<Mat4> matrix;
    /// The factor by which a node scales all lengths alike, where its steps say so.
    std::vector<std::optional<Real>> similarity;
};

Transforms transforms_of(const Scene& scene) {
    const auto uses = [](const Object& object) { return object.transform >= 0; };
    if (std::none_of(scene.objects.begin(), scene.objects.end(), uses)) return {};
    Transforms transforms{compose(scene.transforms), {}};
    transforms.similarity.reserve(scene.transforms.size());
    for (const TransformNode& node : scene.transforms) {
        std::optional<Real> factor = 1;
        if (node.parent >= 0) factor = transforms.similarity[static_cast<std::size_t>(node.parent)];
        if (const auto* scale = std::get_if<Scale>(&node.step)) {
            const Vec3 by = glm::abs(scale->by);
            factor = factor && by.x == by.y && by.y == by.z ? std::optional(*factor * by.x) : std::nullopt;
        }
        transforms.similarity.push_back(factor);
    }
    return transforms;
}

/// Fills a world from a scene's objects, one kind of shape at a time in its own group.
class Builder {
public:
    explicit Builder(const Scene& source)
        : scene(source), transforms(transforms_of(source)), uses(source.meshes.size()) {
        for (const Object& one : source.objects)
            if (const auto* mesh = std::get_if<MeshObject>(&one.shape)) ++uses[mesh->mesh];
    }

    void build(World& world) {
        to_shared.assign(scene.meshes.size(), std::nullopt);
        keep_normals = world.needs.normals;
        keep_uvs = world.needs.uvs;
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            object = &scene.objects[i];
            object_index = static_cast<std::uint32_t>(i);
            find_transform();
            std::visit([&](const auto& shape) { add(world, shape); }, object->shape);
        }
        move_group(world, planes, PlaneKind);
        move_group(world, spheres, SphereKind);
        move_group(world, flat, FlatKind);
        move_group(world, smooth, SmoothKind);
        move_group(world, polygons, PolygonKind);
        move_group(world, ellipsoids, EllipsoidKind);
        move_group(world, instances, InstanceKind);
        for (Primitive& primitive : world.primitives) primitive.group = group_of[primitive.group];
        world.needs.transforms = group_of[EllipsoidKind] != none || group_of[InstanceKind] != none;
    }

private:
    enum Kind : std::uint32_t {
        PlaneKind,
        SphereKind,
        FlatKind,
        SmoothKind,
        PolygonKind,
        EllipsoidKind,
        InstanceKind,
        kinds
    };
    static constexpr std::uint32_t none = ~0u;

    void find_transform() {
        transform.reset();
        if (object->transform < 0) return;
        const auto node = static_cast<std::size_t>(object->transform);
        const Mat4& m = transforms.matrix[node];
        const std::optional<Mat4> back = inverse(m);
        if (!back)
            fail(scene, scene.transforms[node].place,
                 "the transform in force after this step is singular: it has no inverse");
        transform = Transform{m, *back};
    }

    Vec3 baked(const Vec3& point) const {
        return transform ? transform_point(transform->to_world, point) : point;
    }
    Vec3 baked_normal(const Vec3& n) const {
        return transform ? transform_normal(transform->to_local, n) : n;
    }

    /// Registers the next primitive of the file, which has just been appended to `group`.
    template <class Shape>
    void registered(World& world, Group<Shape>& group, Kind kind) {
        group.primitive.push_back(static_cast<std::uint32_t>(world.primitives.size()));
        world.primitives.push_back(
            {kind, static_cast<std::uint32_t>(group.shapes.size() - 1), object->material, object_index});
    }

    void add(World& world, const Plane& plane) {
        planes.shapes.push_back({baked(plane.point), baked_normal(plane.normal)});
        registered(world, planes, PlaneKind);
    }

    void add(World& world, const Sphere& sphere) {
        std::optional<Real> factor = 1;
        if (transform) factor = transforms.similarity[static_cast<std::size_t>(object->transform)];
        if (factor) {
            spheres.shapes.push_back({baked(sphere.center), sphere.radius * *factor});
            registered(world, spheres, SphereKind);
            return;
        }
        // The ellipsoid is the unit sphere's image, so the sphere's own centre and radius join the map.
        const Real r = sphere.radius;
        Mat4 unit(r);
        unit[3] = Vec4(sphere.center, 1);
        Mat4 unit_back(1 / r);
        unit_back[3] = Vec4(-sphere.center / r, 1);
        ellipsoids.shapes.push_back({{transform->to_world * unit, unit_back * transform->to_local}});
        registered(world, ellipsoids, EllipsoidKind);
    }

    void add_triangle(World& world, const Triangle& triangle, const TriangleNormals* normals,
                      const TriangleUvs* uvs) {
        Triangles& group = normals ? smooth : flat;
        group.shapes.push_back(triangle);
        if (normals) group.normals.push_back(*normals);
        // The weights of the corners stand for texture coordinates where a triangle has none.
        if (keep_uvs) group.uvs.push_back(uvs ? *uvs : TriangleUvs{{0, 0}, {1, 0}, {0, 1}});
        registered(world, group, normals ? SmoothKind : FlatKind);
    }

    void add(World& world, const TriangleObject& triangle) {
        const auto [i, j, k] = triangle.vertex;
        if (!triangle.smooth) {
            const auto& v = scene.vertices;
            add_triangle(world, {baked(v[i]), baked(v[j]), baked(v[k])}, nullptr, nullptr);
            return;
        }
        const auto& v = scene.smooth_vertices;
        const TriangleNormals normals{baked_normal(v[i].normal), baked_normal(v[j].normal),
                                      baked_normal(v[k].normal)};
        add_triangle(world, {baked(v[i].position), baked(v[j].position), baked(v[k].position)},
                     keep_normals ? &normals : nullptr, nullptr);
    }

    void add(World& world, const PolygonObject& polygon) {
        Polygon shape;
        for (const std::uint32_t index : polygon.vertex)
            shape.vertices.push_back(baked(scene.vertices[index]));
        polygons.shapes.push_back(std::move(shape));
        registered(world, polygons, PolygonKind);
    }

    /// Calls add_triangle(triangle, normals or null, uvs or null) for each triangle of a mesh.
    template <class AddTriangle>
    void triangles_of(const Mesh& mesh, AddTriangle add_one) const {
        for (const auto& corner : mesh.triangles) {
            const auto position = [&](int i) {
                return mesh.positions[static_cast<std::size_t>(corner[static_cast<std::size_t>(i)].position)];
            };
            const auto normal = [&](int i) {
                return mesh.normals[static_cast<std::size_t>(corner[static_cast<std::size_t>(i)].normal)];
            };
            const auto uv = [&](int i) {
                return mesh.uvs[static_cast<std::size_t>(corner[static_cast<std::size_t>(i)].uv)];
            };
            const auto all = [&](auto member) {
                return std::all_of(corner.begin(), corner.end(),
                                   [&](const auto& c) { return c.*member >= 0; });
            };
            const bool has_normals = keep_normals && all(&Mesh::Corner::normal);
            const bool has_uvs = keep_uvs && all(&Mesh::Corner::uv);
            const TriangleNormals normals =
                has_normals ? TriangleNormals{normal(0), normal(1), normal(2)} : TriangleNormals{};
            const TriangleUvs uvs = has_uvs ? TriangleUvs{uv(0), uv(1), uv(2)} : TriangleUvs{};
            add_one(Triangle{position(0), position(1), position(2)}, has_normals ? &normals : nullptr,
                    has_uvs ? &uvs : nullptr);
        }
    }

    void add(World& world, const MeshObject& object_mesh) {
        const Mesh& mesh = scene.meshes[object_mesh.mesh];
        if (uses[object_mesh.mesh] == 1) {
            triangles_of(mesh, [&](const Triangle& t, const TriangleNormals* n, const TriangleUvs* uv) {
                const TriangleNormals turned =
                    n ? TriangleNormals{baked_normal(n->a), baked_normal(n->b), baked_normal(n->c)}
                      : TriangleNormals{};
                add_triangle(world, {baked(t.a), baked(t.b), baked(t.c)}, n ? &turned : nullptr, uv);
            });
            return;
        }
        std::optional<std::uint32_t>& shared = to_shared[object_mesh.mesh];
        if (!shared) {
            shared = static_cast<std::uint32_t>(world.meshes.size());
            world.meshes.push_back(share(mesh));
        }
        instances.shapes.push_back({transform.value_or(Transform{}), *shared});
        registered(world, instances, InstanceKind);
    }

    SharedMesh share(const Mesh& mesh) const {
        SharedMesh shared;
        Triangles& triangles = shared.triangles;
        const auto has_no_normal = [](const auto& corners) {
            return std::any_of(corners.begin(), corners.end(), [](const auto& c) { return c.normal < 0; });
        };
        // All of a shared mesh is smooth, or all of it is flat.
        const bool is_smooth =
            keep_normals && std::none_of(mesh.triangles.begin(), mesh.triangles.end(), has_no_normal);
        triangles_of(mesh, [&](const Triangle& t, const TriangleNormals* n, const TriangleUvs* uv) {
            triangles.shapes.push_back(t);
            if (is_smooth) triangles.normals.push_back(*n);
            if (keep_uvs) triangles.uvs.push_back(uv ? *uv : TriangleUvs{{0, 0}, {1, 0}, {0, 1}});
        });
        shared.bound = bound_of(mesh);
        return shared;
    }

    static Sphere bound_of(const Mesh& mesh) {
        Vec3 low(infinity), high(-infinity);
        for (const Vec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
        const Vec3 center = 0.5 * low + 0.5 * high;
        Real radius = 0;
        for (const Vec3& p : mesh.positions) radius = std::max(radius, glm::length(p - center));
        // Wider by 2^-20, so that rounding in the sphere test cannot lose a triangle for rays from up to
        // a million radii away.
        return {center, radius * (1 + 0x1p-20)};
    }

    template <class GroupType>
    void move_group(World& world, GroupType& group, Kind kind) {
        if (group.shapes.empty()) return;
        group_of[kind] = static_cast<std::uint32_t>(world.groups.size());
        world.groups.emplace_back(std::move(group));
    }

    const Scene& scene;
    Transforms transforms;
    std::vector<std::size_t> uses;  ///< how many objects show each mesh
    std::vector<std::optional<std::uint32_t>> to_shared;
    bool keep_normals = false;
    bool keep_uvs = false;

    const Object* object = nullptr;
    std::uint32_t object_index = 0;
    std::optional<Transform> transform;

    Planes planes;
    Spheres spheres;
    Triangles flat;
    Triangles smooth;
    Polygons polygons;
    Ellipsoids ellipsoids;
    Instances instances;
    std::array<std::uint32_t, kinds> group_of = {none, none, none, none, none, none, none};
};

void compile_materials(const Scene& scene, World& world) {
    world.materials = scene.materials;
    world.patterns.resize(scene.materials.size());
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Checker& checker = scene.materials[i].checker;
        if (checker.even == Vec3(1) && checker.odd == Vec3(1)) continue;
        world.needs.patterns = true;
        const auto tinted = [&](const Vec3& factor) {
            Material m = scene.materials[i];
            m.ambient *= factor, m.diffuse *= factor, m.emission *= factor;
            return m;
        };
        world.materials[i] = tinted(checker.even);
        world.patterns[i] = {checker.size, static_cast<std::uint32_t>(world.materials.size())};
        world.materials.push_back(tinted(checker.odd));
    }
    world.patterns.resize(world.needs.patterns ? world.materials.size() : 0);
}

void compile_lights(const Scene& scene, World& world) {
    const auto reflects = [](const Material& m) { return !is_zero(m.diffuse) || !is_zero(m.specular); };
    if (!std::any_of(world.materials.begin(), world.materials.end(), reflects)) return;
    for (const Light& light : scene.lights) {
        if (const auto* point = std::get_if<PointLight>(&light); point && !is_zero(point->color))
            world.point_lights.push_back(*point);
        if (const auto* far = std::get_if<DirectionalLight>(&light); far && !is_zero(far->color)) {
            // Scaled first, so that no length overflows.
            const Vec3 a = glm::abs(far->direction);
            const Vec3 d = far->direction / std::max({a.x, a.y, a.z});
            world.directional_lights.push_back({glm::normalize(d), far->color});
        }
    }
}

void derive_needs(const Scene& scene, World& world) {
    Needs& needs = world.needs;
    const auto any = [&](auto has) {
        return std::any_of(world.materials.begin(), world.materials.end(), has);
    };
    const bool raytrace = scene.integrator == Integrator::Raytrace;
    if (raytrace) {
        compile_lights(scene, world);
        needs.lights = !world.point_lights.empty() || !world.directional_lights.empty();
        needs.highlights = needs.lights && any([](const Material& m) { return !is_zero(m.specular); });
        needs.shadows = needs.lights && scene.shadows;
        const bool bounces = scene.max_depth > 0;
        needs.refraction = bounces && any([](const Material& m) { return !is_zero(m.transmission); });
        needs.reflection = bounces && any([](const Material& m) {
                               // Glass mirrors by Fresnel's law, and where its reflection is total.
                               const bool glass = !is_zero(m.transmission) && m.ior != 1;
                               return !is_zero(m.specular) || glass;
                           });
        needs.absorption = needs.refraction && any([](const Material& m) { return !is_zero(m.absorption); });
        needs.colored_shadows =
            needs.shadows && any([](const Material& m) { return !is_zero(m.transmission); });
    }
    const bool shows_normals =
        scene.integrator == Integrator::Normals || scene.integrator == Integrator::Rasterize;
    const auto is_smooth = [&](const Object& object) {
        if (const auto* t = std::get_if<TriangleObject>(&object.shape)) return t->smooth;
        if (const auto* m = std::get_if<MeshObject>(&object.shape))
            return !scene.meshes[m->mesh].normals.empty();
        return false;
    };
    needs.normals = (shows_normals || needs.lights || needs.reflection || needs.refraction) &&
                    std::any_of(scene.objects.begin(), scene.objects.end(), is_smooth);
    needs.uvs = scene.integrator == Integrator::Uv;
}

}  // namespace

World compile(const Scene& scene) {
    World world;
    world.view = view_of(scene);
    world.background = scene.background;
    world.integrator = scene.integrator;
    world.max_depth = scene.max_depth;
    world.min_contribution = scene.min_contribution;
    // A picture of ray directions looks at no object at all.
    if (scene.integrator == Integrator::Directions) return world;
    compile_materials(scene, world);
    derive_needs(scene, world);
    Builder(scene).build(world);
    if (scene.integrator == Integrator::Rasterize)
        for (const Object& object : scene.objects)
            if (!std::holds_alternative<TriangleObject>(object.shape) &&
                !std::holds_alternative<MeshObject>(object.shape))
                fail(scene, object.place, "scan conversion draws triangles only");
    if (world.needs.refraction) world.eye_inside = objects_around_eye(world);
    return world;
}

}  // namespace rt
