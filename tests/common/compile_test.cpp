// From a scene to a world: what is kept, baked, shared and left out, and that pictures depend on nothing
// else.
#include "common/render/compile.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "common/image/file.hpp"
#include "common/math/error.hpp"
#include "common/povray/shapes.hpp"
#include "common/render/explain.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "common/world/query.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

using namespace rt;
namespace fs = std::filesystem;

namespace {

constexpr auto head = "version 1\nsize 40 30\ncamera 0 0 5  0 0 0  0 1 0  40\n";

Scene scene_of(const std::string& commands) {
    return parse_scene_text(head + commands, "small.scene", test::scratch_directory());
}

World world_of(const std::string& commands) { return compile(scene_of(commands)); }

/// The group if it is of this kind, with a grid or without.
template <class GroupType>
const GroupType* group_in(const AnyGroup& any) {
    return std::visit(
        []<class Kind>(const Kind& group) -> const GroupType* {
            if constexpr (std::is_base_of_v<GroupType, Kind>) return &group;
            return nullptr;
        },
        any);
}

/// The group of one kind, which must be there.
template <class GroupType>
const GroupType& group_of(const World& world) {
    for (const AnyGroup& any : world.groups)
        if (const GroupType* group = group_in<GroupType>(any)) return *group;
    FAIL("the world has no such group");
    throw 0;
}

template <class GroupType>
bool has(const World& world) {
    return std::any_of(world.groups.begin(), world.groups.end(),
                       [](const AnyGroup& any) { return group_in<GroupType>(any) != nullptr; });
}

std::string error_of(const std::string& commands) {
    return test::error_of([&] { world_of(commands); });
}

/// Writes a mesh of one square, in the plane z = 0, and returns the command that shows it.
std::string square_mesh(bool smooth = false) {
    const std::string name = smooth ? "square_smooth.obj" : "square.obj";
    std::string obj = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
    obj += smooth ? "vn -1 0 1\nvn 1 0 1\nf 1//1 2//2 3//2\nf 1//1 3//2 4//1\n" : "f 1 2 3\nf 1 3 4\n";
    write_file(fs::path(test::scratch_directory()) / name, obj);
    return "mesh " + name + "\n";
}

bool says(const std::vector<Reason>& reasons, const std::string& what, const std::string& why) {
    return std::any_of(reasons.begin(), reasons.end(),
                       [&](const Reason& reason) { return reason.what == what && reason.why == why; });
}

Explanation explained(const std::string& commands) {
    const Scene scene = scene_of(commands);
    return explain(scene, compile(scene));
}

bool same_bits(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && a.pixels == b.pixels;
}

const std::string lit = "directional 0 1 1  1 1 1\ndiffuse .5 .5 .5\n";

}  // namespace

// ---------------------------------------------------------------------------------------------- baking

TEST_CASE("the triangles of a mesh that is shown once take their transform into their corners", "[compile]") {
    const World world = world_of("translate 10 0 0\nscale 2 1 1\n" + square_mesh());
    CHECK(world.meshes.empty());
    CHECK_FALSE(world.needs.transforms);
    const Group<Triangle>& triangles = group_of<Group<Triangle>>(world);
    REQUIRE(triangles.shapes.size() == 2);
    CHECK(triangles.shapes[0].a == Vec3(8, -1, 0));
    CHECK(triangles.shapes[0].b == Vec3(12, -1, 0));
    CHECK(triangles.shapes[1].c == Vec3(8, 1, 0));
}

TEST_CASE("so do triangles, polygons and planes of the file", "[compile]") {
    const World world = world_of(
        "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nscale 2 3 1\ntri 0 1 2\npolygon 0 1 2\nplane 0 1 0  1 1 "
        "0\n");
    CHECK_FALSE(world.needs.transforms);
    CHECK(group_of<Group<Triangle>>(world).shapes[0].c == Vec3(0, 3, 0));
    CHECK(group_of<Group<Polygon>>(world).shapes[0].vertices[1] == Vec3(2, 0, 0));
    const Plane& plane = group_of<Group<Plane>>(world).shapes[0];
    CHECK(plane.point == Vec3(0, 3, 0));
    // The plane x + y = 1 becomes x/2 + y/3 = 1.
    CHECK(std::abs(plane.normal.x * 2 - plane.normal.y * 3) <= gamma(4));
}

