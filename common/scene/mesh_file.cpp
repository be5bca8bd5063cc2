// Meshes from Wavefront `.obj` files. All is checked first: tinyobjloader, which reads the faces and cuts
// them into triangles, takes a word that is no number for 0 and skips faces whose indices are wrong.
#include "common/scene/mesh_file.hpp"

#include "common/math/input_error.hpp"
#include "common/scene/text.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <utility>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#if defined(__clang__)
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#else
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#endif
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace rt {

namespace {

/// Greatest index from 1 that a face named, and the line where it did.
struct GreatestIndex {
    long value = 0;
    int line = 0;
};

/// What the first pass over a file finds.
struct Checked {
    Mesh mesh;         ///< without its triangles
    std::string text;  ///< the lines that tinyobjloader needs, without comments
    std::size_t triangles = 0;
};

/// Where the first pass is.
struct Place {
    const std::string& name;
    int line = 0;
};

[[noreturn]] void fail(const Place& place, const std::string& what) {
    throw InputError(place.name + ":" + std::to_string(place.line) + ": " + what);
}

/// The first three numbers after the keyword, 0 where there are fewer; all words must be numbers.
Vec3 numbers(const Place& place, const std::vector<std::string_view>& words, std::size_t at_least) {
    if (words.size() <= at_least)
        fail(place, quoted(words[0]) + " needs " + std::to_string(at_least) +
                        (at_least == 1 ? " number" : " numbers") + ", here are " +
                        std::to_string(words.size() - 1));
    Vec3 values(0);
    for (std::size_t i = 1; i < words.size(); ++i) {
        const ParsedNumber number = parse_number(words[i]);
        if (!number.problem.empty()) fail(place, quoted(words[i]) + " " + std::string(number.problem));
        if (i <= 3) values[static_cast<int>(i) - 1] = number.value;
    }
    return values;
}

/// Checks one index of a corner: from 1, or from the end if negative; `count` have been given so far.
void check_index(const Place& place, std::string_view corner, std::string_view word, std::size_t count,
                 const char* plural, GreatestIndex& greatest) {
    long value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || stop != word.data() + word.size())
        fail(place, quoted(corner) + " is not a corner of a face; expected: v, v/vt, v//vn or v/vt/vn");
    if (value == 0) fail(place, quoted(corner) + ": indices count from 1");
    if (value < -static_cast<long>(count))
        fail(place,
             quoted(corner) + ": the number of " + plural + " before this line is " + std::to_string(count));
    if (value > greatest.value) greatest = {value, place.line};
}

/// Throws where a face named an index beyond the `count` of the whole file.
void check_range(const std::string& name, const GreatestIndex& greatest, std::size_t count,
                 const char* noun) {
    if (greatest.value > static_cast<long>(count))
        fail({name, greatest.line}, "there is no " + std::string(noun) + " " +
                                        std::to_string(greatest.value) + ": the file has " +
                                        std::to_string(count));
}

Checked check(std::string_view text, const std::string& name) {
    Checked result;
    Mesh& mesh = result.mesh;
    GreatestIndex position, normal, uv;
    std::vector<std::string_view> words;
    text = without_bom(text);
    const char line_end = line_end_of(text);
    for (Place place{name, 1}; !text.empty(); ++place.line) {
        split_words(take_line(text, line_end), words);
        if (words.empty()) continue;
        if (words[0] == "v") {
            mesh.positions.push_back(numbers(place, words, 3));
        } else if (words[0] == "vn") {
            mesh.normals.push_back(numbers(place, words, 3));
        } else if (words[0] == "vt") {
            mesh.uvs.push_back(Vec2(numbers(place, words, 1)));
        } else if (words[0] == "f") {
            if (words.size() < 4)
                fail(place, "a face needs at least 3 corners, here are " + std::to_string(words.size() - 1));
            result.triangles += words.size() - 3;
            for (std::size_t i = 1; i < words.size(); ++i) {
                const std::string_view corner = words[i];
                const std::size_t first = std::min(corner.find('/'), corner.size());
                const std::size_t second = std::min(corner.find('/', first + 1), corner.size());
                const bool skips_uv = second == first + 1 && second < corner.size();  // v//vn
                check_index(place, corner, corner.substr(0, first), mesh.positions.size(), "vertices",
                            position);
                if (first < corner.size() && !skips_uv)
                    check_index(place, corner, corner.substr(first + 1, second - first - 1), mesh.uvs.size(),
                                "texture coordinates", uv);
                if (second < corner.size())
                    check_index(place, corner, corner.substr(second + 1), mesh.normals.size(), "normals",
                                normal);
            }
        } else {
            continue;
        }
        for (const std::string_view word : words) result.text.append(word) += ' ';
        result.text += '\n';
    }
    if (result.triangles == 0) throw InputError(name + ": has no faces");
    check_range(name, position, mesh.positions.size(), "vertex");
    check_range(name, normal, mesh.normals.size(), "normal");
    check_range(name, uv, mesh.uvs.size(), "texture coordinate");
    return result;
}

Mesh::Corner corner_of(const tinyobj::index_t& index, const Mesh& mesh) {
    const bool has_normal =
        index.normal_index >= 0 && mesh.normals[static_cast<std::size_t>(index.normal_index)] != Vec3(0);
    return {index.vertex_index, has_normal ? index.normal_index : -1, index.texcoord_index};
}

}  // namespace

Mesh parse_mesh(std::string_view text, const std::string& name) {
    if (text.find('\0') != std::string_view::npos)
        throw InputError(name + ": a zero byte: this is not a text file");
    Checked checked = check(text, name);

    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    std::istringstream stream(std::exchange(checked.text, {}));
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, nullptr, true))
        throw InputError(name + ": " + error.substr(0, error.find('\n')));

    // The numbers are those of the check: tinyobjloader's are not correctly rounded.
    Mesh mesh = std::move(checked.mesh);
    mesh.file = name;
    mesh.triangles.reserve(checked.triangles);
    for (const tinyobj::shape_t& shape : shapes)
        for (std::size_t i = 0; i + 2 < shape.mesh.indices.size(); i += 3)
            mesh.triangles.push_back({corner_of(shape.mesh.indices[i], mesh),
                                      corner_of(shape.mesh.indices[i + 1], mesh),
                                      corner_of(shape.mesh.indices[i + 2], mesh)});
    if (mesh.triangles.size() != checked.triangles)
        throw InputError(name + ": some polygons cannot be cut into triangles; write them as triangles");
    return mesh;
}

Mesh read_mesh(const std::filesystem::path& path) {
    return parse_mesh(read_text(path, path.string()), path.string());
}

}  // namespace rt
