// The mesh reader and the cutting of polygons under libFuzzer. Whatever the bytes, out comes a mesh whose
// indices are of its lists, or an InputError of one line; and triangles that cover what the outline goes
// around, or a problem. README.md beside this file says how to build and run it.
#include "common/scene/cut_polygon.hpp"
#include "common/scene/mesh_file.hpp"
#include "tests/fuzz/must.hpp"

#include <cmath>
#include <cstring>
#include <vector>

namespace {

using namespace rt;
using rt::fuzz::require;

void check_mesh(const Mesh& mesh) {
    const auto is_index = [](std::int32_t i, std::size_t count) {
        return i >= 0 && static_cast<std::size_t>(i) < count;
    };
    require(!mesh.triangles.empty());
    for (const auto& triangle : mesh.triangles)
        for (const Mesh::Corner& corner : triangle) {
            require(is_index(corner.position, mesh.positions.size()));
            require(corner.normal == -1 || is_index(corner.normal, mesh.normals.size()));
            require(corner.uv == -1 || is_index(corner.uv, mesh.uvs.size()));
        }
}

/// How many corners are not at the place of the one before them.
std::size_t count_different(const std::vector<Vec3>& corners) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        count += corners[i] != corners[i == 0 ? corners.size() - 1 : i - 1];
    return count;
}

/// Triangles that all go around one way and whose areas add up to the outline's, exactly. The coordinates are
/// small whole numbers, so that the areas are exact too.
void check_cut(const std::vector<Vec3>& corners) {
    const PolygonCut cut = cut_polygon(corners);
    if (!cut.problem.empty()) return;
    long outline = 0, triangles = 0;
    const auto twice_area = [](const Vec3& a, const Vec3& b) { return std::lround(a.x * b.y - a.y * b.x); };
    for (std::size_t i = 0; i < corners.size(); ++i)
        outline += twice_area(corners[i], corners[(i + 1) % corners.size()]);
    for (const auto& [a, b, c] : cut.triangles) {
        const long area = twice_area(corners[a], corners[b]) + twice_area(corners[b], corners[c]) +
                          twice_area(corners[c], corners[a]);
        require(area == 0 ? count_different(corners) == 4 : (area > 0) == (outline > 0));
        triangles += area;
    }
    require(triangles == outline);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const bool lenient : {false, true})
        fuzz::must_read_or_refuse([&] {
            std::vector<std::string> warnings;
            check_mesh(parse_mesh(text, "fuzz", {.lenient = lenient, .warnings = &warnings}));
            for (const std::string& line : warnings)
                require(line.starts_with("fuzz:") && line.find('\n') == std::string::npos);
        });

    // The same bytes as corners, in a small lattice where many things meet.
    std::vector<Vec3> corners;
    for (std::size_t i = 0; i + 1 < size && i < 256; i += 2)
        corners.push_back({data[i] % 16, data[i + 1] % 16, 1});
    check_cut(corners);

    // And as numbers of all sizes, which need only end well.
    corners.assign(size / sizeof(Vec3), Vec3(0));
    if (!corners.empty()) std::memcpy(corners.data(), data, corners.size() * sizeof(Vec3));
    for (Vec3& corner : corners)
        for (int k = 0; k < 3; ++k)
            if (!std::isfinite(corner[k])) corner[k] = 0;
    for (const auto& triangle : cut_polygon(corners).triangles)
        for (const std::uint32_t corner : triangle) require(corner < corners.size());
    return 0;
}