TEST_CASE("normals of smooth triangles are baked by the inverse transpose", "[compile]") {
    const World world = world_of(
        "integrator normals\nscale 2 1 1\nvertexnormal 0 0 0 1 1 0\nvertexnormal 1 0 0 1 1 0\n"
        "vertexnormal 0 1 0 1 1 0\ntrinormal 0 1 2\n");
    const Vec3 n = group_of<Group<Triangle>>(world).normals[0].a;
    CHECK(2 * n.x == n.y);
}

TEST_CASE("a sphere under turns, moves and one scale for all axes is a sphere", "[compile]") {
    const World world =
        world_of("translate 1 2 3\nrotate 1 2 3 40\nscale 2 2 2\nscale -1 1 1\nsphere 0 0 0 1.5\n");
    CHECK_FALSE(world.needs.transforms);
    const Sphere& sphere = group_of<Group<Sphere>>(world).shapes[0];
    CHECK(sphere.radius == 3);
    CHECK(sphere.center == Vec3(1, 2, 3));
}

TEST_CASE("a sphere that shows texture coordinates keeps its matrices where it was turned", "[compile]") {
    CHECK(has<Group<Ellipsoid>>(world_of("integrator uv\nrotate 0 1 0 90\nsphere 0 0 0 1\n")));
    CHECK(has<Group<Sphere>>(world_of("integrator uv\ntranslate 0 1 0\nsphere 0 0 0 1\n")));
    CHECK(has<Group<Sphere>>(world_of("integrator normals\nrotate 0 1 0 90\nsphere 0 0 0 1\n")));
}

TEST_CASE("a sphere under different scales keeps its matrices: the unit sphere's way to it", "[compile]") {
    const World world = world_of("scale 2 1 1\nsphere 1 0 0 .5\n");
    CHECK(world.needs.transforms);
    const Transform& transform = group_of<Group<Ellipsoid>>(world).shapes[0].transform;
    CHECK(transform_point(transform.to_world, {1, 0, 0}) == Vec3(3, 0, 0));
    CHECK(transform_point(transform.to_world, {0, 1, 0}) == Vec3(2, 0.5, 0));
    CHECK(transform_point(transform.to_local, {3, 0, 0}) == Vec3(1, 0, 0));
}

TEST_CASE("a reflection keeps working for every kind of object", "[compile]") {
    // Seen in the mirror x → −x, each picture is the other way round, and its red of normals too.
    const std::string objects =
        "vertex -1 -1 0\nvertex 1 -1 0.5\nvertex -.2 1 0\nvertexnormal -1 -1 -1 -1 0 1\nvertexnormal 1 -1 -1 "
        "1 0 1\n"
        "vertexnormal 0 1 -1 0 1 1\n"
        "tri 0 1 2\ntrinormal 0 1 2\nplane 0 -1.2 0 .2 1 0\nsphere .7 .5 .3 .4\npushTransform\nscale 1 .4 "
        ".7\n"
        "sphere -.8 .3 .4 .5\npopTransform\npushTransform\ntranslate 1 1 -1\nrotate 1 1 0 30\n" +
        square_mesh(true) + "popTransform\ntranslate -1 .4 -2\nscale .5 1 1\n" + square_mesh(true);
    const Image plain = render(world_of("integrator normals\n" + objects)).image;
    const Image mirrored = render(world_of("integrator normals\nscale -1 1 1\n" + objects)).image;
    int different = 0;
    for (int y = 0; y < plain.height; ++y)
        for (int x = 0; x < plain.width; ++x) {
            Vec3 there = pixel(mirrored, plain.width - 1 - x, y);
            const Vec3 here = pixel(plain, x, y);
            if (here != Vec3(0)) there.x = 1 - there.x;
            // Rounding is not symmetric; at silhouettes it may decide.
            different += length(there - here) > 1e-9;
        }
    CAPTURE(different);
    CHECK(different <= 2);
}

