// The objects of a scene as the primitives of a world.
#include "common/render/primitives.hpp"

#include "common/render/bodies.hpp"
#include "common/render/combinations.hpp"
#include "common/render/faces.hpp"
#include "common/render/groups.hpp"
#include "common/render/object_limits.hpp"
#include "common/render/object_transforms.hpp"
#include "common/scene/closed_mesh.hpp"
#include "common/scene/range.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace rt {
namespace {

/// Meshes that are flattened by more are not shared: the sphere around an instance is met like a ball, and
/// that must not lose a triangle.
constexpr Real most_flattening_of_instance = 1e7;

template <class Shape, class... Listed>
constexpr bool is_in(List<Listed...>) {
    return (std::is_same_v<Shape, Listed> || ...);
}

template <class Shape, class... Listed>
constexpr bool is_solid(std::type_identity<std::variant<Listed...>>) {
    return is_in<Shape>(List<Listed...>());
}

template <class>
struct AllGroups;
template <class... Shape>
struct AllGroups<List<Shape...>> {
    using Tuple = std::tuple<Group<Shape>...>;
};

/// Fills a world from a scene's objects, each kind of shape in a group of its own.
struct PrimitiveBuilder {
    PrimitiveBuilder(const Scene& from, World& to)
        : scene(from),
          world(to),
          transforms(from),
          uses(from.meshes.size()),
          shared(from.meshes.size()),
          outwards(from.meshes.size()),
          first_light_material(static_cast<std::uint32_t>(from.materials.size())) {
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
            transform = transforms.of(one);
            is_mirrored = transform && glm::determinant(Mat3(transform->to_world)) < 0;
            spin = last_spin(one);
            std::visit([&](const auto& shape) { add(shape); }, one.shape);
        }
        object = nullptr;
        world.area_lights.first_primitive = static_cast<std::uint32_t>(world.primitives.size());
        for (std::uint32_t i = 0; i < scene.area_lights.size(); ++i)
            std::visit([&](const auto& shape) { add_light(shape, i); }, scene.area_lights[i].light.shape);
        std::apply([&](auto&... group) { (keep(group), ...); }, groups);
    }

    // Lights are there to be seen, and stand in each other's way.

    template <class Shape>
    void append_light(const Shape& shape, std::uint32_t light) {
        Group<Shape>& group = std::get<Group<Shape>>(groups);
        group.primitive.push_back(static_cast<std::uint32_t>(world.primitives.size()));
        group.shapes.push_back(shape);
        if constexpr (std::is_same_v<Shape, Triangle>)
            if (world.needs.uvs) group.uvs.push_back(weights);
        world.primitives.push_back({.material = first_light_material + light,
                                    .object = static_cast<std::uint32_t>(scene.objects.size()) + light});
        world.area_lights.of.push_back(light);
    }
    void add_light(const QuadLight& quad, std::uint32_t light) {
        const Vec3 b = quad.corner + quad.ab, c = b + quad.ac, d = quad.corner + quad.ac;
        append_light(Triangle{quad.corner, b, c}, light);
        append_light(Triangle{quad.corner, c, d}, light);
    }
    void add_light(const DiscLight& disc, std::uint32_t light) {
        append_light(Disc{disc.center, disc.normal, disc.radius}, light);
    }
    void add_light(const SphereLight& sphere, std::uint32_t light) {
        append_light(Sphere{sphere.center, sphere.radius}, light);
    }
    void add_light(const TriangleLight& triangle, std::uint32_t light) {
        append_light(Triangle{triangle.a, triangle.b, triangle.c}, light);
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

    ObjectLimits limits() const { return {scene, *object}; }

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
        static_assert(is_in<Shape>(Shapes()), "this shape is missing in Shapes (common/world/shapes.hpp)");
        if constexpr (!has_uv<Shape>)
            if (shows_picture())
                limits().fail("this " + std::string(words_of(object->shape).name) +
                              " has no texture coordinates for its picture");
        if (tree) {
            // Shapes without an inside have been refused where the file was read.
            if constexpr (is_solid<Shape>(std::type_identity<Solid>())) {
                if constexpr (requires { shape.transform; }) world.needs.transforms = true;
                add_part(*tree, std::move(shape), part_is_taken_away);
                return;
            }
        }
        if (moves()) return append_moving(std::move(shape));
        append(std::get<Group<Shape>>(groups), std::move(shape));
    }

