// The light that an even polygon sends to a point, exactly and without a single sample: Lambert's formula.
#include "chapters/12_distribution/lambert_polygon.hpp"

#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Vec3 lambert_vector(std::span<const Vec3> corners, const Vec3& point) {
    // 12.14  Half the sum of θ·Γ over the edges, the last of which goes back to the first corner.
    return todo("12.14");
}

std::vector<Vec3> above_horizon(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal) {
    // 12.14  The polygon without what is below the horizon of `point`.
    return todo("12.14");
}

Real polygon_irradiance(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal) {
    // 12.14  The irradiance that is left when the horizon has cut the polygon.
    return todo("12.14");
}

}  // namespace rt