TEST_CASE("in a mirror every face keeps its texture coordinates", "[compile]") {
    const std::string objects =
        "vertex -1 -1 0\nvertex 0 -1 0.5\nvertex 0.1 1 0.5\nvertex -.9 0.8 0\n"
        "polygon 0 1 2 3\ntranslate 1.1 0 0\ntri 0 1 2\n" +
        square_mesh(true);
    const Image plain = render(world_of("integrator uv\n" + objects)).image;
    const Image mirrored = render(world_of("integrator uv\nscale -1 1 1\n" + objects)).image;
    int different = 0, seen = 0;
    for (int y = 0; y < plain.height; ++y)
        for (int x = 0; x < plain.width; ++x) {
            const Vec3 here = pixel(plain, x, y), there = pixel(mirrored, plain.width - 1 - x, y);
            seen += here.x != here.y;
            different += length(there - here) > 1e-9;
        }
    INFO(
        "a polygon, a triangle and a mesh under `integrator uv`, and all of it under `scale -1 1 1`: pixels "
        "that are "
        "not the mirrored picture's");
    CAPTURE(seen);
    CHECK(seen > 100);
    CHECK(different <= 2);
}

// --------------------------------------------------------------------------------------------- sharing

TEST_CASE("a mesh that is shown twice is kept once, in its own space", "[compile]") {
    const std::string mesh = square_mesh();
    const World world = world_of("translate 1 0 0\n" + mesh + "translate 1 0 0\n" + mesh + mesh);
    REQUIRE(world.meshes.size() == 1);
    CHECK(world.needs.transforms);
    CHECK(world.meshes[0]->triangles.shapes[0].a == Vec3(-1, -1, 0));
    const Group<Instance>& instances = group_of<Group<Instance>>(world);
    REQUIRE(instances.shapes.size() == 3);
    CHECK(instances.shapes[0].transform.to_world[3] == Vec4(1, 0, 0, 1));
    CHECK(instances.shapes[2].transform.to_world[3] == Vec4(2, 0, 0, 1));
    CHECK_FALSE(has<Group<Triangle>>(world));
}

TEST_CASE("the sphere around a shared mesh holds all its corners", "[compile]") {
    const std::string mesh = square_mesh();
    const World world = world_of(mesh + mesh);
    const SharedMesh& shared = *world.meshes.at(0);
    for (const Triangle& t : shared.triangles.shapes)
        for (const Vec3& corner : {t.a, t.b, t.c})
            CHECK(length(corner - shared.bound.center) < shared.bound.radius);
    CHECK(shared.bound.radius < 1.001 * std::sqrt(2.0));
}

TEST_CASE("a forest of 1024 trees needs the memory of one tree and of the matrices", "[compile]") {
    Scene scene = parse_scene(fs::path(test::repository()) / "references/04_transforms/forest.scene");
    scene.accelerator = AcceleratorChoice::None;
    const World world = compile(scene);
    const std::size_t triangles = 10'000, trees = 1024;
    REQUIRE(world.meshes.size() == 1);
    CHECK(world.meshes[0]->triangles.shapes.size() == triangles);
    CHECK(group_of<Group<Instance>>(world).shapes.size() >= 1000);
    // Where each tree went, and its own colour, is all there is beside its two matrices.
    const std::size_t a_tree =
        sizeof(Instance) + sizeof(std::uint32_t) + sizeof(Primitive) + sizeof(Material);
    const std::size_t bytes = explain(scene, world).bytes;
    CAPTURE(bytes);
    CHECK(bytes <= triangles * sizeof(Triangle) + (trees + 1) * a_tree);
    CHECK(bytes >= triangles * sizeof(Triangle) + trees * sizeof(Instance));
    CHECK(bytes * 300 < trees * triangles * sizeof(Triangle));
}

