// Axis-aligned boxes: around shapes, and where a ray runs through one.
#include "chapters/09_grids/bounds.hpp"

#include "chapters/04_transforms/transform.hpp"
#include "common/math/error.hpp"
#include "common/math/todo.hpp"
#include "common/world/world.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// The box around the image of a sphere under an affine map.
Bounds bounds_of_image(const Mat4& m, const Sphere& sphere) {
    const Vec3 center = transform_point(m, sphere.center);
    Vec3 reach;
    // 09.1  Fill in `reach`: how far the image reaches from its centre along each axis. A matrix of
    // GLM is indexed m[column][row].
    return todo("09.1");
    return {center - reach, center + reach};
}

}  // namespace

Bounds bounds_of(const Sphere& sphere) {
    // 09.1  Return the box that touches the sphere at both ends of each axis.
    return todo("09.1");
}

Bounds bounds_of(const Triangle& triangle) {
    // 09.1  Return the smallest box around the corners.
    return todo("09.1");
}

Bounds bounds_of(const Polygon& polygon) {
    Bounds bounds;
    for (const Vec3& vertex : polygon.vertices) bounds = merge(bounds, {vertex, vertex});
    return bounds;
}

Bounds bounds_of(const Ellipsoid& ellipsoid) {
    return bounds_of_image(ellipsoid.transform.to_world, {Vec3(0), 1});
}

Bounds bounds_of(const Instance& instance) {
    return bounds_of_image(instance.transform.to_world, instance.shape.mesh->bound);
}

Bounds bounds_of_image(const Transform& transform, const Bounds& box) {
    Bounds image;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p(corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                     corner & 4 ? box.high.z : box.low.z);
        const Vec3 q = transform_point(transform.to_world, p);
        image = merge(image, {q, q});
    }
    return image;
}

Real distortion_of(const Transform& transform) {
    Real greatest = 1;
    for (int row = 0; row < 3; ++row) {
        Real sum = 0;
        for (int k = 0; k < 3; ++k)
            for (int column = 0; column < 3; ++column)
                sum += std::abs(transform.to_world[k][row] * transform.to_local[column][k]);
        greatest = std::max(greatest, sum);
    }
    return greatest;
}

Bounds merge(const Bounds& a, const Bounds& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

Bounds grown(const Bounds& box, Real by) { return {box.low - by, box.high + by}; }

bool is_empty(const Bounds& box) {
    return !(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z);
}

std::optional<Interval> clip(const Bounds& box, const Ray& ray, Interval range) {
    // 09.2  Return the part of the range in which the ray is inside the box. Widen what you compute
    // by gamma(3) of its size (common/math/error.hpp), so that nothing is lost.
    //   – If d is 0, the ray is between the planes of this axis everywhere, or nowhere.
    //   – The box is closed, so an interval of one point is not empty: only min > max is.
    //   – A box with low > high along some axis is empty.
    return todo("09.2");
}

Allowance allowance_for(const Bounds& around, Real distortion) {
    const Real edge = max_component(around.high - around.low);
    const Real greatest = max_component(glm::max(glm::abs(around.low), glm::abs(around.high)));
    return {.margin = distortion * (0x1p-30 * edge + 0x1p-44 * greatest), .reach = 0x1p16 * edge};
}

bool is_within_reach(const Ray& ray, const Bounds& box, Real reach) {
    const Vec3 away = glm::abs(ray.origin - (box.low + box.high) * Real(0.5));
    if (!(away.x <= reach && away.y <= reach && away.z <= reach)) return false;
    const Vec3 d = glm::abs(ray.direction);
    const auto is_moderate = [&](Real x) {
        return x == 0 || (x >= 0x1p-900 * reach && x <= 0x1p900 * reach);
    };
    return is_moderate(d.x) && is_moderate(d.y) && is_moderate(d.z);
}

}  // namespace rt
