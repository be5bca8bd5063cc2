// Ellipsoids around points: the smallest one, and where a ray is inside.
#include "chapters/13_hierarchies/ellipsoid_around.hpp"

#include "chapters/13_hierarchies/oriented_box.hpp"
#include "chapters/13_hierarchies/sphere_around.hpp"
#include "common/math/error.hpp"
#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// The roots of the covariance along its principal axes, as far as the points are spread there.
Vec3 reach_along(const Mat3& axes, const Mat3& covariance) {
    Vec3 reach;
    for (int k = 0; k < 3; ++k) reach[k] = std::sqrt(dot(axes[k], covariance * axes[k]));
    return reach;
}

/// For each point (p − mean)ᵀ · covariance⁻¹ · (p − mean). Along the principal axes: the inverse of the
/// matrix as it stands has no right digit where points are nearly on a line.
[[maybe_unused]] std::vector<Real> squares_of(std::span<const Vec3> points, const WeightedSpread& spread) {
    const Mat3 turned = principal_axes(spread.covariance);
    const Vec3 unit = Real(1) / reach_along(turned, spread.covariance);
    std::vector<Real> squares;
    squares.reserve(points.size());
    for (const Vec3& point : points) {
        const Vec3 place = (point - spread.mean) * turned * unit;
        squares.push_back(dot(place, place));
    }
    return squares;
}

}  // namespace

WeightedSpread spread_of(std::span<const Vec3> points, std::span<const Real> weights) {
    WeightedSpread spread;
    if (points.empty()) return spread;
    Vec3 mean(0);
    for (std::size_t i = 0; i < points.size(); ++i) mean += weights[i] * (points[i] - points[0]);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 away = points[i] - points[0] - mean;
        spread.covariance += weights[i] * glm::outerProduct(away, away);
    }
    spread.mean = points[0] + mean;
    return spread;
}

std::vector<Real> ellipsoid_weights(std::span<const Vec3> points, Real tolerance) {
    std::vector<Real> weights(points.size(), 1 / static_cast<Real>(points.size()));
    // 13.22  Return the weights. `squares_of` says how much each point has.
    return todo("13.22");
}

BoundingEllipsoid ellipsoid_of(std::span<const Vec3> points, std::span<const Real> weights) {
    // 13.23  Return the ellipsoid. `spread_of` is its centre and shape: along the principal axes of
    // the covariance (13.18) it reaches as far as the root of the covariance there, times a factor that is
    // the same for all, and as great as the points need.
    return todo("13.23");
}

Real volume_of(const BoundingEllipsoid& ellipsoid) {
    return 4 * pi / 3 / std::abs(glm::determinant(ellipsoid.to_unit));
}

std::optional<Interval> clip(const BoundingEllipsoid& ellipsoid, const Ray& ray, Interval range) {
    // 13.24  Return the part of the range in which the ray is inside. Under `to_unit` the ellipsoid
    // is the unit sphere, which 13.16 knows, and the ray another ray. No rounding on the way moves a point of
    // that sphere by gamma(16) N (longest + distance from the origin to the centre): make the sphere so much
    // larger.
    return todo("13.24");
}

}  // namespace rt
