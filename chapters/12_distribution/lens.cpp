// A lens instead of a pinhole: points of its opening, rays through it, and how large the blur is; and a lens
// that leans.
// The lesson uses the same letters: a and b in the square, φ the angle, k the side of the polygon.
#include "chapters/12_distribution/lens.hpp"

#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Vec2 disc_point(const Vec2& random) {
    // 12.6  The concentric map from the square to the disc.
    return todo("12.6");
}

Vec2 polygon_point(int sides, Real turn, const Vec2& random) {
    // 12.6  The point of the disc, moved so that its circle becomes the regular polygon.
    return todo("12.6");
}

Ray lens_ray(const View& view, const Lens& lens, Real x, Real y, const Vec2& on_lens) {
    // 12.7  The ray through this point of the lens, aimed at the point where the pinhole's ray
    // meets the plane in focus.
    return todo("12.7");
}

Real blur_radius(const Lens& lens, Real depth) {
    // 12.7  The radius, in the plane in focus, of the double cone of all rays from the lens through
    // the point.
    return todo("12.7");
}

Ray tilted_lens_ray(const View& view, Real radius, const FocusPlane& plane, Real x, Real y,
                    const Vec2& on_lens) {
    // 12.24  The ray through this point of the lens, with the given plane in focus.
    return todo("12.24");
}

}  // namespace rt
