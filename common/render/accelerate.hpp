// Accelerators where they pay.
#pragma once

#include "common/scene/scene.hpp"
#include "common/world/world.hpp"

#include <cstdint>

namespace rt {

/// Whether a grid over `shapes` shapes that lie well can pay for `rays` rays: whether building it and walking
/// through it costs less than to ask every shape for every ray. Costs are in units of one sphere asked;
/// measured by `course report error-time`. `ask` is what one of these shapes costs.
bool grid_pays(std::size_t shapes, Real rays, Real ask = 1);

/// Number of rays that the picture will take, roughly: camera rays, and for each one a shadow ray a light and
/// two more where things mirror or transmit.
Real expected_rays(const Scene& scene, const World& world);

/// Work that went into grids, in vain or not, for tests and figures.
struct GridWork {
    std::uint64_t entered = 0;    ///< shapes, once a grid that was begun
    std::uint64_t questions = 0;  ///< whether a shape may be in a box
    std::uint64_t probes = 0;     ///< shapes asked by rays that tried a grid out
};

/// The calling thread's work so far.
GridWork& grid_work();

/// Puts accelerators over the groups and meshes of a finished world, as scene.accelerator says.
///
/// `auto` chooses by counts, so that the same scene always gets the same grids. A group's far outliers, at
/// most 64, go to a group of their own without a grid: a grid's cells and its margin are parts of the box
/// around all. A sample of the shapes says how fine a grid may be; it is built, tried with some rays, and
/// kept if they ask less than all the shapes. Grids inside its cells are tried if what they can save is worth
/// it, and given up when they cost more than a third of that.
void add_accelerators(const Scene& scene, World& world);

}  // namespace rt
