// The camera: its frame, and the ray through a point of the picture.
// The lesson uses the same letters: u, v, w for the frame, a and b on the image plane.
#include "chapters/01_ray_casting/camera.hpp"

#include "common/math/todo.hpp"

namespace rt {

CameraFrame camera_frame(const Camera& camera) {
    // 01.1  Build the three axes of the camera, each of length 1 and perpendicular to the others:
    // w points backwards, from camera.look_at to camera.eye; u points to the right and is perpendicular to
    // camera.up and to w; v points up in the picture and completes them to u × v = w.
    // glm::normalize and glm::cross are all you need; mind the order of the factors.
    return todo("01.1");
}

Ray pixel_ray(const View& view, Real x, Real y) {
    // 01.2  Find where the point (x, y) of the picture lies on the image plane: a to the right
    // of its centre and b above it, each between plus and minus half the picture's extent. The height is
    // 2 · view.half_height, and pixels are square, so one factor serves both. Then, if view.projection is
    // Projection::Perspective, return the ray from view.eye towards a·u + b·v − w, its direction of length 1.
    return todo("01.2");
    // 01.3  What is left is the orthographic view. All its rays are parallel, along −w; what
    // changes from pixel to pixel is where they start: at view.eye, moved by a along u and by b along v.
    return todo("01.3");
}

}  // namespace rt
