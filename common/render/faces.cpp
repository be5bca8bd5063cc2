// The triangles of meshes, one by one or shared.
#include "common/render/faces.hpp"

#include <algorithm>
#include <utility>

namespace rt {
namespace {

TriangleNormals flat_normals(const Triangle& t) {
    const Vec3 n = cross(unit(t.b - t.a), unit(t.c - t.a));
    return {n, n, n};
}

Sphere bound_of(const Mesh& mesh) {
    Vec3 low(infinity), high(-infinity);
    for (const Vec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
    const Vec3 center = 0.5 * low + 0.5 * high;
    Real radius = 0;
    for (const Vec3& p : mesh.positions) radius = std::max(radius, glm::length(p - center));
    // Wider by more than the rounding of centre and radius.
    return {center, radius * (1 + 0x1p-20)};
}

}  // namespace

Face face_of(const Mesh& mesh, const std::array<Mesh::Corner, 3>& corners) {
    const auto [a, b, c] = corners;
    const auto at = [](const auto& list, std::int32_t i) { return list[static_cast<std::size_t>(i)]; };
    Face face;
    face.triangle = {at(mesh.positions, a.position), at(mesh.positions, b.position),
                     at(mesh.positions, c.position)};
    if (a.normal >= 0 && b.normal >= 0 && c.normal >= 0)
        face.normals = {at(mesh.normals, a.normal), at(mesh.normals, b.normal), at(mesh.normals, c.normal)};
    if (a.uv >= 0 && b.uv >= 0 && c.uv >= 0)
        face.uvs = {at(mesh.uvs, a.uv), at(mesh.uvs, b.uv), at(mesh.uvs, c.uv)};
    return face;
}

Face other_way_round(const Face& face) {
    Face other = face;
    std::swap(other.triangle.b, other.triangle.c);
    if (other.normals) std::swap(other.normals->b, other.normals->c);
    other.uvs = face.uvs.value_or(weights);
    std::swap(other.uvs->b, other.uvs->c);
    return other;
}

TriangleNormals unit_normals(const TriangleNormals& n) { return {unit(n.a), unit(n.b), unit(n.c)}; }

SharedMesh share(const Mesh& mesh, const Needs& needs) {
    SharedMesh result;
    Group<Triangle>& triangles = result.triangles;
    for (const auto& corners : mesh.triangles) {
        const Face face = face_of(mesh, corners);
        triangles.shapes.push_back(face.triangle);
        if (needs.normals && !mesh.normals.empty())
            triangles.normals.push_back(face.normals ? unit_normals(*face.normals)
                                                     : flat_normals(face.triangle));
        if (needs.uvs) triangles.uvs.push_back(face.uvs.value_or(weights));
    }
    result.bound = bound_of(mesh);
    return result;
}

}  // namespace rt
