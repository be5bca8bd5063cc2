// The light that an even polygon sends to a point, exactly and without a single sample: Lambert's formula.
#include "chapters/12_distribution/lambert_polygon.hpp"

#include <cmath>

namespace rt {

Vec3 lambert_vector(std::span<const Vec3> corners, const Vec3& point) {
    // [exercise 12.14] Half the sum of θ·Γ over the edges, the last of which goes back to the first corner.
    Vec3 sum(0);
    // d × edge is d × its far end. But where the polygon is small the edge is short, and nothing cancels.
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec3& from = corners[k];
        const Vec3& to = corners[(k + 1) % corners.size()];
        const Vec3 d = from - point, w = cross(d, to - from);
        const Real size = length(w);
        // Of an edge towards the point, or without a length, neither Γ nor θ is left.
        if (!(size > 0)) continue;
        // The tangent of θ is |d × d'| / (d · d'), of any size and sign. acos would lose small angles.
        const Real theta = std::atan2(size, dot(d, to - point));
        sum += theta / size * w;
    }
    return sum / Real(2);
    // [/exercise]
}

std::vector<Vec3> above_horizon(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal) {
    // [exercise 12.14] The polygon without what is below the horizon of `point`.
    std::vector<Vec3> kept;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec3& from = corners[k];
        const Vec3& to = corners[(k + 1) % corners.size()];
        const Real height = dot(from - point, normal), next = dot(to - point, normal);
        if (height >= 0) kept.push_back(from);
        // Heights fall linearly along the edge. A corner on the horizon is not also a crossing.
        const bool crosses = (height > 0 && next < 0) || (height < 0 && next > 0);
        if (crosses) kept.push_back(from + height / (height - next) * (to - from));
    }
    return kept;
    // [/exercise]
}

Real polygon_irradiance(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal) {
    // [exercise 12.14] The irradiance that is left when the horizon has cut the polygon.
    const std::vector<Vec3> seen = above_horizon(corners, point, normal);
    // The order of the corners only decides the sign.
    return std::abs(dot(lambert_vector(seen, point), normal));
    // [/exercise]
}

}  // namespace rt
