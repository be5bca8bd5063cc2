// A lens instead of a pinhole: points of its opening, rays through it, and how large the blur is.
// The lesson uses the same letters: a and b in the square, φ the angle, k the side of the polygon.
#include "chapters/12_distribution/lens.hpp"

#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

Vec2 disc_point(const Vec2& random) {
    // 12.6  Move the square's middle to 0 and make its half side 1: that gives (a, b). The greater
    // of |a| and |b| says on which circle the point comes to lie, and how far it is along its side of the
    // square, between −1 and 1, says how far it is along that quarter of the circle. Mind the middle.
    return todo("12.6");
}

Vec2 polygon_point(int sides, Real turn, const Vec2& random) {
    // 12.6  Take the disc's point. Its angle, as a part of a whole turn, says how far to go along
    // the polygon's edge: past how many corners, and what part of the side after the last of them. Return
    // that point of the edge, times the radius of the disc's point.
    return todo("12.6");
}

Ray lens_ray(const View& view, const Lens& lens, Real x, Real y, const Vec2& on_lens) {
    // 12.7  pixel_ray's ray goes through the middle of the lens. Find where it meets the plane in
    // focus, as seen from the middle of the lens; then from where on the lens the new ray starts, and in
    // which direction the point in focus is from there. If you measure in units of lens.distance, planes that
    // are very far away, or infinitely far, need no care.
    return todo("12.7");
}

Real blur_radius(const Lens& lens, Real depth) {
    // 12.7  The rays from the rim of the lens through the point are a double cone. Its radius is
    // lens.radius at the lens, 0 at the point, and linear in between and beyond. A point that is infinitely
    // far away makes it a cylinder.
    return todo("12.7");
}

}  // namespace rt
