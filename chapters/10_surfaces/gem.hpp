// Solids with flat faces, as many as one likes.
#pragma once

#include "chapters/10_surfaces/span.hpp"
#include "common/scene/shapes.hpp"

#include <optional>
#include <span>

namespace rt {

/// [10.16] The part of the ray's line that is behind all of the planes, where their normals point away from,
/// or nothing. The faces of the span are the numbers of the planes in the list, from 0; where the line comes
/// in or goes out by several at once, the first of them. Behind no plane at all is everything.
///
/// The solid is closed: a line that runs in a plane is behind it. It need not be finite: the line may come in
/// at −infinity, or go out at infinity.
std::optional<Span> inside_gem(std::span<const Plane> planes, const Ray& ray);

}  // namespace rt
