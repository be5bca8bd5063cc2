// Functions of the plane whose mean over a rectangle is known: what sampling is measured against.
#pragma once

#include "common/math/vec.hpp"

namespace rt::test {

/// 1 where normal · p < offset, else 0: a straight edge. `normal` is of any length but 0.
struct HalfPlane {
    Vec2 normal{1, 0};
    Real offset = 0;
};

/// 1 nearer to the centre than the radius, else 0.
struct Disk {
    Vec2 center{0};
    Real radius = 1;
};

/// (1 + cos(frequency · |p − center|²))/2: rings that become narrower outwards. Smooth; at distance d they
/// repeat every π/(frequency · d), nearly.
struct ZonePlate {
    Vec2 center{0};
    Real frequency = 1;
};

Real value(const HalfPlane& plane, const Vec2& p);
Real value(const Disk& disk, const Vec2& p);
Real value(const ZonePlate& plate, const Vec2& p);

/// Mean over the rectangle low ≤ p ≤ high, which must not be empty. Absolute error below 1e-13 where sides
/// are near 1, and numbers (for disks, squares of radii; for zone plates, phases) at most 100.
///
/// Half-plane: area of the clipped rectangle. Disk: sum of triangles and sectors over the rectangle's edges.
/// Zone plate: cos(x² + y²) = cos x² cos y² − sin x² sin y² leaves four integrals of one variable, by
/// Gauss–Legendre quadrature of 16 points for each half turn of the phase.
Real mean(const HalfPlane& plane, const Vec2& low, const Vec2& high);
Real mean(const Disk& disk, const Vec2& low, const Vec2& high);
Real mean(const ZonePlate& plate, const Vec2& low, const Vec2& high);

}  // namespace rt::test
