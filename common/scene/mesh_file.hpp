// Meshes from Wavefront `.obj` files.
#pragma once

#include "common/scene/shapes.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// How strictly to read a mesh.
struct MeshOptions {
    /// Go on with a warning without what the course cannot show, instead of an error: free-form curves and
    /// surfaces, and faces that cannot be cut into triangles.
    bool lenient = false;
    std::vector<std::string>* warnings = nullptr;  ///< one line each is appended; may be null
};

/// The triangles of a `.obj` file, in its order; faces of more than three corners are cut by `cut_polygon`.
/// Read are `v`, `vn`, `vt` and `f`, with indices from 1 or, negative, from the end; a corner's parts may be
/// empty (`1//`, `1/2/`). A `\` at the end of a line joins it with the next. What is not a matter of shape
/// (materials, groups, lines, points) is passed over, and of other unknown statements the first of each kind
/// is warned of. A corner without a normal, or with one of length 0, has normal −1; the same without a
/// texture coordinate.
/// Throws InputError that begins with `path` for a file that cannot be read, and as `parse_mesh`.
Mesh read_mesh(const std::filesystem::path& path, const MeshOptions& options = {});

/// The same from text. Throws InputError `name:line:column: reason` for numbers that are none, indices
/// without a vertex, faces of fewer than three corners or of more that cannot be cut into triangles, and
/// free-form geometry; `name: reason` where there is no face. Triangles without area are kept: no ray hits
/// them.
Mesh parse_mesh(std::string_view text, const std::string& name, const MeshOptions& options = {});

}  // namespace rt
