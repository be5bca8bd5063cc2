// Teapots of any fineness, and rays around them: what chapters that make searches faster are measured on.
#pragma once

#include "common/math/random.hpp"
#include "common/math/ray.hpp"
#include "references/09_grids/teapot.hpp"

namespace rt::teapot {

/// The triangles of a teapot.
inline std::vector<Triangle> teapot_of(int fineness) {
    const Mesh mesh = tessellate(fineness);
    std::vector<Triangle> triangles;
    const auto at = [&](const Mesh::Corner& corner) {
        return mesh.positions[static_cast<std::size_t>(corner.position)];
    };
    for (const auto& [a, b, c] : mesh.triangles) triangles.push_back({at(a), at(b), at(c)});
    return triangles;
}

/// Rays from a sphere around the teapot towards points of its box.
inline std::vector<Ray> rays_around(std::size_t count) {
    std::vector<Ray> rays;
    Random random = random_for(9, 1, 0);
    const auto in_box = [&](const Vec3& middle, const Vec3& half) {
        Vec3 p;
        for (int i = 0; i < 3; ++i) p[i] = middle[i] + (2 * random_real(random) - 1) * half[i];
        return p;
    };
    const Vec3 middle(0.2, 1.575, 0), half(3.2, 1.575, 2);
    while (rays.size() < count) {
        const Vec3 out = in_box(Vec3(0), Vec3(1));
        if (dot(out, out) > 1 || dot(out, out) < 0.01) continue;
        const Vec3 origin = middle + Real(8) * normalize(out);
        rays.push_back({origin, in_box(middle, half) - origin});
    }
    return rays;
}

}  // namespace rt::teapot
