// A mesh becomes a mesh2: lists of positions, normals and texture coordinates, and of the faces' indices.
#include "common/povray/mesh.hpp"

#include "common/povray/optics.hpp"
#include "common/povray/placement.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace rt::povray {
namespace {

/// A list `name { n, <...>, ... }`, one element a line.
template <class Range, class Text>
void write_list(Writer& out, std::string_view name, const Range& range, Text text) {
    out.line("  {} {{ {}", name, range.size());
    for (const auto& element : range) out.line("    , {}", text(element));
    out.line("  }}");
}

using Face = std::array<Mesh::Corner, 3>;
using Indices = std::vector<std::array<std::size_t, 3>>;

void write_indices(Writer& out, std::string_view name, const Indices& indices) {
    write_list(out, name, indices,
               [](const auto& face) { return fmt::format("<{}, {}, {}>", face[0], face[1], face[2]); });
}

Vec3 face_normal(const Mesh& mesh, const Face& face) {
    const auto at = [&](std::size_t i) { return mesh.positions[static_cast<std::size_t>(face[i].position)]; };
    const Vec3 n = glm::cross(at(1) - at(0), at(2) - at(0));
    const Real length = glm::length(n);
    return length > 0 ? n / length : Vec3(0, 0, 1);
}

/// For each face the indices of its corners' values in a list. Where a corner has no value, all corners of
/// the face get those of `otherwise(face)`, appended to the list.
template <class Value, class Otherwise>
Indices indices_of(const Mesh& mesh, std::int32_t Mesh::Corner::*member, std::vector<Value>& values,
                   Otherwise otherwise) {
    Indices indices;
    for (const Face& face : mesh.triangles) {
        std::array<std::size_t, 3> of_face{};
        if (std::ranges::all_of(face, [&](const Mesh::Corner& c) { return c.*member >= 0; })) {
            for (std::size_t i = 0; i < 3; ++i) of_face[i] = static_cast<std::size_t>(face[i].*member);
        } else {
            for (const Value& value : otherwise(face)) values.push_back(value);
            for (std::size_t i = 0; i < 3; ++i) of_face[i] = values.size() - 3 + i;
        }
        indices.push_back(of_face);
    }
    return indices;
}

/// Whether it matters what is inside the mesh: it is part of another solid, or the eye may be inside a
/// transparent object of it.
bool needs_inside(const Scene& scene, std::size_t mesh) {
    const auto shows = [&](const Object& object) {
        const auto* shown = std::get_if<MeshObject>(&object.shape);
        return shown && shown->mesh == mesh;
    };
    const auto is_around_eye = [&](const Object& object) {
        return shows(object) && is_glass(scene, object) && may_surround_eye(scene, object);
    };
    return std::ranges::any_of(scene.parts, shows) || std::ranges::any_of(scene.objects, is_around_eye);
}

/// Whether an object, or a part of one, shows the mesh with a picture.
bool has_picture_on(const Scene& scene, std::size_t mesh) {
    const auto shows = [&](const Object& object) {
        const auto* shown = std::get_if<MeshObject>(&object.shape);
        const std::int32_t texturing = material_of(scene, object).texturing;
        return shown && shown->mesh == mesh && texturing >= 0 &&
               scene.texturings[static_cast<std::size_t>(texturing)].picture;
    };
    return std::ranges::any_of(scene.objects, shows) || std::ranges::any_of(scene.parts, shows);
}

}  // namespace

void write_mesh(Writer& out, std::size_t index) {
    const Mesh& mesh = out.scene.meshes[index];
    const bool uv = row_of(out.scene.integrator).uvs || has_picture_on(out.scene, index);
    std::vector<Vec3> normals = mesh.normals;
    std::vector<Vec2> uvs = mesh.uvs;
    Indices normal_indices, uv_indices;
    if (!normals.empty())
        normal_indices = indices_of(mesh, &Mesh::Corner::normal, normals, [&](const Face& face) {
            const Vec3 n = face_normal(mesh, face);
            return std::array{n, n, n};
        });
    if (uv)
        uv_indices = indices_of(mesh, &Mesh::Corner::uv, uvs, [](const Face&) {
            return std::array{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
        });

    out.line("#declare Mesh{} = mesh2 {{  // {}", index,
             std::filesystem::path(mesh.file).filename().string());
    write_list(out, "vertex_vectors", mesh.positions, triple);
    if (!normals.empty()) write_list(out, "normal_vectors", normals, triple);
    if (uv)
        write_list(out, "uv_vectors", uvs,
                   [](const Vec2& v) { return fmt::format("<{}, {}>", number(v.x), number(v.y)); });
    write_list(out, "face_indices", mesh.triangles, [](const Face& face) {
        return fmt::format("<{}, {}, {}>", face[0].position, face[1].position, face[2].position);
    });
    if (!normals.empty()) write_indices(out, "normal_indices", normal_indices);
    if (uv) write_indices(out, "uv_indices", uv_indices);
    // Any direction in general position, to tell what is inside.
    if (needs_inside(out.scene, index)) out.line("  inside_vector <0.41, 0.83, 0.37>");
    out.line("}}\n");
}

}  // namespace rt::povray
