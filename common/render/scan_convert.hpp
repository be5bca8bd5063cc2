// Scan conversion with a z-buffer: the other way to find what each pixel sees.
// Ray casting asks for each pixel which triangle; scan conversion asks for each triangle which pixels.
#pragma once

#include "common/image/image.hpp"
#include "common/world/world.hpp"

#include <optional>
#include <vector>

namespace rt {

/// For each pixel, row by row from the top left, the nearest triangle at its centre: what closest_hit says of
/// pixel_ray through (x + ½, y + ½) in (0, ∞], up to rounding. So `Hit::t` is in world units,
/// `Hit::primitive` is the order in the file, and equally near triangles are decided by it.
///
/// Edge functions and depth are linear in homogeneous picture coordinates, so that triangles that reach
/// behind the eye need no clipping (Olano & Greer 1997). A triangle seen edge-on, or without area, is not
/// drawn. Throws InputError for a world with other shapes than triangles and instances of meshes.
std::vector<std::optional<Hit>> scan_convert(const World& world);

/// The picture by scan conversion: what the world's integrator paints of each pixel's hit, up to rounding,
/// and the background where there is none. Only for integrators whose colour depends on the nearest hit
/// alone.
Image rasterize(const World& world);

}  // namespace rt
