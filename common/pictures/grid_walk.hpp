// The cells of a world's grids along a ray, and what they list.
#pragma once

#include "common/world/world.hpp"

#include <nlohmann/json_fwd.hpp>

namespace rt {

/// For each group of the world that has a grid, the grid and the cells along the ray in their order:
/// {"of": "triangles", "cells": [8, 4, 8], "low": […], "high": […],
///  "visits": [{"cell": [0, 3, 2], "t": [0.5, 0.75], "shapes": [17, 20]}, …]}.
/// A cell with a grid of its own says how many cells that has ("inner") instead of its shapes. A ray that
/// begins beyond a grid's reach visits none: it asks every shape.
nlohmann::ordered_json walks_of(const World& world, const Ray& ray);

}  // namespace rt
