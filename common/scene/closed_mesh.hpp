// Whether the triangles of a mesh enclose a body.
#pragma once

#include "common/scene/shapes.hpp"

namespace rt {

/// Whether each edge belongs to an even number of faces: a ray that has come in must go out. Edges without
/// length do not count.
bool is_closed(const Mesh& mesh);

/// Whether it is closed, and all its faces look outwards: each edge is run along as often in one direction as
/// in the other, and the volume is positive.
bool looks_outwards(const Mesh& mesh);

}  // namespace rt
