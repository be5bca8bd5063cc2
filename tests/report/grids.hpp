// A mesh in a grid, from a thousand triangles to ten million: CPU time to build and a ray, and bytes, beside
// asking every triangle.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"
#include "tests/report/kernels.hpp"
#include "tests/report/statistics.hpp"

#include <vector>

namespace rt::report {

struct GridPoint {
    double triangles = 0;
    double build_seconds = 0;
    double grid_ns = 0;     ///< a ray; median of repeats
    double brute_ns = 0;    ///< a ray that asks every triangle
    double cells = 0;       ///< entered, a ray
    double asked = 0;       ///< triangles asked, a ray
    double bytes = 0;       ///< of the grid, a triangle
    double break_even = 0;  ///< rays from which on building and using the grid is faster
    std::size_t rays = 0, brute_rays = 0;
    std::size_t different =
        0;  ///< of the rays that were traced both ways: answers that are not the same bits
};

struct Grids {
    std::vector<GridPoint> points;
    PowerLaw build, grid_ray, brute_ray, asked, break_even;  ///< against the number of triangles
};

struct GridsOptions {
    std::vector<double> sizes{1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6, 3e6, 1e7};
    std::size_t rays = 100'000;
    double brute_tests = 5e7;  ///< triangles that are asked without a grid, at each size
    int repeats = 5;           ///< of the timing of rays; a build that takes over a second is made once
};

/// What `course report --quick` measures.
GridsOptions quick_grids();

/// A ball with dents, of radius about 1, around the origin: a cube's faces in n × n squares of two triangles,
/// blown up.
std::vector<Triangle> bumpy_ball(int n);

Grids measure_grids(const GridsOptions& options = {}, const Told& told = {});

}  // namespace rt::report