TEST_CASE("an instance is seen where the same mesh, baked, is seen", "[compile]") {
    // The same file by another name is another mesh, so it is shown once and baked.
    const std::string mesh = square_mesh(true);
    fs::copy_file(fs::path(test::scratch_directory()) / "square_smooth.obj",
                  fs::path(test::scratch_directory()) / "square_again.obj",
                  fs::copy_options::overwrite_existing);
    const std::string place = "integrator normals\nrotate 1 2 0 35\nscale -1.5 1 .5\n";
    const World baked = world_of(place + "mesh square_again.obj\n");
    const World shared = world_of(place + mesh + "translate 0 0 -1000\n" + mesh);
    CHECK(baked.meshes.empty());
    REQUIRE(shared.meshes.size() == 1);
    const Image a = render(baked).image, b = render(shared).image;
    int different = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        // Interpolating normals before or after a map that stretches is not the same: silhouettes are
        // compared.
        different += (a.pixels[i] == Vec3(0)) != (b.pixels[i] == Vec3(0));
    CHECK(different == 0);
}

// ---------------------------------------------------------------------------------------------- errors

TEST_CASE("a singular transform is an error with the place of the step that made it so", "[compile]") {
    // Flattened to a 1e-20th along a slanted line: of the digits that remain of its thickness, none is right.
    const std::string flat = "rotate 0 0 1 45\nscale 1 1e-20 1\nrotate 0 0 1 30\nsphere 0 0 0 1\n";
    CHECK(error_of(flat) ==
          "small.scene:6:1: the transform in force after this step is singular: it has no inverse");
    CHECK(error_of("scale 1e-20 1e-20 1e-20\nsphere 0 0 0 1\n").empty());
    CHECK(error_of("rotate 0 0 1 45\nscale 1 1e-15 1e15\n" + square_mesh()).empty());
    // Nothing stands under it.
    CHECK(error_of("pushTransform\n" + flat.substr(0, flat.find("sphere")) + "popTransform\nsphere 0 0 0 1\n")
              .empty());
}

TEST_CASE("scan conversion refuses what is not made of triangles, with its place", "[compile]") {
    CHECK(error_of("integrator rasterize\nsphere 0 0 0 1\n") ==
          "small.scene:5:1: scan conversion draws triangles only");
    CHECK(error_of("integrator flat\nvisibility rasterize\nplane 0 0 0 0 0 1\n") ==
          "small.scene:6:1: scan conversion draws triangles only");
    CHECK(error_of("integrator rasterize\n" + square_mesh()).empty());
}

// ------------------------------------------------------------------------------------ lights and needs

TEST_CASE("black lights are left out, and all lights where nothing reflects them", "[compile]") {
    const std::string lights =
        "point 0 5 0  0 0 0\npoint 0 5 0  1 0 0\ndirectional 0 1 0  0 0 0\ndirectional 0 3 4  0 0 1\n";
    const World world = world_of(lights + "diffuse .5 .5 .5\nsphere 0 0 0 1\n");
    REQUIRE(world.point_lights.size() == 1);
    CHECK(world.point_lights[0].color == Vec3(1, 0, 0));
    REQUIRE(world.directional_lights.size() == 1);
    CHECK(length(world.directional_lights[0].direction - Vec3(0, .6, .8)) <= gamma(4));
    CHECK(world.needs.lights);
    CHECK(world.needs.shadows);

    const World dark = world_of(lights + "sphere 0 0 0 1\n");
    CHECK(dark.point_lights.empty());
    CHECK(dark.directional_lights.empty());
    CHECK_FALSE(dark.needs.lights);
    CHECK_FALSE(dark.needs.shadows);

    const World flat = world_of("integrator flat\n" + lights + "diffuse .5 .5 .5\nsphere 0 0 0 1\n");
    CHECK_FALSE(flat.needs.lights);
}

