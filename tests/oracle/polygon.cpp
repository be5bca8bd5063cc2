// The exact judge of points, lines and polygons in the plane.
#include "tests/oracle/polygon.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace rt::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 point_2(const Vec2& p) { return {p.x, p.y}; }

}  // namespace

int orientation(const Vec2& p, const Vec2& q, const Vec2& r) {
    return CGAL::orientation(point_2(p), point_2(q), point_2(r));
}

Place place_in_polygon(std::span<const Vec2> polygon, const Vec2& point) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2& p = polygon[i];
        const Vec2& q = polygon[(i + 1) % polygon.size()];
        const Kernel::Point_2 from = point_2(p), to = point_2(q), at = point_2(point);
        if (at == from ||
            (CGAL::collinear(from, at, to) && CGAL::collinear_are_ordered_along_line(from, at, to)))
            return Place::Boundary;
        if ((p.y <= point.y) == (q.y <= point.y)) continue;
        const int turn = CGAL::orientation(from, to, at);
        if (p.y < q.y ? turn > 0 : turn < 0) inside = !inside;
    }
    return inside ? Place::Inside : Place::Outside;
}

}  // namespace rt::oracle
