// POV-Ray's camera is given by the same basis as ours.
#include "common/povray/camera.hpp"

#include <cmath>

namespace rt::povray {

Basis basis_of(const Camera& camera) {
    const Vec3 w = unit_along(camera.eye - camera.look_at);
    const Vec3 u = unit_along(glm::cross(near_one(camera.up), w));
    return {u, glm::cross(w, u), w};
}

/// It needs no look_at, and none of the handedness that comes with it. `direction`, `right` and `up` span the
/// whole picture.
void write_camera(Writer& out) {
    const Camera& camera = out.scene.camera;
    const auto [u, v, w] = basis_of(camera);
    const bool flat = camera.projection == Projection::Orthographic;
    const Real height = flat ? camera.view_height : 2 * std::tan(camera.fovy / 2);
    const Real width = height * out.scene.width / out.scene.height;
    out.line("camera {{");
    out.line("  {}", flat ? "orthographic" : "perspective");
    out.line("  location {}", triple(camera.eye));
    out.line("  direction {}", triple(-w));
    out.line("  right {}", triple(width * u));
    out.line("  up {}", triple(height * v));
    out.line("}}");
    out.line("");
}

}  // namespace rt::povray