TEST_CASE("directions to lights are unit vectors, however long they were written", "[compile]") {
    const World world = world_of(
        "directional 0 3e200 4e200  1 1 1\ndirectional 0 3e-200 4e-200  1 1 1\n"
        "diffuse 1 1 1\nsphere 0 0 0 1\n");
    REQUIRE(world.directional_lights.size() == 2);
    for (const DirectionalLight& light : world.directional_lights)
        CHECK(length(light.direction - Vec3(0, .6, .8)) <= gamma(8));
}

TEST_CASE("a world needs only what its materials ask for", "[compile]") {
    const auto needs = [](const std::string& commands) {
        return world_of(lit + commands + "sphere 0 0 0 1\n").needs;
    };
    CHECK_FALSE(needs("").reflection);
    CHECK_FALSE(needs("").highlights);
    CHECK(needs("specular .5 .5 .5\n").reflection);
    CHECK(needs("specular .5 .5 .5\n").highlights);
    CHECK_FALSE(needs("specular .5 .5 .5\nmaxdepth 0\n").reflection);
    CHECK(needs("specular .5 .5 .5\nmaxdepth 0\n").highlights);
    CHECK(needs("").shadows);
    CHECK_FALSE(needs("shadows off\n").shadows);
    CHECK_FALSE(needs("").colored_shadows);
    CHECK(needs("transmission .5 .5 .5\n").colored_shadows);
    CHECK(needs("transmission .5 .5 .5\n").refraction);
    CHECK_FALSE(needs("transmission .5 .5 .5\n").reflection);
    CHECK(needs("transmission .5 .5 .5\nior 1.5\n").reflection);
    CHECK_FALSE(needs("transmission .5 .5 .5\n").absorption);
    CHECK(needs("transmission .5 .5 .5\nabsorption 1 0 0\n").absorption);
    CHECK_FALSE(needs("").patterns);
    CHECK(needs("checker 1 1 1 .5 .5 .5 1\n").patterns);
    CHECK_FALSE(needs("").uvs);
    CHECK(needs("integrator uv\n").uvs);
}

TEST_CASE("normals are kept only where the picture shows them", "[compile]") {
    const std::string mesh = square_mesh(true);
    CHECK(group_of<Group<Triangle>>(world_of("integrator normals\n" + mesh)).normals.size() == 2);
    CHECK(group_of<Group<Triangle>>(world_of("integrator flat\n" + mesh)).normals.empty());
    CHECK(group_of<Group<Triangle>>(world_of(mesh)).normals.empty());
    CHECK(group_of<Group<Triangle>>(world_of(lit + mesh)).normals.size() == 2);
    CHECK(world_of("integrator normals\n" + mesh + mesh).meshes[0]->triangles.normals.size() == 2);
    CHECK(world_of("integrator flat\n" + mesh + mesh).meshes[0]->triangles.normals.empty());
    CHECK(group_of<Group<Triangle>>(world_of("integrator uv\n" + mesh)).uvs.size() == 2);
}

