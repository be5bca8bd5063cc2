// Objects in world space, as far as boxes, balls and planes tell.
#include "common/povray/placement.hpp"

#include "common/povray/writer.hpp"

#include <glm/matrix.hpp>

#include <cmath>

namespace rt::povray {
namespace {

Mat4 matrix_of(const Translate& move) {
    Mat4 m(1);
    m[3] = Vec4(move.by, 1);
    return m;
}

Mat4 matrix_of(const Scale& stretch) {
    Mat4 m(1);
    for (int i = 0; i < 3; ++i) m[i][i] = stretch.by[i];
    return m;
}

/// Its columns are the turned axes (Rodrigues' formula).
Mat4 matrix_of(const Rotate& turn) {
    Mat4 m(1);
    const Vec3 k = unit_along(turn.axis);
    for (int i = 0; i < 3; ++i) {
        Vec3 e(0);
        e[i] = 1;
        const Vec3 turned = e * std::cos(turn.angle) + glm::cross(k, e) * std::sin(turn.angle) +
                            k * (k[i] * (1 - std::cos(turn.angle)));
        m[i] = Vec4(turned, 0);
    }
    return m;
}

/// Whether the box may reach to the inner side of the plane.
bool may_overlap(const Plane& plane, const Box& box) {
    // The box's lowest corner along the normal.
    Real height = 0;
    for (int i = 0; i < 3; ++i)
        height += plane.normal[i] * ((plane.normal[i] > 0 ? box.low : box.high)[i] - plane.point[i]);
    return height <= 0;
}

}  // namespace

Mat4 matrix_of(const Scene& scene, int node) {
    Mat4 m(1);
    while (node >= 0) {
        const TransformNode& here = scene.transforms[static_cast<std::size_t>(node)];
        m = std::visit([](const auto& step) { return matrix_of(step); }, here.step) * m;
        node = here.parent;
    }
    return m;
}

Plane moved(const Plane& plane, const Mat4& m) {
    const Mat3 directions(m);
    return {Vec3(m * Vec4(plane.point, 1)),
            unit_along(glm::transpose(glm::inverse(directions)) * unit_along(plane.normal))};
}

Box box_of(const Scene& scene, const Object& object) {
    return box_of(scene, object, matrix_of(scene, object.transform));
}

bool overlap(const Box& a, const Box& b) {
    return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

bool may_overlap(const Scene& scene, const Object& a, const Object& b) {
    const auto* plane_a = std::get_if<Plane>(&a.shape);
    const auto* plane_b = std::get_if<Plane>(&b.shape);
    if (plane_a && plane_b) return true;
    if (plane_b) return may_overlap(scene, b, a);
    const Box box = box_of(scene, b);
    if (plane_a) return may_overlap(moved(*plane_a, matrix_of(scene, a.transform)), box);
    const auto* ball_a = std::get_if<Sphere>(&a.shape);
    const auto* ball_b = std::get_if<Sphere>(&b.shape);
    if (ball_a && ball_b && a.transform < 0 && b.transform < 0)
        return glm::length(ball_a->center - ball_b->center) <= ball_a->radius + ball_b->radius;
    return overlap(box, box_of(scene, a));
}

bool is_ball_within(const Object& inner, const Object& outer) {
    const auto* a = std::get_if<Sphere>(&inner.shape);
    const auto* b = std::get_if<Sphere>(&outer.shape);
    return a && b && inner.transform < 0 && outer.transform < 0 &&
           glm::length(a->center - b->center) + a->radius < b->radius;
}

bool surrounds_eye(const Scene& scene, const Object& object) {
    return contains(object,
                    Vec3(glm::inverse(matrix_of(scene, object.transform)) * Vec4(scene.camera.eye, 1)));
}

bool may_surround_eye(const Scene& scene, const Object& object) {
    const Vec3& eye = scene.camera.eye;
    if (const auto* plane = std::get_if<Plane>(&object.shape)) {
        const Plane here = moved(*plane, matrix_of(scene, object.transform));
        return glm::dot(here.normal, eye - here.point) <= 0;
    }
    const Box box = box_of(scene, object);
    return glm::all(glm::lessThanEqual(box.low, eye)) && glm::all(glm::lessThanEqual(eye, box.high));
}

}  // namespace rt::povray
