// Exact arithmetic for the few cases that floating point cannot decide.
#include "common/math/exact.hpp"

#include "common/math/error.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace rt {
namespace {

__extension__ using Wide = unsigned __int128;

/// A finite number as ±significand · 2^exponent.
struct Parts {
    std::uint64_t significand = 0;
    int exponent = 0;
    bool negative = false;
};

Parts parts_of(Real x) {
    static_assert(std::numeric_limits<Real>::is_iec559 && sizeof(Real) == 8);
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const int biased = static_cast<int>((bits >> 52) & 0x7ff);
    const bool negative = (bits >> 63) != 0;
    if (biased == 0) return {fraction, -1074, negative};
    return {fraction | (std::uint64_t{1} << 52), biased - 1075, negative};
}

/// Where a bound derived for rounding alone also covers what underflow takes away: a few times 2^-1074.
constexpr Real least_bound = 0x1p-960;

}  // namespace

void ExactSum::touch(std::size_t first, std::size_t last) {
    if (low >= high) {
        low = high = first;
    }
    while (low > first) digits[--low] = 0;
    while (high < last) digits[high++] = 0;
}

void ExactSum::add(Real a, Real b, Real c) {
    const Parts x = parts_of(a), y = parts_of(b), z = parts_of(c);
    if (x.significand == 0 || y.significand == 0 || z.significand == 0) return;
    const int position = x.exponent + y.exponent + z.exponent - lowest_bit;
    const auto digit = static_cast<std::size_t>(position / digit_bits);
    const int shift = position % digit_bits;

    // 53 + 53 + 53 bits of product and 31 of shift fit into three words.
    const Wide xy = Wide{x.significand} * y.significand;
    const Wide lower = Wide{static_cast<std::uint64_t>(xy)} * z.significand;
    const Wide upper = Wide{static_cast<std::uint64_t>(xy >> 64)} * z.significand + (lower >> 64);
    const Wide low_words = (upper << 64) | static_cast<std::uint64_t>(lower);
    const std::uint64_t top = static_cast<std::uint64_t>(upper >> 64);
    std::array<std::uint64_t, 3> words{static_cast<std::uint64_t>(low_words),
                                       static_cast<std::uint64_t>(low_words >> 64), top};
    if (shift > 0) {
        words[2] = (words[2] << shift) | (words[1] >> (64 - shift));
        words[1] = (words[1] << shift) | (words[0] >> (64 - shift));
        words[0] <<= shift;
    }

    touch(digit, digit + 6);
    const bool negative = x.negative != (y.negative != z.negative);
    for (std::size_t i = 0; i < 6; ++i) {
        const auto part = static_cast<std::int64_t>((words[i / 2] >> (i % 2 * 32)) & 0xffffffffu);
        digits[digit + i] += negative ? -part : part;
    }
}

void ExactSum::add(const ExactSum& other) {
    if (other.low >= other.high) return;
    touch(other.low, other.high);
    for (std::size_t i = other.low; i < other.high; ++i) digits[i] += other.digits[i];
}

/// Carries propagated; the absolute value's digits in [low, high + 2). Returns whether the sum is negative.
bool ExactSum::normalise(std::array<std::uint32_t, size + 2>& magnitude) const {
    const auto carry_through = [&](std::int64_t sign) {
        std::int64_t carry = 0;
        for (std::size_t i = low; i < high; ++i) {
            carry += sign * digits[i];
            magnitude[i] = static_cast<std::uint32_t>(carry);
            carry >>= digit_bits;  // rounds down, so that digits stay positive
        }
        magnitude[high] = static_cast<std::uint32_t>(carry);
        magnitude[high + 1] = static_cast<std::uint32_t>(carry >> digit_bits);
        return carry < 0;
    };
    const bool negative = carry_through(1);
    if (negative) carry_through(-1);
    return negative;
}

int ExactSum::sign() const {
    if (low >= high) return 0;
    std::array<std::uint32_t, size + 2> magnitude;
    if (normalise(magnitude)) return -1;
    const auto begin = magnitude.begin();
    const auto first = begin + static_cast<std::ptrdiff_t>(low);
    return std::any_of(first, begin + static_cast<std::ptrdiff_t>(high) + 2,
                       [](std::uint32_t digit) { return digit != 0; });
}

Scaled ExactSum::value() const {
    if (low >= high) return {};
    std::array<std::uint32_t, size + 2> magnitude;
    const bool negative = normalise(magnitude);
    std::size_t top = high + 2;
    while (top > low && magnitude[top - 1] == 0) --top;
    if (top == low) return {};

    // The greatest three digits hold at least 65 bits; all below only tells which way to round a tie.
    Wide leading = 0;
    for (std::size_t i = 0; i < 3; ++i)
        leading = (leading << digit_bits) | (top >= low + 1 + i ? magnitude[top - 1 - i] : 0);
    if (top > low + 3) {
        const auto begin = magnitude.begin() + static_cast<std::ptrdiff_t>(low);
        const auto end = magnitude.begin() + static_cast<std::ptrdiff_t>(top) - 3;
        if (std::any_of(begin, end, [](std::uint32_t digit) { return digit != 0; })) leading |= 1;
    }
    // Their last bit stands for 2^position.
    const int position = lowest_bit + digit_bits * (static_cast<int>(top) - 3);
    int exponent = 0;
    const Real mantissa = std::frexp(static_cast<Real>(leading), &exponent);
    return {negative ? -mantissa : mantissa, exponent + position};
}

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
    const Real left = (b.x - a.x) * (c.y - a.y);
    const Real right = (b.y - a.y) * (c.x - a.x);
    const Real area = left - right;
    // Each product has three roundings, their difference one more, the bound itself two. NaN and infinity
    // fail the comparison.
    const Real bound = gamma(6) * (std::abs(left) + std::abs(right));
    if (std::abs(area) > bound && bound > least_bound) return area > 0 ? 1 : -1;

    ExactSum sum;
    sum.add(b.x, c.y), sum.subtract(b.x, a.y), sum.subtract(a.x, c.y);
    sum.subtract(b.y, c.x), sum.add(b.y, a.x), sum.add(a.y, c.x);
    return sum.sign();
}

