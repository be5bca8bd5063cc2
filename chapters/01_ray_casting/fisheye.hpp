// Another camera: the fisheye, which can see more than half of everything.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/view.hpp"

namespace rt {

/// [01.7] The ray through the point (x, y) of a fisheye picture that sees the angle `field` from its top edge
/// to its bottom edge, radians.
///
/// x and y are as for `pixel_ray`. Let ρ be the distance of the point from the middle of the picture, in
/// halves of the picture's height. The ray starts at the eye and makes the angle ρ·field/2 with −w, on the
/// side of the middle where the point is. Its direction is a unit vector. `view.projection` and
/// `view.half_height` have no part in it.
Ray fisheye_ray(const View& view, Real x, Real y, Real field);

}  // namespace rt
