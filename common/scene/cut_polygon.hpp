// Polygons in space, cut into triangles.
#pragma once

#include "common/math/vec.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace rt {

/// The triangles of a polygon as indices of its corners, or what is wrong with it.
struct PolygonCut {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::string_view problem;  ///< continues "the polygon …"; empty where all is well
};

/// Cuts a polygon that may be concave into triangles that cover it exactly once, go around as it does, and
/// have an area. A corner at the same place as the one before it is left out, also the first one where the
/// last is at its place; from here on it does not count. Corners that lie straight between their neighbours
/// stay corners of triangles; holes may be joined to the outline by cuts that are gone along twice; the
/// outline may touch itself but not cross itself.
///
/// Decisions are made by exact signs on the given numbers, wherever the polygon is and however large. For
/// that it is looked at along the axis nearest to its mean normal (Newell's; Sutherland, Sproull & Schumacker
/// 1974), because leaving out a coordinate rounds nothing. Corners that are not quite in one plane are
/// taken as they appear from there, and the triangles join the corners where they are.
///
/// A polygon of four corners is cut along the shorter diagonal where both are inside. Only such a polygon can
/// have a triangle without area: where it folds back on itself. A strictly convex polygon is cut into a fan
/// from its first corner, others corner by corner (Meisters 1975) in about n log n steps. Problems: no area,
/// an outline that crosses itself.
PolygonCut cut_polygon(std::span<const Vec3> corners);

}  // namespace rt
