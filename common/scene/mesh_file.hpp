// Meshes from Wavefront `.obj` files.
#pragma once

#include "common/scene/shapes.hpp"

#include <filesystem>
#include <string_view>

namespace rt {

/// The triangles of a `.obj` file, in its order; polygons are cut into triangles. Read are `v`, `vn`, `vt`
/// and `f`, with indices from 1 or, negative, from the end; everything else is not a matter of shape.
/// A corner without a normal, or with one of length 0, has normal −1; the same without a texture coordinate.
/// Throws InputError that begins with `path` for a file that cannot be read, and as `parse_mesh`.
Mesh read_mesh(const std::filesystem::path& path);

/// The same from text. Throws InputError `name:line: reason` for numbers that are none, indices without a
/// vertex, faces of fewer than three corners or that cannot be cut into triangles, and where there is no
/// face.
Mesh parse_mesh(std::string_view text, const std::string& name);

}  // namespace rt