    /// Whether the object's material has something at texture coordinates that the world shows.
    bool shows_picture() const {
        return (!world.textures.empty() && world.textures[object->material].picture.image) ||
               (!world.normal_maps.empty() && world.normal_maps[object->material].image);
    }

    /// Whether its lamps shine through, which depends on what is outside.
    bool is_rough_glass() const {
        const std::int32_t finish = scene.materials[object->material].finish;
        return finish >= 0 && scene.finishes[static_cast<std::size_t>(finish)].kind == FinishKind::Glass;
    }

    bool moves() const { return object->motion != Vec3(0) || spin >= 0; }

    /// The last step of the object's transform that turns, which is the same for all parts of a combination;
    /// −1 if none does.
    int last_spin(const Object& of) const {
        const auto* whole = std::get_if<CombinationObject>(&of.shape);
        if (!whole) return transforms.last_spin(of);
        const int first = last_spin(scene.parts[whole->parts.front()]);
        for (const std::uint32_t part : whole->parts)
            if (last_spin(scene.parts[part]) != first)
                refuse(scene, scene.parts[part].place,
                       "the parts of one solid turn together: say 'spin' before the solid, not in it");
        return first;
    }

    /// Appends a shape that moves or turns as its object does.
    template <class Shape>
    void append_moving(Shape shape) {
        if constexpr (std::is_constructible_v<Still, Shape>) {
            if (spin < 0)
                append_bounded(Moving{object->motion, std::move(shape)});
            else
                append_bounded(Turning{transforms.turns_until(spin), object->motion, std::move(shape)});
        } else {
            const std::string shown = "this " + std::string(words_of(object->shape).name);
            limits().fail(spin < 0
                              ? shown + " has no end, and so it cannot move: say 'motion 0 0 0' before it"
                              : shown + " has no end, and so it cannot turn: say 'popTransform' before it");
        }
    }

    template <class Shape>
    void append_bounded(Shape moving) {
        const Bounds box = bounds_of(moving);
        limits().check_place(box.low);
        limits().check_place(box.high);
        append(std::get<Group<Shape>>(groups), std::move(moving));
    }

    /// A shape that stands in the file as it stands in the world.
    template <class Shape>
    void add(const Shape& shape) {
        if (!transform) return append_checked(shape);
        // What is turned may be the same shape, but for its texture coordinates.
        if constexpr (requires { transformed(shape, *transform); })
            if (!keeps_its_turn())
                if (const std::optional<Shape> moved = transformed(shape, *transform))
                    return append_checked(*moved);
        append_checked(Placed<Shape>{*transform, shape});
    }

    /// Whether it shows how the object is turned, even if its outline does not.
    bool keeps_its_turn() const { return world.needs.uvs && transforms.turns(*object); }

    /// Refuses a shape whose bounds are out of range.
    template <class Shape>
    void append_checked(const Shape& shape) {
        if constexpr (has_bounds<Shape>()) {
            const Bounds box = bounds_of(shape);
            limits().check_place(box.low);
            limits().check_place(box.high);
            limits().check_size("sizes", size_of(box.high - box.low));
        }
        append(shape);
    }

    void add(const Plane& plane) {
        // Of any length in the file; no plane is another by a power of two.
        const Plane baked{point(plane.point), near_one(normal(near_one(plane.normal)))};
        limits().check_place(baked.point);
        if (transform && world.needs.uvs)
            append(Placed<Plane>{*transform, {plane.point, near_one(plane.normal)}});
        else
            append(baked);
    }