TEST_CASE("only kinds that occur have a group, and a picture of directions has none", "[compile]") {
    CHECK(world_of("sphere 0 0 0 1\n").groups.size() == 1);
    CHECK(world_of("").groups.empty());
    CHECK(world_of("integrator directions\nsphere 0 0 0 1\n").groups.empty());
    const World world = world_of("sphere 0 0 0 1\nplane 0 -1 0 0 1 0\nsphere 0 0 0 2\n");
    CHECK(world.groups.size() == 2);
    REQUIRE(world.primitives.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(world.primitives[i].object == i);
    CHECK(group_of<Group<Sphere>>(world).primitive == std::vector<std::uint32_t>{0, 2});
}

TEST_CASE("a checker is two materials, and a material without one is one", "[compile]") {
    const World world =
        world_of("ambient .5 .5 .5\nsphere 0 0 0 1\nchecker 1 1 1 .5 .5 .5 2\nplane 0 -1 0 0 1 0\n");
    REQUIRE(world.patterns.size() == world.materials.size());
    const std::uint32_t of_plane = world.primitives[1].material;
    CHECK(world.patterns[of_plane].size == 2);
    CHECK(world.materials[world.patterns[of_plane].odd].ambient == Vec3(.25));
    CHECK(world.patterns[world.primitives[0].material].size == 0);
    CHECK(world_of("sphere 0 0 0 1\n").patterns.empty());
}

// --------------------------------------------------------------------------------------------- explain

TEST_CASE("explain says what was kept and what was left out, and why", "[explain]") {
    const Explanation plain = explained("integrator normals\nsphere 0 0 0 1\n");
    CHECK(says(plain.kept, "1 sphere", "in one array"));
    CHECK(says(plain.left_out, "matrices", "no object is transformed"));
    CHECK(says(plain.left_out, "shadow rays", "no lights"));
    CHECK(says(plain.left_out, "interpolated normals", "no smooth triangle whose normal the picture shows"));
    CHECK(plain.chapters == std::vector<std::string>{"01", "02"});

    const Explanation moved = explained("integrator normals\ntranslate 1 0 0\nsphere 0 0 0 1\n");
    CHECK(says(moved.left_out, "matrices", "every transform is baked into its shape"));
    CHECK(moved.chapters == std::vector<std::string>{"01", "02", "04"});

    const Explanation stretched =
        explained("integrator normals\nscale 2 1 1\nsphere 0 0 0 1\nsphere 0 1 0 1\n");
    CHECK(says(stretched.kept, "2 ellipsoids with their matrices", "in one array"));
    CHECK(says(stretched.kept, "matrices", "some shapes cannot take their transform into their own numbers"));

    const std::string mesh = square_mesh();
    const Explanation shared = explained("integrator normals\n" + mesh + mesh);
    CHECK(says(shared.kept, "2 shared triangles", "one mesh that several objects show"));
    CHECK(shared.chapters == std::vector<std::string>{"01", "03", "04"});
}

TEST_CASE("explain counts lights that were left out", "[explain]") {
    const std::string lights = "point 0 5 0  0 0 0\npoint 0 5 0  1 0 0\n";
    const Explanation some = explained(lights + "diffuse 1 1 1\nsphere 0 0 0 1\n");
    CHECK(says(some.kept, "1 light", "they reach some material"));
    CHECK(says(some.left_out, "1 light", "black"));
    CHECK(says(explained(lights + "sphere 0 0 0 1\n").left_out, "2 lights",
               "no material reflects light, or all lights are black"));
    CHECK(says(explained("integrator flat\n" + lights + "sphere 0 0 0 1\n").left_out, "2 lights",
               "the integrator asks no lights"));
    CHECK(says(explained(lit + "shadows off\nsphere 0 0 0 1\n").left_out, "shadow rays",
               "the scene says 'shadows off'"));
}

TEST_CASE("explain names the chapters whose code a picture runs", "[explain]") {
    using Names = std::vector<std::string>;
    CHECK(explained(lit + "shadows off\nsphere 0 0 0 1\n").chapters == Names{"01", "02", "05"});
    CHECK(explained(lit + "sphere 0 0 0 1\n").chapters == Names{"01", "02", "05", "06"});
    CHECK(explained(lit + "specular .5 .5 .5\nsphere 0 0 0 1\n").chapters ==
          Names{"01", "02", "05", "06", "07"});
    CHECK(explained("integrator directions\nsphere 0 0 0 1\n").chapters == Names{"01"});
}

TEST_CASE("memory is counted: a group is as large as its shapes", "[explain]") {
    const auto bytes = [](const std::string& commands) { return explained(commands).bytes; };
    const std::string sphere = "sphere 0 0 0 1\n";
    const std::size_t one = bytes(sphere), three = bytes(sphere + sphere + sphere);
    CHECK(three - one == 2 * (sizeof(Sphere) + sizeof(Primitive) + sizeof(std::uint32_t)));
    const std::string mesh = square_mesh();
    CHECK(bytes(mesh + mesh + mesh) - bytes(mesh + mesh) ==
          sizeof(Instance) + sizeof(Primitive) + sizeof(std::uint32_t));
}

// ------------------------------------------------------------------------------------- ties and pictures

TEST_CASE("of equal distances the first in the file wins, whatever the kinds", "[compile]") {
    // All of them are met at exactly t = 5 by a ray along −z from (0, 0, 5).
    const std::string mesh = square_mesh();
    const std::vector<std::string> objects{
        "plane 0 0 0  0 0 1\n",
        "sphere 0 0 -1 1\n",
        "tri 0 1 2\n",
        "polygon 0 1 2\n",
        "pushTransform\nscale 2 1 1\nsphere 0 0 -1 1\npopTransform\n",
        "pushTransform\ntranslate .25 .125 0\n" + mesh + "popTransform\n",
    };
    const std::string vertices = "vertex -2 -2 0\nvertex 2 -2 0\nvertex 0 2 0\n";
    // Shown a second time, far away, so that it is an instance.
    const std::string elsewhere = "translate 0 0 -99\n" + mesh;
    for (const std::string& first : objects)
        for (const std::string& second : objects) {
            const World world = world_of(vertices + first + second + elsewhere);
            const Ray ray{{0, 0, 5}, {0, 0, -1}};
            const std::optional<Hit> hit = closest_hit(world, ray, {0, infinity});
            INFO(first << second);
            REQUIRE(hit.has_value());
            CHECK(hit->t == 5);
            CHECK(hit->primitive == 0);
        }
}

namespace {

/// All the scenes of the references, small enough to be drawn several times.
std::vector<Scene> reference_scenes() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(test::repository()) / "references"))
        if (entry.path().extension() == ".scene") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Scene> scenes;
    for (const fs::path& file : files) {
        Scene scene = parse_scene(file);
        const bool large = scene.objects.size() > 500 ||
                           std::any_of(scene.meshes.begin(), scene.meshes.end(),
                                       [](const Mesh& m) { return m.triangles.size() > 9999; });
        scene.width = large ? 12 : 32;
        scene.height = large ? 9 : 24;
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

/// Whether the texture of the object is measured in units of length.
bool has_picture_in_units(const Scene& scene, const Object& object) {
    const std::int32_t texturing = scene.materials[object.material].texturing;
    return std::holds_alternative<Plane>(object.shape) && texturing >= 0 &&
           scene.texturings[static_cast<std::size_t>(texturing)].picture;
}

// Lights with an extent, with lengths times `unit`.
void enlarge(QuadLight& quad, Real unit) { quad.corner *= unit, quad.ab *= unit, quad.ac *= unit; }
void enlarge(DiscLight& disc, Real unit) { disc.center *= unit, disc.radius *= unit; }
void enlarge(SphereLight& sphere, Real unit) { sphere.center *= unit, sphere.radius *= unit; }
void enlarge(TriangleLight& triangle, Real unit) {
    triangle.a *= unit, triangle.b *= unit, triangle.c *= unit;
}

/// The scene in another unit of length: every length times 2^k. Attenuation and absorption are per length.
Scene in_other_units(Scene scene, int k) {
    const Real unit = std::ldexp(Real(1), k);
    Camera& camera = scene.camera;
    camera.eye *= unit, camera.look_at *= unit, camera.view_height *= unit;
    scene.lens.radius *= unit, scene.lens.distance *= unit, scene.camera_motion *= unit;
    for (AreaLightObject& object : scene.area_lights)
        std::visit([unit](auto& shape) { enlarge(shape, unit); }, object.light.shape);
    for (Vec3& v : scene.vertices) v *= unit;
    for (SmoothVertex& v : scene.smooth_vertices) v.position *= unit;
    for (Mesh& mesh : scene.meshes)
        for (Vec3& p : mesh.positions) p *= unit;
    for (Material& m : scene.materials) m.checker.size *= unit, m.absorption /= unit;
    for (Texturing& t : scene.texturings) {
        if (t.pattern) t.pattern->size *= unit;
        t.bumps.height *= unit, t.bumps.size *= unit;
    }
    for (TransformNode& node : scene.transforms)
        if (auto* move = std::get_if<Translate>(&node.step)) move->by *= unit;
    for (std::vector<Object>* objects : {&scene.objects, &scene.parts})
        for (Object& object : *objects) {
            object.motion *= unit;
            if (has_picture_in_units(scene, object)) {
                scene.transforms.push_back({object.transform, Scale{Vec3(unit)}, object.place});
                object.transform = static_cast<int>(scene.transforms.size()) - 1;
                continue;
            }
            const bool has_vertices = std::holds_alternative<TriangleObject>(object.shape) ||
                                      std::holds_alternative<PolygonObject>(object.shape);
            if (!has_vertices) povray::scale(scene, object, unit);
        }
    for (Light& light : scene.lights)
        if (auto* point = std::get_if<PointLight>(&light)) {
            point->position *= unit;
            point->attenuation.y /= unit;
            point->attenuation.z /= unit * unit;
        }
    return scene;
}

}  // namespace

