// A lens instead of a pinhole: points of its opening, rays through it, and how large the blur is; and a lens
// that leans.
// The lesson uses the same letters: a and b in the square, φ the angle, k the side of the polygon.
#include "chapters/12_distribution/lens.hpp"

#include <cmath>

namespace rt {

Vec2 disc_point(const Vec2& random) {
    // [exercise 12.6] Move the square's middle to 0 and make its half side 1: that gives (a, b). The greater
    // of |a| and |b| says on which circle the point comes to lie, and how far it is along its side of the
    // square, between −1 and 1, says how far it is along that quarter of the circle. Mind the middle.
    const Real a = 2 * random.x - 1, b = 2 * random.y - 1;
    if (a == 0 && b == 0) return Vec2(0);
    // The left side needs no case of its own: with a < 0 the point (cos φ, sin φ) is turned to the other end.
    if (std::abs(a) > std::abs(b)) {
        const Real phi = pi / 4 * (b / a);
        return a * Vec2(std::cos(phi), std::sin(phi));
    }
    // From the top, the angle runs to the right: sine and cosine change places.
    const Real phi = pi / 4 * (a / b);
    return b * Vec2(std::sin(phi), std::cos(phi));
    // [/exercise]
}

Vec2 polygon_point(int sides, Real turn, const Vec2& random) {
    // [exercise 12.6] Take the disc's point. Its angle, as a part of a whole turn, says how far to go along
    // the polygon's edge: past how many corners, and what part of the side after the last of them. Return
    // that point of the edge, times the radius of the disc's point.
    const Vec2 in_disc = disc_point(random);
    const Real along = sides * (std::atan2(in_disc.y, in_disc.x) / (2 * pi));
    // From −sides/2 to sides/2: the corners before the first one are those of the last round.
    const Real k = std::floor(along);
    const auto corner = [&](Real number) {
        const Real angle = turn + 2 * pi * number / sides;
        return Vec2(std::cos(angle), std::sin(angle));
    };
    const Real rest = along - k;
    return glm::length(in_disc) * ((1 - rest) * corner(k) + rest * corner(k + 1));
    // [/exercise]
}

Ray lens_ray(const View& view, const Lens& lens, Real x, Real y, const Vec2& on_lens) {
    // [exercise 12.7] pixel_ray's ray goes through the middle of the lens. Find where it meets the plane in
    // focus, as seen from the middle of the lens; then from where on the lens the new ray starts, and in
    // which direction the point in focus is from there. If you measure in units of lens.distance, planes that
    // are very far away, or infinitely far, need no care.
    const Ray pinhole = pixel_ray(view, x, y);
    const Vec3 beside = on_lens.x * view.frame.u + on_lens.y * view.frame.v;
    // A step along the ray takes it cos = −d·w along the view; the plane is one distance away along the view.
    const Vec3 in_focus = pinhole.direction / -dot(pinhole.direction, view.frame.w);
    const Vec3 aim = in_focus - lens.radius / lens.distance * beside;
    return Ray{pinhole.origin + lens.radius * beside, normalize(aim)};
    // [/exercise]
}

Real blur_radius(const Lens& lens, Real depth) {
    // [exercise 12.7] The rays from the rim of the lens through the point are a double cone. Its radius is
    // lens.radius at the lens, 0 at the point, and linear in between and beyond. A point that is infinitely
    // far away makes it a cylinder.
    if (depth == infinity) return lens.radius;
    // |1 − distance/depth| would lose its digits where depth is nearly the distance. The difference is exact
    // there (Sterbenz 1974).
    return lens.radius * (std::abs(depth - lens.distance) / depth);
    // [/exercise]
}

Ray tilted_lens_ray(const View& view, Real radius, const FocusPlane& plane, Real x, Real y,
                    const Vec2& on_lens) {
    // [exercise 12.24] The ray through this point of the lens whose pixel is sharp in the given plane.
    const auto& [eye, straight, time] = pixel_ray(view, x, y);
    const Vec3 aside = radius * (on_lens.x * view.frame.u + on_lens.y * view.frame.v);
    // 1/t of where the ray from the middle meets the plane: 0 if it never does, negative if that is behind.
    const Real inverse = dot(straight, plane.normal) / dot(plane.point - eye, plane.normal);
    return Ray{eye + aside, normalize(straight - inverse * aside), time};
    // [/exercise]
}

}  // namespace rt
