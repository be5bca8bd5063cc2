// The camera: from a pixel to the ray that looks through it.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/view.hpp"

namespace rt {

/// [01.1] The basis of `camera`: w from look_at to the eye, u to the right, v up; orthonormal and
/// right-handed (u × v = w). `camera.up` need not be perpendicular to the view, nor of unit length;
/// it must not be parallel to the view (the scene's compiler refuses that).
CameraFrame camera_frame(const Camera& camera);

/// [01.2, 01.3] The ray through the point (x, y) of the picture, in world space.
///
/// x grows to the right from 0 to view.width, y grows downwards from 0 to view.height, so the centre of
/// the top left pixel is (½, ½). Pixels are square. Perspective: the ray starts at the eye and its
/// direction, before it is made a unit vector, is a·u + b·v − w with a and b on the image plane at
/// distance 1. Orthographic: the direction is −w for every pixel and the origin is eye + a·u + b·v. The
/// direction is a unit vector.
Ray pixel_ray(const View& view, Real x, Real y);

}  // namespace rt
