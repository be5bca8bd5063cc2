// The camera: its frame, and the ray through a point of the picture.
// The lesson uses the same letters: u, v, w for the frame, a and b on the image plane.
#include "chapters/01_ray_casting/camera.hpp"

#include "common/math/todo.hpp"

namespace rt {

CameraFrame camera_frame(const Camera& camera) {
    // 01.1  Return the three axes of the camera, each of length 1 and perpendicular to the others:
    // w points backwards, from camera.look_at to camera.eye; u points to the right of the picture; v points
    // up in it, as far as camera.up allows.
    return todo("01.1");
}

Ray pixel_ray(const View& view, Real x, Real y) {
    // 01.2  Find where the point (x, y) of the picture lies on the image plane: a to the right of
    // its centre, and b above it. If view.projection is Projection::Perspective, return the ray from view.eye
    // through that point; its direction has length 1.
    return todo("01.2");
    // 01.3  What is left is the orthographic view. Return the ray through the point (x, y) there.
    return todo("01.3");
}

}  // namespace rt
