// The loop of every ray tracer: for each pixel a ray, for each ray a colour.
#pragma once

#include "common/world/query.hpp"

#include <vector>

namespace rt {

/// Which colour arrives along a ray: linear RGB. The stream gives it random numbers, if it needs any.
using RayColor = Vec3 (*)(const World&, const Ray&, Stream&);

/// [01.6] Colour seen along the ray by ray casting: ambient + emission of the material at the nearest hit
/// in (0, ∞], or the background where nothing is hit. No lights, no bounces (Appel 1968).
Vec3 cast_ray(const World& world, const Ray& ray);

/// [01.6] Colours of the pixels of a tile, row by row from its top left: `color` of the ray through each
/// pixel's centre, with the pixel's stream. An empty tile has none.
std::vector<Vec3> render_tile(const World& world, const Tile& tile, RayColor color);

}  // namespace rt
