// The camera: its frame, and the ray through a point of the picture.
// The lesson uses the same letters: u, v, w for the frame, a and b on the image plane.
#include "chapters/01_ray_casting/camera.hpp"

namespace rt {

CameraFrame camera_frame(const Camera& camera) {
    // [exercise 01.1] Return the three axes of the camera, each of length 1 and perpendicular to the others:
    // w points backwards, from camera.look_at to camera.eye; u points to the right of the picture; v points
    // up in it, as far as camera.up allows.
    const Vec3 w = glm::normalize(camera.eye - camera.look_at);
    const Vec3 u = glm::normalize(glm::cross(camera.up, w));
    const Vec3 v = glm::cross(w, u);
    return {u, v, w};
    // [/exercise]
}

Ray pixel_ray(const View& view, Real x, Real y) {
    // [exercise 01.2] Find where the point (x, y) of the picture lies on the image plane: a to the right of
    // its centre, and b above it. If view.projection is Projection::Perspective, return the ray from view.eye
    // through that point; its direction has length 1.
    const auto& [u, v, w] = view.frame;
    const Real a = view.half_height * (2 * x - view.width) / view.height;
    const Real b = view.half_height * (view.height - 2 * y) / view.height;
    if (view.projection == Projection::Perspective) {
        return Ray{view.eye, glm::normalize(a * u + b * v - w)};
    }
    // [/exercise]
    // [exercise 01.3] What is left is the orthographic view. Return the ray through the point (x, y) there.
    return Ray{view.eye + a * u + b * v, -w};
    // [/exercise]
}

}  // namespace rt
