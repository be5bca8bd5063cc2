// Whether the triangles of a mesh enclose a body.
#include "common/scene/closed_mesh.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace rt {
namespace {

/// How often an edge is run along from its lesser to its greater end, and back.
struct Runs {
    int there = 0, back = 0;
};

/// Corners in one place are one corner, so an edge is its two places. 0 and −0 are equal.
std::map<std::pair<std::size_t, std::size_t>, Runs> edges_of(const Mesh& mesh) {
    std::map<std::tuple<Real, Real, Real>, std::size_t> places;
    const auto place = [&](const Mesh::Corner& corner) {
        const Vec3& p = mesh.positions[static_cast<std::size_t>(corner.position)];
        return places.try_emplace({p.x + 0, p.y + 0, p.z + 0}, places.size()).first->second;
    };
    std::map<std::pair<std::size_t, std::size_t>, Runs> edges;
    for (const auto& face : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t a = place(face[i]), b = place(face[(i + 1) % 3]);
            if (a == b) continue;
            Runs& runs = edges[{std::min(a, b), std::max(a, b)}];
            ++(a < b ? runs.there : runs.back);
        }
    return edges;
}

/// Six times the volume, as seen from a corner of the mesh.
Real volume_of(const Mesh& mesh) {
    const auto at = [&](const Mesh::Corner& corner) {
        return mesh.positions[static_cast<std::size_t>(corner.position)] - mesh.positions.front();
    };
    Real volume = 0;
    for (const auto& [a, b, c] : mesh.triangles) volume += glm::dot(at(a), glm::cross(at(b), at(c)));
    return volume;
}

}  // namespace

bool is_closed(const Mesh& mesh) {
    return std::ranges::none_of(
        edges_of(mesh), [](const auto& edge) { return (edge.second.there + edge.second.back) % 2 != 0; });
}

bool looks_outwards(const Mesh& mesh) {
    return std::ranges::all_of(edges_of(mesh),
                               [](const auto& edge) { return edge.second.there == edge.second.back; }) &&
           volume_of(mesh) > 0;
}

}  // namespace rt
