// What the tests of lenses share: views, and how exact a direction may be asked to be.
#pragma once

#include "common/math/error.hpp"
#include "common/world/view.hpp"
#include "tests/support.hpp"

#include <cmath>

namespace rt::test {

/// How far a direction of lens_ray may be off in each coordinate: what its contract promises.
///
/// pixel_ray's tests allow 32u·(1 + 2·half_height·(1 + width/height)) of the direction times its place on the
/// image plane, which is less than 123u·s with s² = 1 + a² + b² in the picture's corner. Divided by the
/// cosine, at least 1/s, that is 123u·s², along both axes. The cosine itself, at most 8u off, is worth 8u·s².
/// Both are as large at the aim's distance, or smaller.
inline Real direction_bound(const View& view) {
    if (view.projection == Projection::Orthographic) return gamma(300);
    const Real b = view.half_height, a = b * view.width / view.height;
    return gamma(300) * (1 + a * a + b * b);
}

/// Some view of up to 2000 × 2000 pixels, its frame not from camera_frame; up to 170 degrees high.
inline View some_view(Random& random, Projection projection) {
    View view;
    view.projection = projection;
    view.half_height = std::tan(radians(random.uniform(1, 170) / 2));
    view.width = 1 + static_cast<int>(random.index(2000));
    view.height = 1 + static_cast<int>(random.index(2000));
    view.frame.w = random.direction();
    const Vec3 helper = std::abs(view.frame.w.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    view.frame.u = glm::normalize(glm::cross(helper, view.frame.w));
    view.frame.v = glm::cross(view.frame.w, view.frame.u);
    view.eye = random.magnitude(-6, 6) * random.in_cube();
    return view;
}

}  // namespace rt::test
