// The light that an even polygon sends to a point, exactly and without a single sample: Lambert's formula.
#include "chapters/12_distribution/lambert_polygon.hpp"

#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Vec3 lambert_vector(std::span<const Vec3> corners, const Vec3& point) {
    // 12.14  Half the sum of θ·Γ over the edges. The cross product with an edge is that with its
    // far end; but the edge is short where the polygon is small, and then nothing cancels.
    return todo("12.14");
}

std::vector<Vec3> above_horizon(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal) {
    // 12.14  Go round once. Keep each corner that is above, and where an edge goes from one side to
    // the other, add the point where it crosses.
    return todo("12.14");
}

Real polygon_irradiance(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal) {
    // 12.14  Lambert's vector of what is above the horizon, along the normal.
    return todo("12.14");
}

}  // namespace rt
