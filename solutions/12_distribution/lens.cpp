// A lens instead of a pinhole: points of its opening, rays through it, and how large the blur is; and a lens
// that leans.
// The lesson uses the same letters: a and b in the square, φ the angle, k the side of the polygon.
#include "chapters/12_distribution/lens.hpp"

#include <cmath>

namespace rt {

Vec2 disc_point(const Vec2& random) {
    // [exercise 12.6] The concentric map from the square to the disc.
    const Real a = 2 * random.x - 1, b = 2 * random.y - 1;
    // The greater of |a| and |b| is the radius; the other one, as a part of it, goes along a quarter of the
    // circle.
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
    // [exercise 12.6] The point of the disc, moved so that its circle becomes the regular polygon.
    const Vec2 in_disc = disc_point(random);
    // As a part of a turn, the angle says how far to go along the polygon's edge.
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
    // [exercise 12.7] The ray through this point of the lens, aimed at the point where the pinhole's ray
    // meets the plane in focus.
    const Ray pinhole = pixel_ray(view, x, y);
    const Vec3 beside = on_lens.x * view.frame.u + on_lens.y * view.frame.v;
    // A step along the ray takes it cos = −d·w along the view; the plane is one distance away along the view.
    const Vec3 in_focus = pinhole.direction / -dot(pinhole.direction, view.frame.w);
    const Vec3 aim = in_focus - lens.radius / lens.distance * beside;
    return Ray{pinhole.origin + lens.radius * beside, normalize(aim)};
    // [/exercise]
}

Real blur_radius(const Lens& lens, Real depth) {
    // [exercise 12.7] The radius, in the plane in focus, of the double cone of all rays from the lens through
    // the point.
    if (depth == infinity) return lens.radius;
    // |1 − distance/depth| would lose its digits where depth is nearly the distance. The difference is exact
    // there (Sterbenz 1974).
    return lens.radius * (std::abs(depth - lens.distance) / depth);
    // [/exercise]
}

Ray tilted_lens_ray(const View& view, Real radius, const FocusPlane& plane, Real x, Real y,
                    const Vec2& on_lens) {
    // [exercise 12.24] The ray through this point of the lens, with the given plane in focus.
    const auto& [eye, straight, time] = pixel_ray(view, x, y);
    const Vec3 aside = radius * (on_lens.x * view.frame.u + on_lens.y * view.frame.v);
    // 1/t of where the ray from the middle meets the plane: 0 if it never does, negative if that is behind.
    const Real inverse = dot(straight, plane.normal) / dot(plane.point - eye, plane.normal);
    return Ray{eye + aside, normalize(straight - inverse * aside), time};
    // [/exercise]
}

}  // namespace rt
