// Ellipsoids around points: the smallest one, and where a ray is inside.
#include "chapters/13_hierarchies/ellipsoid_around.hpp"

#include "chapters/13_hierarchies/oriented_box.hpp"
#include "chapters/13_hierarchies/sphere_around.hpp"
#include "common/math/error.hpp"

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
    // [exercise 13.22] Return the weights. `squares_of` says how much each point has.
    for (;;) {
        const std::vector<Real> squares = squares_of(points, spread_of(points, weights));
        const auto most = std::ranges::max_element(squares);
        if (!(*most > 3 * (1 + tolerance))) return weights;
        const Real step = (*most - 3) / (4 * *most);
        for (Real& weight : weights) weight *= 1 - step;
        weights[static_cast<std::size_t>(most - squares.begin())] += step;
    }
    // [/exercise]
}

BoundingEllipsoid ellipsoid_of(std::span<const Vec3> points, std::span<const Real> weights) {
    // [exercise 13.23] Return the ellipsoid. `spread_of` is its centre and shape: along the principal axes of
    // the covariance (13.18) it reaches as far as the root of the covariance there, times a factor that is
    // the same for all, and as great as the points need.
    const WeightedSpread spread = spread_of(points, weights);
    const Mat3 axes = principal_axes(spread.covariance);
    const Vec3 reach = reach_along(axes, spread.covariance);
    Real factor = 0;
    for (const Vec3& point : points) factor = std::max(factor, length((point - spread.mean) * axes / reach));
    Mat3 to_unit = glm::transpose(axes);
    for (int k = 0; k < 3; ++k) to_unit[k] /= factor * reach;
    return {spread.mean, to_unit, factor * max_component(reach)};
    // [/exercise]
}

Real volume_of(const BoundingEllipsoid& ellipsoid) {
    return 4 * pi / 3 / std::abs(glm::determinant(ellipsoid.to_unit));
}

std::optional<Interval> clip(const BoundingEllipsoid& ellipsoid, const Ray& ray, Interval range) {
    // [exercise 13.24] Return the part of the range in which the ray is inside. Under `to_unit` the ellipsoid
    // is the unit sphere, which 13.16 knows, and the ray another ray. No rounding on the way moves a point of
    // that sphere by gamma(16) N (longest + distance from the origin to the centre): make the sphere so much
    // larger.
    const Mat3& m = ellipsoid.to_unit;
    const Vec3 from = ray.origin - ellipsoid.center;
    const Real size = std::sqrt(dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2]));
    const Real radius = 1 + gamma(16) * size * (ellipsoid.longest + length(from));
    return clip(BoundingSphere{Vec3(0), radius}, {m * from, m * ray.direction}, range);
    // [/exercise]
}

}  // namespace rt
