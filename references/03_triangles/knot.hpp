// A trefoil knot, cut into as many triangles as one likes: the mesh of this chapter's pictures and
// measurements.
#pragma once

#include "common/scene/shapes.hpp"

#include <cmath>

namespace rt {

/// 2 · along · around triangles, with a normal at each corner; both at least 3. Counterclockwise seen from
/// outside. The knot lies on a torus around the z axis, within 3.7 of the origin.
inline Mesh knot(int along, int around) {
    const Real ring = 1, hole = 2, radius = 0.62;
    Mesh mesh;
    for (int i = 0; i < along; ++i) {
        const Real s = 2 * pi * i / along, a = 2 * s, b = 3 * s;
        const Real r = hole + ring * std::cos(b);
        const Vec3 center(r * std::cos(a), r * std::sin(a), -ring * std::sin(b));
        const Vec3 tangent(-3 * ring * std::sin(b) * std::cos(a) - 2 * r * std::sin(a),
                           -3 * ring * std::sin(b) * std::sin(a) + 2 * r * std::cos(a),
                           -3 * ring * std::cos(b));
        // The torus's normal is perpendicular to the knot: counting the turn around the tube from there, the
        // tube closes on itself.
        const Vec3 out(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), -std::sin(b));
        const Vec3 side = glm::cross(glm::normalize(tangent), out);
        for (int j = 0; j < around; ++j) {
            const Real turn = 2 * pi * j / around;
            const Vec3 normal = std::cos(turn) * out + std::sin(turn) * side;
            mesh.positions.push_back(center + radius * normal);
            mesh.normals.push_back(normal);
        }
    }
    const auto corner = [&](int i, int j) {
        const int index = i % along * around + j % around;
        return Mesh::Corner{.position = index, .normal = index};
    };
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            mesh.triangles.push_back({corner(i, j), corner(i, j + 1), corner(i + 1, j + 1)});
            mesh.triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i + 1, j)});
        }
    return mesh;
}

}  // namespace rt
