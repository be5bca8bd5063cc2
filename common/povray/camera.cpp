// POV-Ray's camera is given by the same basis as ours.
#include "common/povray/camera.hpp"

#include <cmath>

namespace rt::povray {
namespace {

/// Along the ray through the middle of the picture, 1 along the view: leaning back by what the eye is beside
/// the middle of the lens, over the distance of the plane in focus, so that all rays still meet where they
/// did in it.
Vec3 direction_of(const Writer& out, const Basis& basis) {
    const Vec2& lens = out.snapshot.lens;
    if (lens == Vec2(0)) return -basis.w;
    return -basis.w - out.factor / out.scene.lens.distance * (lens.x * basis.u + lens.y * basis.v);
}

}  // namespace

Basis basis_of(const Camera& camera) {
    const Vec3 w = unit_along(camera.eye - camera.look_at);
    const Vec3 u = unit_along(glm::cross(near_one(camera.up), w));
    return {u, glm::cross(w, u), w};
}

Scene still_of(const Scene& scene, const Snapshot& snapshot) {
    Scene still = scene_at(scene, snapshot.time);
    if (snapshot.lens == Vec2(0)) return still;
    const auto [u, v, w] = basis_of(still.camera);
    const Vec3 beside = snapshot.lens.x * u + snapshot.lens.y * v;
    still.camera.eye += beside, still.camera.look_at += beside;
    return still;
}

Vec3 to_viewer(const Writer& out) {
    const Vec3 back = -direction_of(out, basis_of(out.scene.camera));
    return out.snapshot.lens == Vec2(0) ? back : unit_along(back);
}

/// It needs no look_at, and none of the handedness that comes with it. `direction`, `right` and `up` span the
/// whole picture; off the middle of the pixel, it is moved by that part of one. POV-Ray warns that they are
/// not perpendicular, which concerns look_at alone.
void write_camera(Writer& out) {
    const Camera& camera = out.scene.camera;
    const Basis basis = basis_of(camera);
    const bool flat = camera.projection == Projection::Orthographic;
    const Real height = flat ? camera.view_height : 2 * std::tan(camera.fovy / 2);
    const Real width = height * out.scene.width / out.scene.height;
    const Vec3 right = width * basis.u, up = height * basis.v;
    Vec3 location = camera.eye, direction = direction_of(out, basis);
    if (const Vec2 off = out.snapshot.at - Vec2(0.5); off != Vec2(0))
        (flat ? location : direction) += off.x / out.scene.width * right - off.y / out.scene.height * up;
    out.line("camera {{");
    out.line("  {}", flat ? "orthographic" : "perspective");
    out.line("  location {}", triple(location));
    out.line("  direction {}", triple(direction));
    out.line("  right {}", triple(right));
    out.line("  up {}", triple(up));
    out.line("}}");
    out.line("");
}

}  // namespace rt::povray
