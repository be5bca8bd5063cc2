// Boxes with axes of their own: how points are spread, the axes that fit them, and where a ray is inside.
#include "chapters/13_hierarchies/oriented_box.hpp"

#include "chapters/09_grids/bounds.hpp"
#include "common/math/error.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// The axes, turned by this angle about the one with this number.
[[maybe_unused]] Mat3 turned(Mat3 axes, int number, Real angle) {
    const int i = (number + 1) % 3, j = (number + 2) % 3;
    const Vec3 u = axes[i], v = axes[j];
    axes[i] = std::cos(angle) * u + std::sin(angle) * v;
    axes[j] = std::cos(angle) * v - std::sin(angle) * u;
    return axes;
}

}  // namespace

Mat3 covariance(std::span<const Vec3> points) {
    Mat3 spread(0);
    if (points.empty()) return spread;
    // [exercise 13.17] Return the covariance of the points. Find their mean first: what is subtracted from
    // the mean of squares afterwards takes the digits with it.
    const Real share = 1 / static_cast<Real>(points.size());
    Vec3 mean(0);
    for (const Vec3& point : points) mean += share * (point - points[0]);
    for (const Vec3& point : points) {
        const Vec3 away = point - points[0] - mean;
        spread += share * glm::outerProduct(away, away);
    }
    return spread;
    // [/exercise]
}

Mat3 principal_axes(const Mat3& matrix) {
    // [exercise 13.18] Return the axes, as the columns of a matrix. Turn a copy of the matrix until nothing
    // is left beside its diagonal but rounding.
    Mat3 m = matrix, axes(1);
    for (int round = 0; round < 16; ++round)
        for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
            if (m[i][j] == 0) continue;
            // The smaller of the two angles: its tangent, from the cotangent of its double.
            const Real cotangent = (m[j][j] - m[i][i]) / (2 * m[i][j]);
            const Real tangent =
                std::copysign(1 / (std::abs(cotangent) + std::hypot(cotangent, Real(1))), cotangent);
            const Real c = 1 / std::hypot(tangent, Real(1)), s = tangent * c;
            Mat3 turn(1);
            turn[i][i] = turn[j][j] = c;
            turn[j][i] = s;
            turn[i][j] = -s;
            m = glm::transpose(turn) * m * turn;
            m[i][j] = m[j][i] = 0;
            axes = axes * turn;
        }
    return axes;
    // [/exercise]
}

OrientedBox box_along(const Mat3& axes, std::span<const Vec3> points) {
    if (points.empty()) return {.axes = axes};
    // [exercise 13.19] Return the box. Seen along the axes, from one of the points, it is the one of 09.1: `v
    // * axes` has the lengths of v along the three axes, and `axes * v` goes so far along each.
    Bounds along;
    for (const Vec3& point : points) {
        const Vec3 place = (point - points[0]) * axes;
        along = merge(along, {place, place});
    }
    const Vec3 half = (along.high - along.low) * Real(0.5);
    return {axes, points[0] + axes * (along.low + half), half};
    // [/exercise]
}

Real half_area(const OrientedBox& box) {
    if (box.half.x < 0 || box.half.y < 0 || box.half.z < 0) return 0;
    const Vec3 edges = Real(2) * box.half;
    return edges.x * edges.y + edges.y * edges.z + edges.z * edges.x;
}

Mat3 refined_axes(const Mat3& start, std::span<const Vec3> points) {
    // [exercise 13.20] Return the turned axes. `turned` turns about one of them.
    Mat3 axes = start;
    Real least = half_area(box_along(axes, points));
    for (Real angle = pi / 8; angle > pi / 256; angle /= 2)
        for (bool better = true; better;) {
            better = false;
            for (const int number : {0, 1, 2})
                for (const Real by : {angle, -angle}) {
                    const Mat3 other = turned(axes, number, by);
                    const Real area = half_area(box_along(other, points));
                    if (!(area < least)) continue;
                    least = area, axes = other, better = true;
                }
        }
    return axes;
    // [/exercise]
}

std::optional<Interval> clip(const OrientedBox& box, const Ray& ray, Interval range) {
    // [exercise 13.21] Return the part of the range in which the ray is inside. Seen along the axes the box
    // is one that 09.2 knows, and the ray another ray. No rounding on the way moves a point of the box by
    // gamma(16) of length(box.half) and of the distance from the origin to the centre: make the box so much
    // larger.
    const Vec3 from = ray.origin - box.center;
    const Vec3 half = box.half + gamma(16) * (length(box.half) + length(from));
    return clip(Bounds{-half, half}, {from * box.axes, ray.direction * box.axes}, range);
    // [/exercise]
}

}  // namespace rt
