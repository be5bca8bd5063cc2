// Objects in world space, as far as shapes tell.
#include "common/povray/placement.hpp"

#include "common/povray/writer.hpp"

#include <glm/matrix.hpp>

#include <array>
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

std::array<Vec3, 8> corners_of(const Extent& box) {
    std::array<Vec3, 8> corners;
    for (unsigned k = 0; k < 8; ++k)
        for (int i = 0; i < 3; ++i) corners[k][i] = (k >> i & 1 ? box.high : box.low)[i];
    return corners;
}

/// The object's ball, which nothing has moved or stretched; null where it is none.
const Sphere* ball_of(const Object& object) {
    return object.transform < 0 ? std::get_if<Sphere>(&object.shape) : nullptr;
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

std::string transform_of(const Scene& scene, const Object& object) {
    if (object.transform < 0) return "";
    const Mat4 m = matrix_of(scene, object.transform);
    std::string text = " matrix <";
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) text += (column + row == 0 ? "" : ", ") + number(m[column][row]);
    return text + ">";
}

Extent extent_of(const Scene& scene, const Object& object) {
    return extent_of(scene, object, matrix_of(scene, object.transform));
}

bool may_overlap(const Scene& scene, const Object& a, const Object& b) {
    const Sphere *ball_a = ball_of(a), *ball_b = ball_of(b);
    if (ball_a && ball_b)
        return glm::length(ball_a->center - ball_b->center) <= ball_a->radius + ball_b->radius;
    return may_reach(scene, a, corners_of(extent_of(scene, b))) &&
           may_reach(scene, b, corners_of(extent_of(scene, a)));
}

bool is_ball_within(const Object& inner, const Object& outer) {
    const Sphere *a = ball_of(inner), *b = ball_of(outer);
    return a && b && glm::length(a->center - b->center) + a->radius < b->radius;
}

bool surrounds(const Scene& scene, const Object& object, const Vec3& p) {
    return contains(scene, object, Vec3(glm::inverse(matrix_of(scene, object.transform)) * Vec4(p, 1)));
}

bool surrounds_eye(const Scene& scene, const Object& object) {
    return surrounds(scene, object, scene.camera.eye);
}

bool may_reach(const Scene& scene, const Object& object, std::span<const Vec3> corners) {
    return may_reach(scene, object, matrix_of(scene, object.transform), corners);
}

bool may_surround_eye(const Scene& scene, const Object& object) {
    return may_reach(scene, object, {&scene.camera.eye, 1});
}

}  // namespace rt::povray
