// Grids where they pay.
#pragma once

#include "common/scene/scene.hpp"
#include "common/scene/world.hpp"

namespace rt {

/// Whether a grid over `shapes` shapes pays for `rays` rays: whether building it and walking through it costs
/// less than to ask every shape for every ray. Costs are in units of one shape asked; measured by `course
/// report error-time`, rounded to the side of no grid.
bool grid_pays(std::size_t shapes, Real rays);

/// Number of rays that the picture will take, roughly: camera rays, and for each one a shadow ray a light and
/// two more where things mirror or transmit.
Real expected_rays(const Scene& scene, const World& world);

/// Puts grids over the groups and meshes of a finished world, as scene.accelerator says.
void add_grids(const Scene& scene, World& world);

}  // namespace rt