TEST_CASE("every scene of the references has the same bits at 1, 2 and 7 threads", "[compile][references]") {
    for (const Scene& scene : reference_scenes()) {
        INFO(scene.file);
        const World world = compile(scene);
        const Image one = render(world, {.threads = 1, .progress = {}}).image;
        CHECK(same_bits(one, render(world, {.threads = 2, .progress = {}}).image));
        CHECK(same_bits(one, render(world, {.threads = 7, .progress = {}}).image));
    }
}

TEST_CASE("every scene of the references has the same bits in other units of length",
          "[compile][references]") {
    for (const Scene& scene : reference_scenes()) {
        const Image plain = render(compile(scene)).image;
        for (const int k : {-40, 40}) {
            INFO(scene.file << ", lengths times 2^" << k);
            CHECK(same_bits(plain, render(compile(in_other_units(scene, k))).image));
        }
    }
}

TEST_CASE("a scale around the whole scene changes no bit of the picture", "[compile]") {
    const std::string mesh = square_mesh(true);
    const std::string objects =
        "pushTransform\nrotate 1 2 3 40\nscale 1.3 .4 .7\nsphere .3 -.2 .1 .9\npopTransform\n"
        "sphere -1 .5 0 .4\npushTransform\ntranslate 1 1 -1\nrotate 1 1 0 30\n" +
        mesh + "popTransform\ntranslate -1 .4 -2\nscale .5 1 1\n" + mesh;
    const Image plain = render(world_of("integrator normals\n" + objects)).image;
    for (const int k : {-40, -3, 7, 40}) {
        const std::string unit = fmt::format("{:.17g}", std::ldexp(1.0, k));
        Scene scene = scene_of(fmt::format("integrator normals\nscale {0} {0} {0}\n", unit) + objects);
        scene.camera.eye *= std::ldexp(1.0, k);
        CAPTURE(k);
        CHECK(same_bits(plain, render(compile(scene)).image));
    }
}

TEST_CASE("the eye is inside a plane of glass where it is behind it, wherever it faces", "[compile]") {
    const auto inside = [](const Vec3& at, const Vec3& normal) {
        return world_of(fmt::format("transmission 1 1 1\nior 1.5\nplane {} {} {} {} {} {}\n", at.x, at.y,
                                    at.z, normal.x, normal.y, normal.z))
            .eye_inside.size();
    };
    const Vec3 eye(0, 0, 5);
    for (int axis = 0; axis < 3; ++axis)
        for (const Real side : {1., -1.}) {
            Vec3 normal(0);
            normal[axis] = side;
            CAPTURE(axis, side);
            CHECK(inside(eye + 2. * normal, normal) == 1);
            CHECK(inside(eye - 2. * normal, normal) == 0);
        }
}