    void add(const Sphere& sphere) {
        const std::optional<Real> factor = transforms.similarity(*object);
        if (factor && !keeps_its_turn()) {
            const Sphere baked{point(sphere.center), sphere.radius * *factor};
            limits().check_place(baked.center);
            limits().check_size("radii", baked.radius);
            limits().check_ball(baked.center, baked.radius, baked.radius, 1);
            append(baked);
            return;
        }
        // The ellipsoid is the unit sphere's image, so the sphere's own centre and radius join the map.
        const Real r = sphere.radius;
        Mat4 from_unit(r), to_unit(1 / r);
        from_unit[3] = Vec4(sphere.center, 1);
        to_unit[3] = Vec4(-sphere.center / r, 1);
        limits().check_size("radii", r);
        const Ellipsoid ellipsoid{{transform->to_world * from_unit, to_unit * transform->to_local}, {}};
        limits().check_ellipsoid(ellipsoid.transform);
        append(ellipsoid);
    }

    void add(const Face& face) {
        const bool is_smooth = world.needs.normals && face.normals;
        if (moves() && (is_smooth || world.needs.uvs)) {
            check_corners(face.triangle);
            return add_moving(face);
        }
        if (is_mirrored)
            bake(other_way_round(face), is_smooth);
        else
            bake(face, is_smooth);
    }

    Triangle check_corners(const Triangle& t) const {
        const Triangle baked{point(t.a), point(t.b), point(t.c)};
        limits().check_corners(std::array{baked.a, baked.b, baked.c});
        return baked;
    }

    void bake(const Face& face, bool is_smooth) {
        const Triangle baked = check_corners(face.triangle);
        if (is_smooth) {
            // Not made unit vectors again: the map is linear, so interpolating its images is the same as
            // mapping what was interpolated, as instances do.
            const TriangleNormals n = unit_normals(*face.normals);
            smooth.normals.push_back({normal(n.a), normal(n.b), normal(n.c)});
        }
        Group<Triangle>& group = is_smooth ? smooth : std::get<Group<Triangle>>(groups);
        if (moves()) return append(baked);
        if (world.needs.uvs) group.uvs.push_back(face.uvs.value_or(weights));
        append(group, baked);
    }

    /// A triangle that moves is a mesh of its own if its corners know more than their places.
    void add_moving(const Face& face) {
        const std::int32_t normal = face.normals ? 0 : -1, uv = face.uvs ? 0 : -1;
        Mesh mesh;
        mesh.positions = {face.triangle.a, face.triangle.b, face.triangle.c};
        if (face.normals) mesh.normals = {face.normals->a, face.normals->b, face.normals->c};
        if (face.uvs) mesh.uvs = {face.uvs->a, face.uvs->b, face.uvs->c};
        auto& corners = mesh.triangles.emplace_back();
        for (std::int32_t i = 0; i < 3; ++i)
            corners[static_cast<std::size_t>(i)] = {i, normal < 0 ? -1 : i, uv < 0 ? -1 : i};
        world.meshes.push_back(std::make_shared<SharedMesh>(share(mesh, world.needs)));
        append_instance(world.meshes.back());
    }

    void append_instance(const std::shared_ptr<SharedMesh>& mesh) {
        const Instance instance{transform.value_or(Transform{}), {mesh}};
        limits().check_instance(instance.transform, mesh->bound);
        append(instance);
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
        // A picture lies between the corners that were named last, first and second.
        const bool has_place = shows_picture() || row_of(scene.integrator).uvs;
        if (is_mirrored && !has_place) std::reverse(shape.vertices.begin() + 1, shape.vertices.end());
        if (is_mirrored && shows_picture() && is_rough_glass())
            limits().fail(
                "a polygon of rough glass with a picture that 'scale' mirrors: make it of triangles");
        limits().check_corners(shape.vertices);
        if (shows_picture() && texture_point(shape, shape.vertices.front(), 0).du == Vec3(0))
            limits().fail(
                "the corner of this polygon between its last, first and second vertex, which tells "
                "where its picture lies, is straight: begin with another vertex");
        append(std::move(shape));
    }