Vec3 exact_normal(std::span<const Vec3> vertices) {
    std::array<Scaled, 3> normal;
    int greatest = std::numeric_limits<int>::min();
    for (int z = 0; z < 3; ++z) {
        const int x = (z + 1) % 3, y = (z + 2) % 3;
        // Twice the area of the shadow along z, edge by edge.
        ExactSum sum;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const Vec3& p = vertices[i];
            const Vec3& q = vertices[(i + 1) % vertices.size()];
            sum.add(p[x], q[y]);
            sum.subtract(p[y], q[x]);
        }
        Scaled& coordinate = normal[static_cast<std::size_t>(z)];
        coordinate = sum.value();
        if (coordinate.mantissa != 0) greatest = std::max(greatest, coordinate.exponent);
    }
    Vec3 result;
    for (int i = 0; i < 3; ++i) {
        const auto [mantissa, exponent] = normal[static_cast<std::size_t>(i)];
        result[i] = mantissa == 0 ? 0 : std::ldexp(mantissa, exponent - greatest);
    }
    return result;
}

namespace {

/// Adds the determinant of the columns p, q and r.
void add_determinant(ExactSum& sum, const Vec3& p, const Vec3& q, const Vec3& r, Real sign = 1) {
    for (int x = 0; x < 3; ++x) {
        const int y = (x + 1) % 3, z = (x + 2) % 3;
        sum.add(sign * p[x], q[y], r[z]);
        sum.subtract(sign * p[x], q[z], r[y]);
    }
}

/// The volume d · ((p − o) × (q − o)) for the ray o + t·d.
ExactSum volume(const Ray& ray, const Vec3& p, const Vec3& q) {
    const auto& [o, d] = std::pair(ray.origin, ray.direction);
    ExactSum sum;
    add_determinant(sum, d, p, q);
    add_determinant(sum, d, p, o, -1);
    add_determinant(sum, d, o, q, -1);
    return sum;
}

/// The quotient, rounded once; the divisor is not 0. Infinite or 0 where it leaves the range of Real.
Real quotient(const Scaled& a, const Scaled& b) {
    return std::ldexp(a.mantissa / b.mantissa, a.exponent - b.exponent);
}

}  // namespace

std::optional<Crossing> exact_crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Ray& ray) {
    const ExactSum u = volume(ray, b, c), v = volume(ray, c, a), w = volume(ray, a, b);
    const int signs[] = {u.sign(), v.sign(), w.sign()};
    const auto [least, greatest] = std::minmax({signs[0], signs[1], signs[2]});
    if (least < 0 && greatest > 0) return std::nullopt;
    if (least == 0 && greatest == 0) return std::nullopt;

    ExactSum sum;
    sum.add(u);
    sum.add(v);
    sum.add(w);
    // The height of the origin over the plane, times the normal's length; along the direction it is t times
    // sum.
    ExactSum height;
    add_determinant(height, a, b, c);
    add_determinant(height, ray.origin, b, c, -1);
    add_determinant(height, a, ray.origin, c, -1);
    add_determinant(height, a, b, ray.origin, -1);
    const Scaled whole = sum.value();
    return Crossing{quotient(height.value(), whole),
                    {quotient(v.value(), whole), quotient(w.value(), whole)}};
}

bool exact_passes_through(std::span<const Vec3> polygon, const Ray& ray) {
    const Vec3& d = ray.direction;
    const Vec3 size = glm::abs(d);
    const int z = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int y = (z + 2) % 3;

    // Seen along the ray a corner has the height y − (d.y/d.z)·z over it.
    const auto above = [&](const Vec3& p) {
        ExactSum height;
        height.add(p[y], d[z]), height.subtract(ray.origin[y], d[z]);
        height.subtract(p[z], d[y]), height.add(ray.origin[z], d[y]);
        return height.sign() * (d[z] > 0 ? 1 : -1) > 0;
    };
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& p = polygon[i];
        const Vec3& q = polygon[(i + 1) % polygon.size()];
        const bool p_above = above(p), q_above = above(q);
        if (p_above == q_above) continue;
        // From the lower end to the upper the corners turn counterclockwise around the ray where the edge is
        // on its right.
        const int turn = volume(ray, p, q).sign() * (d[z] > 0 ? 1 : -1);
        if ((q_above ? turn : -turn) > 0) inside = !inside;
    }
    return inside;
}

}  // namespace rt
