// The torus: a tube whose middle is a ring.
// The lesson uses the same letters: n for the axis, q for where the line is nearest to the centre, e for its
// direction, τ for the way along it from q, R for the ring's radius and r for the tube's.
// ε is the unit roundoff of `Real`.
#pragma once

#include "chapters/10_surfaces/polynomial.hpp"
#include "chapters/10_surfaces/span.hpp"
#include "common/scene/shapes.hpp"
#include "common/world/bounds.hpp"

#include <array>
#include <optional>

namespace rt {

/// A line as a torus sees it. Its point at τ is q + τ·e, as seen from the centre; the ray's t is
/// from + τ/speed.
struct TorusLine {
    Vec3 q = Vec3(0);  ///< the line's point nearest to the centre, perpendicular to e
    Vec3 e = Vec3(0);  ///< unit vector along the line
    Vec3 n = Vec3(0);  ///< unit vector along the axis
    Real from = 0;
    Real speed = 1;  ///< |direction|
};

/// The line of the ray, or nothing where it passes the ball around the torus. Given; as `cone_line`.
std::optional<TorusLine> torus_line(const Torus& torus, const Ray& ray);

/// [10.9] The quartic, as a polynomial in σ = τ − base, that is positive outside of the torus and 0 on its
/// surface: Q² − P, both of degree 2. With x the point, ρ its distance from the axis and z = x·n,
///   – if the ring is wide, R ≥ 2r:  Q = x·x − R² − r²,         P = 4R²·(r² − z²);
///   – if it is not:                 Q = x·x + (R − r)(R + r),  P = 4R²·ρ².
/// Both are the same quartic. Where the surface is, the first subtracts no more than the tube's size from the
/// ring's, and the second no more than it must near the axis.
///
/// Where R < r it is also positive in the lemon around the axis, inside the ball |x|² ≤ r² − R², in which Q ≤
/// 0.
Polynomial torus_quartic(const Torus& torus, const TorusLine& line, Real base);

/// The parts of a line that are inside, in order, without a point in common.
struct TorusSpans {
    int count = 0;
    std::array<Span, 2> spans{};  ///< in units of the ray's direction; the face is 0
};

/// [10.10] The parts of the ray's line that are inside the torus. Inside is where the ring is no farther than
/// r; so for R = r the hole is closed to one point, and for R < r there is none.
///
/// Inside or not is right everywhere unless moving the surface by η would change the answer, and each end is
/// one of the moved surface, but for 8ε|t|: η = 8ε|f| + 40ε(R + r), where f = origin − centre.
TorusSpans inside(const Torus& torus, const Ray& ray);

/// Nearest hit with the torus's surface in (range.min, range.max], or nothing. Given.
std::optional<Hit> intersect(const Torus& torus, const Ray& ray, Interval range);

/// The surface at a hit: the point, moved onto the surface, and the unit normal, away from the ring. Where
/// the hole is no wider than rounding, the point is moved along the surface until a ray can leave it. Given.
Surface surface_at(const Torus& torus, const Ray& ray, const Hit& hit);

/// The smallest box around the torus, up to rounding. Given.
Bounds bounds_of(const Torus& torus);

}  // namespace rt
