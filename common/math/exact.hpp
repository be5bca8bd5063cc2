// Exact arithmetic for the few cases that floating point cannot decide: a sum of products without rounding,
// and the signs that geometry asks for. Each question is first put to a floating-point filter, whose error
// bound is derived beside it; only what the filter cannot tell costs the exact sum.
#pragma once

#include "common/math/ray.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace rt {

/// The number mantissa · 2^exponent; 0.5 ≤ |mantissa| < 1, or 0. For numbers that may lie outside the range
/// of Real.
struct Scaled {
    Real mantissa = 0;
    int exponent = 0;
};

/// A sum of products of up to three numbers, exact for all finite ones: neither rounding nor overflow nor
/// underflow. A long accumulator (Kulisch & Miranker, Computer Arithmetic in Theory and Practice, 1981): one
/// whole number, wide enough for the greatest product and fine enough for the least. Only the digits that the
/// products reach are ever touched.
class ExactSum {
public:
    /// Adds a·b·c; all finite.
    void add(Real a, Real b, Real c = 1);
    void subtract(Real a, Real b, Real c = 1) { add(-a, b, c); }

    /// Adds another sum.
    void add(const ExactSum& other);

    /// Sign of the sum: −1, 0 or 1.
    int sign() const;

    /// The sum, rounded once, to the nearest.
    Scaled value() const;

private:
    static constexpr int digit_bits = 32;
    static constexpr int lowest_bit = -3 * 1074;  // the least product of three
    static constexpr std::size_t size = 204;      // digits up to 2^3306: products end at 2^3072

    // Digits are signed and wider than their weight, so that adding propagates no carry.
    std::array<std::int64_t, size> digits;  // only [low, high) are initialised
    std::size_t low = size, high = 0;

    void touch(std::size_t first, std::size_t last);
    bool normalise(std::array<std::uint32_t, size + 2>& magnitude) const;
};

/// Sign of the signed area of the triangle (a, b, c) in the plane: 1 where the corners turn counterclockwise,
/// −1 where clockwise, 0 where they lie on one line. Exact for all finite numbers (filter: Shewchuk, Adaptive
/// precision floating-point arithmetic and fast robust geometric predicates, 1997).
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// The normal of a polygon by Newell's method, without rounding: the direction from which the vertices turn
/// counterclockwise, as long as it happens to be, its greatest coordinate between ½ and 1; every coordinate
/// is rounded once. Zero where the polygon has no area, exactly.
Vec3 exact_normal(std::span<const Vec3> vertices);

/// Where the line of a ray meets a triangle.
struct Crossing {
    Real t = 0;       ///< in units of |ray.direction|; rounded three times, so that its sign is exact
    Vec2 weights{0};  ///< of the corners b and c, each rounded three times
};

/// Where the line of the ray passes through the closed triangle, edges and corners included; nothing where it
/// passes beside it or lies in its plane, or where the triangle has no area. Decided by the exact signs of
/// the volumes that the ray's direction spans with each edge, as seen from its origin.
std::optional<Crossing> exact_crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Ray& ray);

/// Whether the line of the ray passes through the polygon, exactly, by the even-odd rule. Seen along the ray,
/// with its direction's greatest coordinate as depth and the next two in cyclic order as x and y, crossings
/// are counted along +x, and each edge owns its lower end.
bool exact_passes_through(std::span<const Vec3> polygon, const Ray& ray);

}  // namespace rt
