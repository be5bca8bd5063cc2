// The triangles of meshes, one by one or shared.
#pragma once

#include "common/world/world.hpp"

#include <array>
#include <optional>

namespace rt {

/// A triangle with what its corners know.
struct Face {
    Triangle triangle;
    std::optional<TriangleNormals> normals;
    std::optional<TriangleUvs> uvs;
};

/// The face of these corners; it has normals, or texture coordinates, if all three corners have.
Face face_of(const Mesh& mesh, const std::array<Mesh::Corner, 3>& corners);

/// Unit normals at the corners, so that those of the file weigh alike when they are interpolated.
TriangleNormals unit_normals(const TriangleNormals& n);

/// Texture coordinates of a triangle that has none: the weights of its corners b and c.
inline constexpr TriangleUvs weights{{0, 0}, {1, 0}, {0, 1}};

/// The same place, seen from behind: with the corners b and c, and what they know, exchanged.
Face other_way_round(const Face& face);

/// The mesh as several instances share it, in its own space, with what these needs ask of its corners.
SharedMesh share(const Mesh& mesh, const Needs& needs);

}  // namespace rt
