// What a polygon sends to a point, found in another way than Lambert's: its outline, drawn onto the disc of
// Nusselt (1928), encloses an area which is the irradiance. That area is an integral along the edges, taken
// here by quadrature in long double.
#pragma once

#include "common/math/error.hpp"
#include "common/math/vec.hpp"

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace rt::test {

using Long = long double;

/// A vector in long double; x and y along the surface and z along the normal where it is one of a frame.
struct LongVec {
    Long x = 0, y = 0, z = 0;
};

inline LongVec operator+(const LongVec& a, const LongVec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline LongVec operator-(const LongVec& a, const LongVec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline LongVec operator*(Long s, const LongVec& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Long inner(const LongVec& a, const LongVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Long norm(const LongVec& a) { return std::sqrt(inner(a, a)); }
inline LongVec outer(const LongVec& a, const LongVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline LongVec wide(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Gauss & Legendre's rule of ten points.
template <class F>
Long ten_points(F f, Long a, Long b) {
    constexpr Long at[] = {0.148874338981631210884826001129720L, 0.433395394129247190799265943165784L,
                           0.679409568299024406234327365114874L, 0.865063366688984510732096688423493L,
                           0.973906528517171720077964012084452L};
    constexpr Long part[] = {0.295524224714752870173815619188769L, 0.269266719309996355091226921569469L,
                             0.219086362515982043995534934228163L, 0.149451349150580593145863396957697L,
                             0.066671344308688137593568809893332L};
    const Long middle = (a + b) / 2, half = (b - a) / 2;
    Long sum = 0;
    for (int i = 0; i < 5; ++i) sum += part[i] * (f(middle - half * at[i]) + f(middle + half * at[i]));
    return sum * half;
}

/// The integral from a to b of an f that has one sign, in halves until they agree.
template <class F>
Long integral(F f, Long a, Long b, Long whole, int depth) {
    const Long middle = (a + b) / 2, left = ten_points(f, a, middle), right = ten_points(f, middle, b);
    if (depth == 0 || std::abs(left + right - whole) <= 1e-17L * std::abs(whole)) return left + right;
    return integral(f, a, middle, left, depth - 1) + integral(f, middle, b, right, depth - 1);
}

/// Integral of (x·dy − y·dx)/ρ² along the edge from `a` to `b`, with ρ² = |d|², or x² + y² if `flat`. The
/// edge is gone along from the foot of the perpendicular, where ρ² is the square of the line's distance.
inline Long along_edge(LongVec a, LongVec b, bool flat) {
    if (flat) a.z = b.z = 0;
    const LongVec e = b - a, w = outer(a, e);
    if (w.z == 0) return 0;
    const Long square = inner(e, e), foot = -inner(a, e) / square, nearest = inner(w, w) / square;
    const auto f = [&](Long s) { return w.z / (nearest + square * s * s); };
    return integral(f, -foot, 1 - foot, ten_points(f, -foot, 1 - foot), 50);
}

struct ExactIrradiance {
    Real value = 0;
    Real bound = 0;  ///< the contract's, for a solution's error
};

/// What an edge contributes to the contract's bound: θ·(1 + (r + extra)/p).
inline Long edge_bound(const LongVec& a, const LongVec& b, Long extra) {
    const LongVec e = b - a, w = outer(a, e);
    if (!(norm(w) > 0)) return 0;
    const Long p = norm(w) / norm(e), r = std::max(norm(a), norm(b));
    return std::atan2(norm(w), inner(a, b)) * (1 + (r + extra) / p);
}

/// The corners in a frame around the point, z along the normal.
inline std::vector<LongVec> in_frame(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal) {
    const LongVec n = (1 / norm(wide(normal))) * wide(normal);
    const LongVec across = outer(n, std::abs(n.x) < 0.6L ? LongVec{1, 0, 0} : LongVec{0, 1, 0});
    const LongVec t = (1 / norm(across)) * across, s = outer(t, n);
    std::vector<LongVec> turned;
    for (const Vec3& corner : corners) {
        const LongVec d = wide(corner) - wide(point);
        turned.push_back({inner(d, s), inner(d, t), inner(d, n)});
    }
    return turned;
}

/// Irradiance of a polygon of radiance 1. Parts of the outline below the horizon are drawn onto the disc's
/// rim, where they enclose nothing; only if the nadir is in the polygon do they enclose all the rest.
inline ExactIrradiance exact_irradiance(std::span<const Vec3> corners, const Vec3& point,
                                        const Vec3& normal) {
    const std::vector<LongVec> d = in_frame(corners, point, normal);
    bool is_cut = false;
    Long greatest = size_of(point), farthest = 0;
    for (std::size_t k = 0; k < d.size(); ++k) {
        is_cut = is_cut || d[k].z < 0;
        greatest = std::max(greatest, Long(size_of(corners[k])));
        farthest = std::max(farthest, norm(d[k]));
    }
    Long area = 0, turn = 0, bound = 0;
    LongVec newell;
    for (std::size_t k = 0; k < d.size(); ++k) {
        const LongVec a = d[k], b = d[(k + 1) % d.size()];
        newell = newell + outer(a - d[0], b - d[0]);
        turn += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
        bound += edge_bound(a, b, is_cut ? greatest : 0);
        if ((a.z < 0) == (b.z < 0)) {
            area += along_edge(a, b, a.z < 0);
        } else {
            const LongVec middle = a + (a.z / (a.z - b.z)) * (b - a);
            area += along_edge(a, middle, a.z < 0) + along_edge(middle, b, b.z < 0);
        }
    }
    const Long half_turn = std::numbers::pi_v<Long>;
    if (is_cut) {
        // The edge along the horizon: p is how far the point is from the line in which the planes meet.
        const Long slope = std::hypot(newell.x, newell.y), p = std::abs(inner(newell, d[0])) / slope;
        if (slope > 0) bound += half_turn * (1 + (farthest + greatest) / p);
    }
    const bool has_nadir = std::abs(turn) > half_turn && inner(newell, d[0]) * newell.z < 0;
    const Long value = has_nadir ? half_turn - std::abs(area / 2) : std::abs(area / 2);
    return {static_cast<Real>(value), static_cast<Real>(bound) * gamma(16 + static_cast<int>(d.size()))};
}

}  // namespace rt::test
