// The exact judge of points, lines and polygons in the plane: CGAL's predicates behind a plain header.
// Every input must be finite.
#pragma once

#include "common/math/vec.hpp"

#include <span>

namespace rt::oracle {

/// +1 where p, q, r turn counterclockwise, −1 where clockwise, 0 where they lie on one line.
int orientation(const Vec2& p, const Vec2& q, const Vec2& r);

enum class Place { Outside, Boundary, Inside };

/// Where the point is, by the even-odd rule; the polygon may cross itself.
Place place_in_polygon(std::span<const Vec2> polygon, const Vec2& point);

}  // namespace rt::oracle
