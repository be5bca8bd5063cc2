// Shapes that move or turn while the shutter is open: asked where they are at the ray's time.
#include "common/render/moving.hpp"

#include "common/math/error.hpp"
#include "common/render/groups.hpp"

namespace rt {
namespace {

Surface surface_of_still(const Still& still, const Ray& seen, const Hit& hit, bool uvs) {
    return std::visit(
        [&]<class Shape>(const Shape& shape) {
            Surface own = surface_at(shape, seen, hit);
            // A triangle that shows coordinates moves as a mesh.
            if constexpr (has_uv<Shape> && !std::is_same_v<Shape, Triangle>)
                if (uvs) set_uv(shape, hit.element, own);
            return own;
        },
        still);
}

Bounds bounds_of_still(const Still& still) {
    return std::visit([](const auto& shape) { return bounds_of(shape); }, still);
}

void move_on(const Vec3& motion, Real time, Surface& surface) {
    const Vec3 way = time * motion;
    surface.point += way;
    // The way is rounded where the ray is moved and where the surface is moved back, and so are the sums.
    surface.error += gamma(4) * (glm::abs(surface.point) + Real(2) * glm::abs(way));
}

/// What has been turned back is where it was after a turn the other way.
Spin reversed(const Spin& spin) { return {spin.center, spin.axis, -spin.angle}; }

Vec3 turned(const Spin& spin, const Vec3& direction, Real time) {
    return seen_while_turning({spin.center, direction, time}, reversed(spin)).direction;
}

void turn_on(const Spin& spin, Real time, Surface& surface) {
    const Ray there = seen_while_turning({surface.point, surface.normal, time}, reversed(spin));
    surface.point = there.origin, surface.normal = there.direction;
    surface.shading_normal = turned(spin, surface.shading_normal, time);
    Vec3 error(0);
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 along(0);
        along[axis] = surface.error[axis];
        error += glm::abs(turned(spin, along, time));
    }
    // What step 12.21 promises, for the ray that was turned back and for the surface.
    surface.error = error + gamma(128) * (length(surface.point) + length(spin.center));
}

}  // namespace

Ray seen_by(const Moving& moving, const Ray& ray) { return seen_while_moving(ray, moving.motion); }

Ray seen_by(const Turning& turning, const Ray& ray) {
    Ray seen = seen_while_moving(ray, turning.motion);
    for (const Spin& spin : turning.spins) seen = seen_while_turning(seen, spin);
    return seen;
}

Vec3 turned(const Turning& turning, Vec3 direction, Real time) {
    for (auto spin = turning.spins.rbegin(); spin != turning.spins.rend(); ++spin)
        direction = turned(*spin, direction, time);
    return direction;
}

std::optional<Hit> intersect(const Moving& moving, const Ray& ray, Interval range) {
    const Ray seen = seen_by(moving, ray);
    return std::visit([&](const auto& shape) { return intersect(shape, seen, range); }, moving.shape);
}

std::optional<Hit> intersect(const Turning& turning, const Ray& ray, Interval range) {
    const Ray seen = seen_by(turning, ray);
    return std::visit([&](const auto& shape) { return intersect(shape, seen, range); }, turning.shape);
}

Surface surface_at(const Moving& moving, const Ray& ray, const Hit& hit, bool uvs) {
    Surface surface = surface_of_still(moving.shape, seen_by(moving, ray), hit, uvs);
    move_on(moving.motion, ray.time, surface);
    return surface;
}

Surface surface_at(const Turning& turning, const Ray& ray, const Hit& hit, bool uvs) {
    Surface surface = surface_of_still(turning.shape, seen_by(turning, ray), hit, uvs);
    for (auto spin = turning.spins.rbegin(); spin != turning.spins.rend(); ++spin)
        turn_on(*spin, ray.time, surface);
    move_on(turning.motion, ray.time, surface);
    return surface;
}

Surface surface_at(const Moving& moving, const Ray& ray, const Hit& hit) {
    return surface_at(moving, ray, hit, false);
}

Surface surface_at(const Turning& turning, const Ray& ray, const Hit& hit) {
    return surface_at(turning, ray, hit, false);
}

Bounds bounds_of(const Moving& moving) {
    return bounds_while_moving(bounds_of_still(moving.shape), moving.motion);
}

Bounds bounds_of(const Turning& turning) {
    Bounds bounds = bounds_of_still(turning.shape);
    for (auto spin = turning.spins.rbegin(); spin != turning.spins.rend(); ++spin)
        bounds = bounds_while_turning(bounds, *spin);
    return bounds_while_moving(bounds, turning.motion);
}

}  // namespace rt
