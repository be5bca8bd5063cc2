// Functions of the plane whose mean over a rectangle is known: what sampling is measured against.
#include "tests/stability/coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rt::test {
namespace {

Real cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

std::array<Vec2, 4> corners(const Vec2& low, const Vec2& high) {
    return {low, Vec2(high.x, low.y), high, Vec2(low.x, high.y)};
}

Real area(const Vec2& low, const Vec2& high) { return (high.x - low.x) * (high.y - low.y); }

/// Area of the sector of the circle around the origin between the directions a and b, with the turn's sign.
Real sector(const Vec2& a, const Vec2& b, Real radius) {
    return radius * radius / 2 * std::atan2(cross(a, b), dot(a, b));
}

/// Signed area that the circle around the origin has in common with the triangle of the origin, a and b.
Real slice(const Vec2& a, const Vec2& b, Real radius) {
    // The edge a + s·d is inside the circle for s from `enter` to `leave`.
    const Vec2 d = b - a;
    const Real A = dot(d, d), B = dot(a, d), D = A * radius * radius - cross(a, d) * cross(a, d);
    if (D <= 0) return sector(a, b, radius);
    const Real enter = (-B - std::sqrt(D)) / A, leave = (-B + std::sqrt(D)) / A;
    if (enter >= 1 || leave <= 0) return sector(a, b, radius);
    const Vec2 p = a + std::max(enter, Real(0)) * d, q = a + std::min(leave, Real(1)) * d;
    return (enter > 0 ? sector(a, p, radius) : 0) + cross(p, q) / 2 + (leave < 1 ? sector(q, b, radius) : 0);
}

/// Nodes in (−1, 1) and weights of Gauss–Legendre quadrature: exact for polynomials of degree 31.
struct Rule {
    std::array<Real, 16> node{}, weight{};
};

Rule gauss_legendre() {
    Rule rule;
    const auto n = static_cast<Real>(rule.node.size());
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
        // Newton's method on the Legendre polynomial, from where its roots nearly are.
        Real x = std::cos(pi * (static_cast<Real>(i) + 0.75) / (n + 0.5)), slope = 1;
        for (int step = 0; step < 8; ++step) {
            Real p = 1, q = 0;
            for (Real k = 1; k <= n; ++k) {
                const Real next = ((2 * k - 1) * x * p - (k - 1) * q) / k;
                q = p;
                p = next;
            }
            slope = n * (x * p - q) / (x * x - 1);
            x -= p / slope;
        }
        rule.node[i] = x;
        rule.weight[i] = 2 / ((1 - x * x) * slope * slope);
    }
    return rule;
}

/// Integrals of cos(frequency · x²) and sin(frequency · x²) from low to high.
Vec2 fresnel(Real frequency, Real low, Real high) {
    static const Rule rule = gauss_legendre();
    const Real steepest = 2 * std::abs(frequency) * std::max(std::abs(low), std::abs(high));
    const Real panels = std::ceil(steepest * (high - low) / pi + 1), half = (high - low) / (2 * panels);
    Vec2 sum(0);
    for (Real panel = 0; panel < panels; ++panel) {
        const Real middle = low + (2 * panel + 1) * half;
        for (std::size_t i = 0; i < rule.node.size(); ++i) {
            const Real x = middle + half * rule.node[i], phase = frequency * x * x;
            sum += rule.weight[i] * Vec2(std::cos(phase), std::sin(phase));
        }
    }
    return sum * half;
}

}  // namespace

Real value(const HalfPlane& plane, const Vec2& p) { return dot(plane.normal, p) < plane.offset ? 1 : 0; }

Real value(const Disk& disk, const Vec2& p) {
    const Vec2 d = p - disk.center;
    return dot(d, d) < disk.radius * disk.radius ? 1 : 0;
}

Real value(const ZonePlate& plate, const Vec2& p) {
    const Vec2 d = p - plate.center;
    return (1 + std::cos(plate.frequency * dot(d, d))) / 2;
}

Real mean(const HalfPlane& plane, const Vec2& low, const Vec2& high) {
    // The rectangle, without what is on the wrong side of the edge (Sutherland & Hodgman 1974).
    const std::array<Vec2, 4> corner = corners(low, high);
    std::vector<Vec2> inside;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 &a = corner[i], &b = corner[(i + 1) % 4];
        const Real above_a = dot(plane.normal, a) - plane.offset,
                   above_b = dot(plane.normal, b) - plane.offset;
        if (above_a < 0) inside.push_back(a);
        if ((above_a < 0) != (above_b < 0)) inside.push_back(a + above_a / (above_a - above_b) * (b - a));
    }
    Real twice = 0;
    for (std::size_t i = 2; i < inside.size(); ++i)
        twice += cross(inside[i - 1] - inside[0], inside[i] - inside[0]);
    return twice / 2 / area(low, high);
}

Real mean(const Disk& disk, const Vec2& low, const Vec2& high) {
    const std::array<Vec2, 4> corner = corners(low - disk.center, high - disk.center);
    Real sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += slice(corner[i], corner[(i + 1) % 4], disk.radius);
    return sum / area(low, high);
}

Real mean(const ZonePlate& plate, const Vec2& low, const Vec2& high) {
    const Vec2 from = low - plate.center, to = high - plate.center;
    const Vec2 x = fresnel(plate.frequency, from.x, to.x), y = fresnel(plate.frequency, from.y, to.y);
    return (1 + (x.x * y.x - x.y * y.y) / area(low, high)) / 2;
}

}  // namespace rt::test
