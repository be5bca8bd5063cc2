// Directions to a light that is a rectangle, evenly by solid angle.
// The lesson uses the same letters: (x, y, z) for a point of the light along its sides and its normal, as
// seen by the viewer, β for the angle by which he turns up from the z axis to y₀ or y₁, and k for the solid
// angle of a strip from x = 0 on.
#include "chapters/12_distribution/rectangle_light.hpp"

#include "common/math/error.hpp"

#include <cmath>

namespace rt {
namespace {

/// Whether the closed formula answers well. Given.
[[maybe_unused]] bool is_easy(const QuadLight& light, Real omega) {
    const Real skew = dot(light.ab, light.ac) / (length(light.ab) * length(light.ac));
    return omega >= 0x1p-20 && std::abs(skew) < 0x1p-40;
}

/// The solid angle of the part of a strip, y from y0 to y1, that is to the left of x: from where x is 0 on,
/// so that it is negative for negative x. Given.
[[maybe_unused]] Real left_of(Real x, Real y0, Real y1, Real z) {
    const auto corner = [&](Real y) { return std::atan2(x * y, z * length(Vec3(x, y, z))); };
    return corner(y1) - corner(y0);
}

/// 1 + s and 1 − s of the sine s = y/√(y² + d²), d > 0, both of them right to some u. Given.
[[maybe_unused]] Vec2 around_sine(Real y, Real d) {
    const Real r = std::hypot(y, d), greater = 1 + std::abs(y) / r, lesser = (d / r) * (d / r) / greater;
    return y < 0 ? Vec2(lesser, greater) : Vec2(greater, lesser);
}

/// What rounding may have made negative, or 0 where a quotient needs more. Given.
[[maybe_unused]] Real positive(Real x) { return std::max(x, std::numeric_limits<Real>::min()); }

}  // namespace

std::array<SeenTriangle, 2> halves(const QuadLight& light, const Vec3& from) {
    const Vec3 ab = light.ab, ac = light.ac, ad = ab + ac;
    const Vec3 a = light.corner - from, b = a + ab, c = a + ac, d = a + ad;
    return {SeenTriangle{a, d, b, ad, ab}, SeenTriangle{a, c, d, ac, ad}};
}

Real solid_angle(const QuadLight& light, const Vec3& from) {
    // [exercise 12.13] The solid angle of the whole parallelogram.
    const auto both = halves(light, from);
    return solid_angle(both[0]) + solid_angle(both[1]);
    // [/exercise]
}

std::optional<LightDirection> toward_a_half(const QuadLight& light, const Vec3& from, const Vec2& random) {
    const auto both = halves(light, from);
    // Seen nearly from the side, rounding may make one of them dark.
    const Real first = std::max(solid_angle(both[0]), Real(0)),
               second = std::max(solid_angle(both[1]), Real(0));
    if (!(first + second > 0)) return std::nullopt;
    const Real place = random.x * (first + second);
    const bool in_first = place < first || second == 0;
    const Real part = in_first ? place / first : (place - first) / second;
    auto found = toward(both[in_first ? 0 : 1], Vec2(std::min(part, 1 - unit_roundoff), random.y));
    if (found) found->pdf = 1 / (first + second);
    return found;
}

std::optional<LightDirection> toward(const QuadLight& light, const Vec3& from, const Vec2& random) {
    // [exercise 12.13] A uniform direction to the rectangle: first the x, then the y of a point of it. Where
    // the given is_easy says no, toward_a_half answers.
    const Real omega = solid_angle(light, from);
    const Vec3 a = light.corner - from, right = unit(light.ab), up = unit(light.ac);
    const Real x0 = dot(a, right), x1 = x0 + length(light.ab), y0 = dot(a, up), y1 = y0 + length(light.ac);
    const Real z = dot(a, cross(right, up)), b0 = std::atan2(y0, z), b1 = std::atan2(y1, z);
    if (!(z > 0) || !is_easy(light, omega)) return toward_a_half(light, from, random);
    const Real k = std::lerp(left_of(x0, y0, y1, z), left_of(x1, y0, y1, z), random.x);
    // (cos k − cos(β₁ − β₀))·(cos k + cos(β₁ + β₀)) as products, each factor of which has its digits
    const Real first = std::sin((b1 - b0 + k) / 2) * std::sin((b1 - b0 - k) / 2);
    const Real second = std::cos((b1 + b0 + k) / 2) * std::cos((b1 + b0 - k) / 2);
    const Real x = std::clamp(z * std::sin(k) / (2 * std::sqrt(positive(first * second))), x0, x1);
    const Real d = std::hypot(x, z);
    const Vec2 h = glm::mix(around_sine(y0, d), around_sine(y1, d), random.y);
    const Real y = std::clamp(d * (h.x - h.y) / (2 * std::sqrt(h.x * h.y)), y0, y1);
    return aimed(a + (x - x0) * right + (y - y0) * up, 1 / omega);
    // [/exercise]
}

}  // namespace rt
