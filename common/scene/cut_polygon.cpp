// Polygons in space, cut into triangles: along which axis to look, and the plain cases.
#include "common/scene/cut_polygon.hpp"

#include "common/math/error.hpp"
#include "common/math/exact.hpp"
#include "common/scene/ear_clipping.hpp"
#include "common/scene/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace rt {

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

constexpr std::string_view no_area = "has no area";
constexpr std::string_view crosses = "crosses itself";

Vec3 scaled(const Vec3& v, int exponent) {
    return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

/// The corners as seen from the first one, scaled by a power of two to a size of about 1. Good for
/// what need only be about right: differences round.
std::vector<Vec3> normalised(std::span<const Vec3> corners) {
    std::vector<Vec3> result(corners.begin(), corners.end());
    Real size = 0, reach = 0;
    for (const Vec3& corner : corners) reach = std::max(reach, size_of(corner));
    const int quarter = reach > 0x1p1020 ? -2 : 0;  // differences of the largest numbers overflow
    const Vec3 first = scaled(corners.front(), quarter);
    for (Vec3& corner : result) {
        corner = scaled(corner, quarter) - first;
        size = std::max(size, size_of(corner));
    }
    if (size == 0) return result;
    for (Vec3& corner : result) corner = scaled(corner, -std::ilogb(size));
    return result;
}

/// The axes along which the polygon's shadow may be, for all that rounding can do, at least half as large as
/// the largest of the three, this one first.
std::vector<int> axes_to_look_along(std::span<const Vec3> corners) {
    Vec3 normal(0), size(0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3& p = corners[i];
        const Vec3& q = corners[i + 1 == corners.size() ? 0 : i + 1];
        const Vec3 term =
            (Vec3(p.y, p.z, p.x) - Vec3(q.y, q.z, q.x)) * (Vec3(p.z, p.x, p.y) + Vec3(q.z, q.x, q.y));
        normal += term;
        size += glm::abs(term);
    }
    normal = glm::abs(normal);
    const Vec3 error = gamma(static_cast<int>(corners.size()) + 8) * size;
    std::vector<int> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return normal[a] > normal[b]; });
    const Real half = normal[axes[0]] / 2;
    std::erase_if(axes, [&](int axis) { return normal[axis] + error[axis] < half; });
    return axes;
}

/// Without the coordinate `axis`, the other two in cyclic order: what is counterclockwise stays so where the
/// normal points along the axis.
std::vector<Vec2> seen_along(int axis, std::span<const Vec3> corners) {
    std::vector<Vec2> result;
    result.reserve(corners.size());
    for (const Vec3& corner : corners) result.emplace_back(corner[(axis + 1) % 3], corner[(axis + 2) % 3]);
    return result;
}

/// Four corners: along a diagonal that has one of the other corners on each side, or else one of them on it:
/// where the corners are not in one plane, one may stand behind another.
std::optional<Triangles> cut_quad(std::span<const Vec2> p, std::span<const Vec3> about) {
    enum Fit { No, OnOneSide, Yes };
    const auto fit = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
        const int first = orientation(p[a], p[b], p[c]), second = orientation(p[a], p[c], p[d]);
        if (first == second) return first != 0 ? Yes : No;
        return first == 0 || second == 0 ? OnOneSide : No;
    };
    const auto length = [&](std::size_t a, std::size_t b) {
        const Vec3 d = about[b] - about[a];
        return glm::dot(d, d);
    };
    const Fit first = fit(0, 1, 2, 3), second = fit(1, 2, 3, 0);
    if (first == No && second == No) return std::nullopt;
    if (first > second || (first == second && length(0, 2) < length(1, 3)))
        return Triangles{{0, 1, 2}, {0, 2, 3}};
    return Triangles{{0, 1, 3}, {1, 2, 3}};
}

/// Whether all corners turn the same way, and the outline goes around once.
bool is_strictly_convex(std::span<const Vec2> p) {
    const auto at = [&](std::size_t i) -> const Vec2& { return p[i % p.size()]; };
    const auto is_rightwards = [&](std::size_t i) {
        return at(i).x < at(i + 1).x || (at(i).x == at(i + 1).x && at(i).y < at(i + 1).y);
    };
    const int sign = orientation(p[0], p[1], p[2]);
    int reversals = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (sign == 0 || orientation(at(i), at(i + 1), at(i + 2)) != sign) return false;
        reversals += is_rightwards(i) != is_rightwards(i + 1);
    }
    return reversals == 2;
}

Triangles fan(std::uint32_t count) {
    Triangles triangles;
    for (std::uint32_t i = 1; i + 1 < count; ++i) triangles.push_back({0, i, i + 1});
    return triangles;
}

/// The indices of the corners, and again those of corners inside a side, where they touch it.
std::vector<std::uint32_t> with_touches(std::uint32_t count, const std::vector<Touch>& touches) {
    std::vector<std::uint32_t> outline;
    auto touch = touches.begin();
    for (std::uint32_t i = 0; i < count; ++i) {
        outline.push_back(i);
        for (; touch != touches.end() && touch->side == i; ++touch) outline.push_back(touch->corner);
    }
    return outline;
}

/// Any polygon in the plane.
PolygonCut cut_outline(std::span<const Vec2> corners) {
    const OutlineCheck check = check_outline(corners);
    if (check.crosses) return {{}, crosses};
    if (check.turns == 0) return {{}, no_area};
    const auto outline = with_touches(static_cast<std::uint32_t>(corners.size()), check.touches);
    std::vector<Vec2> points;
    points.reserve(outline.size());
    // In a mirror what goes clockwise goes counterclockwise.
    for (const std::uint32_t i : outline)
        points.push_back(check.turns > 0 ? corners[i] : Vec2(corners[i].y, corners[i].x));
    std::optional<Triangles> triangles = clip_ears(points);
    if (!triangles) return {{}, "cannot be cut into triangles"};
    for (auto& triangle : *triangles)
        for (std::uint32_t& corner : triangle) corner = outline[corner];
    return {std::move(*triangles), {}};
}

PolygonCut cut_seen_along(int axis, std::span<const Vec3> corners, std::span<const Vec3> about) {
    const std::vector<Vec2> seen = seen_along(axis, corners);
    if (seen.size() == 4)
        if (auto triangles = cut_quad(seen, about)) return {std::move(*triangles), {}};
    if (is_strictly_convex(seen)) return {fan(static_cast<std::uint32_t>(seen.size())), {}};
    return cut_outline(seen);
}

}  // namespace

PolygonCut cut_polygon(std::span<const Vec3> corners) {
    std::vector<std::uint32_t> kept;
    std::vector<Vec3> different;
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
        if (corners[i] == corners[i == 0 ? corners.size() - 1 : i - 1]) continue;
        kept.push_back(i);
        different.push_back(corners[i]);
    }
    if (different.size() < 3) return {{}, no_area};

    const std::vector<Vec3> about = normalised(different);
    PolygonCut result;
    for (const int axis : axes_to_look_along(about)) {
        PolygonCut cut = cut_seen_along(axis, different, about);
        if (cut.problem.empty()) {
            result = std::move(cut);
            break;
        }
        if (result.problem.empty() || result.problem == no_area) result = std::move(cut);
    }
    for (auto& triangle : result.triangles)
        for (std::uint32_t& corner : triangle) corner = kept[corner];
    return result;
}

}  // namespace rt
