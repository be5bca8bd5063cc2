// Boxes with axes of their own: how points are spread, the axes that fit them, and where a ray is inside.
#include "chapters/13_hierarchies/oriented_box.hpp"

#include "chapters/09_grids/bounds.hpp"
#include "common/math/error.hpp"
#include "common/math/todo.hpp"

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
    // 13.17  Return the covariance of the points. Find their mean first: what is subtracted from
    // the mean of squares afterwards takes the digits with it.
    return todo("13.17");
}

Mat3 principal_axes(const Mat3& matrix) {
    // 13.18  Return the axes, as the columns of a matrix. Turn a copy of the matrix until nothing
    // is left beside its diagonal but rounding.
    return todo("13.18");
}

OrientedBox box_along(const Mat3& axes, std::span<const Vec3> points) {
    if (points.empty()) return {.axes = axes};
    // 13.19  Return the box. Seen along the axes, from one of the points, it is the one of 09.1: `v
    // * axes` has the lengths of v along the three axes, and `axes * v` goes so far along each.
    return todo("13.19");
}

Real half_area(const OrientedBox& box) {
    if (box.half.x < 0 || box.half.y < 0 || box.half.z < 0) return 0;
    const Vec3 edges = Real(2) * box.half;
    return edges.x * edges.y + edges.y * edges.z + edges.z * edges.x;
}

Mat3 refined_axes(const Mat3& start, std::span<const Vec3> points) {
    // 13.20  Return the turned axes. `turned` turns about one of them.
    return todo("13.20");
}

std::optional<Interval> clip(const OrientedBox& box, const Ray& ray, Interval range) {
    // 13.21  Return the part of the range in which the ray is inside. Seen along the axes the box
    // is one that 09.2 knows, and the ray another ray. No rounding on the way moves a point of the box by
    // gamma(16) of length(box.half) and of the distance from the origin to the centre: make the box so much
    // larger.
    return todo("13.21");
}

}  // namespace rt
