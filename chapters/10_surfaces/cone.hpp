// Cones and cylinders, solid or open: all that is round about an axis and straight along it.
// The lesson uses the same letters: u for the axis from a to b, e and m across it, α and β for the radius.
// ε is the unit roundoff of `Real`.
#pragma once

#include "chapters/02_spheres/quadratic.hpp"
#include "chapters/10_surfaces/span.hpp"
#include "common/scene/shapes.hpp"
#include "common/world/bounds.hpp"

namespace rt {

/// A line as a cone sees it that stands on the axis u = b − a. Its τ is counted from near the cone, not from
/// where a ray begins: the ray's t is from + τ. The point at τ
///   – is at s = along + τ·along_step, where s = 0 is at a and s = 1 at b,
///   – and its distance from the axis, times |u|, is |e + τ·m|; where the cone is, that equals α + τ·β, which
///     is the cone's radius at s, times |u|.
struct ConeLine {
    Vec3 e = Vec3(0), m = Vec3(0);
    Real alpha = 0, beta = 0;
    Real a = 0;  ///< m·m − β²: 0 of a line parallel to the side, negative of a steeper one. Known here, so
                 ///< that all who ask which of these a line is are told the same
    Real along = 0, along_step = 0;
    Real from = 0;
};

/// [10.4] The line of the ray as the cone sees it. τ is 0 at the point of the line that is nearest to the
/// narrower end, which is a if both are equal. With f, the vector from that end to that point, e = f × u and
/// m = direction × u.
ConeLine cone_line(const Cone& cone, const Ray& ray);

/// [10.4] Where |e + τ·m| = |α + τ·β|: the roots of a·τ² + 2·(e·m − αβ)·τ + (e·e − α²), ascending.
/// That is where the line meets the double cone, endless and mirrored at its apex, of which the cone is a
/// part.
///
/// The discriminant is |α·m − β·e|² − |e × m|², which subtracts only numbers of the cone's own size: the
/// square of its radius, and that of the distance between line and axis. A line parallel to the side of the
/// cone meets it once, and one along the axis of a cylinder nowhere.
Roots side_roots(const ConeLine& line);

/// [10.5] The part of the ray's line that is inside the cone, or nothing. Face 0 is the side, 1 the cap at a,
/// 2 the cap at b; where the line goes through the apex, a cap of radius 0 may be met instead of the side.
///
/// Hit or miss, and each end but for 8ε|t|, are those of a cone whose surface is moved by no more than η
/// along its axis, and η(1 + |radius_b − radius_a|/|u|) across it: η = 8ε|f| + 40ε(|u| + the greater radius),
/// where f = origin − a.
std::optional<Span> inside(const Cone& cone, const Ray& ray);

/// Nearest hit with the solid cone's surface in (range.min, range.max], or nothing. `Hit::element` is the
/// face. Given.
std::optional<Hit> intersect(const Cone& cone, const Ray& ray, Interval range);

/// [10.6] Nearest hit with the side alone, from its one end to the other, both included; as exact as
/// `inside`.
std::optional<Hit> intersect(const OpenCone& open, const Ray& ray, Interval range);

/// [10.6] The unit normal of the cone's side, outward, where `radial`, a unit vector perpendicular to the
/// axis, leads from the axis to the surface.
Vec3 side_normal(const Cone& cone, const Vec3& radial);

/// The surface at a hit: the point, moved onto the side or the cap; the unit normal, outward. At the apex,
/// where there is no normal, it is one of those around it. Given.
Surface surface_at(const Cone& cone, const Ray& ray, const Hit& hit);
Surface surface_at(const OpenCone& open, const Ray& ray, const Hit& hit);

/// The smallest box around both ends, up to rounding. Given.
Bounds bounds_of(const Cone& cone);
Bounds bounds_of(const OpenCone& open);

}  // namespace rt
