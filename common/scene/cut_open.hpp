// Surfaces that end at their box, and so enclose nothing.
#pragma once

#include "common/scene/shapes.hpp"

#include <optional>

namespace rt {

/// A point on a face of the box of an implicit surface or a quadric where the surface is cut open: it has an
/// inside there, and on beyond the box, by 2⁻⁴⁰ of its size. Nothing where the surface is closed or just
/// touches its box, or where interval arithmetic on 1024 pieces of each face does not find out; nor of other
/// shapes.
std::optional<Vec3> cut_open(const FileShape& shape);

/// Whether one alone has an inside, where glass bends and absorbs light.
inline bool has_inside(const FileShape& shape) { return words_of(shape).has_inside && !cut_open(shape); }

}  // namespace rt