    void add(const MeshObject& shown) {
        const Mesh& mesh = scene.meshes[shown.mesh];
        const bool too_flat = transform && !(flattening_of(*transform) <= 3 * most_flattening_of_instance);
        if (tree) check_part(shown.mesh, too_flat);
        if (moves() && too_flat) limits().fail("a mesh that is flattened too much to move");
        if (!tree && !moves() && (uses[shown.mesh] == 1 || too_flat)) {
            for (const auto& corners : mesh.triangles) add(face_of(mesh, corners));
            return;
        }
        std::shared_ptr<SharedMesh>& one = shared[shown.mesh];
        if (!one) {
            one = std::make_shared<SharedMesh>(share(mesh, world.needs));
            world.meshes.push_back(one);
        }
        append_instance(one);
    }

    void add(const CombinationObject& whole) {
        Combination made;
        tree = &made;
        add_parts(whole, false);
        find_common_planes(made);
        tree = nullptr;
        const Bounds box = bounds_of(made);
        if (box.low.x > box.high.x)
            limits().fail("nothing is left of this solid: what is intersected here has nothing in common");
        if (size_of(box.low) == infinity || size_of(box.high) == infinity)
            limits().fail(
                "a solid without an end: what is made of planes must be intersected with something else");
        append_checked(made);
    }

    /// Adds the parts to the tree, and joins them; returns what the tree calls the whole.
    std::int32_t add_parts(const CombinationObject& whole, bool is_taken_away) {
        const Object* const outer = object;
        std::vector<std::int32_t> solids;
        for (const std::uint32_t part : whole.parts) {
            object = &scene.parts[part];
            transform = transforms.of(*object);
            part_is_taken_away =
                is_taken_away != (whole.operation == SetOperation::Difference && !solids.empty());
            if (const auto* inner = std::get_if<CombinationObject>(&object->shape)) {
                solids.push_back(add_parts(*inner, part_is_taken_away));
                continue;
            }
            std::visit([&](const auto& shape) { add(shape); }, object->shape);
            solids.push_back(static_cast<std::int32_t>(tree->parts.size()) - 1);
        }
        object = outer;
        return join(*tree, whole.operation, solids);
    }

    /// Refuses a mesh that is no solid.
    void check_part(std::uint32_t mesh, bool too_flat) {
        if (too_flat) limits().fail("a mesh that is flattened too much to be part of another solid");
        if (!outwards[mesh]) outwards[mesh] = looks_outwards(scene.meshes[mesh]);
        if (!*outwards[mesh])
            limits().fail(
                "a mesh that encloses nothing cannot be part of a solid: each edge must have a face on "
                "either side, and all faces must look outwards");
    }

    const Scene& scene;
    World& world;
    ObjectTransforms transforms;
    std::vector<std::size_t> uses;                    ///< how many objects show each mesh
    std::vector<std::shared_ptr<SharedMesh>> shared;  ///< each mesh that several do
    std::vector<std::optional<bool>> outwards;        ///< whether each mesh looks outwards; asked for once

    const std::uint32_t first_light_material;  ///< index into World::materials; each light has its own

    std::vector<std::uint32_t> bodies;  ///< as Bodies::of

    const Object* object = nullptr;      ///< the one being added,
    std::optional<Transform> transform;  ///< its transform,
    bool is_mirrored = false;            ///< whether that turns the way round a face, and so its outside,
    int spin = -1;                       ///< and, as last_spin, its turns

    Combination* tree = nullptr;      ///< whose parts are being added, if any are,
    bool part_is_taken_away = false;  ///< and on which side of it the part is

    AllGroups<Shapes>::Tuple groups;
    Group<Triangle> smooth;
};

}  // namespace

void add_primitives(const Scene& scene, World& world) { PrimitiveBuilder(scene, world).add_all(); }

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
