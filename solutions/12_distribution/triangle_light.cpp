// Directions to a light that is a triangle, evenly by solid angle.
// The lesson uses the same letters: a, b and c for the corners as they are from the viewer, A, B for unit
// vectors to two of them, y/x for the tangent of half a solid angle, and c′ for a point of the side ac.
#include "chapters/12_distribution/triangle_light.hpp"

#include <cmath>

namespace rt {
namespace {

/// −det(a, b, c), six times the volume of the pyramid from the viewer to the triangle; positive on the bright
/// side. By the two sides, not three corners, and with the nearest corner as its top: so it keeps its digits
/// where the triangle is small and far away, or where the viewer is next to a corner. Given.
[[maybe_unused]] Real six_volumes(const SeenTriangle& t) {
    const Vec3& nearer = dot(t.b, t.b) < dot(t.a, t.a) ? t.b : t.a;
    const Vec3& nearest = dot(t.c, t.c) < dot(nearer, nearer) ? t.c : nearer;
    return -dot(nearest, cross(t.ab, t.ac));
}

/// What `along` has besides its part in the direction of the unit vector. Given.
[[maybe_unused]] Vec3 rest_beside(const Vec3& direction, const Vec3& along) {
    return along - dot(along, direction) * direction;
}

/// The part s of the way from `start` to start + side, in [0, 1], at which a viewer at 0 has turned by
/// `angle` from where he sees the start. Given.
[[maybe_unused]] Real part_at(Real angle, const Vec3& start, const Vec3& side) {
    // In the plane of both, start + s·side is (|start| + s·p, s·q), and angle is that of this point.
    const Vec3 direction = unit(start);
    const Real p = dot(side, direction), q = length(rest_beside(direction, side));
    const Real above = length(start) * std::sin(angle), below = q * std::cos(angle) - p * std::sin(angle);
    return above >= 0 && above < below ? above / below : 1;
}

}  // namespace

Real solid_angle(const SeenTriangle& triangle) {
    // [exercise 12.12] Van Oosterom and Strackee's formula, from −2π to 2π.
    const auto& [a, b, c, ab, ac] = triangle;
    const Real la = length(a), lb = length(b), lc = length(c);
    const Real x = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
    return 2 * std::atan2(six_volumes(triangle), x);
    // [/exercise]
}

Real solid_angle(const TriangleLight& light, const Vec3& from) { return solid_angle(seen(light, from)); }

std::optional<LightDirection> toward(const SeenTriangle& triangle, const Vec2& random) {
    // [exercise 12.12] A uniform direction to the triangle: first to the point c′ of the side ac, then along
    // the side bc′.
    const auto& [a, b, c, ab, ac] = triangle;
    const Real omega = solid_angle(triangle), half = random.x * omega / 2;
    if (!(omega > 0)) return std::nullopt;
    const Vec3 A = unit(a), sum = A + unit(b), beside = rest_beside(A, ac);
    const Real q = length(beside);
    // n/m is the tangent of half of ψ, the angle from a to c′.
    const Real n = std::sin(half) * length(b) * dot(sum, sum) / 2;  // |b| + A·b = |b|·(1 + A·B)
    const Real m =
        std::cos(half) * six_volumes(triangle) / (length(a) * q) - std::sin(half) * dot(ab, beside / q);
    const Vec3 side = part_at(2 * std::atan2(n, m), a, ac) * ac - ab;  // from b to c′
    const Real eta = std::atan2(length(cross(b, side)), dot(b, b + side));
    // 1 − cos is 2·sin² of the half.
    const Real theta = 2 * std::asin(std::sqrt(random.y) * std::sin(eta / 2));
    return aimed(b + part_at(theta, b, side) * side, 1 / omega);
    // [/exercise]
}

std::optional<LightDirection> toward(const TriangleLight& light, const Vec3& from, const Vec2& random) {
    return toward(seen(light, from), random);
}

}  // namespace rt
