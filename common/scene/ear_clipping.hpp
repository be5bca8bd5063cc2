// Triangles from the outline of a polygon in the plane, cut off corner by corner.
#pragma once

#include "common/math/vec.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rt {

/// Triangles that cover the inside of a counterclockwise outline exactly once, as indices of its corners. The
/// outline must not cross itself and has no corner inside a side; corners may be at one place, sides on one
/// another.
///
/// A corner is an ear if the triangle with its neighbours has an area and no other part of the outline is in
/// it; every polygon has two (Meisters 1975). Cutting off ears never counts a place twice: the sum of the
/// triangles' outlines is the outline, so that triangles which all go counterclockwise cover each point as
/// often as the outline goes around it. Nothing where no ear is left, which is not known to happen.
std::optional<std::vector<std::array<std::uint32_t, 3>>> clip_ears(std::span<const Vec2> outline);

}  // namespace rt
