// Commands that put objects into the scene, and the vertices that some of them are made of.
#include "common/scene/language/arguments.hpp"
#include "common/scene/language/commands.hpp"
#include "common/scene/mesh_file.hpp"

#include <system_error>
#include <utility>

namespace rt::language {

namespace {

/// The shape as an object, with the material and transform in force.
void add_object(Parser& parser, FileShape shape) {
    std::vector<Material>& materials = parser.scene.materials;
    if (materials.empty() || !(materials.back() == parser.material)) materials.push_back(parser.material);
    parser.scene.objects.push_back({std::move(shape), static_cast<std::uint32_t>(materials.size() - 1),
                                    parser.transform, place_of(parser, parser.words[0])});
}

void add_triangle(Parser& parser) {
    TriangleObject triangle;
    for (std::size_t i = 0; i < 3; ++i)
        triangle.vertex[i] = index(parser, i + 1, parser.scene.vertices.size(), "vertex");
    add_object(parser, triangle);
}

void add_smooth_triangle(Parser& parser) {
    TriangleObject triangle{{}, true};
    for (std::size_t i = 0; i < 3; ++i)
        triangle.vertex[i] = index(parser, i + 1, parser.scene.smooth_vertices.size(), "vertexnormal");
    add_object(parser, triangle);
}

void add_polygon(Parser& parser) {
    PolygonObject polygon;
    for (std::size_t i = 1; i < parser.words.size(); ++i)
        polygon.vertex.push_back(index(parser, i, parser.scene.vertices.size(), "vertex"));
    add_object(parser, std::move(polygon));
}

void read_new_mesh(Parser& parser, const std::filesystem::path& path, std::string_view word) {
    std::vector<std::string> warnings;
    try {
        parser.scene.meshes.push_back(
            read_mesh(path, {.lenient = parser.options.lenient, .warnings = &warnings}));
    } catch (const InputError& problem) {
        fail(parser, word, std::string("mesh ") + problem.what());
    }
    for (const std::string& warning : warnings) warn(parser, word.data(), "mesh " + warning);
    parser.scene.meshes.back().file = word;
}

void add_mesh(Parser& parser) {
    if (!parser.options.meshes) fail(parser, parser.words[0], "mesh files are not read here");
    const std::string_view word = parser.words[1];
    const std::filesystem::path path = parser.directory / std::filesystem::path(word);
    std::error_code error;
    const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, error);
    const auto [found, is_new] = parser.mesh_of_file.try_emplace(
        error ? path.string() : canonical.string(), static_cast<std::uint32_t>(parser.scene.meshes.size()));
    if (is_new) read_new_mesh(parser, path, word);
    add_object(parser, MeshObject{found->second});
}

const CommandRow rows[] = {
    {{"plane", "px py pz nx ny nz",
      "Plane through (px, py, pz) with the normal (nx, ny, nz), of any length but 0.", "01"},
     [](Parser& p) {
         add_object(p, Plane{vec3(p, 1), direction(p, 4, "the normal")});
     }},
    {{"sphere", "x y z r", "Sphere with centre (x, y, z) and radius r > 0.", "02"},
     [](Parser& p) {
         add_object(p, Sphere{vec3(p, 1), positive(p, 4, "the radius")});
     }},
    {{"maxverts", "n",
      "Number of `vertex` lines to expect; accepted because old scenes say it, and not trusted.", "03"},
     [](Parser& p) { whole(p, 1, "the number of vertices", 0, 0x1p53); }},
    {{"maxvertnorms", "n", "The same for `vertexnormal` lines.", "03"},
     [](Parser& p) { whole(p, 1, "the number of vertices", 0, 0x1p53); }},
    {{"vertex", "x y z", "Appended to the list of vertices, which are counted from 0; not transformed here.",
      "03"},
     [](Parser& p) { p.scene.vertices.push_back(vec3(p, 1)); }},
    {{"tri", "a b c",
      "Triangle of three vertices, counterclockwise seen from the side that its normal points to.", "03"},
     add_triangle},
    {{"vertexnormal", "x y z nx ny nz",
      "Appended to a second list, of vertices with normals, of any length but 0; also counted from 0.", "03"},
     [](Parser& p) {
         p.scene.smooth_vertices.push_back({vec3(p, 1), direction(p, 4, "the normal")});
     }},
    {{"trinormal", "a b c", "Triangle of three vertices of the second list, with interpolated normals.",
      "03"},
     add_smooth_triangle},
    {{"polygon", "i j k ...", "Planar polygon of three vertices or more of the first list, in order.", "03"},
     add_polygon},
    {{"mesh", "file.obj",
      "The triangles of a Wavefront file, its path relative to the scene's; the name is without blanks. A "
      "file that several objects name is read once.",
      "03"},
     add_mesh},
};

}  // namespace

std::span<const CommandRow> shape_commands() { return rows; }

}  // namespace rt::language
